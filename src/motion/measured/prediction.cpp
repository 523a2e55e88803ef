#include "measured/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "error/error.h"
#include "measured/flight_fit.h"
#include "measured/flight_model.h"
#include "mechanics/free/free_rotation.h"
#include "numerics/small_solvers.h"

namespace poinsot {

namespace {

// A flight in units of its rate, with the covariance of its changes.
struct UncertainFlight {
    Flight flight;
    double rate = 1.0;
    FlightSquare covariance = FlightSquare::Zero();
};

// The covariance of what is fitted, from residuals that are alike from row to row.
FlightSquare covariance_of(const Flight& flight, std::span<const MeasuredRow> rows,
                           const IsFitted& is_fitted) {
    std::vector<Eigen::Vector3d> residuals;
    const FlightSums sums = flight_sums(flight, rows, &residuals);
    const FlightSums spread = flight_sums(flight, rows, nullptr, correlation_of(residuals));
    const std::vector<int> places = places_of(is_fitted);
    const Eigen::MatrixXd normal = chosen(sums.normal, places);
    const auto n = normal.rows();
    const Eigen::MatrixXd inverse = solved(normal, Eigen::MatrixXd::Identity(n, n));
    const Eigen::MatrixXd seen = chosen(spread.spread, places) * inverse;
    const Eigen::MatrixXd small =
        variance_of(sums.squares, rows.size(), seen.trace()) * (inverse * seen);
    FlightSquare covariance = FlightSquare::Zero();
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k)
            covariance(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(k)]) =
                small(i, k);
    return covariance;
}

std::optional<double> period_of(const Flight& flight) {
    const FreeRotation free(
        InertiaTensor::from_matrix(Eigen::Matrix3d(flight.moments.asDiagonal()),
                                   Physicality::waived),
        RotationState{0.0, Eigen::Quaterniond::Identity(), flight.axes.transpose() * flight.omega});
    return free.constants().polhode_period_s;
}

// The sign change of ω along e2 that is nearest to `near`, or the first one after `from`.
std::optional<double> flip_of(const Flight& flight, double from, double last,
                              std::optional<double> near = {}) {
    constexpr double step = 0.02;
    std::vector<double> times;
    for (double t = 0.0; t <= last; t += step) times.push_back(t);
    const std::vector<Eigen::Vector3d> omegas = flight_omega(flight, times);
    std::optional<double> best;
    for (std::size_t i = 1; i < omegas.size(); ++i) {
        const double a = flight.axes.col(1).dot(omegas[i - 1]);
        const double b = flight.axes.col(1).dot(omegas[i]);
        if ((a < 0.0) == (b < 0.0)) continue;
        const double t = times[i - 1] + step * a / (a - b);
        if (!near && t > from) return t;
        if (near && (!best || std::abs(t - *near) < std::abs(*best - *near))) best = t;
    }
    return best;
}

// A number of the flight, with the deviation that its covariance gives, by differences.
std::optional<Predicted> with_deviation(
    const UncertainFlight& from, double unit,
    const std::function<std::optional<double>(const Flight&)>& number) {
    const auto value = number(from.flight);
    if (!value) return std::nullopt;
    FlightChange slope = FlightChange::Zero();
    for (int k = 0; k < most_flight_changes; ++k) {
        const double sd = std::sqrt(std::max(from.covariance(k, k), 0.0));
        if (!(sd > 0.0)) continue;
        const FlightChange by = std::min(0.1 * sd, 1e-3) * FlightChange::Unit(k);
        const auto above = number(changed(from.flight, by));
        const auto below = number(changed(from.flight, -by));
        if (above && below) slope[k] = (*above - *below) / (2.0 * by[k]);
    }
    const double variance = slope.dot(from.covariance * slope);
    return Predicted{*value * unit, std::sqrt(std::max(variance, 0.0)) * unit};
}

Prediction compared(std::span<const MeasuredRow> rows, std::size_t n_fitted,
                    const UncertainFlight& from) {
    Prediction made;
    made.n_fitted = n_fitted;
    made.n_rest = rows.size() - n_fitted;
    const double first_s = rows.front().time_s;
    made.has_attitude = from.flight.attitude.has_value();
    const double unit = made.has_attitude ? 1.0 : from.rate;
    std::vector<Eigen::Vector3d> residuals;
    flight_sums(from.flight, scaled_by(rows, from.rate), &residuals);
    double fitted = 0.0, rest = 0.0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        const double off = unit * residuals[i].norm();
        (i < n_fitted ? fitted : rest) += off * off;
        if (i < n_fitted || off < made.largest) continue;
        made.largest = off;
        made.largest_at_s = rows[i].time_s;
    }
    made.residual = std::sqrt(fitted / static_cast<double>(3 * n_fitted));
    made.rms = std::sqrt(rest / static_cast<double>(made.n_rest));
    made.period_s = with_deviation(from, 1.0 / from.rate, period_of);
    const double from_rad = (rows[n_fitted - 1].time_s - first_s) * from.rate;
    // A predicted flip may come after the last row.
    const double last_rad = 2.0 * (rows.back().time_s - first_s) * from.rate;
    if (const auto flip = flip_of(from.flight, from_rad, last_rad)) {
        made.flip_s = with_deviation(from, 1.0 / from.rate, [&](const Flight& flight) {
            return flip_of(flight, from_rad, last_rad, flip);
        });
        made.flip_s->value += first_s;
    }
    for (std::size_t i = n_fitted; i < rows.size() && !made.measured_flip_s; ++i) {
        const Eigen::Vector3d middle = from.flight.axes.col(1);
        const double a = middle.dot(rows[i - 1].omega_body), b = middle.dot(rows[i].omega_body);
        if ((a < 0.0) != (b < 0.0))
            made.measured_flip_s =
                rows[i - 1].time_s + (rows[i].time_s - rows[i - 1].time_s) * a / (a - b);
    }
    return made;
}

