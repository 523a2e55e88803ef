#include "measured/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "error/error.h"
#include "measured/flight_fit.h"
#include "measured/flight_model.h"
#include "measured/table_faults.h"
#include "numerics/small_solvers.h"

namespace poinsot {

namespace {

constexpr std::size_t most_rows = 20'000;
constexpr double most_turn_rad = 0.5;         // from row to row
constexpr double least_whole_turn_rad = 0.1;  // from the first row to the last

[[noreturn]] void throw_no_motion(const std::string& off) {
    throw InputError(fmt::format(
        "no free motion of a rigid body comes near these rows: the best is off by {}; cut the "
        "table to the time in which the body is free, and check units and axes",
        off));
}
[[noreturn]] void throw_no_motion(double off_rad_s, double rate_rad_s) {
    throw_no_motion(fmt::format("{:.3g} rad/s of {:.3g}", off_rad_s, rate_rad_s));
}
[[noreturn]] void throw_undetermined() {
    throw InputError(
        "the rows do not determine the moments: bodies with other moments would give the same "
        "ω(t); "
        "measure a motion in which the axis of rotation moves farther through the body, or measure "
        "for longer");
}
[[noreturn]] void throw_no_body(double excess, double sd) {
    throw InputError(fmt::format(
        "no rigid body has the moments that fit these rows best, since I1 exceeds I2 + I3 by "
        "{:.2g} ± {:.1g} of I1; check units and axes, cut the table to the time in which the body "
        "is free, or measure a motion in which the axis of rotation moves farther through the "
        "body",
        excess, sd));
}
constexpr double most_noise_share = 0.3;  // of the rate

// Refuses rows that are noise, and a turn about one axis, which says nothing about the moments:
// whatever ω is besides is noise.
void check_wandering(std::span<const MeasuredRow> rows) {
    const double noise = noise_of(rows), rate = rate_of(rows);
    if (noise > most_noise_share * rate) throw_no_motion(noise, rate);
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const MeasuredRow& row : rows) squares += row.omega_body * row.omega_body.transpose();
    // Not from the eigenvalues: those of constant ω are 0 but for the rounding of the largest.
    const Eigen::Vector3d axis = eigenpairs_of(squares).vectors.col(2);
    double squares_beside = 0.0, squares_of_steps = 0.0;
    for (const MeasuredRow& row : rows)
        squares_beside += (row.omega_body - axis.dot(row.omega_body) * axis).squaredNorm();
    const double beside = std::sqrt(squares_beside / 2.0 / static_cast<double>(rows.size()));
    // Rounded values that change slowly scatter less from row to row than they are wrong.
    for (int k = 0; k < 3; ++k)
        if (const double step = resolution_of(rows, k); std::isfinite(step))
            squares_of_steps += step * step;
    const double rounding = std::sqrt(squares_of_steps / 3.0 / 12.0);
    constexpr double least_share = 1e-5, least_noises = 3.0;
    if (!(beside > std::max(least_noises * std::max(noise, rounding), least_share * rate)))
        throw InputError(
            "the rows do not determine the moments: but for noise the body turns about one axis; "
            "measure a motion whose axis of rotation wanders through the body");
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
    if (rows.size() < least_fitted_rows)
        throw InputError(fmt::format("{} about a motion; give {} or more",
                                     rows.size() == 1
                                         ? "1 row says too little"
                                         : fmt::format("{} rows say too little", rows.size()),
                                     least_fitted_rows));
    const double rate = rate_of(rows);
    if (!(rate > 0.0))
        throw InputError("ω is zero in all rows: a body at rest says nothing about its moments");
    if (!std::isfinite(rate)) throw InputError("ω is too large to be squared; give it in rad/s");
    // A gyroscope at rest: what it says fits a body as well as another.
    if ((rows.back().time_s - rows.front().time_s) * rate < least_whole_turn_rad)
        throw InputError(
            "the body turns by less than a tenth of a radian in these rows, which says nothing "
            "about "
            "its moments; measure a motion of half a turn or more");
    std::size_t n_far = 0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        n_far += (rows[i].time_s - rows[i - 1].time_s) * rate > most_turn_rad;
    if (2 * n_far > rows.size())
        throw InputError(
            fmt::format("the body turns by more than half a radian from one row to the next; "
                        "sample it at {:.3g} Hz or more",
                        2.0 * rate));
}

// The residual of a flight, with as many degrees of freedom as its fitted numbers leave.
double residual_left_by(const FoundFlight& found, const std::vector<MeasuredRow>& rows,
                        const std::optional<Eigen::Vector3d>& moments) {
    return residual_of(
        found, rows.size(),
        count(fitted_changes(moments, found.flight.drag, found.flight.attitude.has_value())));
}

// The flight with the drag that describes the rows best, and all that were tried, if linear drag
// does not describe the rows to their noise.
struct ChosenDrag {
    FoundFlight best;
    std::vector<FoundFlight> tried{};
};
ChosenDrag with_chosen_drag(const FoundFlight& linear, const std::vector<MeasuredRow>& rows,
                            const std::optional<Eigen::Vector3d>& moments, double noise,
                            bool goes_on) {
    constexpr double like_noise = 1.2, rounding_of_rows = 1e-6;
    const auto left_by = [&](const FoundFlight& found) {
        return residual_left_by(found, rows, moments);
    };
    ChosenDrag chosen{linear};
    if (!(left_by(linear) > std::max(like_noise * noise, rounding_of_rows))) return chosen;
    for (const DragModel drag : {DragModel::axes, DragModel::quadratic, DragModel::growing}) {
        if (goes_on && drag == DragModel::growing) continue;
        const FoundFlight richer = with_drag(rows, linear, drag, moments);
        if (left_by(richer) < left_by(chosen.best)) chosen.best = richer;
        chosen.tried.push_back(richer);
    }
    return chosen;
}

// How far another flight lies from this one: as a change of its body and start.
FlightChange change_to(const Flight& from, const Flight& to) {
    FlightChange change = FlightChange::Zero();
    for (int k = 0; k < 2; ++k) change[k] = std::log(to.moments[k + 1] / from.moments[k + 1]);
    Eigen::Matrix3d axes = to.axes;
    for (int k = 0; k < 3; ++k)
        if (axes.col(k).dot(from.axes.col(k)) < 0.0) axes.col(k) *= -1.0;
    const Eigen::Matrix3d turn = from.axes.transpose() * axes;
    change.segment<3>(2) = 0.5 * Eigen::Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                                                 turn(1, 0) - turn(0, 1));
    change.segment<3>(first_of_omega) = to.omega - from.omega;
    if (from.attitude && to.attitude)
        change.tail<3>() = *from.attitude * turn_between(*from.attitude, *to.attitude);
    return change;
}

