#include "drawing/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "drawing/fade.h"
#include "drawing/overlay.h"
#include "drawing/panel.h"
#include "drawing/stage_data.h"
#include "error/nearest.h"
#include "mechanics/free_rotation.h"
#include "scene/film_clock.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// Identifiers only name uploads; which number a geometry gets never reaches a pixel.
std::uint64_t next_geometry_id() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

// The panels of a scene that names none: the one that suits its motion.
std::vector<PanelSpec> panels_of(const StageData& stage) {
    if (!stage.scene.panels.empty()) return stage.scene.panels;
    PanelSpec alone;
    alone.kind = default_panel(stage);
    return {alone};
}

// Boundaries of the columns or rows in pixels, by their relative sizes; whole, and the last one is
// the end of the room that they share.
std::vector<int> boundaries(const std::vector<double>& sizes, int from_px, int total_px) {
    double sum = 0.0;
    for (const double size : sizes) sum += size;
    std::vector<int> edges{from_px};
    double at = 0.0;
    for (const double size : sizes) {
        at += size;
        edges.push_back(from_px + static_cast<int>(std::lround(at / sum * total_px)));
    }
    return edges;
}

PanelBox box_of(const PanelSpec& spec, const std::vector<int>& columns,
                const std::vector<int>& rows) {
    const auto at = [](const std::vector<int>& edges, int i) {
        return edges[static_cast<std::size_t>(i)];
    };
    PanelBox box;
    box.x_px = at(columns, spec.column);
    box.y_px = at(rows, spec.row);
    box.width_px = at(columns, spec.column + spec.columns) - box.x_px;
    box.height_px = at(rows, spec.row + spec.rows) - box.y_px;
    return box;
}

// Lines of a panel shrink with it, but less than it does; its type shrinks less still, and not
// below what can be read.
double line_scale(const PanelBox& box, const StageOptions& options) {
    const double share =
        std::min(1.0 * box.height_px / options.height_px, 1.5 * box.width_px / options.width_px);
    return std::sqrt(std::min(1.0, share));
}
constexpr double least_type_share = 0.72;
constexpr double least_type_px = 0.36;  // a label of 12 px

// The name of a panel in its upper left corner.
Drawer header_of(Panel& panel, std::string_view text) {
    const double size = 24.0 * panel.type_px;
    const SetType type =
        panel.stage->type_case.set(text, {.size_px = size, .mode = TypeMode::text});
    panel.header_px = 1.7 * size;
    // In the first column it stands below the title.
    const double left =
        panel.box.x_px == 0 ? overlay_margin * panel.stage->px : panel.box.x_px + 0.7 * size;
    return [&panel, type, size, left](const Instant&, Sheet& sheet) {
        Label label;
        label.mask = type.mask;
        label.top_left_px = {std::round(left) + type.left_px,
                             std::round(panel.box.y_px + 0.4 * size + size) - type.baseline_px};
        label.colour = panel.stage->theme->text;
        label.halo_colour = panel.stage->theme->halo;
        label.halo_px = 2.0 * panel.px;
        label.opacity = 0.75;
        if (type.mask->width > 0) sheet.view.labels.push_back(label);
    };
}

// Refuses cells in which nothing can be seen.
void check_room(const Scene& scene, const PanelBox& box, std::size_t panel) {
    constexpr int least_px = 8;
    if (scene.panels.size() < 2 || std::min(box.width_px, box.height_px) >= least_px) return;
    throw SceneError(scene.location_of(fmt::format("panels[{}]", panel)),
                     fmt::format("panels[{}] gets {}x{} pixels of the picture, title and caption "
                                 "taken off; a panel needs {} a side: make the picture larger, or "
                                 "the grid coarser",
                                 panel, box.width_px, box.height_px, least_px));
}

bool says_camera(const KeyframeSpec& key) {
    return key.azimuth_deg || key.elevation_deg || key.distance || key.field_deg || key.target ||
           !key.look_at.empty();
}

