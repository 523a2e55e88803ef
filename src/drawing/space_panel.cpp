// The space panel: the inertia ellipsoid rolling on the invariable plane, seen from outside.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drawing/elements.h"
#include "drawing/framing.h"
#include "drawing/marks.h"
#include "drawing/overlay.h"
#include "drawing/panel.h"
#include "drawing/sweep.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// The scene's camera about the vertical L. Unless the scene says where it looks, it is aimed so
// that the figure stands over the caption, and is farther away where the figure would not fit.
Camera camera_of(const Panel& panel) {
    const CameraSpec& spec = panel.stage->scene.camera;
    const Eigen::Vector3d towards_eye = direction_of(spec.azimuth_deg, spec.elevation_deg);
    Camera camera;
    camera.vertical_field_rad = field_of(panel);
    if (spec.target) {
        camera.target = *spec.target;
        camera.eye = camera.target + spec.distance * towards_eye;
        return camera;
    }

    // The plane runs on below the caption; what stands on it does not.
    const double per_px =
        2.0 * spec.distance * std::tan(0.5 * field_of(panel)) / panel.box.height_px;
    const double label = 1.4 * label_size * panel.type_px * per_px;
    const std::vector<Eigen::Vector3d> points =
        swept_points(*panel.stage->rolling, spec.azimuth_deg * std::numbers::pi / 180.0, label);
    const double gap = 14.0 * panel.px;
    Margins margins{gap, gap, gap + panel.header_px, gap};
    const StageOptions& picture = panel.stage->options;
    if (panel.box.height_px == picture.height_px)
        margins.bottom_px += overlay_bands(*panel.stage).bottom_px;
    margins.bottom_px = std::min(margins.bottom_px, 0.4 * panel.box.height_px);
    camera =
        framed(panel.box, towards_eye, Eigen::Vector3d::UnitZ(), field_of(panel), points, margins);
    const double distance = (camera.eye - camera.target).norm();
    camera.eye += std::max(0.0, spec.distance - distance) * towards_eye;
    return camera;
}

}  // namespace

void make_space_panel(Panel& panel) {
    aim(panel, camera_of(panel));

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
