#include "construction/certificate.h"

#include <algorithm>
#include <cmath>

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

// The first claims, which are distances and speeds at the ellipsoid's surface.
constexpr std::size_t n_gaps = 3;

void take(CertifiedClaim& claim, double residual, double time_s) {
    // A residual that is not a number is the worst of all.
    if (residual > claim.worst || !(residual == residual)) {
        claim.worst = residual == residual ? residual : HUGE_VAL;
        claim.at_time_s = time_s;
    }
}

}  // namespace

bool Certificate::holds() const {
    return std::all_of(claims.begin(), claims.end(),
                       [](const CertifiedClaim& claim) { return claim.holds(); });
}

Certificate certify(const Motion& motion, std::span<const double> times_s, double bound) {
    const MotionProblem& problem = motion.problem();
    const PoinsotConstruction construction(problem.inertia, problem.start);

    Certificate certificate;
    certificate.claims = {
        {"contact_plane_gap", "distance of the contact point from the plane, over the plane's"},
        {"tangency_gap",
         "distance of the ellipsoid's point of tangency from the plane, over the plane's"},
        {"slip",
         "speed of the matter where it touches the plane, over |omega| times the largest "
         "half-axis"},
        {"momentum", "drift of L as a vector in space, over |L|"},
        {"kinetic_energy", "drift of T, over T"},
        {"unit_quaternion", "deviation of the attitude's quaternion from length one"},
        {"speed_difference",
         "speed on the polhode less that on the herpolhode, over the greatest speed"},
    };
    // A turn by the bound moves the end of a long half-axis by so much more of the plane's
    // distance.
    const double reach =
        std::max(1.0, construction.half_axes().maxCoeff() / construction.plane_distance());
    for (CertifiedClaim& claim : certificate.claims) claim.bound = bound;
    for (std::size_t i = 0; i < n_gaps; ++i) certificate.claims[i].bound *= reach;
    certificate.claims.back().bound = std::max(bound, speed_difference_bound);

    // A five-hundredth of a radian at the present rate keeps the difference's own error near 1e-12.
    // Stepped motions end with the film, so the differences stay inside it.
    const double rate = problem.start.omega_body.norm();
    const double step_s = 2e-3 / rate;
    const bool stepped = motion.integrated() != nullptr;
    double greatest_speed = 0.0;
    std::vector<std::pair<double, ContactSpeeds>> speeds;

    for (const double time_s : times_s) {
        const RollingResiduals r = construction.residuals(motion.at(time_s));
        const double values[] = {r.contact_plane_gap, r.tangency_gap, r.slip,
                                 r.momentum,          r.energy,       r.unit_quaternion};
        for (std::size_t i = 0; i < std::size(values); ++i) {
            take(certificate.claims[i], values[i], time_s);
        }
        const bool inside = !stepped || (time_s - 2.0 * step_s >= problem.first_time_s &&
                                         time_s + 2.0 * step_s <= problem.last_time_s);
        if (inside) {
            speeds.emplace_back(time_s, contact_speeds(construction, motion, time_s, step_s));
            greatest_speed = std::max(
                {greatest_speed, speeds.back().second.on_body, speeds.back().second.in_space});
        }
    }
    // Where the contact point hardly moves (steady spin, a small wobble) the differences are
    // rounding, measured 4e-14 of the rate times the half-axis: a floor keeps it far below the
    // bound.
    const double least_speed = 1e-3 * rate * construction.half_axes().maxCoeff();
    for (const auto& [time_s, speed] : speeds) {
        take(certificate.claims.back(),
             std::abs(speed.on_body - speed.in_space) / std::max(greatest_speed, least_speed),
             time_s);
    }
    certificate.n_instants = static_cast<std::int64_t>(times_s.size());
    return certificate;
}

}  // namespace poinsot