void check_rest(std::span<const MeasuredRow> rows, std::size_t n_fitted) {
    if (n_fitted >= rows.size())
        throw InputError(
            fmt::format("{} rows are fitted of {}, so that none is left to predict; "
                        "fit fewer",
                        n_fitted, rows.size()));
}

Flight flight_of(const FittedMotion& fit, double rate) {
    Flight flight;
    flight.moments = fit.moments;
    flight.axes = fit.instrument_from_principal;
    flight.omega = fit.omega_rad_s / rate;
    flight.drag = fit.drag;
    flight.drag_rates = fit.drag_rates / (fit.drag == DragModel::quadratic ? 1.0 : rate);
    flight.attitude = fit.attitude;
    return flight;
}

}  // namespace

Prediction predicted_alone(std::span<const MeasuredRow> rows, std::size_t n_fitted,
                           const std::optional<Eigen::Vector3d>& moments_kg_m2,
                           const std::optional<DragModel>& drag) {
    check_rest(rows, n_fitted);
    const auto first = rows.first(n_fitted);
    const FittedMotion fit = fit_motion(first, moments_kg_m2, drag, true);
    UncertainFlight from;
    from.rate = rate_of(first);
    from.flight = flight_of(fit, from.rate);
    std::optional<Eigen::Vector3d> known;
    if (moments_kg_m2) known = fit.moments;
    from.covariance =
        covariance_of(from.flight, scaled_by(first, from.rate),
                      fitted_changes(known, fit.drag, from.flight.attitude.has_value()));
    Prediction made = compared(rows, n_fitted, from);
    const FittedMotion whole = fit_motion(rows, moments_kg_m2, drag);
    made.measured_period_s = period_of(flight_of(whole, 1.0));
    return made;
}

Prediction predicted_by_others(std::span<const MeasuredRow> rows, std::size_t n_fitted,
                               const JointFit& joint, std::size_t index) {
    check_rest(rows, n_fitted);
    constexpr std::size_t least_rows = 3;
    if (n_fitted < least_rows)
        throw InputError(
            fmt::format("{} rows do not fix the start; fit {} or more", n_fitted, least_rows));
    const auto first = rows.first(n_fitted);
    UncertainFlight from;
    from.rate = rate_of(first);
    Flight& flight = from.flight;
    flight.moments = joint.moments;
    flight.axes = joint.instrument_from_principal;
    FlightChange without = FlightChange::Zero();
    without.head<n_of_body>() = joint.flights[index].change_without;
    flight = changed(flight, without);
    flight.drag = joint.drag;
    const double unit = joint.drag == DragModel::quadratic ? 1.0 : 1.0 / from.rate;
    // The drag of the other flights: their median, with their scatter.
    Eigen::Vector3d rates = Eigen::Vector3d::Zero(), scatter = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        std::vector<double> others;
        for (std::size_t i = 0; i < joint.flights.size(); ++i)
            if (i != index && joint.flights[i].left_out.empty())
                others.push_back(joint.flights[i].drag_rates[k]);
        const auto median = [](std::vector<double>& values) {
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            return *middle;
        };
        if (others.empty()) continue;
        rates[k] = median(others);
        for (double& other : others) other = std::abs(other - rates[k]);
        constexpr double of_normal = 1.4826;
        scatter[k] = of_normal * median(others);
    }
    flight.drag_rates = unit * rates;
    flight.omega = first.front().omega_body / from.rate;
    const std::vector<MeasuredRow> scaled = scaled_by(first, from.rate);
    const bool has_attitude = has_fitted_attitude(rows);
    flight = minimised(scaled, flight, fitted_start(joint.drag, false, false)).flight;
    const IsFitted is_start = fitted_start(joint.drag, has_attitude, false);
    if (has_attitude)
        flight = with_attitude(scaled, flight, attitude_noise_of(scaled), is_start).flight;

    // The start follows the body and the drag that it is fitted with.
    const FlightSquare normal = flight_sums(flight, scaled).normal;
    const std::vector<int> start_places = places_of(is_start);
    const Eigen::MatrixXd start_by =
        -solved(chosen(normal, start_places), normal(start_places, Eigen::all));
    FlightSquare known = FlightSquare::Zero();
    known.topLeftCorner<n_of_body, n_of_body>() = joint.covariance;
    const int n_drag = n_changes(joint.drag) - first_of_drag;
    for (int k = 0; k < n_drag; ++k)
        known(first_of_drag + k, first_of_drag + k) = std::pow(unit * scatter[k], 2);
    FlightSquare follows = FlightSquare::Identity();
    for (std::size_t i = 0; i < start_places.size(); ++i)
        follows.row(start_places[i]) = start_by.row(static_cast<Eigen::Index>(i));
    for (const int k : start_places) follows.col(k).setZero();
    from.covariance =
        follows * known * follows.transpose() + covariance_of(flight, scaled, is_start);
    Prediction made = compared(rows, n_fitted, from);
    // All rows, with the same body.
    const double rate = rate_of(rows);
    Flight whole = flight;
    whole.omega = flight.omega * from.rate / rate;
    whole.drag_rates = rates * (joint.drag == DragModel::quadratic ? 1.0 : 1.0 / rate);
    whole = minimised(scaled_by(rows, rate), whole, fitted_start(joint.drag, has_attitude)).flight;
    if (const auto period = period_of(whole)) made.measured_period_s = *period / rate;
    return made;
}

