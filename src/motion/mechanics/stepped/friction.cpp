#include "mechanics/stepped/friction.h"

#include <algorithm>
#include <cmath>

#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

using Eigen::Vector3d;

// Mean and variance of the weights over the squares of a direction's components: X and |n × Jn|² in
// units of the range of J. The variance as a sum of squares keeps its digits near an axis.
double mean_of(const Vector3d& weight, const Vector3d& squares) { return weight.dot(squares); }

double variance_of(const Vector3d& weight, const Vector3d& squares) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double apart = weight[i] - weight[j];
        sum += squares[i] * squares[j] * apart * apart;
    }
    return sum;
}

// X(to) − X(from), from the components that are small.
double rise(const Vector3d& weight, const Vector3d& from, const Vector3d& to) {
    const Vector3d change = (to - from).cwiseProduct(to + from);
    if (2.0 * mean_of(weight, from.cwiseAbs2()) <= 1.0) return weight.dot(change);
    return -(Vector3d::Ones() - weight).dot(change);
}

// The direction n moved along the steepest descent of X, n exp(−s w) normalised, until X is that of
// `start` times exp(−decay). X(s) falls throughout, with slope −2 variance: s is found by Newton's
// method, and between the nearest values on both sides where that would leave them.
Vector3d descended(const Vector3d& weight, const Vector3d& start, const Vector3d& n, double decay) {
    // Quadratic convergence: a correction this small leaves an error below rounding, and one that
    // turns n by no more than its last place is rounding.
    constexpr double last_correction = 1e-9;
    constexpr double last_turn_rad = 4e-16;
    constexpr double longest_correction = 2.0;
    constexpr int most_corrections = 60;
    const double before = mean_of(weight, start.cwiseAbs2());
    const double lost = -before * std::expm1(-decay);
    double least_s = -HUGE_VAL;
    double greatest_s = HUGE_VAL;
    Vector3d moved = n;
    double s = 0.0;
    for (int k = 0; k < most_corrections; ++k) {
        const Vector3d squares = moved.cwiseAbs2();
        const double variance = variance_of(weight, squares);
        if (!(variance > 0.0)) break;
        const double above = 2.0 * lost < before
                                 ? rise(weight, start, moved) + lost
                                 : mean_of(weight, squares) - before * std::exp(-decay);
        (above > 0.0 ? least_s : greatest_s) = s;
        double next =
            s + std::clamp(above / (2.0 * variance), -longest_correction, longest_correction);
        if (!(next > least_s && next < greatest_s)) next = 0.5 * (least_s + greatest_s);
        const double correction = next - s;
        if (!std::isfinite(correction)) break;
        s = next;
        for (int i = 0; i < 3; ++i) moved[i] = n[i] * std::exp(-s * weight[i]);
        moved.normalize();
        if (std::abs(correction) <= last_correction ||
            correction * correction * variance <= last_turn_rad * last_turn_rad)
            break;
    }
    return moved;
}

}  // namespace

Friction::Friction(const MethodStart& start) : backwards_(start.step_s < 0.0) {
    acts_ = has_friction(start.dynamics.torque());
    if (!acts_) return;
    momentum_ = norm_of(start.state.momentum);
    direction_space_ = start.state.space_from_principal * start.state.momentum.stableNormalized();
    strength_1_s_ = 4.0 * start.dynamics.greatest_friction_turning_rad_s();
    // By ratios of moments, since their inverses need not be doubles.
    const Vector3d& I = start.dynamics.moments_kg_m2();
    const double least = I.minCoeff();
    const double greatest = I.maxCoeff();
    if (!(greatest > least)) return;
    for (int i = 0; i < 3; ++i) {
        const double from_least = (greatest - I[i]) / (greatest - least) * (least / I[i]);
        const double from_greatest = (I[i] - least) / (greatest - least) * (greatest / I[i]);
        weight_[i] = backwards_ ? from_greatest : from_least;
    }
}

Vector3d Friction::direction_at(const Eigen::Quaterniond& space_from_principal) const {
    return space_from_principal.normalized().conjugate() * direction_space_;
}

Vector3d Friction::momentum_at(const Eigen::Quaterniond& space_from_principal) const {
    return momentum_ * direction_at(space_from_principal);
}

double Friction::decay_1_s(const Vector3d& momentum) const {
    const Vector3d squares = (momentum / momentum_).cwiseAbs2();
    const double mean = mean_of(weight_, squares);
    return mean > 0.0 ? strength_1_s_ * variance_of(weight_, squares) / mean : 0.0;
}

double Friction::turn_of_decay_rad(const Vector3d& momentum) const {
    const Vector3d squares = (momentum / momentum_).cwiseAbs2();
    const double variance = variance_of(weight_, squares);
    return variance > 0.0 ? mean_of(weight_, squares) / (2.0 * std::sqrt(variance)) : 0.0;
}

StepState Friction::settled(const StepState& start, const Eigen::Quaterniond& attitude,
                            double decay) const {
    const Vector3d reached = direction_at(attitude);
    const Vector3d wanted =
        descended(weight_, start.momentum / momentum_, reached, std::max(decay, 0.0));
    // The least turn that takes L from where it is in the body to where it is wanted, of the axes.
    const Vector3d axis = wanted.cross(reached);
    const Eigen::Quaterniond turn(1.0 + wanted.dot(reached), axis[0], axis[1], axis[2]);
    StepState end;
    end.space_from_principal = (attitude * turn.normalized()).normalized();
    end.momentum = momentum_at(end.space_from_principal);
    return end;
}

}  // namespace poinsot
