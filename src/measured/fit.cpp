#include "measured/fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "error/error.h"
#include "measured/fit_start.h"
#include "measured/flight_model.h"
#include "measured/table_faults.h"

namespace poinsot {

namespace {

constexpr std::size_t most_rows = 20'000;
constexpr std::size_t least_rows = 30;
constexpr double most_turn_rad = 0.5;  // from row to row

double rate_of(std::span<const MeasuredRow> rows) {
    double sum = 0.0;
    for (const MeasuredRow& row : rows) sum += row.omega_body.squaredNorm();
    return std::sqrt(sum / static_cast<double>(rows.size()));
}

// The noise of a component, from sixth differences, to which a smooth motion adds little: the
// squares of their coefficients, 1, 6, 15, 20 and so on, sum up to 924. Between uneven instants it
// is too large.
double noise_of(std::span<const MeasuredRow> rows) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    std::size_t n = 0;
    const auto add = [&sum, &n](std::span<const MeasuredRow> stretch) {
        for (std::size_t i = 3; i + 3 < stretch.size(); ++i, ++n) {
            const auto pair = [&](std::size_t k) -> Eigen::Vector3d {
                return stretch[i - k].omega_body + stretch[i + k].omega_body;
            };
            sum += (pair(3) - 6.0 * pair(2) + 15.0 * pair(1) - 20.0 * stretch[i].omega_body)
                       .squaredNorm();
        }
    };
    for (const auto& stretch : stretches_of(rows, -infinity, infinity)) add(stretch);
    if (n == 0) add(rows);
    return std::sqrt(sum / 924.0 / static_cast<double>(3 * n));
}

[[noreturn]] void throw_no_motion(double off_rad_s, double rate_rad_s) {
    throw InputError(fmt::format(
        "no free motion of a rigid body comes near these rows: the best is off by {:.3g} rad/s of "
        "{:.3g}; cut the table to the time in which the body is free, and check units and axes",
        off_rad_s, rate_rad_s));
}
[[noreturn]] void throw_undetermined() {
    throw InputError(
        "the rows do not determine the moments: bodies with other moments would give the same "
        "ω(t); "
        "measure a motion in which the axis of rotation moves farther through the body, or measure "
        "for longer");
}
constexpr double most_noise_share = 0.3;      // of the rate
constexpr double most_residual_share = 0.05;  // of the rate, where the rows scatter less

// Refuses rows that are noise, and a turn about one axis, which says nothing about the moments:
// whatever ω is besides is noise.
void check_wandering(std::span<const MeasuredRow> rows) {
    const double noise = noise_of(rows), rate = rate_of(rows);
    if (noise > most_noise_share * rate) throw_no_motion(noise, rate);
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const MeasuredRow& row : rows) squares += row.omega_body * row.omega_body.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(squares);
    const double beside = std::sqrt((eigen.eigenvalues()[0] + eigen.eigenvalues()[1]) / 2.0 /
                                    static_cast<double>(rows.size()));
    constexpr double least_share = 1e-6, least_noises = 3.0;
    if (beside < least_noises * noise || beside < least_share * rate)
        throw InputError(
            "the rows do not determine the moments: but for noise the body turns about one axis; "
            "measure a motion whose axis of rotation wanders through the body");
}

// Each axis points to the positive side of its largest component.
void point_axes(Eigen::Matrix3d& axes) {
    for (int k = 0; k < 3; ++k) {
        Eigen::Index largest = 0;
        axes.col(k).cwiseAbs().maxCoeff(&largest);
        if (axes(largest, k) < 0.0) axes.col(k) *= -1.0;
    }
    if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
}

// What is known beforehand, and so is not fitted.
using IsFitted = std::array<bool, most_flight_changes>;
IsFitted fitted_changes(const std::optional<Eigen::Vector3d>& moments, DragModel drag) {
    IsFitted is_fitted{};
    for (int k = 0; k < n_changes(drag); ++k) is_fitted[static_cast<std::size_t>(k)] = true;
    if (!moments) return is_fitted;
    is_fitted[0] = is_fitted[1] = false;
    // A turn about the axis of two equal moments changes nothing.
    for (std::size_t k = 0; k < 3; ++k) {
        const auto one = static_cast<Eigen::Index>((k + 1) % 3);
        const auto other = static_cast<Eigen::Index>((k + 2) % 3);
        if ((*moments)[one] == (*moments)[other]) is_fitted[2 + k] = false;
    }
    return is_fitted;
}
int count(const IsFitted& is_fitted) {
    return static_cast<int>(std::count(is_fitted.begin(), is_fitted.end(), true));
}

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_flight_changes,
                             most_flight_changes>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_flight_changes, 1>;

