#include "measured/joint_sums.h"

#include <algorithm>
#include <cmath>

#include "numerics/small_solvers.h"
#include "system/interrupt.h"

namespace poinsot {

JointPlaces joint_places(const std::optional<Eigen::Vector3d>& moments, DragModel drag,
                         bool shares_drag) {
    JointPlaces places;
    for (const int k : places_of(fitted_changes(moments, drag))) {
        const bool is_shared = k < n_of_body || (shares_drag && k >= first_of_drag);
        (is_shared ? places.shared : places.own).push_back(k);
    }
    return places;
}

JointPlaces JointPlaces::of(const Flight& flight) const {
    JointPlaces made = *this;
    if (flight.attitude)
        for (int k = first_of_attitude; k < most_flight_changes; ++k) made.own.push_back(k);
    return made;
}

FlightSums weighted_sums(const JointPart& part, const Flight& flight, bool shares_drag,
                         std::vector<Eigen::Vector3d>* residuals, double correlation) {
    FlightSums sums = flight_sums(flight, part.rows, residuals, correlation);
    FlightChange units = FlightChange::Ones();
    if (shares_drag) units.segment<3>(first_of_drag).setConstant(drag_unit(part, flight.drag));
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
    made.normal.resize(n, n);
    made.mixed.resize(n, m);
    made.own_normal.resize(m, m);
    made.gradient.resize(n);
    made.own_gradient.resize(m);
    for (Eigen::Index i = 0; i < n; ++i) {
        made.gradient[i] = sums.gradient[shared(i)];
        for (Eigen::Index k = 0; k < n; ++k) made.normal(i, k) = sums.normal(shared(i), shared(k));
        for (Eigen::Index k = 0; k < m; ++k) made.mixed(i, k) = sums.normal(shared(i), own(k));
    }
    for (Eigen::Index i = 0; i < m; ++i) {
        made.own_gradient[i] = sums.gradient[own(i)];
        for (Eigen::Index k = 0; k < m; ++k) made.own_normal(i, k) = sums.normal(own(i), own(k));
        made.own_normal(i, i) *= 1.0 + trust + 1e-12;
    }
    made.normal -= made.mixed * solved(made.own_normal, made.mixed.transpose());
    made.gradient -= made.mixed * solved(made.own_normal, made.own_gradient);
    return made;
}

JointMinimum minimised_together(std::vector<JointPart> parts, const JointPlaces& places,
                                bool shares_drag) {
    std::size_t n_rows = 0;
    for (const JointPart& part : parts) n_rows += part.rows.size();
    const int most_steps = steps_to_a_minimum(n_rows);
    constexpr double least_gain = 1e-9, most_trust = 1e10;
    double trust = 1e-3;
    const auto n = static_cast<Eigen::Index>(places.shared.size());
    for (int n_steps = 0; n_steps < most_steps; ++n_steps) {
        stop_if_interrupted();
        std::vector<Reduced> all;
        all.reserve(parts.size());
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
        double squares = 0.0;
        for (const JointPart& part : parts) {
            all.push_back(reduced(weighted_sums(part, part.flight, shares_drag),
                                  places.of(part.flight), trust));
            normal += all.back().normal;
            gradient += all.back().gradient;
            squares += all.back().squares;
        }
        normal.diagonal() *= 1.0 + trust;
        const Eigen::VectorXd step = solved(normal, -gradient);
        if (!std::isfinite(squares) || !step.allFinite()) return {parts, squares};
        std::vector<JointPart> next = parts;
        double there = 0.0;
        for (std::size_t f = 0; f < parts.size(); ++f) {
            const Eigen::VectorXd own =
                -solved(all[f].own_normal, all[f].own_gradient + all[f].mixed.transpose() * step);
            FlightChange by = FlightChange::Zero();
            for (std::size_t k = 0; k < places.shared.size(); ++k)
                by[places.shared[k]] = step[static_cast<Eigen::Index>(k)];
            if (shares_drag)
                by.segment<3>(first_of_drag) *= drag_unit(parts[f], parts[f].flight.drag);
            const JointPlaces its = places.of(parts[f].flight);
            for (std::size_t k = 0; k < its.own.size(); ++k)
                by[its.own[k]] = own[static_cast<Eigen::Index>(k)];
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

}  // namespace poinsot
