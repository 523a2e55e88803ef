#include "measured/joint_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "error/error.h"
#include "measured/flight_fit.h"
#include "measured/flight_model.h"

namespace poinsot {

namespace {

// A flight in units of its rate.
struct JointPart {
    std::vector<MeasuredRow> rows;
    double rate = 0.0, noise = 0.0;
    double weight = 1.0;
    Flight flight;
    double squares = 0.0;
};

// Numbers that all flights share, at most the body's five and three of the drag, and those of one.
using Shared = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;
using SharedSquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;
using Mixed = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 6>;
using Own = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using OwnSquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

struct JointPlaces {
    std::vector<int> shared, own;
};

JointPlaces joint_places(const std::optional<Eigen::Vector3d>& moments, DragModel drag,
                         bool shares_drag) {
    JointPlaces places;
    for (const int k : places_of(fitted_changes(moments, drag))) {
        const bool is_shared = k < n_of_body || (shares_drag && k >= first_of_drag);
        (is_shared ? places.shared : places.own).push_back(k);
    }
    return places;
}

// A flight's sums for the shared numbers after its own numbers are eliminated.
struct Reduced {
    SharedSquare normal;
    Shared gradient;
    Mixed mixed;
    Own own_gradient;
    Eigen::LDLT<OwnSquare> own_normal;
    double squares = 0.0;
};

// Shared drag rates have the units of the table, those of a flight its own.
double drag_unit(const JointPart& part, DragModel drag) {
    return drag == DragModel::quadratic ? 1.0 : 1.0 / part.rate;
}

FlightSums weighted_sums(const JointPart& part, const Flight& flight, bool shares_drag,
                         std::vector<Eigen::Vector3d>* residuals = nullptr,
                         double correlation = 0.0) {
    FlightSums sums = flight_sums(flight, part.rows, residuals, correlation);
    FlightChange units = FlightChange::Ones();
    if (shares_drag) units.tail<3>().setConstant(drag_unit(part, flight.drag));
    sums.squares *= part.weight;
    sums.gradient = (part.weight * units.cwiseProduct(sums.gradient)).eval();
    sums.normal = (part.weight * units.asDiagonal() * sums.normal * units.asDiagonal()).eval();
    sums.spread = (part.weight * units.asDiagonal() * sums.spread * units.asDiagonal()).eval();
    return sums;
}

Reduced reduced(const FlightSums& sums, const JointPlaces& places, double trust) {
    const auto n = static_cast<Eigen::Index>(places.shared.size());
    const auto m = static_cast<Eigen::Index>(places.own.size());
    const auto shared = [&places](Eigen::Index i) {
        return places.shared[static_cast<std::size_t>(i)];
    };
    const auto own = [&places](Eigen::Index i) { return places.own[static_cast<std::size_t>(i)]; };
    Reduced made;
    made.squares = sums.squares;
    SharedSquare normal(n, n);
    Mixed mixed(n, m);
    OwnSquare own_normal(m, m);
    made.gradient.resize(n);
    made.own_gradient.resize(m);
    for (Eigen::Index i = 0; i < n; ++i) {
        made.gradient[i] = sums.gradient[shared(i)];
        for (Eigen::Index k = 0; k < n; ++k) normal(i, k) = sums.normal(shared(i), shared(k));
        for (Eigen::Index k = 0; k < m; ++k) mixed(i, k) = sums.normal(shared(i), own(k));
    }
    for (Eigen::Index i = 0; i < m; ++i) {
        made.own_gradient[i] = sums.gradient[own(i)];
        for (Eigen::Index k = 0; k < m; ++k) own_normal(i, k) = sums.normal(own(i), own(k));
        own_normal(i, i) *= 1.0 + trust + 1e-12;
    }
    made.own_normal.compute(own_normal);
    made.mixed = mixed;
    made.normal = normal - mixed * made.own_normal.solve(Mixed(mixed).transpose());
    made.gradient -= mixed * made.own_normal.solve(made.own_gradient);
    return made;
}

struct JointMinimum {
    std::vector<JointPart> parts;
    double squares = std::numeric_limits<double>::infinity();
};

// Levenberg's and Marquardt's method; the numbers of each flight are eliminated.
JointMinimum minimised_together(std::vector<JointPart> parts, const JointPlaces& places,
                                bool shares_drag) {
    constexpr int most_steps = 60;
    constexpr double least_gain = 1e-9, most_trust = 1e10;
    double trust = 1e-3;
    const auto n = static_cast<Eigen::Index>(places.shared.size());
    for (int n_steps = 0; n_steps < most_steps; ++n_steps) {
        std::vector<Reduced> all;
        all.reserve(parts.size());
        SharedSquare normal = SharedSquare::Zero(n, n);
        Shared gradient = Shared::Zero(n);
        double squares = 0.0;
        for (const JointPart& part : parts) {
            all.push_back(reduced(weighted_sums(part, part.flight, shares_drag), places, trust));
            normal += all.back().normal;
            gradient += all.back().gradient;
            squares += all.back().squares;
        }
        normal.diagonal() *= 1.0 + trust;
        const Shared step = normal.ldlt().solve(-gradient);
        if (!std::isfinite(squares) || !step.allFinite()) return {parts, squares};
        std::vector<JointPart> next = parts;
        double there = 0.0;
        for (std::size_t f = 0; f < parts.size(); ++f) {
            const Own own = -all[f].own_normal.solve(
                Own(all[f].own_gradient + all[f].mixed.transpose() * step));
            FlightChange by = FlightChange::Zero();
            for (std::size_t k = 0; k < places.shared.size(); ++k)
                by[places.shared[k]] = step[static_cast<Eigen::Index>(k)];
            if (shares_drag) by.tail<3>() *= drag_unit(parts[f], parts[f].flight.drag);
            for (std::size_t k = 0; k < places.own.size(); ++k)
                by[places.own[k]] = own[static_cast<Eigen::Index>(k)];
            next[f].flight = changed(parts[f].flight, by);
            there += flight_sums(next[f].flight, next[f].rows).squares * next[f].weight;
        }
        if (there < squares) {
            const double gain = 1.0 - there / squares;
            parts = std::move(next);
            trust = std::max(0.1 * trust, 1e-9);
            if (gain < least_gain) return {parts, there};
        } else {
            trust *= 8.0;
            if (trust > most_trust) return {parts, squares};
        }
    }
    double squares = 0.0;
    for (const JointPart& part : parts)
        squares += part.weight * flight_sums(part.flight, part.rows).squares;
    return {parts, squares};
}

double median_in(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

using BodyNumbers = Eigen::Matrix<double, 5, 1>;
constexpr std::array<const char*, 5> names_of_body{
    "I2/I1", "I3/I1", "axes (turned about e1)", "axes (turned about e2)", "axes (turned about e3)"};

// ln I2, ln I3 and small turns from a reference.
BodyNumbers numbers_of(const FittedMotion& fit, const FittedMotion& reference) {
    Eigen::Matrix3d axes = fit.instrument_from_principal;
    for (int k = 0; k < 3; ++k)
        if (axes.col(k).dot(reference.instrument_from_principal.col(k)) < 0.0) axes.col(k) *= -1.0;
    const Eigen::Matrix3d turn = reference.instrument_from_principal.transpose() * axes;
    BodyNumbers numbers;
    numbers << std::log(fit.moments[1]), std::log(fit.moments[2]), 0.5 * (turn(2, 1) - turn(1, 2)),
        0.5 * (turn(0, 2) - turn(2, 0)), 0.5 * (turn(1, 0) - turn(0, 1));
    return numbers;
}
BodyNumbers deviations_of(const FittedMotion& fit) {
    BodyNumbers sd;
    sd << fit.moments_sd[1] / fit.moments[1], fit.moments_sd[2] / fit.moments[2], fit.axes_sd_rad;
    return sd;
}

// The index of the flight whose ratios lie nearest to the medians.
std::size_t most_typical(const std::vector<JointFlight>& flights) {
    std::vector<double> second, third;
    for (const JointFlight& flight : flights)
        if (flight.own) {
            second.push_back(std::log(flight.own->moments[1]));
            third.push_back(std::log(flight.own->moments[2]));
        }
    if (second.empty()) return 0;
    const double middle_2 = median_in(second), middle_3 = median_in(third);
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < flights.size(); ++i) {
        if (!flights[i].own) continue;
        const double off = std::hypot(std::log(flights[i].own->moments[1]) - middle_2,
                                      std::log(flights[i].own->moments[2]) - middle_3);
        if (off < least) {
            least = off;
            best = i;
        }
    }
    return best;
}

// Says of each flight that is far from the others why it is left out.
void leave_outliers_out(std::vector<JointFlight>& flights, const FittedMotion& reference) {
    std::vector<std::size_t> with_own;
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (flights[i].own) with_own.push_back(i);
    constexpr std::size_t least_flights = 5;
    if (with_own.size() < least_flights) return;
    std::vector<double> farthest(flights.size(), 0.0);
    for (int k = 0; k < 5; ++k) {
        std::vector<double> values, distances;
        for (const std::size_t i : with_own)
            values.push_back(numbers_of(*flights[i].own, reference)[k]);
        const double middle = median_in(values);
        for (const double value : values) distances.push_back(std::abs(value - middle));
        constexpr double of_normal = 1.4826;
        const double scatter = of_normal * median_in(distances);
        for (std::size_t j = 0; j < with_own.size(); ++j) {
            const std::size_t i = with_own[j];
            const double sd = std::hypot(scatter, deviations_of(*flights[i].own)[k]);
            const double off = sd > 0.0 ? distances[j] / sd : 0.0;
            if (!(off > outlier_deviations) || off < farthest[i]) continue;
            farthest[i] = off;
            flights[i].left_out =
                fmt::format("its {} {} {:.2g} deviations from the median",
                            names_of_body[static_cast<std::size_t>(k)], k < 2 ? "is" : "are", off);
        }
    }
}

// Start and drag of a flight of this body.
FoundFlight fitted_start_of(const JointPart& part, const Flight& body, DragModel drag) {
    Flight start = body;
    start.omega = part.rows.front().omega_body;
    start.drag = DragModel::linear;
    start.drag_rates.setZero();
    FoundFlight found = minimised(part.rows, start, fitted_start(DragModel::linear));
    if (drag == DragModel::linear) return found;
    start = found.flight;
    start.drag = drag;
    start.drag_rates = first_rates(drag, found.flight.drag_rates[0]);
    return minimised(part.rows, start, fitted_start(drag));
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

}  // namespace

JointFit fit_together(std::span<const std::span<const MeasuredRow>> all,
                      const std::optional<Eigen::Vector3d>& moments_kg_m2,
                      const std::optional<DragModel>& wanted, bool shares_drag) {
    std::optional<Eigen::Vector3d> moments = moments_kg_m2;
    if (moments) std::sort(moments->begin(), moments->end(), std::greater<>());
    JointFit joint;
    std::string last_refusal;
    for (const auto& rows : all) {
        JointFlight flight;
        try {
            flight.own = fit_motion(rows, moments_kg_m2, wanted, true);
        } catch (const InputError& error) {
            last_refusal = error.what();
        }
        joint.flights.push_back(std::move(flight));
    }
    const std::size_t typical = most_typical(joint.flights);
    if (joint.flights.empty() || !joint.flights[typical].own)
        throw InputError(joint.flights.empty() ? "there is no flight to fit" : last_refusal);
    const FittedMotion& reference = *joint.flights[typical].own;
    leave_outliers_out(joint.flights, reference);

    Flight body;
    body.moments = moments ? Eigen::Vector3d(*moments / (*moments)[0]) : reference.moments;
    body.axes = reference.instrument_from_principal;
    std::vector<JointPart> parts(all.size());
    std::vector<std::size_t> used;
    constexpr double most_share = 0.05;
    for (std::size_t i = 0; i < all.size(); ++i) {
        JointPart& part = parts[i];
        JointFlight& flight = joint.flights[i];
        part.rate = rate_of(all[i]);
        part.noise = noise_of(all[i]) / part.rate;
        part.rows = scaled_by(all[i], part.rate);
        const FoundFlight found = fitted_start_of(part, body, DragModel::axes);
        part.flight = found.flight;
        const double share = residual_of(found, part.rows.size(), 6);
        const double residual = flight.own ? flight.own->residual_rad_s / part.rate : share;
        // A flight that this body describes as well counts, whatever body it has alone.
        if (share < outlier_residuals * residual) flight.left_out.clear();
        if (flight.left_out.empty() && !(share < most_share))
            flight.left_out = "no motion of the body of the others comes near it";
        constexpr double rounding = 1e-9;
        part.weight = 1.0 / std::pow(std::max(residual, rounding), 2);
        if (flight.left_out.empty()) used.push_back(i);
    }
    if (used.size() < 2)
        throw InputError("fewer than two flights are of one body; fit them one by one");

    std::vector<JointPart> counted;
    counted.reserve(used.size());
    for (const std::size_t i : used) counted.push_back(parts[i]);
    // As in fit_motion: a richer drag where linear drag does not describe the rows to their noise.
    JointMinimum best =
        fitted_with(counted, body, wanted.value_or(DragModel::linear), moments, shares_drag);
    DragModel drag = wanted.value_or(DragModel::linear);
    const auto is_like_noise = [&] {
        double squares = 0.0, noises = 0.0;
        for (const JointPart& part : best.parts) {
            squares += std::pow(residual_in(part, 4), 2) * part.weight;
            noises += std::pow(part.noise, 2) * part.weight;
        }
        constexpr double like_noise = 1.2;
        return squares < like_noise * like_noise * noises;
    };
    if (!wanted && !is_like_noise())
        for (const DragModel richer : {DragModel::axes, DragModel::quadratic}) {
            JointMinimum other = fitted_with(counted, body, richer, moments, shares_drag);
            if (!(other.squares < best.squares)) continue;
            best = std::move(other);
            drag = richer;
        }
    // All parts have the same body; put it in order once, with the drag along its axes.
    for (JointPart& part : best.parts) part.flight = in_order(part.flight);
    body = best.parts.front().flight;
    if (moments) body.moments = *moments / (*moments)[0];

    const JointPlaces places = joint_places(moments, drag, shares_drag);
    const auto n = static_cast<Eigen::Index>(places.shared.size());
    const int n_own = static_cast<int>(places.own.size());
    SharedSquare normal = SharedSquare::Zero(n, n), within = normal, between = normal;
    std::vector<Reduced> pieces;
    for (std::size_t f = 0; f < used.size(); ++f) {
        JointPart& part = best.parts[f];
        part.flight.moments = body.moments;
        std::vector<Eigen::Vector3d> residuals;
        flight_sums(part.flight, part.rows, &residuals);
        const double residual = residual_in(part, n_own);
        const FlightSums sums =
            weighted_sums(part, part.flight, shares_drag, nullptr, correlation_of(residuals));
        const Reduced piece = reduced(sums, places, 0.0);
        normal += piece.normal;
        // The scores of the shared numbers, free of those of the flight: P s with P = (1, −BC⁻¹).
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> free(n, most_flight_changes);
        free.setZero();
        const Mixed taken = piece.own_normal.solve(Mixed(piece.mixed).transpose()).transpose();
        for (Eigen::Index i = 0; i < n; ++i) {
            free(i, places.shared[static_cast<std::size_t>(i)]) = 1.0;
            for (Eigen::Index k = 0; k < taken.cols(); ++k)
                free(i, places.own[static_cast<std::size_t>(k)]) = -taken(i, k);
        }
        within += free * sums.spread * free.transpose() * (part.weight * residual * residual);
        pieces.push_back(piece);
    }
    const SharedSquare inverse = normal.ldlt().solve(SharedSquare::Identity(n, n));
    const auto n_used = static_cast<double>(used.size());
    for (std::size_t f = 0; f < used.size(); ++f) {
        const SharedSquare others = normal - pieces[f].normal;
        // The step to the minimum without this flight.
        const Shared step = others.ldlt().solve(pieces[f].gradient);
        between += step * step.transpose() * ((n_used - 1.0) / n_used);
        for (std::size_t k = 0; k < places.shared.size(); ++k)
            if (places.shared[k] < n_of_body)
                joint.flights[used[f]].change_without[places.shared[k]] =
                    step[static_cast<Eigen::Index>(k)];
    }
    SharedSquare covariance = inverse * within * inverse;
    Shared sd = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    if (constexpr std::size_t least_flights = 3; used.size() >= least_flights) {
        Shared larger = Shared::Ones(n);
        for (Eigen::Index k = 0; k < n; ++k)
            if (sd[k] > 0.0 && between(k, k) > sd[k] * sd[k])
                larger[k] = std::sqrt(between(k, k)) / sd[k];
        covariance = (larger.asDiagonal() * covariance * larger.asDiagonal()).eval();
        sd = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    }
    if (!sd.allFinite())
        throw InputError(
            "the flights do not determine the body; give some whose axis of rotation "
            "moves farther through the body");

    FlightChange shared_sd = FlightChange::Zero();
    for (std::size_t i = 0; i < places.shared.size(); ++i) {
        shared_sd[places.shared[i]] = sd[static_cast<Eigen::Index>(i)];
        for (std::size_t k = 0; k < places.shared.size(); ++k)
            if (places.shared[i] < n_of_body && places.shared[k] < n_of_body)
                joint.covariance(places.shared[i], places.shared[k]) =
                    covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
    }
    joint.moments = body.moments;
    joint.moments_sd =
        Eigen::Vector3d(0.0, body.moments[1] * shared_sd[0], body.moments[2] * shared_sd[1]);
    if (moments) joint.I1_kg_m2 = (*moments)[0];
    joint.instrument_from_principal = body.axes;
    joint.axes_sd_rad = shared_sd.segment<3>(2);
    joint.drag = drag;
    joint.shares_drag = shares_drag && drag != DragModel::none;
    joint.drag_rates = best.parts.front().flight.drag_rates / drag_unit(best.parts.front(), drag);
    joint.drag_rates_sd = shared_sd.tail<3>();
    const auto with_one_rate = [drag](Eigen::Vector3d& rates) {
        if (drag == DragModel::linear) rates.setConstant(rates[0]);
        if (drag == DragModel::none) rates.setZero();
    };
    with_one_rate(joint.drag_rates);
    with_one_rate(joint.drag_rates_sd);
    joint.n_used = used.size();
    double squares = 0.0;
    for (std::size_t i = 0, f = 0; i < all.size(); ++i) {
        JointFlight& flight = joint.flights[i];
        JointPart part = parts[i];
        if (flight.left_out.empty())
            part = best.parts[f++];
        else
            part.flight = fitted_start_of(part, body, drag).flight;
        flight.first_time_s = all[i].front().time_s;
        flight.omega_rad_s = part.rate * part.flight.omega;
        flight.drag_rates = part.flight.drag_rates / drag_unit(part, drag);
        with_one_rate(flight.drag_rates);
        flight.rate_rad_s = part.rate;
        flight.residual_rad_s = part.rate * residual_in(part, n_own);
        flight.n_rows = part.rows.size();
        if (!flight.left_out.empty()) continue;
        squares += std::pow(flight.residual_rad_s, 2) * static_cast<double>(flight.n_rows);
        joint.n_rows += flight.n_rows;
    }
    joint.residual_rad_s = std::sqrt(squares / static_cast<double>(joint.n_rows));
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
    motion.residual_rad_s = flight.residual_rad_s;
    motion.n_rows = flight.n_rows;
    return motion;
}

}  // namespace poinsot
