#include "web/module/live_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <type_traits>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/live_values.h"
#include "drawing/stage/panel.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/type/labels.h"
#include "error/error.h"
#include "production/session/picture_setting.h"
#include "production/session/scene_summary.h"
#include "scene/parse_scene.h"
#include "shapes/solids.h"
#include "text/json_text.h"
#include "text/languages.h"
#include "text/printable.h"
#include "typeset/plain_text.h"
#include "vector/picture.h"
#include "vector/svg.h"
#include "web/module/scene_of_page.h"

namespace poinsot {

namespace {

constexpr double deg = 180.0 / std::numbers::pi;

}  // namespace

Scene scene_of_page(const PageScene& files) {
    const SceneFiles bytes_of = [&files](const NamedFile& named) {
        const auto found = files.files.find(named.name);
        if (found == files.files.end())
            throw InputError(
                fmt::format("{} = \"{}\": this file is not in the page; add it, or "
                            "remove the key",
                            named.key, printable(named.name)));
        return FileBytes{named.name, found->second};
    };
    return parse_scene(files.text, files.name, overrides_of(files.overrides), bytes_of);
}

Session session_of_page(const Scene& scene, FontSource fonts) {
    SessionRequest request;
    request.fonts = std::move(fonts);
    return session_of(scene, request);
}

namespace {

Scene read(const PageScene& files, const CanvasSize& size, CanvasSize& film_size) {
    Scene scene = scene_of_page(files);
    film_size = {scene.film.width_px, scene.film.height_px};
    scene.film.width_px = size.width_px;
    scene.film.height_px = size.height_px;
    return scene;
}

// Axes in which azimuth and elevation are measured: the camera's vertical, and two that are fixed
// beside it.
Eigen::Matrix3d axes_about(const Eigen::Vector3d& up) {
    const Eigen::Vector3d z = up.normalized();
    Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    if (std::abs(z.x()) > 0.9) x = Eigen::Vector3d::UnitY();
    x = (x - x.dot(z) * z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
}

struct Direction {
    double azimuth_deg, elevation_deg;
};

Direction direction_of(const Camera& camera) {
    const Eigen::Vector3d sight =
        axes_about(camera.up).transpose() * (camera.eye - camera.target).normalized();
    return {deg * std::atan2(sight.y(), sight.x()),
            deg * std::asin(std::clamp(sight.z(), -1.0, 1.0))};
}

bool is_given(double value) { return !std::isnan(value); }

}  // namespace

PanelView panel_view(std::span<const double> n) {
    PanelView view;
    view.panel = static_cast<int>(n[0]);
    for (std::size_t k = 0; k < view_fields.size(); ++k) view.*view_fields[k].value = n[1 + k];
    return view;
}

Camera changed(const Camera& camera, const PanelView& view) {
    Camera made = camera;
    const Eigen::Vector3d sight = camera.eye - camera.target;
    double distance = sight.norm();
    Eigen::Vector3d towards_eye = sight / distance;
    if (is_given(view.azimuth_deg) || is_given(view.elevation_deg)) {
        const Direction own = direction_of(camera);
        const double azimuth =
            (is_given(view.azimuth_deg) ? view.azimuth_deg : own.azimuth_deg) / deg;
        // Short of the poles, where the picture's vertical would turn about.
        constexpr double most_deg = 89.9;
        const double elevation =
            std::clamp(is_given(view.elevation_deg) ? view.elevation_deg : own.elevation_deg,
                       -most_deg, most_deg) /
            deg;
        towards_eye = axes_about(camera.up) *
                      Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                      std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    }
    if (is_given(view.distance) && view.distance > 0.0 && !camera.orthographic)
        distance = view.distance;
    if (is_given(view.zoom) && view.zoom > 0.0) {
        if (camera.orthographic)
            made.height_units /= view.zoom;
        else
            distance /= view.zoom;
    }
    made.eye = made.target + distance * towards_eye;
    const Eigen::Matrix3d axes = camera_axes(made);  // right, up, backward
    const double height = camera.orthographic
                              ? made.height_units
                              : 2.0 * distance * std::tan(0.5 * camera.vertical_field_rad);
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    if (is_given(view.shift_x)) shift -= view.shift_x * height * axes.col(0);
    if (is_given(view.shift_y)) shift -= view.shift_y * height * axes.col(1);
    made.eye += shift;
    made.target += shift;
    if (is_given(view.roll_deg)) {
        const double roll = view.roll_deg / deg;
        made.up = std::cos(roll) * axes.col(1) - std::sin(roll) * axes.col(0);
    }
    return made;
}

LiveScene::LiveScene(const PageScene& files, FontSource fonts, const CanvasSize& size)
    : session_(session_of_page(read(files, size, film_size_), std::move(fonts))),
      grid_(session_.scene.grid),
      panels_(session_.scene.panels),
      type_scale_(session_.scene.type_scale),
      film_(film_plan(session_)) {
    resize(size);
}

void LiveScene::size_scene(const CanvasSize& size) {
    Scene& scene = session_.scene;
    scene.film.width_px = size.width_px;
    scene.film.height_px = size.height_px;
    scene.type_scale = type_scale_ * size.type_scale;
    const bool is_upright = size.height_px > size.width_px && !panels_.empty();
    scene.grid = is_upright ? GridSpec{{1.0}, {}} : grid_;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        PanelSpec& panel = scene.panels[i];
        panel.column = is_upright ? 0 : panels_[i].column;
        panel.row = is_upright ? static_cast<int>(i) : panels_[i].row;
        panel.columns = is_upright ? 1 : panels_[i].columns;
        panel.rows = is_upright ? 1 : panels_[i].rows;
        // Charts are wide.
        const bool is_chart = panel_kind_named(panel.kind).camera == CameraUse::none;
        if (is_upright) scene.grid.rows.push_back(is_chart ? 0.7 : 1.0);
    }
    session_.accuracy = accuracy_of(scene);
}

Stage LiveScene::stage_of_size(const CanvasSize& size) {
    size_scene(size);
    PictureSetting setting = setting_of(session_.scene);
    setting.samples = 1;
    return stage_of(session_, {film_.time_of(0), film_.last_time_s(), {}}, setting);
}

void LiveScene::resize(const CanvasSize& size) {
    stage_.emplace(stage_of_size(size));
    size_ = size;
}

void LiveScene::set_views(const std::vector<PanelView>& views) {
    cameras_.clear();
    cameras_.resize(stage_->panels().size());
    for (const PanelView& view : views) {
        if (!has_panel(view.panel)) continue;
        cameras_[static_cast<std::size_t>(view.panel)] = [view](const Camera& camera) {
            return changed(camera, view);
        };
    }
}

bool LiveScene::has_panel(int panel) const {
    return panel >= 0 && static_cast<std::size_t>(panel) < stage_->panels().size();
}

FilmTime LiveScene::moment_of(double time_s, double film_s) const {
    if (is_given(film_s)) return {time_s, film_s};
    return moment_of_time(film_.clock, time_s);
}

std::vector<Camera> LiveScene::cameras_at(const FilmTime& moment) const {
    const Drawing drawing = drawing_at(moment);
    std::vector<Camera> cameras;
    for (std::size_t k = 0; k < stage_->panels().size(); ++k)
        cameras.push_back(drawing.views[k].camera);
    return cameras;
}

void LiveScene::hold(const std::vector<Camera>& cameras) {
    held_.clear();
    if (cameras.size() != stage_->panels().size()) return;
    for (const Camera& camera : cameras)
        held_.emplace_back([camera](const Camera&) { return camera; });
}

namespace {

constexpr auto is_beside = [](const auto& shape) { return shape.name.element == "body-beside"; };

// Replaces the shapes of the body beside the construction by those of another instant.
void exchange_beside(View& view, View& later) {
    // Both views have the same lists in the same order.
    std::vector<void*> lists;
    for_each_list(later, [&lists](auto& list) { lists.push_back(&list); });
    auto next = lists.begin();
    for_each_list(view, [&next](auto& list) {
        auto& from = *static_cast<std::remove_reference_t<decltype(list)>*>(*next++);
        std::erase_if(list, is_beside);
        std::copy_if(from.begin(), from.end(), std::back_inserter(list), is_beside);
    });
}

}  // namespace

Drawing LiveScene::drawing_at(const FilmTime& moment, double beside_later_s) const {
    const std::vector<CameraChange>& cameras = held_.empty() ? cameras_ : held_;
    Drawing drawing = stage_->at(moment, cameras);
    if (!(beside_later_s > 0.0)) return drawing;
    Drawing later = stage_->at({moment.time_s + beside_later_s, moment.film_s}, cameras);
    for (std::size_t k = 0; k < drawing.views.size(); ++k)
        exchange_beside(drawing.views[k], later.views[k]);
    return drawing;
}

Drawing LiveScene::drawing_of_size(const FilmTime& moment, int width_px, int height_px) {
    picture_stage_.emplace(stage_of_size({width_px, height_px}));
    size_scene(size_);
    return picture_stage_->at(moment, cameras_);
}

std::vector<double> LiveScene::digits_at(double time_s) const {
    const bool is_top = session_.motion.regime() == Regime::heavy_top;
    const MotionSample sample = session_.motion.sample(
        time_s, {.attitude = true, .herpolhode = true, .euler_angles = is_top});
    const Eigen::Vector3d &omega = sample.state.omega_body, &herpolhode = sample.herpolhode_space;
    const Eigen::Quaterniond& q = sample.state.space_from_body;
    std::vector<double> digits{omega[0], omega[1], omega[2],      q.w(),         q.x(),
                               q.y(),    q.z(),    herpolhode[0], herpolhode[1], herpolhode[2]};
    if (is_top)
        digits.insert(digits.end(),
                      {sample.euler.theta_rad, sample.euler.phi_rad, sample.euler.psi_rad});
    return digits;
}

std::string LiveScene::state_at(const FilmTime& moment) const {
    // In the order of language_codes.
    static constexpr Phrase sentence{
        "Time {t:.4g}. Angular velocity {omega:.3g}; its components along the body axes are "
        "{omega_body_1:.3g}, {omega_body_2:.3g} and {omega_body_3:.3g}.",
        "Zeit {t:.4g}. Winkelgeschwindigkeit {omega:.3g}; ihre Komponenten entlang der "
        "Körperachsen sind {omega_body_1:.3g}, {omega_body_2:.3g} und {omega_body_3:.3g}.",
        "Temps {t:.4g}. Vitesse angulaire {omega:.3g} ; ses composantes selon les axes du corps "
        "sont {omega_body_1:.3g}, {omega_body_2:.3g} et {omega_body_3:.3g}.",
        "Tiempo {t:.4g}. Velocidad angular {omega:.3g}; sus componentes según los ejes del cuerpo "
        "son {omega_body_1:.3g}, {omega_body_2:.3g} y {omega_body_3:.3g}.",
        "Tempo {t:.4g}. Velocità angolare {omega:.3g}; le sue componenti lungo gli assi del corpo "
        "sono {omega_body_1:.3g}, {omega_body_2:.3g} e {omega_body_3:.3g}.",
        "時刻 {t:.4g}。角速度 {omega:.3g}。物体軸に沿った成分は "
        "{omega_body_1:.3g}、{omega_body_2:.3g}、"
        "{omega_body_3:.3g}。"};
    const FrameInput instant{session_.motion.sample(moment.time_s, {.attitude = false}),
                             moment.time_s, moment.film_s};
    return plain_text(
        live_text(session_.scene, phrase_in(session_.scene.language, sentence), instant));
}

std::string LiveScene::svg_at(const FilmTime& moment) const {
    // The canvas as a slide 540 points high.
    const Drawing drawing = drawing_at(moment);
    vector::PaperChoices choices;
    choices.pt_per_px = 540.0 / drawing.height_px;
    return vector::svg_of(vector::paper_of(drawing, choices), plain_text(session_.scene.title), "");
}

std::string LiveScene::panels_text() const {
    std::vector<std::string> panels;
    const FilmTime first{film_.time_of(0), 0.0};
    for (const Panel& panel : stage_->panels()) {
        const PanelKind& kind = panel_kind_named(panel.spec.kind);
        const Camera camera = panel.camera_at ? panel.camera_at(first.film_s) : panel.camera;
        const Direction direction = direction_of(camera);
        panels.push_back(JsonObject()
                             .add("name", panel.spec.title.value_or(std::string(
                                              phrase_in(session_.scene.language, kind.title))))
                             .add("kind", panel.spec.kind)
                             .add("x", panel.box.x_px)
                             .add("y", panel.box.y_px)
                             .add("width", panel.box.width_px)
                             .add("height", panel.box.height_px)
                             .add("has_view", kind.camera != CameraUse::none)
                             .add("azimuth_deg", direction.azimuth_deg)
                             .add("elevation_deg", direction.elevation_deg)
                             .add("distance", (camera.eye - camera.target).norm())
                             .line());
    }
    return json_list(panels);
}

}  // namespace poinsot
