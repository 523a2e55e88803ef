#include "drawing/stage/stage_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/stage/smooth_paths.h"
#include "drawing/stage/stage_context.h"
#include "scene/scene_error.h"
#include "shapes/identity.h"

namespace poinsot {

namespace {

// Drawn with radii up to twice the picture's height: the sagitta r(1 − cos(π/n)) stays below
// curve_px.
CurveGeometry circle_of_radius_1(const StageOptions& options, double curve_px) {
    CurveGeometry circle;
    circle.closed = true;
    const double least = std::numbers::pi / std::sqrt(curve_px / options.height_px);
    const int n_points = static_cast<int>(std::clamp(std::ceil(least), 512.0, 65536.0));
    for (int k = 0; k < n_points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_points;
        circle.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    circle.smooth = smooth_circle(Eigen::Vector3d::Zero(), 1.0, circle.points.size());
    return circle;
}

}  // namespace

// Curves are subdivided to curve_px, those that are made for one instant as well.
StageStore::StageStore(const StageContext& context)
    : context_(&context),
      text_(context.options.fonts, context.options.samples, context.options.least),
      curve_error_px_(context.curve_px),
      unit_circle_(keep(circle_of_radius_1(context.options, context.curve_px), context.curve_px,
                        "a circle")),
      unit_segment_(
          keep({.points = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}}, 0.0, "a line")) {}

const CurveGeometry* StageStore::keep(CurveGeometry geometry, double off_px,
                                      std::string_view what) {
    constexpr double rounding = 1e-6;
    if (!(off_px <= (1.0 + rounding) * context_->curve_px)) {
        const Scene& scene = context_->scene;
        const double from_s = std::min(context_->options.first_time_s, context_->film_first_s);
        const double to_s = std::max(context_->options.last_time_s, context_->film_last_s);
        throw SceneError(
            scene.location_of("film"),
            fmt::format("{} cannot be drawn within accuracy_px = {:g} from t = {:g} s to {:g} s: "
                        "it has too many turns, or the times are too large to resolve its points; "
                        "set film.start_s nearer to the last instant shown, shorten the film or "
                        "its trails, or raise accuracy_px",
                        what, scene.accuracy_px, from_s, to_s));
    }
    curve_error_px_ = std::max(curve_error_px_, off_px);
    geometry.id = next_identity();
    return &curves_.emplace_back(std::move(geometry));
}

const MeshGeometry* StageStore::keep(MeshGeometry geometry) {
    geometry.id = next_identity();
    return &meshes_.emplace_back(std::move(geometry));
}

void StageStore::note(std::string text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end())
        notes_.push_back(std::move(text));
}

}  // namespace poinsot
