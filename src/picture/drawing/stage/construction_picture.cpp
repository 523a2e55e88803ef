#include "drawing/stage/construction_picture.h"

#include <cmath>

#include "numerics/least_turn.h"

namespace poinsot {

ConstructionPicture::ConstructionPicture(const MotionProblem& problem, std::string_view plane)
    : construction(problem.inertia, problem.start),
      polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix),
      cones(rolling_cones(problem.inertia, problem.start.omega_body)) {
    picture_per_rho = 1.0 / construction.half_axes().maxCoeff();
    half_axes = construction.half_axes() * picture_per_rho;
    plane_distance = construction.plane_distance() * picture_per_rho;
    herpolhode_radius = polhode.annulus().outer * picture_per_rho;
    picture_from_space = least_turn(construction.normal_space(), Eigen::Vector3d::UnitZ());
    normal = Eigen::Vector3d::UnitZ();
    if (plane == "below") {
        const Eigen::Quaterniond half_turn_about_x(0.0, 1.0, 0.0, 0.0);
        picture_from_space = half_turn_about_x * picture_from_space;
        normal = -normal;
    }
}

Eigen::Quaterniond ConstructionPicture::picture_from_body(const FrameInput& instant) const {
    return picture_from_space * instant.state.space_from_body;
}

Eigen::Matrix3d ConstructionPicture::principal_axes(const FrameInput& instant) const {
    return picture_from_body(instant).toRotationMatrix() *
           construction.inertia().body_from_principal();
}

Eigen::Vector3d ConstructionPicture::contact(const FrameInput& instant) const {
    const Eigen::Vector3d rho =
        picture_from_space * construction.contact_space(instant.state) * picture_per_rho;
    return dissipates ? Eigen::Vector3d(rho * rho_growth(instant.state.omega_body)) : rho;
}

Eigen::Vector3d ConstructionPicture::foot(const FrameInput& instant) const {
    return dissipates ? Eigen::Vector3d(foot() * plane_approach(instant.state.omega_body)) : foot();
}

double ConstructionPicture::plane_approach(const Eigen::Vector3d& omega_body) const {
    if (!dissipates) return 1.0;
    if (!is_slowed) return 1.0 / rho_growth(omega_body);
    // |Jρ| = L/√(2T).
    const double slope = (construction.inertia().matrix_body() * contact_body(omega_body)).norm();
    return 1.0 / (slope * construction.plane_distance());
}

double ConstructionPicture::rho_growth(const Eigen::Vector3d& omega_body) const {
    if (!dissipates) return 1.0;
    // F(ω/√(2T(0))) = T/T(0).
    const Eigen::Vector3d rho = construction.contact_body(omega_body);
    return 1.0 / std::sqrt(rho.dot(construction.inertia().matrix_body() * rho));
}

Eigen::Vector3d ConstructionPicture::contact_body(const Eigen::Vector3d& omega_body) const {
    if (!dissipates) return construction.contact_body(omega_body);
    return construction.contact_body(omega_body) * rho_growth(omega_body);
}

}  // namespace poinsot
