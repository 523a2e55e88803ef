// The space panel: the inertia ellipsoid rolling on the invariable plane, viewed from outside.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "drawing/figures/elements/elements.h"
#include "drawing/figures/elements/figure_elements.h"
#include "drawing/figures/elements/object_shapes.h"
#include "drawing/figures/elements/sweep.h"
#include "drawing/figures/elements/user_marks.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/framing.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// Ends of elements beside the ellipsoid, for a camera at this azimuth.
std::vector<Eigen::Vector3d> points_aside(const Panel& panel, double azimuth_deg) {
    const StageContext& stage = *panel.stage;
    const Eigen::Vector3d right =
        Eigen::Vector3d::UnitZ().cross(direction_of(azimuth_deg, 0.0)).normalized();
    std::vector<Eigen::Vector3d> points;
    if (is_shown(stage, "precession")) {
        points.emplace_back(
            is_shown(stage, "plane")
                ? Eigen::Vector3d(-1.45 * stage.rolling->normal)
                : Eigen::Vector3d(momentum_tip(*stage.rolling) + 0.45 * stage.rolling->normal));
    }
    if (is_shown(stage, "levels")) {
        points.emplace_back(1.75 * right);
        points.emplace_back(1.75 * right + 1.1 * stage.rolling->normal);
    }
    if (is_shown(stage, "gradient")) {
        const double radius = stage.rolling->herpolhode_radius;
        for (const double side : {radius, -radius}) {
            points.emplace_back(side * right + stage.rolling->foot() +
                                0.72 * stage.rolling->normal);
        }
    }
    if (is_shown(stage, "distance")) points.emplace_back(1.6 * right);
    return points;
}

SweptShapes swept_shapes(const Panel& panel) {
    const StageContext& stage = *panel.stage;
    SweptShapes shapes;
    shapes.spin_axis = is_shown(stage, "spin-axis");
    const bool turn = is_shown(stage, "turn");
    const Eigen::Matrix3d& axes = stage.rolling->construction.inertia().body_from_principal();
    for (int i = 0; i < 3; ++i) {
        if (turn || is_shown(stage, "given-axes"))
            shapes.tips.emplace_back(given_axis_length * axes.row(i).transpose());
        if (turn) shapes.tips.emplace_back(given_axis_length * Eigen::Vector3d::Unit(i));
    }
    if (turn) shapes.tips.emplace_back(turn_axis_length * Eigen::AngleAxisd(axes).axis());
    return shapes;
}

// A camera towards the figure, aimed so that the figure is above the caption, and moved back if the
// figure would not fit.
Camera framing_camera(const Panel& panel, const CameraPose& pose) {
    const Eigen::Vector3d towards_eye = direction_of(pose.azimuth_deg, pose.elevation_deg);
    const double field_rad = pose.field_deg * std::numbers::pi / 180.0;

    // The plane continues behind the caption; the figure on it does not.
    const double per_px = 2.0 * pose.distance * std::tan(0.5 * field_rad) / panel.box.height_px;
    const double label = 1.4 * label_em_px(panel) * per_px;
    std::vector<Eigen::Vector3d> points =
        swept_points(*panel.stage->rolling, swept_shapes(panel),
                     pose.azimuth_deg * std::numbers::pi / 180.0, label);
    for (const Eigen::Vector3d& point : points_aside(panel, pose.azimuth_deg)) {
        points.push_back(point);
    }
    const double gap = 14.0 * panel.px;
    Margins margins{gap, gap, gap + panel.header_px, gap};
    const StageOptions& picture = panel.stage->options;
    if (panel.box.height_px == picture.height_px) {
        const OverlayBands& bands = panel.overlays;
        margins.bottom_px += bands.bottom_px;
        // The figure is centred: a long title is above it, a short one beside it.
        if (bands.title_right_px > 0.38 * picture.width_px) margins.top_px += bands.top_px;
    }
    margins.bottom_px = std::min(margins.bottom_px, 0.4 * panel.box.height_px);
    Camera camera = framed(panel, towards_eye, up_of(pose), field_rad, points, margins);
    const double distance = (camera.eye - camera.target).norm();
    camera.eye += std::max(0.0, pose.distance - distance) * towards_eye;
    return camera;
}

