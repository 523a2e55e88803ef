#include "measured/joint_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "error/error.h"
#include "measured/flight_fit.h"
#include "measured/flight_model.h"
#include "measured/joint_outliers.h"
#include "measured/joint_sums.h"
#include "numerics/small_solvers.h"

namespace poinsot {

namespace {

using Flights = std::span<const std::span<const MeasuredRow>>;

[[noreturn]] void throw_undetermined_together() {
    throw InputError(
        "the flights do not determine the body; give some whose axis of rotation moves farther "
        "through the body");
}

// Start and drag of a flight of this body.
FoundFlight fitted_start_of(const JointPart& part, const Flight& body, DragModel drag) {
    Flight start = body;
    start.omega = part.rows.front().omega_body;
    start.drag = DragModel::linear;
    start.drag_rates.setZero();
    FoundFlight found = minimised(part.rows, start, fitted_start(DragModel::linear));
    const bool has_attitude = has_fitted_attitude(part.rows);
    if (has_attitude)
        found = with_attitude(part.rows, found.flight, part.noise,
                              fitted_start(DragModel::linear, true));
    if (drag == DragModel::linear) return found;
    start = found.flight;
    start.drag = drag;
    start.drag_rates = first_rates(drag, found.flight.drag_rates[0]);
    return minimised(part.rows, start, fitted_start(drag, has_attitude));
}

// The parts that count, fitted with one body and this drag.
JointMinimum fitted_with(const std::vector<JointPart>& parts, const Flight& body, DragModel drag,
                         const std::optional<Eigen::Vector3d>& moments, bool shares_drag) {
    std::vector<JointPart> starts = parts;
    Eigen::Vector3d rates = Eigen::Vector3d::Zero();
    for (JointPart& part : starts) {
        part.flight = fitted_start_of(part, body, drag).flight;
        rates +=
            part.flight.drag_rates / drag_unit(part, drag) / static_cast<double>(starts.size());
    }
    if (shares_drag)
        for (JointPart& part : starts) part.flight.drag_rates = rates * drag_unit(part, drag);
    return minimised_together(std::move(starts), joint_places(moments, drag, shares_drag),
                              shares_drag);
}

double residual_in(const JointPart& part, int n_fitted) {
    const FoundFlight found{part.flight, flight_sums(part.flight, part.rows).squares};
    return residual_of(found, part.rows.size(), n_fitted);
}

// Fits each flight alone. Throws InputError if no flight can be fitted.
std::vector<JointFlight> fitted_alone(Flights all, const std::optional<Eigen::Vector3d>& moments,
                                      const std::optional<DragModel>& wanted) {
    std::vector<JointFlight> flights;
    std::string last_refusal = "there is no flight to fit";
    for (const auto& rows : all) {
        JointFlight flight;
        try {
            flight.own = fit_motion(rows, moments, wanted, true);
        } catch (const InputError& error) {
            last_refusal = error.what();
        }
        flights.push_back(std::move(flight));
    }
    if (flights.empty() || !flights[most_typical(flights)].own) throw InputError(last_refusal);
    return flights;
}

// The flights in their own units, each with a start of this body and the weight of its residual.
// Leaves out flights that no motion of this body describes.
std::vector<JointPart> parts_of(Flights all, const Flight& body,
                                std::vector<JointFlight>& flights) {
    std::vector<JointPart> parts(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        JointPart& part = parts[i];
        JointFlight& flight = flights[i];
        part.rate = rate_of(all[i]);
        part.noise = fitted_noise_of(all[i], part.rate);
        part.rows = scaled_by(all[i], part.rate);
        const FoundFlight found = fitted_start_of(part, body, DragModel::axes);
        part.flight = found.flight;
        const bool has_attitude = part.flight.attitude.has_value();
        const double left = residual_of(found, part.rows.size(), has_attitude ? 9 : 6);
        const double unit = has_attitude ? 1.0 : part.rate;
        const double residual = flight.own ? flight.own->residual / unit : left;
        const double most = has_attitude ? most_residual_rad : most_residual_share;
        // A flight that this body describes as well counts, whatever body it has alone.
        if (left < outlier_residuals * residual) flight.left_out.clear();
        if (flight.left_out.empty() && !(left < most))
            flight.left_out = "no motion of the body of the others comes near it";
        constexpr double rounding = 1e-9;
        part.weight = 1.0 / std::pow(std::max(residual, rounding), 2);
    }
    return parts;
}

bool is_like_noise(const JointMinimum& minimum) {
    double squares = 0.0, noises = 0.0;
    for (const JointPart& part : minimum.parts) {
        squares += std::pow(residual_in(part, 4), 2) * part.weight;
        noises += std::pow(part.noise, 2) * part.weight;
    }
    constexpr double like_noise = 1.2;
    return squares < like_noise * like_noise * noises;
}

// The body that fits the parts best, and its drag.
struct FittedBody {
    std::vector<JointPart> parts;  // each with this body, its moments in order
    DragModel drag = DragModel::linear;
    Flight body;
};

// As in fit_motion: a richer drag where linear drag does not describe the rows to their noise.
FittedBody fitted_body(const std::vector<JointPart>& counted, const Flight& start,
                       const std::optional<Eigen::Vector3d>& moments,
                       const std::optional<DragModel>& wanted, bool shares_drag) {
    FittedBody fitted;
    fitted.drag = wanted.value_or(DragModel::linear);
    JointMinimum best = fitted_with(counted, start, fitted.drag, moments, shares_drag);
    if (!wanted && !is_like_noise(best))
        for (const DragModel richer : {DragModel::axes, DragModel::quadratic}) {
            JointMinimum other = fitted_with(counted, start, richer, moments, shares_drag);
            if (!(other.squares < best.squares)) continue;
            best = std::move(other);
            fitted.drag = richer;
        }
    // All parts have the same body; put it in order once, with the drag along its axes.
    for (JointPart& part : best.parts) part.flight = in_order(part.flight);
    fitted.body = best.parts.front().flight;
    if (moments) fitted.body.moments = *moments / (*moments)[0];
    for (JointPart& part : best.parts) part.flight.moments = fitted.body.moments;
    fitted.parts = std::move(best.parts);
    return fitted;
}

// Errors of the shared numbers.
struct SharedErrors {
    Eigen::MatrixXd covariance;
    Eigen::VectorXd sd;
    std::vector<Eigen::VectorXd> steps_without;  // to the minimum without one flight, for each
};

// From the scatter of the residuals within the flights and, with three flights or more, from that
// between the flights, whichever is larger. Throws InputError if the errors are infinite.
SharedErrors errors_of(const std::vector<JointPart>& parts, const JointPlaces& places,
                       bool shares_drag) {
    const auto n = static_cast<Eigen::Index>(places.shared.size());
    SharedErrors errors;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n), within = normal, between = normal;
    std::vector<Reduced> pieces;
    for (const JointPart& part : parts) {
        std::vector<Eigen::Vector3d> residuals;
        flight_sums(part.flight, part.rows, &residuals);
        const JointPlaces its = places.of(part.flight);
        const double residual = residual_in(part, static_cast<int>(its.own.size()));
        const FlightSums sums =
            weighted_sums(part, part.flight, shares_drag, nullptr, correlation_of(residuals));
        const Reduced piece = reduced(sums, its, 0.0);
        normal += piece.normal;
        // The scores of the shared numbers, free of those of the flight: P s with P = (1, −BC⁻¹).
        Eigen::MatrixXd free = Eigen::MatrixXd::Zero(n, most_flight_changes);
        const Eigen::MatrixXd taken = solved(piece.own_normal, piece.mixed.transpose()).transpose();
        for (Eigen::Index i = 0; i < n; ++i) {
            free(i, its.shared[static_cast<std::size_t>(i)]) = 1.0;
            for (Eigen::Index k = 0; k < taken.cols(); ++k)
                free(i, its.own[static_cast<std::size_t>(k)]) = -taken(i, k);
        }
        within += free * sums.spread * free.transpose() * (part.weight * residual * residual);
        pieces.push_back(piece);
    }
    const Eigen::MatrixXd inverse = solved(normal, Eigen::MatrixXd::Identity(n, n));
    const auto n_used = static_cast<double>(parts.size());
    for (const Reduced& piece : pieces) {
        const Eigen::VectorXd step = solved(normal - piece.normal, piece.gradient);
        between += step * step.transpose() * ((n_used - 1.0) / n_used);
        errors.steps_without.push_back(step);
    }
    errors.covariance = inverse * within * inverse;
    errors.sd = errors.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    if (constexpr std::size_t least_flights = 3; parts.size() >= least_flights) {
        Eigen::VectorXd larger = Eigen::VectorXd::Ones(n);
        for (Eigen::Index k = 0; k < n; ++k)
            if (errors.sd[k] > 0.0 && between(k, k) > errors.sd[k] * errors.sd[k])
                larger[k] = std::sqrt(between(k, k)) / errors.sd[k];
        errors.covariance = (larger.asDiagonal() * errors.covariance * larger.asDiagonal()).eval();
        errors.sd = errors.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    }
    if (!errors.sd.allFinite()) throw_undetermined_together();
    return errors;
}

// As of a single flight.
void check_body(const JointFit& joint) {
    constexpr double most_sd = 0.25, least_sds = 3.0;
    if (!(joint.moments_sd.maxCoeff() < most_sd)) throw_undetermined_together();
    const double sd = std::hypot(joint.moments_sd[1], joint.moments_sd[2]);
    if (const double excess = excess_of(joint.moments);
        excess > std::max(most_excess, least_sds * sd))
        throw InputError(fmt::format(
            "no rigid body has the moments that fit these flights best, since I1 exceeds I2 + I3 "
            "by {:.2g} ± {:.1g} of I1; check units and axes, and that the flights are of one body",
            excess, sd));
}

// Sets the body with its errors, and its drag.
void set_body(const FittedBody& fitted, const SharedErrors& errors, const JointPlaces& places,
              JointFit& joint) {
    FlightChange shared_sd = FlightChange::Zero();
    for (std::size_t i = 0; i < places.shared.size(); ++i) {
        shared_sd[places.shared[i]] = errors.sd[static_cast<Eigen::Index>(i)];
        for (std::size_t k = 0; k < places.shared.size(); ++k)
            if (places.shared[i] < n_of_body && places.shared[k] < n_of_body)
                joint.covariance(places.shared[i], places.shared[k]) =
                    errors.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
    }
    const Eigen::Vector3d& moments = fitted.body.moments;
    joint.moments = moments;
    joint.moments_sd = Eigen::Vector3d(0.0, moments[1] * shared_sd[0], moments[2] * shared_sd[1]);
    joint.instrument_from_principal = fitted.body.axes;
    joint.axes_sd_rad = shared_sd.segment<3>(2);
    joint.drag = fitted.drag;
    const JointPart& first = fitted.parts.front();
    joint.drag_rates = first.flight.drag_rates / drag_unit(first, fitted.drag);
    joint.drag_rates_sd = shared_sd.segment<3>(first_of_drag);
}

// Models of one rate repeat it for each axis.
void repeat_rate(DragModel drag, Eigen::Vector3d& rates) {
    if (drag == DragModel::linear) rates.setConstant(rates[0]);
    if (drag == DragModel::none) rates.setZero();
}

// Sets the numbers of a flight.
void set_flight(const JointPart& part, DragModel drag, JointFlight& flight) {
    flight.omega_rad_s = part.rate * part.flight.omega;
    flight.drag_rates = part.flight.drag_rates / drag_unit(part, drag);
    repeat_rate(drag, flight.drag_rates);
    flight.rate_rad_s = part.rate;
    flight.attitude = part.flight.attitude;
    flight.residual =
        (flight.attitude ? 1.0 : part.rate) *
        root_mean_square_of(flight_sums(part.flight, part.rows).squares, part.rows.size());
    flight.n_rows = part.rows.size();
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> repeated_flight(Flights flights) {
    // ω of three numbers with all their digits is seldom the same in two flights.
    std::vector<std::pair<std::array<double, 3>, std::size_t>> rows;  // ω and its flight
    for (std::size_t i = 0; i < flights.size(); ++i)
        for (const MeasuredRow& row : flights[i])
            rows.push_back({{row.omega_body[0], row.omega_body[1], row.omega_body[2]}, i});
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> n_common;
    for (std::size_t k = 1; k < rows.size(); ++k)
        for (std::size_t i = k; i-- > 0 && rows[i].first == rows[k].first;) {
            const std::pair both(rows[i].second, rows[k].second);
            const std::size_t shorter =
                std::min(flights[both.first].size(), flights[both.second].size());
            if (2 * ++n_common[both] > shorter) return both;
        }
    return std::nullopt;
}

JointFit fit_together(std::span<const std::span<const MeasuredRow>> all,
                      const std::optional<Eigen::Vector3d>& moments_kg_m2,
                      const std::optional<DragModel>& wanted, bool shares_drag) {
    std::optional<Eigen::Vector3d> moments = moments_kg_m2;
    if (moments) check_known_moments(*moments);
    if (moments) std::sort(moments->begin(), moments->end(), std::greater<>());
    if (const auto repeated = repeated_flight(all))
        throw InputError(fmt::format("flights {} and {} hold the same rows; give each flight once",
                                     repeated->first + 1, repeated->second + 1));
    JointFit joint;
    joint.flights = fitted_alone(all, moments_kg_m2, wanted);
    const FittedMotion& reference = *joint.flights[most_typical(joint.flights)].own;
    leave_outliers_out(joint.flights, reference);

    Flight start;
    start.moments = moments ? Eigen::Vector3d(*moments / (*moments)[0]) : reference.moments;
    start.axes = reference.instrument_from_principal;
    std::vector<JointPart> parts = parts_of(all, start, joint.flights);
    std::vector<JointPart> counted;
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (joint.flights[i].left_out.empty()) {
            used.push_back(i);
            counted.push_back(parts[i]);
        }
    if (used.size() < 2)
        throw InputError("fewer than two flights are of one body; fit them one by one");

    const FittedBody fitted = fitted_body(counted, start, moments, wanted, shares_drag);
    const JointPlaces places = joint_places(moments, fitted.drag, shares_drag);
    const SharedErrors errors = errors_of(fitted.parts, places, shares_drag);
    for (std::size_t f = 0; f < used.size(); ++f)
        for (std::size_t k = 0; k < places.shared.size(); ++k)
            if (places.shared[k] < n_of_body)
                joint.flights[used[f]].change_without[places.shared[k]] =
                    errors.steps_without[f][static_cast<Eigen::Index>(k)];

    set_body(fitted, errors, places, joint);
    if (!moments) check_body(joint);
    if (moments) joint.I1_kg_m2 = (*moments)[0];
    joint.shares_drag = shares_drag && fitted.drag != DragModel::none;
    repeat_rate(fitted.drag, joint.drag_rates);
    repeat_rate(fitted.drag, joint.drag_rates_sd);
    joint.n_used = used.size();
    // Of ω and of attitudes: squares and rows.
    double squares = 0.0, squares_rad = 0.0;
    std::size_t n_rows_rad = 0;
    for (std::size_t i = 0, f = 0; i < all.size(); ++i) {
        JointFlight& flight = joint.flights[i];
        const bool counts = flight.left_out.empty();
        if (!counts) parts[i].flight = fitted_start_of(parts[i], fitted.body, fitted.drag).flight;
        flight.first_time_s = all[i].front().time_s;
        set_flight(counts ? fitted.parts[f++] : parts[i], fitted.drag, flight);
        if (!counts) continue;
        (flight.attitude ? squares_rad : squares) +=
            std::pow(flight.residual, 2) * static_cast<double>(flight.n_rows);
        joint.n_rows += flight.n_rows;
        if (flight.attitude) n_rows_rad += flight.n_rows;
    }
    if (const std::size_t n = joint.n_rows - n_rows_rad; n > 0)
        joint.residual_rad_s = std::sqrt(squares / static_cast<double>(n));
    if (n_rows_rad > 0)
        joint.residual_rad = std::sqrt(squares_rad / static_cast<double>(n_rows_rad));
    return joint;
}

FittedMotion motion_of(const JointFit& joint, const JointFlight& flight) {
    FittedMotion motion;
    motion.first_time_s = flight.first_time_s;
    motion.omega_rad_s = flight.omega_rad_s;
    motion.moments = joint.moments;
    motion.moments_sd = joint.moments_sd;
    motion.I1_kg_m2 = joint.I1_kg_m2;
    motion.instrument_from_principal = joint.instrument_from_principal;
    motion.axes_sd_rad = joint.axes_sd_rad;
    motion.drag = joint.drag;
    motion.drag_rates = flight.drag_rates;
    motion.residual = flight.residual;
    motion.attitude = flight.attitude;
    motion.n_rows = flight.n_rows;
    return motion;
}

}  // namespace poinsot