// Drawn with radii up to half the picture's height: the sagitta r(1 − cos(π/n)) stays below half
// of accuracy_px.
CurveGeometry circle_of_radius_1(const StageOptions& options, double accuracy_px) {
    CurveGeometry circle;
    circle.closed = true;
    const double least = std::numbers::pi / std::sqrt(2.0 * accuracy_px / options.height_px);
    const int n_points = static_cast<int>(std::clamp(std::ceil(least), 512.0, 65536.0));
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    return circle;
}

}  // namespace

ConstructionPicture::ConstructionPicture(const InertiaTensor& inertia, const RotationState& start)
    : construction(inertia, start),
      polhode(inertia, start.omega_body),
      cones(rolling_cones(inertia, start.omega_body)) {
    picture_per_rho = 1.0 / construction.half_axes().maxCoeff();
    half_axes = construction.half_axes() * picture_per_rho;
    plane_distance = construction.plane_distance() * picture_per_rho;
    herpolhode_radius = polhode.annulus().outer * picture_per_rho;
    picture_from_space =
        Eigen::Quaterniond::FromTwoVectors(construction.vertical_space(), Eigen::Vector3d::UnitZ());
}

Eigen::Quaterniond ConstructionPicture::picture_from_body(const Instant& instant) const {
    return picture_from_space * instant.state.space_from_body;
}

Eigen::Matrix3d ConstructionPicture::principal_axes(const Instant& instant) const {
    return picture_from_body(instant).toRotationMatrix() *
           construction.inertia().body_from_principal();
}

Eigen::Vector3d ConstructionPicture::contact(const Instant& instant) const {
    return picture_from_space * construction.contact_space(instant.state) * picture_per_rho;
}

StageData::StageData(const Scene& scene_, const Motion& motion_, const StageOptions& options_,
                     const Motion* beside_)
    : scene(scene_),
      motion(motion_),
      options(options_),
      theme(at_scene_key(scene_, "theme", [&] { return &theme_named(scene_.theme); })) {
    if (beside_ != nullptr) beside.emplace(*beside_);
    px = options.line_scale > 0.0 ? options.line_scale : options.height_px / 1080.0;
    film_first_s = std::min(scene.film.start_s, options.first_time_s);
    film_last_s = std::max(film_end_time_s(scene), options.last_time_s);
    unit_circle = keep(circle_of_radius_1(options, scene.accuracy_px));
    unit_segment = keep({.points = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}});
    make_construction();
    timeline = Timeline(scene, rolling ? rolling->plane_distance : 0.0);
    // Curves are subdivided to half of accuracy_px; those that could not be note it.
    note_curve_error(0.5 * scene.accuracy_px);
    make_panels();
    if (beside && !shows_beside) {
        throw SceneError(scene.location_of("beside"),
                         "no panel here shows a second motion; add a panel \"space\", \"body\", "
                         "\"momentum\" or \"plot\"");
    }
    overlays = make_overlays(*this);
    check_fades();
    check_keyframes();
}

void StageData::make_construction() {
    const MotionProblem& problem = motion.motion().problem();
    if (!std::holds_alternative<NoTorque>(problem.torque) || problem.start.omega_body.isZero(0.0)) {
        return;
    }
    rolling.emplace(problem.inertia, problem.start);
    const FreeRotationConstants constants =
        FreeRotation(problem.inertia, problem.start).constants();
    polhode_period_s = constants.polhode_period_s;
    if (scene.camera.motion == "co-precessing") turn_rate_rad_s = constants.mean_advance_rate_rad_s;
}

void StageData::check_fades() const {
    for (std::size_t i = 0; i < scene.fades.size(); ++i) {
        for (const std::string& name : scene.fades[i].elements) {
            if (can_fade.contains(name)) continue;
            const std::vector<std::string_view> known(can_fade.begin(), can_fade.end());
            throw SceneError(
                scene.location_of(fmt::format("fades[{}].elements", i)),
                fmt::format("nothing shown is called \"{}\"{}; here fade: {}", echo(name),
                            did_you_mean(name, known), fmt::join(known, ", ")));
        }
    }
}

