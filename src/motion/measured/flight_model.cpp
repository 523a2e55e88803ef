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
// Where attitudes are fitted also the attitude, space from principal axes (w, x, y, z), and for
// each of these changes the small turn of the body that it makes, in principal axes.
constexpr int n_stepped = 8;
using SteppedChange = std::array<std::array<double, n_stepped>, 3>;
struct SteppedState {
    std::array<double, 3> omega{};
    SteppedChange change{};
    double time = 0.0;
    std::array<double, 4> attitude{1.0, 0.0, 0.0, 0.0};
    SteppedChange turn{};
};

// Euler's equations with drag, and the linear equations of small changes.
class StepEquations {
 public:
    explicit StepEquations(const Flight& flight)
        : drag_(flight.drag), has_attitude_(flight.attitude.has_value()) {
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
        if (has_attitude_) turn_slope(at, out);
    }

    // The turn θ of the body by a small change obeys θ′ = −ω × θ + δω in its own axes.
    void turn_slope(const SteppedState& at, SteppedState& out) const {
        const auto& w = at.omega;
        const auto& q = at.attitude;
        out.attitude = {0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]),
                        0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
                        0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]),
                        0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0])};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            for (std::size_t c = 0; c < static_cast<std::size_t>(n_); ++c)
                out.turn[i][c] = w[k] * at.turn[j][c] - w[j] * at.turn[k][c] + at.change[i][c];
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
            if (!has_attitude_) return;
            for (std::size_t i = 0; i < 4; ++i)
                between.attitude[i] = state.attitude[i] + h * slope.attitude[i];
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < static_cast<std::size_t>(n_); ++k)
                    between.turn[i][k] = state.turn[i][k] + h * slope.turn[i][k];
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
        if (!has_attitude_) return;
        for (std::size_t i = 0; i < 4; ++i)
            state.attitude[i] +=
                sixth * (a.attitude[i] + 2.0 * (b.attitude[i] + c.attitude[i]) + d.attitude[i]);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < static_cast<std::size_t>(n_); ++k)
                state.turn[i][k] +=
                    sixth * (a.turn[i][k] + 2.0 * (b.turn[i][k] + c.turn[i][k]) + d.turn[i][k]);
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
    bool has_attitude_;
    double growth_ = 0.0;  // κ
    std::array<double, 3> factor_{}, rate_{};
    std::array<std::array<double, 3>, 3> by_moment_{};
    int n_ = 0;
};

// ω and the attitude, space from instrument, at an instant.
struct FlightState {
    Eigen::Vector3d omega;  // instrument axes
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
};

// The motion in closed form: with the torque −γL, ω(t) = e^(−γt) ω_free((1 − e^(−γt))/γ), and the
// attitude is that of the free motion at (1 − e^(−γt))/γ.
class ClosedFlight {
 public:
    explicit ClosedFlight(const Flight& flight)
        : axes_(flight.axes),
          damping_(flight.drag == DragModel::none ? 0.0 : flight.drag_rates[0]),
          wanted_{.attitude = flight.attitude.has_value()},
          free_(InertiaTensor::from_matrix(Eigen::Matrix3d(flight.moments.asDiagonal()),
                                           Physicality::waived),
                RotationState{0.0,
                              flight.attitude.value_or(Eigen::Quaterniond::Identity()) *
                                  Eigen::Quaterniond(flight.axes),
                              flight.axes.transpose() * flight.omega}) {}
    FlightState at(double t) const {
        const double x = damping_ * t;
        const double slowed = std::abs(x) < 1e-12 ? t : -std::expm1(-x) / damping_;
        const RotationState state = free_.sample(slowed, wanted_).state;
        FlightState made{axes_ * (std::exp(-x) * state.omega_body)};
        if (wanted_.attitude)
            made.attitude = state.space_from_body * Eigen::Quaterniond(axes_).conjugate();
        return made;
    }

 private:
    Eigen::Matrix3d axes_;
    double damping_;
    Quantities wanted_;
    FreeRotation free_;
};

bool has_closed_form(DragModel drag) {
    return drag == DragModel::none || drag == DragModel::linear;
}

using ThreeByStepped = Eigen::Matrix<double, 3, n_stepped>;
ThreeByStepped matrix_of(const SteppedChange& change) {
    ThreeByStepped made;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < n_stepped; ++c)
            made(r, c) = change[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    return made;
}

// Changes of ω along the principal axes, or of the attitude as turns about these, by those of a
// flight: `start_turn` is what a turn of the axes, about each of them, makes of it if ω at the
// start keeps its components along them.
FlightDerivative derivative_of(const ThreeByStepped& change, const Eigen::Matrix3d& start_turn,
                               const Eigen::Vector3d& start, const Flight& flight) {
    FlightDerivative derivative = FlightDerivative::Zero();
    derivative.leftCols<2>() = change.middleCols<2>(3);
    for (int k = 0; k < 3; ++k)
        derivative.col(2 + k) =
            start_turn.col(k) - change.leftCols<3>() * Eigen::Vector3d::Unit(k).cross(start);
    derivative.middleCols<3>(first_of_omega) = change.leftCols<3>() * flight.axes.transpose();
    derivative.middleCols<3>(first_of_drag) = change.rightCols<3>();
    return derivative;
}

