#include "drawing/figures/elements/body_axes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace poinsot {

Eigen::Matrix3d principal_from_body(const Panel& panel) {
    return panel.stage->rolling->construction.inertia().body_from_principal().transpose();
}

Eigen::Vector3d rho_in_principal_axes(const Panel& panel, const FrameInput& instant) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    return principal_from_body(panel) * picture.contact_body(instant.state.omega_body) *
           picture.picture_per_rho;
}

Eigen::Vector3d momentum_direction(const Panel& panel, const Eigen::Vector3d& contact_body) {
    const Eigen::Vector3d moments = panel.stage->rolling->construction.inertia().moments_kg_m2();
    return moments.cwiseProduct(principal_from_body(panel) * contact_body).stableNormalized();
}

Eigen::Vector3d principal_view_direction(const Panel& panel) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    // The axis that the polhode encircles, or, for a polhode that is a point, the nearest axis.
    const Eigen::Vector3d rho = (principal_from_body(panel) * picture.polhode.at(0.0))
                                    .cwiseQuotient(picture.construction.half_axes());
    int axis = picture.polhode.encircled_axis();
    if (picture.polhode.kind() == Polhode::Kind::point) rho.cwiseAbs().maxCoeff(&axis);

    struct Place {
        double azimuth_deg, elevation_deg;
    };
    constexpr std::array<Place, 3> places{{{26.0, 20.0}, {62.0, 20.0}, {32.0, 36.0}}};
    const Place& place = places[static_cast<std::size_t>(axis)];
    Eigen::Vector3d direction = direction_of(place.azimuth_deg, place.elevation_deg);
    direction[axis] = std::copysign(direction[axis], rho[axis]);
    return direction;
}

void aim_in_principal_axes(Panel& panel, std::vector<Eigen::Vector3d> points,
                           const Margins& margins) {
    if (panel.user_timeline) {
        aim_around(panel, std::move(points), margins);
    } else {
        const double field_rad = panel.stage->scene.camera.field_deg * std::numbers::pi / 180.0;
        aim(panel, framed(panel, principal_view_direction(panel), Eigen::Vector3d::UnitZ(),
                          field_rad, points, margins));
    }
    light_from_camera(panel);
}

void light_from_camera(Panel& panel) {
    const Eigen::Vector3d eye = panel.camera.eye - panel.camera.target;
    const Eigen::Vector3d usual = direction_of(CameraSpec{}.azimuth_deg, 0.0);
    const double turn = std::atan2(eye.y(), eye.x()) - std::atan2(usual.y(), usual.x());
    panel.light.towards = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * panel.light.towards;
}

}  // namespace poinsot