void StageData::check_keyframes() const {
    const auto moves = [](const Panel& panel) { return panel.camera_at != nullptr; };
    if (!timeline.camera_moves() || std::any_of(panels.begin(), panels.end(), moves)) return;
    for (std::size_t i = 0; i < scene.keyframes.size(); ++i) {
        if (!says_camera(scene.keyframes[i])) continue;
        throw SceneError(
            scene.location_of(fmt::format("keyframes[{}]", i)),
            fmt::format("keyframes[{}] moves the camera, but every panel here is seen "
                        "from where it always is; add a panel \"space\", \"object\" or "
                        "\"top\", or leave the camera out",
                        i));
    }
}

void StageData::make_panels() {
    const std::vector<PanelSpec> specs = panels_of(*this);

    // Several panels, and those that fill their box, leave the title and the caption their room.
    PanelBox room{0, 0, options.width_px, options.height_px};
    if (specs.size() > 1 || panel_kind_named(specs.front().kind).fills) {
        const OverlayBands bands = overlay_bands(*this);
        room.y_px = bands.top_px;
        room.height_px = std::max(1, options.height_px - bands.top_px - bands.bottom_px);
    }
    const std::vector<int> columns = boundaries(scene.grid.columns, room.x_px, room.width_px);
    const std::vector<int> rows = boundaries(scene.grid.rows, room.y_px, room.height_px);
    for (const PanelSpec& spec : specs) {
        const PanelKind& kind = at_scene_key(
            scene, "panels", [&]() -> const PanelKind& { return panel_kind_named(spec.kind); });
        if (!kind.possible(*this)) {
            const bool rests = motion.motion().problem().start.omega_body.isZero(0.0);
            throw SceneError(scene.location_of(rests ? "start.omega_rad_s" : "panels"),
                             rests ? "omega_rad_s is zero, and a body at rest has no invariable "
                                     "plane; give it a spin"
                                   : "panel \"" + spec.kind + "\" needs " +
                                         std::string(kind.needs) + "; choose another panel");
        }
        Panel& panel = panels.emplace_back();
        panel.stage = this;
        panel.spec = spec;
        panel.light = theme->light;
        panel.box = box_of(spec, columns, rows);
        check_room(scene, panel.box, static_cast<std::size_t>(&spec - specs.data()));
        const double share = line_scale(panel.box, options);
        panel.px = px * share;
        panel.type_px =
            std::max(px * std::max(share, least_type_share), least_type_px * options.samples);
        Drawer header;
        if (specs.size() > 1)
            header = header_of(panel, spec.title.value_or(std::string(kind.title)));
        kind.make(panel);
        asks = united(asks, panel.asks);
        shows_beside = shows_beside || panel.shows_beside;
        if (header) {
            panel.draw = [header, draw = std::move(panel.draw)](const Instant& instant,
                                                                Sheet& sheet) {
                draw(instant, sheet);
                header(instant, sheet);
            };
        }
        panel.draw = fading(*this, spec.kind, std::move(panel.draw));
    }
}

StageData::~StageData() = default;

const CurveGeometry* StageData::keep(CurveGeometry geometry) {
    geometry.id = next_geometry_id();
    return &curves.emplace_back(std::move(geometry));
}

const MeshGeometry* StageData::keep(MeshGeometry geometry) {
    geometry.id = next_geometry_id();
    return &meshes.emplace_back(std::move(geometry));
}

