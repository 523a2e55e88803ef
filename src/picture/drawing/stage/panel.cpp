#include "drawing/stage/panel.h"

#include <cmath>

namespace poinsot {

const Timeline& timeline_of(const Panel& panel) {
    return panel.user_timeline ? *panel.user_timeline : panel.stage->timeline;
}

Camera projected(const Panel& panel, const Camera& camera) {
    if (!panel.orthographic || camera.orthographic) return camera;
    constexpr double far_off = 100.0;
    const Eigen::Vector3d sight = camera.eye - camera.target;
    Camera flat = camera;
    flat.orthographic = true;
    flat.height_units = 2.0 * sight.norm() * std::tan(0.5 * camera.vertical_field_rad);
    flat.eye = camera.target + far_off * sight.normalized();
    return flat;
}

void aim(Panel& panel, const Camera& framing) {
    const auto& views = panel.stage->options.views;
    const bool is_given = panel.index < views.size() && views[panel.index];
    const Camera& camera = is_given ? *views[panel.index] : framing;
    panel.camera = projected(panel, camera);
    const double distance = (camera.eye - camera.target).norm();
    panel.units_per_px =
        camera.orthographic
            ? camera.height_units / panel.box.height_px
            : 2.0 * distance * std::tan(0.5 * camera.vertical_field_rad) / panel.box.height_px;
}

}  // namespace poinsot
