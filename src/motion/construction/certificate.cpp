#include "construction/certificate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "construction/polhode.h"
#include "mechanics/motion_errors.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// |dρ/dt| on the body and in space at an instant, by the central difference of order 4.
struct ContactSpeeds {
    double on_body = 0.0;
    double in_space = 0.0;
};

ContactSpeeds contact_speeds(const PoinsotConstruction& construction, const Motion& motion,
                             double time_s, double step_s) {
    Eigen::Vector3d body = Eigen::Vector3d::Zero();
    Eigen::Vector3d space = Eigen::Vector3d::Zero();
    for (const auto& [offset, weight] :
         {std::pair{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
        const RotationState state = motion.at(time_s + offset * step_s);
        body += weight * construction.contact_body(state.omega_body);
        space += weight * construction.contact_space(state);
    }
    return {body.norm() / (12.0 * step_s), space.norm() / (12.0 * step_s)};
}

// The fastest rate of the contact point's motion, rad/s: |ω| where the polhode is farthest from the
// centre, or the rate of Jacobi's functions, λ² = ω_a²(I_a − I_b)(I_a − I_c)/(I_b I_c), where ω_a
// is the largest ω along the axis that the polhode encircles. Neither is much more than |ω| at the
// start for a body that some mass distribution has; for others both may be, by orders of magnitude.
double fastest_rate(const InertiaTensor& inertia, const PoinsotConstruction& construction,
                    const MotionProblem& problem) {
    const Eigen::Vector3d& omega = problem.start.omega_body;
    const Polhode polhode(inertia, omega, problem.on_separatrix);
    const double omega_per_rho = norm_of(omega) / norm_of(construction.contact_body(omega));
    const Eigen::Vector3d side = polhode.at(0.0);
    const int a = polhode.encircled_axis();
    const double along = std::abs(inertia.body_from_principal().col(a).dot(side));
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    const double Ib = I[(a + 1) % 3], Ic = I[(a + 2) % 3];
    const double jacobi =
        along * std::sqrt(std::abs(I[a] - Ib) / Ic) * std::sqrt(std::abs(I[a] - Ic) / Ib);
    const double farthest = std::max(norm_of(side), norm_of(polhode.at(0.5 * std::numbers::pi)));
    return omega_per_rho * std::max(farthest, jacobi);
}

// Chooses where speeds are measured. The step is a power of two near a five-hundredth of a radian
// at |ω| of the start, which keeps the difference's own error near 1e-12, or near a 250th at the
// motion's fastest rate, if that is shorter.
class Differences {
 public:
    Differences(const Motion& motion, double fastest_rad_s)
        : motion_(motion),
          rate_(std::max(norm_of(motion.problem().start.omega_body), 0.5 * fastest_rad_s)) {
        const double step = 2e-3 / rate_;
        if (std::isfinite(step) && step > 0.0) step_s_ = std::exp2(std::round(std::log2(step)));
    }

    double step_s() const { return step_s_; }
    double rate() const { return rate_; }

    // The nearest instant from which whole steps lead to times that are doubles, so that no time is
    // rounded; none if a step is less than 2^20 last places of the time, or leaves the interval
    // that a stepped motion covers.
    std::optional<double> centre(double time_s) const {
        const double farthest_s = std::abs(time_s) + 2.0 * step_s_;
        if (!(step_s_ > 0.0) || !std::isfinite(farthest_s)) return std::nullopt;
        const double place_s = std::ldexp(1.0, std::max(std::ilogb(farthest_s) - 52, -1074));
        if (step_s_ < std::ldexp(place_s, 20)) return std::nullopt;
        const double centre_s = std::nearbyint(time_s / place_s) * place_s;
        // Stepped motions end with the film, so the differences stay inside it.
        const MotionProblem& problem = motion_.problem();
        const bool inside =
            motion_.integrated() == nullptr || (centre_s - 2.0 * step_s_ >= problem.first_time_s &&
                                                centre_s + 2.0 * step_s_ <= problem.last_time_s);
        return inside ? std::optional(centre_s) : std::nullopt;
    }

 private:
    const Motion& motion_;
    double rate_;
    double step_s_ = 0.0;
};

// The same body in a unit of mass in which its moments are far from the smallest doubles: the
// motion does not depend on that unit, and T and L keep their digits.
InertiaTensor lifted(const InertiaTensor& inertia) {
    constexpr int least_exponent = -900, most_exponent = 1000;
    const int least = exponent_of(inertia.moments_kg_m2().minCoeff());
    const int most = exponent_of(inertia.moments_kg_m2());
    if (least >= least_exponent) return inertia;
    const int up = std::min(least_exponent - least, most_exponent - most);
    const Eigen::Vector3d moments = ldexp(inertia.moments_kg_m2(), up);
    return inertia.body_axes_are_principal()
               ? InertiaTensor::from_principal_moments(moments, Physicality::waived)
               : InertiaTensor::from_principal_axes(moments, inertia.body_from_principal(),
                                                    Physicality::waived);
}

// The first claims are distances and speeds at the ellipsoid's surface, and these all are residuals
// of a state.
constexpr std::size_t n_gaps = 3;
constexpr std::size_t n_residuals = 6;

// The error of a stepped motion is measured at a hundred instants. Between them, the attitude error
// may be larger by at most this factor.
constexpr double most_error = 2.0;
// Relative change of an attitude error while the body turns by a radian.
// Measured 0.4 over random bodies and all methods.
constexpr double speeds_of_errors = 2.0;

// The closed form of a stepped motion, which must agree with it within the requested accuracy.
std::optional<Motion> exact_beside(const Motion& motion) {
    if (motion.integrated() == nullptr) return std::nullopt;
    MotionProblem problem = motion.problem();
    problem.method = MethodChoice{};
    return Motion(problem);
}

// First-order effects if the attitude and the direction of L in the body are each off by `error`.
// At the tip of ρ, the end of the longest half-axis a at most, with d the plane's distance:
//   L in space            turned by both:                             2
//   T                     ω·δL over T, |ω||L|/2T = |ρ|/d:             2 a/d
//   ρ over the plane      n·δρ by both, each |ρ|/d:                   2 a/d
//   the tangency          by the attitude alone:                      a/d
//   the slip              δρ/a and the turn of ω and of the tangency: 2 + 2 a/d
void set_stepped_bounds(std::vector<CertifiedClaim>& claims, double accuracy_rad, double reach) {
    const double error = most_error * accuracy_rad;
    const double bounds[] = {2.0 * reach * error,
                             reach * error,
                             (2.0 + 2.0 * reach) * error,
                             2.0 * error,
                             2.0 * reach * error,
                             exact_residual_bound,
                             0.0,  // of the speeds, once they are measured
                             error};
    for (std::size_t i = 0; i < claims.size(); ++i)
        claims[i].bound = std::max(bounds[i], exact_residual_bound);
}

void take(CertifiedClaim& claim, double residual, double time_s) {
    ++claim.n_measured;
    // A residual that is not a number counts as the largest.
    if (residual > claim.worst || !(residual == residual)) {
        claim.worst = residual == residual ? residual : HUGE_VAL;
        claim.at_time_s = time_s;
    }
}

// The claims about an exact motion, in this order: distances and speeds, the other residuals of a
// state, the speeds of the contact point. A stepped motion adds its attitude.
std::vector<CertifiedClaim> rolling_claims() {
    return {
        {"contact_plane_gap",
         "distance of the contact point from the plane, relative to the plane's distance from the "
         "centre"},
        {"tangency_gap",
         "distance of the ellipsoid's point of tangency from the plane, relative to the plane's "
         "distance from the centre"},
        {"slip",
         "speed of the body's material point at the contact, relative to |omega| times the largest "
         "half-axis"},
        {"momentum", "drift of the vector L in space, relative to |L|"},
        {"kinetic_energy", "drift of T, relative to T"},
        {"unit_quaternion", "deviation of the attitude quaternion's length from 1"},
        {"speed_difference",
         "speed on the polhode minus speed on the herpolhode, relative to the largest speed"},
    };
}

// The largest difference of the contact point's speeds on the polhode and on the herpolhode.
struct SpeedCheck {
    double greatest_speed = 0.0;
    double worst = 0.0;
    double worst_time_s = 0.0;
    std::int64_t n_measured = 0;

    void add(const ContactSpeeds& speed, double time_s) {
        const double difference = std::abs(speed.on_body - speed.in_space);
        ++n_measured;
        greatest_speed = std::max({greatest_speed, speed.on_body, speed.in_space});
        if (difference > worst || !(difference == difference)) {
            worst = difference == difference ? difference : HUGE_VAL;
            worst_time_s = time_s;
        }
    }
};

}  // namespace

bool Certificate::holds() const {
    return std::none_of(claims.begin(), claims.end(),
                        [](const CertifiedClaim& claim) { return claim.fails(); });
}

Certificate certify(const Motion& motion, std::span<const double> times_s, double bound) {
    const MotionProblem& problem = motion.problem();
    const InertiaTensor inertia = lifted(problem.inertia);
    const PoinsotConstruction construction(inertia, problem.start);

    Certificate certificate;
    certificate.claims = rolling_claims();
    // An attitude error of `bound` moves the end of a long half-axis by a larger part of the
    // plane's distance.
    const double reach =
        std::max(1.0, construction.half_axes().maxCoeff() / construction.plane_distance());
    const std::optional<Motion> truth = exact_beside(motion);
    if (truth) {
        certificate.claims.push_back(
            {"attitude", "angle from the attitude of the exact motion, in radians"});
        set_stepped_bounds(certificate.claims, bound, reach);
    } else {
        for (CertifiedClaim& claim : certificate.claims) claim.bound = bound;
        for (std::size_t i = 0; i < n_gaps; ++i) certificate.claims[i].bound *= reach;
    }

    const Differences differences(motion, fastest_rate(inertia, construction, problem));
    SpeedCheck check;
    for (const double time_s : times_s) {
        const RotationState state = motion.at(time_s);
        const RollingResiduals r = construction.residuals(state);
        const double values[] = {r.contact_plane_gap, r.tangency_gap, r.slip,
                                 r.momentum,          r.energy,       r.unit_quaternion};
        static_assert(std::size(values) == n_residuals);
        for (std::size_t i = 0; i < n_residuals; ++i) {
            take(certificate.claims[i], values[i], time_s);
        }
        if (truth)
            take(certificate.claims.back(),
                 angle_between(state.space_from_body, truth->at(time_s).space_from_body), time_s);
        const auto centre_s = differences.centre(time_s);
        if (!centre_s) continue;
        check.add(contact_speeds(construction, motion, *centre_s, differences.step_s()), time_s);
    }
    // Where the contact point hardly moves (steady spin, a small wobble) the differences are only
    // rounding, measured 4e-14 of the rate times the half-axis: a floor keeps their relative error
    // far below the bound.
    const double least_speed = 1e-3 * differences.rate() * construction.half_axes().maxCoeff();
    const double unit_speed = std::max(check.greatest_speed, least_speed);
    CertifiedClaim& speeds = certificate.claims[n_residuals];
    speeds.n_measured = check.n_measured;
    speeds.worst = check.worst > 0.0 ? check.worst / unit_speed : 0.0;
    speeds.bound = std::max(bound, speed_difference_bound);
    if (truth) {
        // The speeds differ by |Ω − ω| |ρ|, where Ω is how fast the attitude turns: its error over
        // the time in which that changes.
        const double fastest = differences.rate() * construction.half_axes().maxCoeff();
        speeds.bound = std::max(speed_difference_bound,
                                speeds_of_errors * most_error * bound * fastest / unit_speed);
    }
    speeds.at_time_s = check.worst_time_s;
    certificate.n_instants = static_cast<std::int64_t>(times_s.size());
    return certificate;
}

}  // namespace poinsot