// The places of what is fitted.
std::vector<int> places_of(const IsFitted& is_fitted) {
    std::vector<int> places;
    places.reserve(is_fitted.size());
    for (std::size_t k = 0; k < is_fitted.size(); ++k)
        if (is_fitted[k]) places.push_back(static_cast<int>(k));
    return places;
}
Square chosen(const FlightSquare& square, const std::vector<int>& places) {
    const auto n = static_cast<Eigen::Index>(places.size());
    Square normal(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k)
            normal(i, k) =
                square(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(k)]);
    return normal;
}

struct FoundFlight {
    Flight flight;
    double squares = std::numeric_limits<double>::infinity();
};

// Levenberg's and Marquardt's method on the rows as a whole.
FoundFlight minimised(std::span<const MeasuredRow> rows, const Flight& start,
                      const IsFitted& is_fitted) {
    constexpr int most_steps = 60;
    constexpr double least_gain = 1e-9, most_trust = 1e12, widest_log = 11.0;
    const std::vector<int> places = places_of(is_fitted);
    Flight flight = start;
    FlightSums sums = flight_sums(flight, rows);
    double trust = 1e-3;
    for (int n_steps = 0; n_steps < most_steps && std::isfinite(sums.squares); ++n_steps) {
        const Square normal = chosen(sums.normal, places);
        Column gradient(normal.rows());
        for (Eigen::Index i = 0; i < gradient.size(); ++i)
            gradient[i] = sums.gradient[places[static_cast<std::size_t>(i)]];
        Square damped = normal;
        const double floor = 1e-12 * normal.diagonal().maxCoeff();
        for (Eigen::Index i = 0; i < damped.rows(); ++i)
            damped(i, i) += trust * normal(i, i) + floor;
        const Column step = damped.ldlt().solve(-gradient);
        FlightChange by = FlightChange::Zero();
        for (Eigen::Index i = 0; i < step.size(); ++i)
            by[places[static_cast<std::size_t>(i)]] = step[i];
        if (!by.allFinite()) break;
        const Flight next = changed(flight, by);
        const bool is_tried = by.head<n_of_body>().cwiseAbs().maxCoeff() < 2.0 &&
                              next.moments.array().log().abs().maxCoeff() < widest_log;
        FlightSums there;
        there.squares = std::numeric_limits<double>::infinity();
        if (is_tried) there = flight_sums(next, rows);
        if (there.squares < sums.squares) {
            const double gain = 1.0 - there.squares / sums.squares;
            flight = next;
            sums = there;
            trust = std::max(trust * 0.1, 1e-9);
            if (gain < least_gain) break;
        } else {
            trust *= 8.0;
            if (trust > most_trust || by.cwiseAbs().maxCoeff() < 1e-13) break;
        }
    }
    return {flight, sums.squares};
}

// Least squares over the first rows, then over twice as many, and so on: each fit is near enough
// for the next to keep count of the periods.
FoundFlight grown(std::span<const MeasuredRow> rows, Flight start, const IsFitted& is_fitted,
                  double first_span_rad) {
    for (double span = first_span_rad;; span *= 2.0) {
        const auto end =
            std::upper_bound(rows.begin(), rows.end(), rows.front().time_s + span,
                             [](double t, const MeasuredRow& row) { return t < row.time_s; });
        const std::size_t n = std::min(
            rows.size(), std::max(least_rows, static_cast<std::size_t>(end - rows.begin())));
        FoundFlight found = minimised(rows.first(n), start, is_fitted);
        if (n == rows.size()) return found;
        start = found.flight;
    }
}

// Starts are tried until one leaves no more than noise, or until two of them end in the same least
// minimum.
FoundFlight best_fit(std::span<const MeasuredRow> rows, double noise,
                     const std::optional<Eigen::Vector3d>& moments) {
    const IsFitted is_fitted = fitted_changes(moments, DragModel::linear);
    const double most_noise = 1.2 * noise;
    const double n_values = static_cast<double>(3 * rows.size()) - count(is_fitted);
    FoundFlight best;
    constexpr double same = 1e-3, near_share = 0.05;
    for (const double first_span_rad : {12.0, 5.0, 30.0})
        for (const Flight& start : first_flights(rows, moments)) {
            const FoundFlight found = grown(rows, start, is_fitted, first_span_rad);
            const bool is_same = std::abs(found.squares - best.squares) < same * best.squares;
            if (found.squares < best.squares) best = found;
            if (best.squares < most_noise * most_noise * n_values) return best;
            if (is_same && best.squares < near_share * near_share * n_values) return best;
        }
    return best;
}

