#include "drawing/stage.h"

#include <algorithm>
#include <atomic>

#include "drawing/overlay.h"
#include "drawing/panel.h"
#include "drawing/stage_data.h"
#include "error/error.h"

namespace poinsot {

namespace {

// Identifiers only name uploads; which number a geometry gets never reaches a pixel.
std::uint64_t next_geometry_id() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

// The panels of a scene that names none: the construction alone.
std::vector<PanelSpec> panels_of(const Scene& scene) {
    return scene.panels.empty() ? std::vector<PanelSpec>{PanelSpec{}} : scene.panels;
}

// Boundaries of the columns or rows in pixels, by their relative sizes; whole, and the last one is
// the picture's edge.
std::vector<int> boundaries(const std::vector<double>& sizes, int total_px) {
    double sum = 0.0;
    for (const double size : sizes) sum += size;
    std::vector<int> edges{0};
    double at = 0.0;
    for (const double size : sizes) {
        at += size;
        edges.push_back(static_cast<int>(at / sum * total_px + 0.5));
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

StageData::StageData(const Scene& scene_, const Motion& motion_, const StageOptions& options_)
    : scene(scene_), motion(&motion_), options(options_), theme(&theme_named(scene_.theme)) {
    px = options.line_scale > 0.0 ? options.line_scale : options.height_px / 1080.0;
    const MotionProblem& problem = motion->problem();
    if (std::holds_alternative<NoTorque>(problem.torque) && !problem.start.omega_body.isZero(0.0)) {
        rolling.emplace(problem.inertia, problem.start);
    }

    const std::vector<int> columns = boundaries(scene.grid.columns, options.width_px);
    const std::vector<int> rows = boundaries(scene.grid.rows, options.height_px);
    for (const PanelSpec& spec : panels_of(scene)) {
        const PanelKind& kind = panel_kind_named(spec.kind);
        if (!kind.possible(*this)) {
            throw InputError("panel \"" + spec.kind + "\" needs " + std::string(kind.needs) +
                             "; choose another panel or another motion");
        }
        Panel& panel = panels.emplace_back();
        panel.stage = this;
        panel.spec = spec;
        panel.box = box_of(spec, columns, rows);
        // Lines and type of a panel shrink with it, but less than it does: they must stay readable.
        panel.px = px * std::sqrt(std::min(1.0, panel.box.height_px / (1.0 * options.height_px)));
        kind.make(panel);
    }
    overlays = make_overlays(*this);
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

std::vector<LiveValue> StageData::live_values(const Instant& instant) const {
    const Eigen::Vector3d& omega = instant.state.omega_body;
    return {{"time_s", instant.time_s},
            {"omega_1_rad_s", omega[0]},
            {"omega_2_rad_s", omega[1]},
            {"omega_3_rad_s", omega[2]}};
}

Stage::Stage(const Scene& scene, const Motion& motion, const StageOptions& options)
    : data_(std::make_unique<StageData>(scene, motion, options)) {}
Stage::~Stage() = default;
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;

Drawing Stage::at(double time_s) const {
    Instant instant;
    instant.time_s = time_s;
    instant.state = data_->motion->at(time_s);

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
        view.camera = panel.camera;
        view.light = data_->theme->light;
        view.background = data_->theme->background;
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
