#include "drawing/stage.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "drawing/elements.h"
#include "drawing/stage_data.h"

namespace poinsot {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// The scene's camera about the vertical L, aimed so that the construction fills the picture.
Camera camera_of(const CameraSpec& spec, double plane_distance) {
    const double azimuth = radians(spec.azimuth_deg);
    const double elevation = radians(spec.elevation_deg);
    Camera camera;
    camera.target = spec.target.value_or(Eigen::Vector3d(0.0, 0.0, 0.5 * (1.25 - plane_distance)));
    camera.eye =
        camera.target + spec.distance * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                                        std::cos(elevation) * std::sin(azimuth),
                                                        std::sin(elevation));
    camera.vertical_field_rad = radians(spec.field_deg);
    return camera;
}

// Identifiers only name uploads; which number a geometry gets never reaches a pixel.
std::uint64_t next_geometry_id() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

}  // namespace

StageData::StageData(const Scene& scene_, const Motion& motion_, const StageOptions& options_)
    : scene(scene_),
      motion(&motion_),
      options(options_),
      theme(&theme_named(scene_.theme)),
      construction(motion_.problem().inertia, motion_.problem().start),
      polhode(motion_.problem().inertia, motion_.problem().start.omega_body),
      cones(rolling_cones(motion_.problem().inertia, motion_.problem().start.omega_body)) {
    px = options.line_scale > 0.0 ? options.line_scale : options.height_px / 1080.0;

    picture_per_rho = 1.0 / construction.half_axes().maxCoeff();
    half_axes = construction.half_axes() * picture_per_rho;
    plane_distance = construction.plane_distance() * picture_per_rho;
    herpolhode_radius = polhode.annulus().outer * picture_per_rho;
    picture_from_space =
        Eigen::Quaterniond::FromTwoVectors(construction.vertical_space(), Eigen::Vector3d::UnitZ());

    camera = camera_of(scene.camera, plane_distance);
    units_per_px =
        2.0 * scene.camera.distance * std::tan(0.5 * camera.vertical_field_rad) / options.height_px;

    // The elements that the scene names, or those that this kind of motion shows by itself.
    for (const std::string& name : scene.show) element_named(name);
    for (const Element& element : elements()) {
        const bool named =
            std::find(scene.show.begin(), scene.show.end(), element.name) != scene.show.end();
        if (scene.show.empty() ? element.by_default(*this) : named) {
            drawers.push_back(element.make(*this));
        }
    }
}

const CurveGeometry* StageData::keep(CurveGeometry geometry) {
    geometry.id = next_geometry_id();
    return &curves.emplace_back(std::move(geometry));
}

const MeshGeometry* StageData::keep(MeshGeometry geometry) {
    geometry.id = next_geometry_id();
    return &meshes.emplace_back(std::move(geometry));
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
    instant.picture_from_body = data_->picture_from_space * instant.state.space_from_body;
    instant.contact = data_->picture_from_space * data_->construction.contact_space(instant.state) *
                      data_->picture_per_rho;

    Sheet sheet;
    View& view = sheet.view;
    view.width_px = data_->options.width_px;
    view.height_px = data_->options.height_px;
    view.camera = data_->camera;
    view.light = data_->theme->light;
    view.background = data_->theme->background;
    for (const Drawer& draw : data_->drawers) draw(instant, sheet);
    place_labels(sheet.wishes, data_->theme->halo, 3.0 * data_->px, view);

    Drawing drawing;
    drawing.width_px = data_->options.width_px;
    drawing.height_px = data_->options.height_px;
    drawing.background = data_->theme->background;
    drawing.views.push_back(std::move(view));
    return drawing;
}

}  // namespace poinsot
