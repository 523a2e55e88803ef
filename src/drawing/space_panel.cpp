// The space panel: the inertia ellipsoid rolling on the invariable plane, seen from outside.
#include <algorithm>
#include <numbers>
#include <vector>

#include "drawing/elements.h"
#include "drawing/framing.h"
#include "drawing/overlay.h"
#include "drawing/panel.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// The scene's camera about the vertical L, aimed so that the construction fills the panel. A panel
// that is narrow for its height is seen from farther away.
Camera camera_of(const CameraSpec& spec, const PanelBox& box, double plane_distance) {
    constexpr double least_aspect = 1.3;
    const double aspect = 1.0 * box.width_px / box.height_px;
    const double distance = spec.distance * std::max(1.0, least_aspect / aspect);
    Camera camera;
    camera.target = spec.target.value_or(Eigen::Vector3d(0.0, 0.0, 0.5 * (1.42 - plane_distance)));
    camera.eye = camera.target + distance * direction_of(spec.azimuth_deg, spec.elevation_deg);
    camera.vertical_field_rad = spec.field_deg * std::numbers::pi / 180.0;
    return camera;
}

}  // namespace

void make_space_panel(Panel& panel) {
    const ConstructionPicture& picture = *panel.stage->rolling;
    aim(panel, camera_of(panel.stage->scene.camera, panel.box, picture.plane_distance));

    // The elements that the scene names, or those that this kind of motion shows by itself.
    const std::vector<std::string>& show = panel.stage->scene.show;
    for (const std::string& name : show) {
        if (is_overlay(name)) continue;
        at_scene_key(panel.stage->scene, "show", [&] { element_named(name); });
    }
    std::vector<Drawer> drawers;
    for (const Element& element : elements()) {
        const bool named = std::find(show.begin(), show.end(), element.name) != show.end();
        if (show.empty() ? element.by_default(*panel.stage) : named) {
            panel.asks = united(panel.asks, element.asks);
            drawers.push_back(element.make(panel));
        }
    }
    panel.draw = [drawers](const Instant& instant, Sheet& sheet) {
        for (const Drawer& draw : drawers) draw(instant, sheet);
    };
}

}  // namespace poinsot