// Drags that leave nearly as little say other numbers. No torque of the air is one of them exactly:
// the standard deviations grow by their scatter about the chosen one, to which a drag adds the less
// the more it leaves.
void add_scatter_of_drags(const ChosenDrag& chosen, const Flight& flight, FlightChange& sd) {
    FlightChange squares = FlightChange::Zero();
    double n = 0.0;
    for (const FoundFlight& other : chosen.tried) {
        const double share = chosen.best.squares / other.squares;
        if (!(share > 0.0)) continue;
        squares += share * share * change_to(flight, in_order(other.flight)).cwiseAbs2();
        n += share * share;
    }
    if (n > 0.0) sd = (sd.cwiseAbs2() + squares / n).cwiseSqrt().eval();
}

// Standard deviations of a flight's numbers, and the correlation of its residuals.
struct FlightErrors {
    FlightChange sd = FlightChange::Zero();
    double correlation = 0.0;
};

// Throws InputError if the rows do not determine the flight.
FlightErrors errors_of(const FoundFlight& found, const std::vector<MeasuredRow>& rows,
                       const std::optional<Eigen::Vector3d>& moments) {
    FlightErrors errors;
    const Flight& flight = found.flight;
    const std::vector<int> places =
        places_of(fitted_changes(moments, flight.drag, flight.attitude.has_value()));
    std::vector<Eigen::Vector3d> residuals;
    const Eigen::MatrixXd normal = chosen(flight_sums(flight, rows, &residuals).normal, places);
    // Scaled, so that units do not matter.
    const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) throw_undetermined();
    const Eigenpairs eigen = eigenpairs_of(scale.asDiagonal() * normal * scale.asDiagonal());
    constexpr double least_eigenvalue = 1e-13;
    if (!(eigen.values[0] > least_eigenvalue)) throw_undetermined();
    if (!moments && is_on_separatrix(flight)) throw_undetermined();
    errors.correlation = correlation_of(residuals);
    const Eigen::MatrixXd spread =
        chosen(flight_sums(flight, rows, nullptr, errors.correlation).spread, places);
    const Eigen::MatrixXd inverse =
        eigen.vectors * eigen.values.cwiseInverse().asDiagonal() * eigen.vectors.transpose();
    const Eigen::MatrixXd scaled_spread = scale.asDiagonal() * spread * scale.asDiagonal();
    const Eigen::MatrixXd taken = inverse * scaled_spread;
    const Eigen::MatrixXd covariance = taken * inverse;
    const double residual = std::sqrt(variance_of(found.squares, rows.size(), taken.trace()));
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        errors.sd[places[k]] = residual * std::sqrt(std::max(covariance(i, i), 0.0)) * scale[i];
    }
    return errors;
}

