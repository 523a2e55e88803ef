#include "measured/flight_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "mechanics/free/free_rotation.h"

namespace poinsot {

namespace {

// ω in principal axes and its derivatives with respect to ω at the start, ln I2, ln I3 and drag.
constexpr int n_stepped = 8;
struct SteppedState {
    std::array<double, 3> omega{};
    std::array<std::array<double, n_stepped>, 3> change{};
    double time = 0.0;
};

// Euler's equations with drag, and the linear equations of small changes.
class StepEquations {
 public:
    explicit StepEquations(const Flight& flight) : drag_(flight.drag) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const auto moment = [&flight](std::size_t n) {
                return flight.moments[static_cast<Eigen::Index>(n)];
            };
            const double I = moment(i), J = moment(j), K = moment(k);
            factor_[i] = (J - K) / I;
            by_moment_[i][i] = -factor_[i];
            by_moment_[i][j] = J / I;
            by_moment_[i][k] = -K / I;
            rate_[i] = flight.drag == DragModel::none ? 0.0
                       : flight.drag == DragModel::linear || flight.drag == DragModel::growing
                           ? flight.drag_rates[0]
                           : flight.drag_rates[static_cast<Eigen::Index>(i)];
        }
        growth_ = flight.drag == DragModel::growing ? flight.drag_rates[1] : 0.0;
        n_ = first_of_drag_ + n_changes(flight.drag) - first_of_drag;
    }

    void slope(const SteppedState& at, SteppedState& out) const {
        const auto& w = at.omega;
        const bool is_quadratic = drag_ == DragModel::quadratic;
        const double grown = growth_ == 0.0 ? 1.0 : std::exp(growth_ * at.time);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const double braking = is_quadratic ? std::abs(w[i]) * w[i] : grown * w[i];
            const double product = w[j] * w[k];
            out.omega[i] = factor_[i] * product - rate_[i] * braking;
            const double own = is_quadratic ? 2.0 * rate_[i] * std::abs(w[i]) : grown * rate_[i];
            const double of_j = factor_[i] * w[k], of_k = factor_[i] * w[j];
            for (std::size_t c = 0; c < static_cast<std::size_t>(n_); ++c)
                out.change[i][c] =
                    of_j * at.change[j][c] + of_k * at.change[k][c] - own * at.change[i][c];
            out.change[i][3] += by_moment_[i][1] * product;
            out.change[i][4] += by_moment_[i][2] * product;
            if (drag_ == DragModel::axes || is_quadratic) {
                out.change[i][first_of_drag_ + i] -= braking;
            } else if (drag_ != DragModel::none) {
                out.change[i][first_of_drag_] -= braking;
                if (drag_ == DragModel::growing)
                    out.change[i][first_of_drag_ + 1] -= rate_[i] * at.time * braking;
            }
        }
    }

    void step(SteppedState& state, double by) const {
        SteppedState a, b, c, d, between;
        const auto moved = [&](const SteppedState& slope, double h) {
            between.time = state.time + h;
            for (std::size_t i = 0; i < 3; ++i) {
                between.omega[i] = state.omega[i] + h * slope.omega[i];
                for (std::size_t k = 0; k < static_cast<std::size_t>(n_); ++k)
                    between.change[i][k] = state.change[i][k] + h * slope.change[i][k];
            }
        };
        slope(state, a);
        moved(a, 0.5 * by);
        slope(between, b);
        moved(b, 0.5 * by);
        slope(between, c);
        moved(c, by);
        slope(between, d);
        state.time += by;
        const double sixth = by / 6.0;
        for (std::size_t i = 0; i < 3; ++i) {
            state.omega[i] += sixth * (a.omega[i] + 2.0 * (b.omega[i] + c.omega[i]) + d.omega[i]);
            for (std::size_t k = 0; k < static_cast<std::size_t>(n_); ++k)
                state.change[i][k] +=
                    sixth *
                    (a.change[i][k] + 2.0 * (b.change[i][k] + c.change[i][k]) + d.change[i][k]);
        }
    }

    // From one row to the next; false where ω leaves all bounds.
    bool advance(SteppedState& state, double by, double widest_rad) const {
        const double rate =
            std::sqrt(state.omega[0] * state.omega[0] + state.omega[1] * state.omega[1] +
                      state.omega[2] * state.omega[2]);
        constexpr double most_rate = 100.0, most_steps = 1e5;
        if (!(rate < most_rate)) return false;
        const double n = std::ceil(by * std::max(rate, 1.0) / widest_rad);
        if (!(n < most_steps)) return false;
        for (int i = 0; i < static_cast<int>(n); ++i) step(state, by / n);
        return true;
    }

 private:
    static constexpr std::size_t first_of_drag_ = 5;
    DragModel drag_;
    double growth_ = 0.0;  // κ
    std::array<double, 3> factor_{}, rate_{};
    std::array<std::array<double, 3>, 3> by_moment_{};
    int n_ = 0;
};

