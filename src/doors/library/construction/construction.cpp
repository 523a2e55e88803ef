#include "library/poinsot/construction.h"

#include <cmath>
#include <utility>

#include "construction/certificate.h"
#include "construction/flips.h"
#include "construction/poinsot_construction.h"
#include "construction/polhode.h"
#include "error/error.h"
#include "library/mechanics/motion_access.h"

namespace poinsot::library {

struct Construction::Impl {
    Motion shared;
    const poinsot::Motion& motion;  // of `shared`
    PoinsotConstruction geometry;
    poinsot::Polhode polhode;
};

namespace {

constexpr int most_flips = 1'000'000;

const poinsot::Motion& free_motion(const Motion& motion) {
    const poinsot::Motion& inside = MotionAccess::in(motion);
    if (!std::holds_alternative<poinsot::NoTorque>(inside.problem().torque))
        throw InputError(
            "construction: Poinsot's construction belongs to a motion without torque; this one has "
            "a torque");
    return inside;
}

}  // namespace

Construction::Construction(const Motion& motion) {
    const poinsot::Motion& free = free_motion(motion);
    const MotionProblem& problem = free.problem();
    PoinsotConstruction geometry(problem.inertia, problem.start);
    impl_ = std::make_shared<const Impl>(
        Impl{motion, free, std::move(geometry),
             poinsot::Polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix)});
}

Eigen::Vector3d Construction::half_axes() const { return impl_->geometry.half_axes(); }
double Construction::plane_distance() const { return impl_->geometry.plane_distance(); }
Eigen::Vector3d Construction::normal_space() const { return impl_->geometry.normal_space(); }

ContactPoint Construction::contact(double time_s) const {
    const RotationState state = impl_->motion.at(time_s);
    return {.body = impl_->geometry.contact_body(state.omega_body),
            .space = impl_->geometry.contact_space(state)};
}

Polhode Construction::polhode(double tolerance) const {
    if (!(tolerance > 0.0) || !std::isfinite(tolerance))
        throw InputError(
            "polhode: the tolerance must be a positive number; give a length such as "
            "1e-3 of plane_distance()");
    Polhode polhode;
    polhode.closed = impl_->polhode.closed();
    polhode.points = impl_->polhode.sampled(tolerance, &polhode.largest_distance);
    return polhode;
}

std::vector<Eigen::Vector3d> Construction::herpolhode(std::span<const double> times_s) const {
    std::vector<Eigen::Vector3d> points;
    points.reserve(times_s.size());
    for (const double time_s : times_s) {
        const MotionSample sample =
            impl_->motion.sample(time_s, {.attitude = false, .herpolhode = true});
        points.push_back(impl_->geometry.contact_in_plane(sample.herpolhode_space));
    }
    return points;
}

Construction::Radii Construction::herpolhode_radii() const {
    const poinsot::Polhode::Annulus annulus = impl_->polhode.annulus();
    return {annulus.inner, annulus.outer};
}

std::optional<Cones> Construction::cones() const {
    const MotionProblem& problem = impl_->motion.problem();
    const auto cones = rolling_cones(problem.inertia, problem.start.omega_body);
    if (!cones) return std::nullopt;
    return Cones{.symmetry_axis = cones->symmetry_axis,
                 .body_half_angle_rad = cones->body_half_angle_rad,
                 .space_half_angle_rad = cones->space_half_angle_rad,
                 .body_precession_rad_s = cones->body_precession_rad_s,
                 .space_precession_rad_s = cones->space_precession_rad_s};
}

std::vector<double> Construction::flips(double first_time_s, double last_time_s) const {
    if (!std::isfinite(first_time_s) || !std::isfinite(last_time_s))
        throw InputError("flips: the ends of the interval must be finite numbers");
    const auto flips = flips_of(impl_->motion.problem(), impl_->motion.free_constants());
    if (!flips) return {};
    std::vector<double> times = flips->between(first_time_s, last_time_s, most_flips + 1);
    if (times.size() > static_cast<std::size_t>(most_flips))
        throw InputError(
            "flips: there are more than a million in the interval; give a shorter one");
    return times;
}

Residuals Construction::residuals(double time_s) const {
    const RollingResiduals r = impl_->geometry.residuals(impl_->motion.at(time_s));
    return {.contact_plane_gap = r.contact_plane_gap,
            .tangency_gap = r.tangency_gap,
            .slip = r.slip,
            .momentum = r.momentum,
            .energy = r.energy,
            .unit_quaternion = r.unit_quaternion};
}

Certificate Construction::certificate(std::span<const double> times_s,
                                      double attitude_error_rad) const {
    if (!(attitude_error_rad > 0.0))
        throw InputError("certificate: the attitude error must be a positive number of radians");
    const bool stepped = impl_->motion.integrated() != nullptr;
    const poinsot::Certificate certified =
        certify(impl_->motion, times_s, stepped ? attitude_error_rad : exact_residual_bound);
    Certificate certificate;
    certificate.holds = certified.holds();
    for (const CertifiedClaim& claim : certified.claims)
        certificate.claims.push_back({.name = std::string(claim.name),
                                      .means = std::string(claim.means),
                                      .worst = claim.worst,
                                      .at_time_s = claim.at_time_s,
                                      .bound = claim.bound,
                                      .n_measured = static_cast<std::size_t>(claim.n_measured)});
    return certificate;
}

}  // namespace poinsot::library