// With linear drag, to ω or to attitudes. `noise`: of what is fitted.
FoundFlight linear_fit(const std::vector<MeasuredRow>& rows, double rate, double noise,
                       const std::optional<Eigen::Vector3d>& moments) {
    const double omega_noise = noise_of(rows);
    FoundFlight linear = best_fit(rows, omega_noise, moments);
    if (!has_fitted_attitude(rows)) return linear;
    // Differences are wrong by some percent.
    constexpr double most_start_share = 0.2;
    const double left = residual_left_by(linear, rows, moments);
    if (!(left < std::max(most_start_share, 1.5 * omega_noise))) throw_no_motion(left * rate, rate);
    return with_attitude(rows, linear.flight, noise,
                         fitted_changes(moments, DragModel::linear, true));
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
        case DragModel::growing:
            return "growing";
        default:
            return "linear";
    }
}

FittedMotion fit_motion(std::span<const MeasuredRow> all,
                        const std::optional<Eigen::Vector3d>& moments_kg_m2,
                        const std::optional<DragModel>& wanted, bool goes_on) {
    std::optional<Eigen::Vector3d> moments = moments_kg_m2;
    if (moments) std::sort(moments->begin(), moments->end(), std::greater<>());
    if (moments) check_known_moments(*moments);
    check(all);
    const std::vector<MeasuredRow> unscaled = thinned(all);
    check(unscaled);
    check_wandering(unscaled);
    const double rate = rate_of(unscaled);
    const double noise = fitted_noise_of(unscaled, rate);
    const std::vector<MeasuredRow> rows = scaled_by(unscaled, rate);

    const FoundFlight linear = linear_fit(rows, rate, noise, moments);
    const ChosenDrag chosen_drag = wanted ? ChosenDrag{with_drag(rows, linear, *wanted, moments)}
                                          : with_chosen_drag(linear, rows, moments, noise, goes_on);
    FoundFlight best = chosen_drag.best;
    best.flight = in_order(best.flight);
    if (moments) best.flight.moments = *moments / (*moments)[0];
    const Flight& flight = best.flight;
    const double residual = residual_left_by(best, rows, moments);
    const bool has_attitude = flight.attitude.has_value();
    const double most_residual = has_attitude ? most_residual_rad : most_residual_share;
    if (!(residual < std::max(most_residual, 1.5 * noise))) {
        if (has_attitude) throw_no_motion(fmt::format("{:.3g} rad in the attitude", residual));
        throw_no_motion(residual * rate, rate);
    }
    const double unit = has_attitude ? 1.0 : rate;  // of residuals

    auto [sd, correlation] = errors_of(best, rows, moments);
    add_scatter_of_drags(chosen_drag, flight, sd);
    if (moments) sd.head<2>().setZero();

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
    fit.drag_rates_sd = drag_unit * sd.segment<3>(first_of_drag);
    if (flight.drag == DragModel::none) fit.drag_rates.setZero();
    if (flight.drag == DragModel::linear) {
        fit.drag_rates.setConstant(fit.drag_rates[0]);
        fit.drag_rates_sd.setConstant(fit.drag_rates_sd[0]);
    }
    fit.attitude = flight.attitude;
    fit.attitude_sd_rad = sd.segment<3>(first_of_attitude);
    fit.residual = unit * root_mean_square_of(best.squares, rows.size());
    fit.linear_residual = unit * root_mean_square_of(linear.squares, rows.size());
    fit.correlation = correlation;
    fit.n_rows = rows.size();
    fit.noise = unit * noise;
    if (constexpr double most = 0.25; !(fit.moments_sd.maxCoeff() < most)) throw_undetermined();
    constexpr double least_sds = 3.0;
    const double excess_sd = std::hypot(fit.moments_sd[1], fit.moments_sd[2]);
    if (!moments && excess_of(fit) > std::max(most_excess, least_sds * excess_sd))
        throw_no_body(excess_of(fit), excess_sd);
    return fit;
}

double excess_of(const FittedMotion& fit) {
    const double excess = excess_of(fit.moments);
    constexpr double rounding = 1e-12;  // of a plate's moments
    return std::abs(excess) < rounding ? 0.0 : excess;
}

void check_known_moments(const Eigen::Vector3d& moments_kg_m2) {
    Eigen::Vector3d moments = moments_kg_m2;
    std::sort(moments.begin(), moments.end(), std::greater<>());
    if (moments[0] == moments[2])
        throw InputError(
            "the three moments are equal: every axis of such a body is a principal axis, and its ω "
            "does not change");
    if (excess_of(moments) > most_excess)
        throw InputError(fmt::format(
            "no rigid body has these moments, since {} + {} < {}; give the moments about its three "
            "principal axes through the centre of mass",
            moments[1], moments[2], moments[0]));
}

}  // namespace poinsot