// `take(state, derivative)` at each time, the derivative of the attitude where the flight has one,
// else of ω; false if the flight leaves all bounds.
template <typename Take>
bool step_through(const Flight& flight, std::size_t n,
                  const std::function<double(std::size_t)>& time, const Take& take) {
    const StepEquations equations(flight);
    const Eigen::Vector3d start = flight.axes.transpose() * flight.omega;
    const Eigen::Quaterniond axes(flight.axes);
    SteppedState state;
    for (std::size_t i = 0; i < 3; ++i) {
        state.omega[i] = start[static_cast<Eigen::Index>(i)];
        state.change[i][i] = 1.0;
    }
    Eigen::Matrix3d first = Eigen::Matrix3d::Identity();  // space from principal axes
    if (flight.attitude) {
        const Eigen::Quaterniond q = *flight.attitude * axes;
        state.attitude = {q.w(), q.x(), q.y(), q.z()};
        first = q.toRotationMatrix();
    }
    std::optional<ClosedFlight> closed;
    if (has_closed_form(flight.drag)) closed.emplace(flight);
    const double widest_rad = closed ? 0.1 : 0.05;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0 && !equations.advance(state, time(i) - time(i - 1), widest_rad)) return false;
        const Eigen::Vector3d omega(state.omega[0], state.omega[1], state.omega[2]);
        FlightState there;
        if (closed)
            there = closed->at(time(i));
        else
            there.omega = flight.axes * omega;
        FlightDerivative derivative;
        if (!flight.attitude) {
            Eigen::Matrix3d turned;
            for (int k = 0; k < 3; ++k) turned.col(k) = Eigen::Vector3d::Unit(k).cross(omega);
            derivative = derivative_of(matrix_of(state.change), turned, start, flight);
        } else {
            if (!closed) {
                const auto& q = state.attitude;
                there.attitude =
                    Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized() * axes.conjugate();
            }
            const Eigen::Matrix3d back =
                (there.attitude.toRotationMatrix() * flight.axes).transpose();
            // Axes that turn take the body along, and turn back in the end.
            const Eigen::Matrix3d turned = back * first - Eigen::Matrix3d::Identity();
            derivative = derivative_of(matrix_of(state.turn), turned, start, flight);
            derivative.middleCols<3>(first_of_attitude) = back;
        }
        derivative = (flight.axes * derivative).eval();
        take(i, there, derivative);
    }
    return true;
}

// Adds a row to the sums: its residual and the derivative of it, of which the first n columns
// count. `before` is the sum of the earlier derivatives, weighted by their correlation.
template <int n>
void add_row(const Eigen::Vector3d& residual, const FlightDerivative& whole, double correlation,
             FlightDerivative& before, FlightSums& sums) {
    using Columns = Eigen::Matrix<double, 3, n>;
    const Columns derivative = whole.leftCols<n>();
    sums.squares += residual.squaredNorm();
    sums.gradient.head<n>() += derivative.transpose() * residual;
    // Lazily: the product of blocks costs more than these three rows.
    const Eigen::Matrix<double, n, n> square = derivative.transpose().lazyProduct(derivative);
    sums.normal.topLeftCorner<n, n>() += square;
    if (!(correlation > 0.0)) return;
    const Columns earlier = correlation * before.leftCols<n>();
    const Eigen::Matrix<double, n, n> mixed = derivative.transpose().lazyProduct(earlier);
    sums.spread.topLeftCorner<n, n>() += square + mixed + mixed.transpose();
    before.leftCols<n>() = earlier + derivative;
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
    made.drag_rates += by.segment<3>(first_of_drag);
    const Eigen::Vector3d aside = by.segment<3>(first_of_attitude);
    if (const double angle = aside.norm(); made.attitude && angle > 0.0)
        made.attitude =
            (Eigen::Quaterniond(Eigen::AngleAxisd(angle, aside / angle)) * *flight.attitude)
                .normalized();
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
        [&](std::size_t i, const FlightState& there, const FlightDerivative& derivative) {
            const Eigen::Vector3d r = flight.attitude
                                          ? turn_between(rows[i].space_from_body, there.attitude)
                                          : Eigen::Vector3d(there.omega - rows[i].omega_body);
            if (residuals != nullptr) residuals->push_back(r);
            if (flight.attitude)
                add_row<most_flight_changes>(r, derivative, correlation, before, sums);
            else
                add_row<first_of_attitude>(r, derivative, correlation, before, sums);
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
        [&omegas](std::size_t, const FlightState& there, const FlightDerivative&) {
            omegas.push_back(there.omega);
        });
    return omegas;
}

}  // namespace poinsot
