#include "measured/departure.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "mechanics/motion_errors.h"

namespace poinsot {

namespace {

// The angle between two vectors, accurate for small ones (W. Kahan, "How futile are mindless
// assessments of roundoff", §12: 2 atan2(|a|b| − b|a||, |a|b| + b|a||)).
double tilt_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d u = a.normalized(), v = b.normalized();
    return 2.0 * std::atan2((u - v).norm(), (u + v).norm());
}

void keep_larger(std::optional<double>& kept, const std::optional<double>& other) {
    if (other && (!kept || std::abs(*other) > std::abs(*kept))) kept = other;
}

void keep_larger(DepartureAt& kept, const DepartureAt& other) {
    keep_larger(kept.attitude_rad, other.attitude_rad);
    keep_larger(kept.omega_rad_s, other.omega_rad_s);
    keep_larger(kept.omega_share, other.omega_share);
    keep_larger(kept.energy_share, other.energy_share);
    keep_larger(kept.momentum_share, other.momentum_share);
    keep_larger(kept.momentum_tilt_rad, other.momentum_tilt_rad);
}

}  // namespace

Departure::Departure(const Motion& motion)
    : motion_(&motion), tensor_body_(motion.problem().inertia.matrix_body()) {
    is_free_ = turns_freely(motion.problem());
    if (!is_free_) return;
    const FreeRotationConstants constants = motion.free_constants();
    energy_J_ = constants.kinetic_energy_J;
    momentum_space_ = constants.momentum_space;
}

void Departure::add(const MeasuredRow& row, bool has_omega, bool has_attitude) {
    const Quantities wanted{.attitude = has_attitude};
    const RotationState exact = motion_->sample(row.time_s, wanted).state;
    DepartureAt at;
    at.time_s = row.time_s;
    if (has_attitude) at.attitude_rad = angle_between(exact.space_from_body, row.space_from_body);
    if (has_omega) {
        const double scale = exact.omega_body.norm();
        at.omega_rad_s = (row.omega_body - exact.omega_body).norm();
        at.omega_share = *at.omega_rad_s / (scale > 0.0 ? scale : 1.0);
    }
    if (has_omega && is_free_) {
        const Eigen::Vector3d momentum = tensor_body_ * row.omega_body;
        at.energy_share = 0.5 * momentum.dot(row.omega_body) / energy_J_ - 1.0;
        at.momentum_share = momentum.norm() / momentum_space_.norm() - 1.0;
        if (has_attitude && !momentum.isZero(0.0))
            at.momentum_tilt_rad = tilt_between(row.space_from_body * momentum, momentum_space_);
    }
    note(at);
}

void Departure::note(const DepartureAt& at) {
    if (n_rows_++ == 0) first_time_s_ = at.time_s;
    last_ = at;
    const auto take = [&at](Peak& peak, const std::optional<double>& value) {
        if (value) peak.take(std::abs(*value), at.time_s);
    };
    take(attitude_rad_, at.attitude_rad);
    take(omega_share_, at.omega_share);
    take(energy_share_, at.energy_share);
    take(momentum_share_, at.momentum_share);
    take(momentum_tilt_rad_, at.momentum_tilt_rad);

    // Places of a power of two of rows: when there are too many, neighbours become one.
    constexpr std::size_t most_places = 512;
    if (rows_in_last_ == rows_a_place_ || outline_.empty()) {
        if (outline_.size() == most_places) {
            for (std::size_t i = 0; 2 * i < outline_.size(); ++i) {
                const DepartureAt second = outline_[2 * i + 1];
                outline_[i] = outline_[2 * i];
                keep_larger(outline_[i], second);
                outline_[i].time_s = second.time_s;
            }
            outline_.resize(most_places / 2);
            rows_a_place_ *= 2;
        }
        outline_.push_back(at);
        rows_in_last_ = 1;
        return;
    }
    keep_larger(outline_.back(), at);
    outline_.back().time_s = at.time_s;
    ++rows_in_last_;
}

}  // namespace poinsot