// Whether L² = 2T·I2 but for rounding. Then sech and tanh of ω(t) fit a family of bodies: k = 1
// says nothing more about the moments.
bool is_on_separatrix(const Flight& flight) {
    const Eigen::Vector3d squares = (flight.axes.transpose() * flight.omega).cwiseAbs2();
    const double twice_energy = flight.moments.dot(squares);
    const double momentum_squared = flight.moments.cwiseAbs2().dot(squares);
    constexpr double nearest = 1e-6;
    return std::abs(momentum_squared / twice_energy - flight.moments[1]) <
           nearest * (flight.moments[0] - flight.moments[2]);
}

// I1 ≥ I2 ≥ I3 in units of I1, and axes whose largest components are positive.
Flight in_order(const Flight& flight) {
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&flight](int a, int b) { return flight.moments[a] > flight.moments[b]; });
    Flight made = flight;
    for (int k = 0; k < 3; ++k) {
        const int from = order[static_cast<std::size_t>(k)];
        made.moments[k] = flight.moments[from] / flight.moments[order[0]];
        made.axes.col(k) = flight.axes.col(from);
        if (flight.drag != DragModel::linear) made.drag_rates[k] = flight.drag_rates[from];
    }
    point_axes(made.axes);
    return made;
}

// How much the residual of a row is like that of the row before it.
double correlation_of(const std::vector<Eigen::Vector3d>& residuals) {
    double squares = 0.0, products = 0.0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        squares += residuals[i].squaredNorm();
        if (i > 0) products += residuals[i].dot(residuals[i - 1]);
    }
    constexpr double most = 0.99;
    return squares > 0.0 ? std::clamp(products / squares, 0.0, most) : 0.0;
}

// Every so many rows, evenly, so that no more than most_rows are left, but none of them so far
// apart that the body turns by too much in between: of a longer table the beginning is taken.
std::vector<MeasuredRow> thinned(std::span<const MeasuredRow> rows) {
    const double step_s = (rows.back().time_s - rows.front().time_s) /
                          static_cast<double>(std::max<std::size_t>(rows.size(), 2) - 1);
    const double most_turn = 0.5 * most_turn_rad;
    const auto widest = static_cast<std::size_t>(
        std::max(1.0, std::min(1e9, most_turn / std::max(step_s * rate_of(rows), 1e-9))));
    const std::size_t stride = std::min((rows.size() + most_rows - 1) / most_rows, widest);
    std::vector<MeasuredRow> some;
    some.reserve(std::min(rows.size(), most_rows));
    for (std::size_t i = 0; i < rows.size() && some.size() < most_rows; i += stride)
        some.push_back(rows[i]);
    return some;
}

void check(std::span<const MeasuredRow> rows) {
    if (rows.size() < least_rows)
        throw InputError(fmt::format("{} about a motion; give {} or more",
                                     rows.size() == 1
                                         ? "1 row says too little"
                                         : fmt::format("{} rows say too little", rows.size()),
                                     least_rows));
    const double rate = rate_of(rows);
    if (!(rate > 0.0))
        throw InputError("ω is zero in all rows: a body at rest says nothing about its moments");
    if (!std::isfinite(rate)) throw InputError("ω is too large to be squared; give it in rad/s");
    std::size_t n_far = 0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        n_far += (rows[i].time_s - rows[i - 1].time_s) * rate > most_turn_rad;
    if (2 * n_far > rows.size())
        throw InputError(
            fmt::format("the body turns by more than half a radian from one row to the next; "
                        "sample it at {:.3g} Hz or more",
                        2.0 * rate));
}

std::vector<MeasuredRow> scaled_by(std::span<const MeasuredRow> rows, double rate) {
    std::vector<MeasuredRow> scaled(rows.begin(), rows.end());
    for (MeasuredRow& row : scaled) {
        row.time_s = (row.time_s - rows.front().time_s) * rate;
        row.omega_body /= rate;
    }
    return scaled;
}

// The richer air: from the linear fit on, whose damping the three axes share at first.
FoundFlight with_drag(std::span<const MeasuredRow> rows, const FoundFlight& linear, DragModel drag,
                      const std::optional<Eigen::Vector3d>& moments) {
    if (drag == DragModel::linear) return linear;
    Flight start = linear.flight;
    start.drag = drag;
    start.drag_rates.setConstant(drag == DragModel::none ? 0.0 : linear.flight.drag_rates[0]);
    return minimised(rows, start, fitted_changes(moments, drag));
}

}  // namespace

std::string_view name_of(DragModel drag) {
    switch (drag) {
        case DragModel::none:
            return "none";
        case DragModel::axes:
            return "axes";
        case DragModel::quadratic:
            return "quadratic";
        default:
            return "linear";
    }
}