// The motion in closed form: with the torque −γL, ω(t) = e^(−γt) ω_free((1 − e^(−γt))/γ).
class ClosedFlight {
 public:
    explicit ClosedFlight(const Flight& flight)
        : axes_(flight.axes),
          damping_(flight.drag == DragModel::none ? 0.0 : flight.drag_rates[0]),
          free_(InertiaTensor::from_matrix(Eigen::Matrix3d(flight.moments.asDiagonal()),
                                           Physicality::waived),
                RotationState{0.0, Eigen::Quaterniond::Identity(),
                              flight.axes.transpose() * flight.omega}) {}
    Eigen::Vector3d omega(double t) const {
        const Quantities omega_alone{.attitude = false};
        const double x = damping_ * t;
        const double slowed = std::abs(x) < 1e-12 ? t : -std::expm1(-x) / damping_;
        return axes_ * (std::exp(-x) * free_.sample(slowed, omega_alone).state.omega_body);
    }

 private:
    Eigen::Matrix3d axes_;
    double damping_;
    FreeRotation free_;
};

bool has_closed_form(DragModel drag) {
    return drag == DragModel::none || drag == DragModel::linear;
}

// `take(ω in instrument axes, derivative)` at each time; false if the flight leaves all bounds.
template <typename Take>
bool step_through(const Flight& flight, std::size_t n,
                  const std::function<double(std::size_t)>& time, const Take& take) {
    const StepEquations equations(flight);
    const Eigen::Vector3d start = flight.axes.transpose() * flight.omega;
    SteppedState state;
    for (std::size_t i = 0; i < 3; ++i) {
        state.omega[i] = start[static_cast<Eigen::Index>(i)];
        state.change[i][i] = 1.0;
    }
    std::optional<ClosedFlight> closed;
    if (has_closed_form(flight.drag)) closed.emplace(flight);
    const double widest_rad = closed ? 0.1 : 0.05;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0 && !equations.advance(state, time(i) - time(i - 1), widest_rad)) return false;
        const Eigen::Vector3d omega(state.omega[0], state.omega[1], state.omega[2]);
        Eigen::Matrix<double, 3, n_stepped> change;
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < n_stepped; ++c)
                change(r, c) =
                    state.change[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
        FlightDerivative derivative = FlightDerivative::Zero();
        derivative.leftCols<2>() = change.middleCols<2>(3);
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d turn = Eigen::Vector3d::Unit(k);
            derivative.col(2 + k) = turn.cross(omega) - change.leftCols<3>() * turn.cross(start);
        }
        derivative.middleCols<3>(first_of_omega) = change.leftCols<3>() * flight.axes.transpose();
        derivative.rightCols<3>() = change.rightCols<3>();
        derivative = (flight.axes * derivative).eval();
        const Eigen::Vector3d there = closed ? closed->omega(time(i)) : flight.axes * omega;
        take(i, there, derivative);
    }
    return true;
}

}  // namespace

int n_changes(DragModel drag) {
    switch (drag) {
        case DragModel::none:
            return first_of_drag;
        case DragModel::linear:
            return first_of_drag + 1;
        case DragModel::growing:
            return first_of_drag + 2;
        default:
            return first_of_drag + 3;
    }
}

Flight changed(const Flight& flight, const FlightChange& by) {
    Flight made = flight;
    made.moments[1] *= std::exp(by[0]);
    made.moments[2] *= std::exp(by[1]);
    const Eigen::Vector3d turn = by.segment<3>(2);
    if (const double angle = turn.norm(); angle > 0.0)
        made.axes = Eigen::Quaterniond(flight.axes *
                                       Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix())
                        .normalized()
                        .toRotationMatrix();
    made.omega += by.segment<3>(first_of_omega);
    made.drag_rates += by.tail<3>();
    return made;
}

FlightSums flight_sums(const Flight& flight, std::span<const MeasuredRow> rows,
                       std::vector<Eigen::Vector3d>* residuals, double correlation) {
    FlightSums sums;
    FlightDerivative before = FlightDerivative::Zero();  // weighted sum of the earlier rows
    if (residuals != nullptr) residuals->clear();
    const double first_s = rows.front().time_s;
    const bool is_bounded = step_through(
        flight, rows.size(), [&rows, first_s](std::size_t i) { return rows[i].time_s - first_s; },
        [&](std::size_t i, const Eigen::Vector3d& omega, const FlightDerivative& derivative) {
            const Eigen::Vector3d r = omega - rows[i].omega_body;
            if (residuals != nullptr) residuals->push_back(r);
            sums.squares += r.squaredNorm();
            sums.gradient += derivative.transpose() * r;
            // Lazily: the product of blocks costs more than these three rows.
            const FlightSquare square = derivative.transpose().lazyProduct(derivative);
            sums.normal += square;
            if (!(correlation > 0.0)) return;
            before *= correlation;
            const FlightSquare mixed = derivative.transpose().lazyProduct(before);
            sums.spread += square + mixed + mixed.transpose();
            before += derivative;
        });
    if (!(correlation > 0.0)) sums.spread = sums.normal;
    if (!is_bounded || !std::isfinite(sums.squares) || !sums.normal.allFinite())
        sums.squares = std::numeric_limits<double>::infinity();
    return sums;
}

std::vector<Eigen::Vector3d> flight_omega(const Flight& flight, std::span<const double> times) {
    std::vector<Eigen::Vector3d> omegas;
    omegas.reserve(times.size());
    step_through(
        flight, times.size(), [times](std::size_t i) { return times[i]; },
        [&omegas](std::size_t, const Eigen::Vector3d& omega, const FlightDerivative&) {
            omegas.push_back(omega);
        });
    return omegas;
}

}  // namespace poinsot