Instant StageData::instant_at(const FilmMoment& moment) const {
    const MotionSample sample = motion.sample(moment.time_s, asks);
    Instant instant{moment.time_s, sample.state,  sample.herpolhode_space,
                    sample.euler,  moment.film_s, {}};
    if (shows_beside) {
        constexpr Quantities whole_state{
            .attitude = true, .herpolhode = false, .euler_angles = false};
        instant.beside = beside->sample(moment.time_s, whole_state).state;
    }
    if (turns()) {
        const Eigen::Quaterniond turn = turned_from_space(moment.time_s);
        instant.state.space_from_body = turn * instant.state.space_from_body;
        instant.herpolhode_space = turn * instant.herpolhode_space;
        if (instant.beside) {
            instant.beside->space_from_body = turn * instant.beside->space_from_body;
        }
    }
    return instant;
}

Eigen::Quaterniond StageData::turned_from_space(double time_s) const {
    const double angle_rad = turn_rate_rad_s * (time_s - scene.film.start_s);
    return Eigen::Quaterniond(
        Eigen::AngleAxisd(-angle_rad, rolling->construction.vertical_space()));
}

double StageData::quickest_rate_rad_s() const {
    const MotionProblem& problem = motion.motion().problem();
    const double I_least = problem.inertia.moments_kg_m2().minCoeff();
    const Eigen::Vector3d omega =
        problem.inertia.body_from_principal().transpose() * problem.start.omega_body;
    // In units of the least moment, so that T neither overflows nor vanishes.
    const Eigen::Vector3d weights = (problem.inertia.moments_kg_m2() / I_least).cwiseSqrt();
    double rate = weights.cwiseProduct(omega).stableNorm();
    if (const auto* gravity = std::get_if<GravityTorque>(&problem.torque)) {
        rate = std::hypot(rate, 2.0 * std::sqrt(std::abs(gravity->mgl_N_m) / I_least));
    }
    return rate;
}

std::vector<LiveValue> StageData::live_values(const Instant& instant) {
    const Eigen::Vector3d& omega = instant.state.omega_body;
    return {{"time_s", instant.time_s},           {"time_h", instant.time_s / 3600.0},
            {"time_d", instant.time_s / 86400.0}, {"omega_1_rad_s", omega[0]},
            {"omega_2_rad_s", omega[1]},          {"omega_3_rad_s", omega[2]}};
}

Stage::Stage(const Scene& scene, const Motion& motion, const StageOptions& options,
             const Motion* beside)
    : data_(std::make_unique<StageData>(scene, motion, options, beside)) {}
Stage::~Stage() = default;
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;

const EvaluationCounts& Stage::counts() const { return data_->motion.counts(); }

double Stage::curve_error_px() const { return data_->curve_error_px; }

Drawing Stage::at(double time_s) const {
    return at(moment_of_time(FilmClock(data_->scene), time_s));
}

Drawing Stage::at(const FilmMoment& moment) const {
    const Instant instant = data_->instant_at(moment);
    Drawing drawing;
    drawing.width_px = data_->options.width_px;
    drawing.height_px = data_->options.height_px;
    drawing.background = data_->theme->background;
    for (const Panel& panel : data_->panels) {
        Sheet sheet;
        View& view = sheet.view;
        view.x_px = panel.box.x_px;
        view.y_px = panel.box.y_px;
        view.width_px = panel.box.width_px;
        view.height_px = panel.box.height_px;
        view.camera = panel.camera_at ? panel.camera_at(moment.film_s) : panel.camera;
        view.light = panel.light;
        // Panels that share the picture stand on its one background.
        view.background = data_->theme->background;
        if (panel.box.height_px < drawing.height_px || panel.box.width_px < drawing.width_px) {
            view.background.alpha = 0.0;
        }
        panel.draw(instant, sheet);
        place_labels(sheet.wishes, data_->theme->halo, 3.0 * panel.px, view);
        drawing.views.push_back(std::move(view));
    }

    // Title, caption and clock stand in a view of their own over all panels.
    Sheet over;
    over.view.width_px = drawing.width_px;
    over.view.height_px = drawing.height_px;
    over.view.background.alpha = 0.0;
    for (const Drawer& draw : data_->overlays) draw(instant, over);
    if (!over.view.labels.empty()) drawing.views.push_back(std::move(over.view));
    return drawing;
}

}  // namespace poinsot