FittedMotion fit_motion(std::span<const MeasuredRow> all,
                        const std::optional<Eigen::Vector3d>& moments_kg_m2,
                        const std::optional<DragModel>& wanted) {
    std::optional<Eigen::Vector3d> moments = moments_kg_m2;
    if (moments) std::sort(moments->begin(), moments->end(), std::greater<>());
    if (moments && (*moments)[0] == (*moments)[2])
        throw InputError(
            "the three moments are equal: every axis of such a body is a principal axis, and its ω "
            "does not change");
    check(all);
    const std::vector<MeasuredRow> unscaled = thinned(all);
    check(unscaled);
    check_wandering(unscaled);
    const double rate = rate_of(unscaled);
    const double noise = noise_of(unscaled) / rate;
    const std::vector<MeasuredRow> rows = scaled_by(unscaled, rate);

    const FoundFlight linear = best_fit(rows, noise, moments);
    const auto residual_of = [&rows, &moments](const FoundFlight& found) {
        const int n = count(fitted_changes(moments, found.flight.drag));
        return std::sqrt(found.squares / (static_cast<double>(3 * rows.size()) - n));
    };
    FoundFlight best = linear;
    constexpr double like_noise = 1.2, rounding_of_rows = 1e-6;
    if (wanted)
        best = with_drag(rows, linear, *wanted, moments);
    else if (residual_of(linear) > std::max(like_noise * noise, rounding_of_rows))
        for (const DragModel drag : {DragModel::axes, DragModel::quadratic}) {
            const FoundFlight richer = with_drag(rows, linear, drag, moments);
            if (residual_of(richer) < residual_of(best)) best = richer;
        }
    best.flight = in_order(best.flight);
    if (moments) best.flight.moments = *moments / (*moments)[0];
    const Flight& flight = best.flight;
    const double residual = residual_of(best);
    if (!(residual < std::max(most_residual_share, 1.5 * noise)))
        throw_no_motion(residual * rate, rate);

    const std::vector<int> places = places_of(fitted_changes(moments, flight.drag));
    std::vector<Eigen::Vector3d> residuals;
    const Square normal = chosen(flight_sums(flight, rows, &residuals).normal, places);
    // Scaled, so that units do not matter.
    const Column scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) throw_undetermined();
    const Eigen::SelfAdjointEigenSolver<Square> eigen(
        Square(scale.asDiagonal() * normal * scale.asDiagonal()));
    constexpr double least_eigenvalue = 1e-13;
    if (!(eigen.eigenvalues()[0] > least_eigenvalue)) throw_undetermined();
    if (!moments && is_on_separatrix(flight)) throw_undetermined();
    const double correlation = correlation_of(residuals);
    const Square spread = chosen(flight_sums(flight, rows, nullptr, correlation).spread, places);
    const Square inverse = eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() *
                           eigen.eigenvectors().transpose();
    const Square scaled_spread = scale.asDiagonal() * spread * scale.asDiagonal();
    const Square covariance = inverse * scaled_spread * inverse;
    FlightChange sd = FlightChange::Zero();
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        sd[places[k]] = residual * std::sqrt(std::max(covariance(i, i), 0.0)) * scale[i];
    }

    FittedMotion fit;
    fit.first_time_s = unscaled.front().time_s;
    fit.omega_rad_s = rate * flight.omega;
    fit.omega_sd_rad_s = rate * sd.segment<3>(first_of_omega);
    fit.moments = flight.moments;
    fit.moments_sd = Eigen::Vector3d(0.0, flight.moments[1] * sd[0], flight.moments[2] * sd[1]);
    if (moments) fit.I1_kg_m2 = (*moments)[0];
    fit.instrument_from_principal = flight.axes;
    fit.axes_sd_rad = sd.segment<3>(2);
    fit.drag = flight.drag;
    const double drag_unit = flight.drag == DragModel::quadratic ? 1.0 : rate;
    fit.drag_rates = drag_unit * flight.drag_rates;
    fit.drag_rates_sd = drag_unit * sd.tail<3>();
    if (flight.drag == DragModel::none) fit.drag_rates.setZero();
    if (flight.drag == DragModel::linear) {
        fit.drag_rates.setConstant(fit.drag_rates[0]);
        fit.drag_rates_sd.setConstant(fit.drag_rates_sd[0]);
    }
    fit.residual_rad_s = rate * residual;
    fit.linear_residual_rad_s = rate * residual_of(linear);
    fit.correlation = correlation;
    fit.n_rows = rows.size();
    fit.noise_rad_s = rate * noise;
    if (constexpr double most = 0.25; fit.moments_sd.maxCoeff() > most) throw_undetermined();
    return fit;
}

}  // namespace poinsot