// The camera of a pose: framing the figure, aimed as given, or interpolated between both.
Camera camera_of(const Panel& panel, const CameraPose& pose) {
    const Eigen::Vector3d towards_eye = direction_of(pose.azimuth_deg, pose.elevation_deg);
    Camera told;
    told.vertical_field_rad = pose.field_deg * std::numbers::pi / 180.0;
    told.up = up_of(pose);
    told.target = pose.target;
    told.eye = told.target + pose.distance * towards_eye;
    if (!(pose.framing > 0.0)) return told;
    Camera camera = framing_camera(panel, pose);
    if (pose.framing >= 1.0) return camera;
    const double distance = (camera.eye - camera.target).norm();
    camera.target += (1.0 - pose.framing) * (told.target - camera.target);
    camera.eye = camera.target +
                 distance * std::pow(pose.distance / distance, 1.0 - pose.framing) * towards_eye;
    return camera;
}

// Sets the first camera of the film, and how it moves. The size of a pixel is that of the nearest
// camera, so that curves have their accuracy throughout.
void aim_along(Panel& panel) {
    const Timeline& timeline = timeline_of(panel);
    const Camera first = camera_of(panel, timeline.camera_at(0.0));
    aim(panel, first);
    if (!timeline.camera_moves()) return;
    constexpr int n_looks = 64;
    double units_per_px = panel.units_per_px;
    for (int k = 1; k <= n_looks; ++k) {
        aim(panel, camera_of(panel, timeline.camera_at(timeline.last_key_s() * k / n_looks)));
        units_per_px = std::min(units_per_px, panel.units_per_px);
    }
    panel.camera = projected(panel, first);
    panel.units_per_px = units_per_px;
    panel.camera_at = [&panel](double film_s) {
        return projected(panel, camera_of(panel, timeline_of(panel).camera_at(film_s)));
    };
}

// Marks on the ellipsoid and in space, and on the body if it is shown inside.
Drawer make_marks(Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const std::vector<MarkSpec>& marks = stage.scene.marks;
    const bool has_body = is_shown(stage, "body") &&
                          std::any_of(marks.begin(), marks.end(),
                                      [](const MarkSpec& mark) { return mark.on == "body"; });
    const double picture_per_m =
        has_body ? body_in_ellipsoid(*stage.rolling) / body_shape(panel, store).reach_m : 0.0;
    return make_user_marks(
        panel, store,
        [&stage, has_body, picture_per_m](
            const MarkSpec& mark, const RotationState& state) -> std::optional<Eigen::Vector3d> {
            if (mark.on == "space") return mark.at;
            const ConstructionPicture& picture = *stage.rolling;
            const Eigen::Quaterniond turn = picture.picture_from_space * state.space_from_body;
            if (mark.on == "ellipsoid") return turn * on_ellipsoid(picture, mark);
            if (!has_body) return std::nullopt;
            return turn * (picture_per_m * on_body_m(stage.scene, mark));
        });
}

}  // namespace

void make_space_panel(Panel& panel, StageStore& store) {
    aim_along(panel);

    std::vector<Drawer> drawers{make_shown_elements(panel, store, uses_elements)};
    if (!panel.stage->scene.marks.empty())
        drawers.emplace_back(
            [marks = make_marks(panel, store)](const FrameInput& instant, ViewBuilder& builder) {
                marks(instant, builder);
                name_shapes("marks", builder);
            });
    panel.draw = [drawers](const FrameInput& instant, ViewBuilder& builder) {
        for (const Drawer& draw : drawers) draw(instant, builder);
    };
}

}  // namespace poinsot