std::vector<Eigen::Vector3d> residuals_of(const FittedMotion& fit,
                                          std::span<const MeasuredRow> rows) {
    std::vector<Eigen::Vector3d> residuals;
    if (!fit.attitude) {
        std::vector<double> times_s;
        for (const MeasuredRow& row : rows) times_s.push_back(row.time_s);
        residuals = omega_of(fit, times_s);
        for (std::size_t i = 0; i < rows.size(); ++i)
            residuals[i] = rows[i].omega_body - residuals[i];
        return residuals;
    }
    const double rate = fit.omega_rad_s.norm();
    flight_sums(flight_of(fit, rate), scaled_by(rows, rate), &residuals);
    if (residuals.size() < rows.size())
        throw InputError(
            fmt::format("times: at {:g} s the fitted ω is too large for a number; give fewer rows",
                        rows[residuals.size()].time_s));
    for (Eigen::Vector3d& residual : residuals) residual *= -1.0;
    return residuals;
}

std::vector<Eigen::Vector3d> omega_of(const FittedMotion& fit, std::span<const double> times_s) {
    for (const double time_s : times_s)
        if (!std::isfinite(time_s))
            throw InputError("times: an instant is not finite; give seconds");
    std::vector<Eigen::Vector3d> omegas(times_s.size());
    if (fit.drag == DragModel::none || fit.drag == DragModel::linear) {
        const double damping = fit.drag == DragModel::none ? 0.0 : fit.drag_rates[0];
        const FreeRotation free(
            InertiaTensor::from_matrix(Eigen::Matrix3d(fit.moments.asDiagonal()),
                                       Physicality::waived),
            RotationState{0.0, Eigen::Quaterniond::Identity(),
                          fit.instrument_from_principal.transpose() * fit.omega_rad_s});
        for (std::size_t i = 0; i < times_s.size(); ++i) {
            // With the torque −γL, ω(t) = e^(−γt) ω_free((1 − e^(−γt))/γ).
            const double t = times_s[i] - fit.first_time_s, x = damping * t;
            const double slowed = std::abs(x) < 1e-12 ? t : -std::expm1(-x) / damping;
            omegas[i] = fit.instrument_from_principal *
                        (std::exp(-x) * free.sample(slowed, {.attitude = false}).state.omega_body);
            if (!omegas[i].allFinite())
                throw InputError(
                    fmt::format("times: at {:g} s the fitted ω is too large for a number; give "
                                "later instants",
                                times_s[i]));
        }
        return omegas;
    }
    std::vector<std::size_t> order(times_s.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [times_s](std::size_t a, std::size_t b) { return times_s[a] < times_s[b]; });
    const double rate = fit.omega_rad_s.norm();
    std::vector<double> times{0.0};  // where the flight begins
    for (const std::size_t i : order) times.push_back((times_s[i] - fit.first_time_s) * rate);
    if (times.size() > 1 && times[1] < 0.0)
        throw InputError(
            fmt::format("times: {:g} s is before the first row, and a motion with {} drag is "
                        "followed forwards; give instants from {:g} s on",
                        times_s[order.front()], name_of(fit.drag), fit.first_time_s));
    const std::vector<Eigen::Vector3d> found = flight_omega(flight_of(fit, rate), times);
    if (found.size() < times.size())
        throw InputError(
            fmt::format("times: {:g} s is too long after the rows before it for a motion with {} "
                        "drag; give instants nearer to them",
                        times_s[order[found.size() - 1]], name_of(fit.drag)));
    for (std::size_t k = 0; k < order.size(); ++k) omegas[order[k]] = rate * found[k + 1];
    return omegas;
}

}  // namespace poinsot
