#include "drawing/figures/elements/measured_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/possible_motions.h"
#include "error/error.h"
#include "measured/table_faults.h"

namespace poinsot {

namespace {

// More dots would take time, and nearer ones would run into each other; the line joins all rows.
constexpr std::size_t most_dots = 160;
constexpr double dot_px = 3.0;
constexpr double least_apart_px = 4.0 * dot_px;
constexpr double rim_px = 1.1;
constexpr double track_px = 1.3;
constexpr double track_opacity = 0.7;
constexpr double behind = 0.3;  // opacity of what the ellipsoid or the plane hides

// Moves what is drawn towards the eye by some pixels, along the lines of sight, so that its place
// in the picture stays. The dots are balls: one whose centre lies a little below a surface is still
// seen.
Eigen::Affine3d raised(const Panel& panel, const Camera& camera, double px) {
    const Eigen::Vector3d to_eye = camera.eye - camera.target;
    const double by = px * panel.units_per_px;
    if (camera.orthographic) return Eigen::Affine3d(Eigen::Translation3d(to_eye.normalized() * by));
    return Eigen::Translation3d(camera.eye) * Eigen::Scaling(1.0 - by / to_eye.norm()) *
           Eigen::Translation3d(-camera.eye);
}

struct MeasuredDot {
    double time_s = 0.0;
    Eigen::Vector3d at;
};

struct MeasuredStretch {
    Curve curve;
    std::vector<double> times_s;
};

}  // namespace

Eigen::Vector3d measured_rho(const StageContext& stage, const MeasuredRow& row) {
    const ConstructionPicture& picture = *stage.rolling;
    Eigen::Vector3d rho = picture.construction.contact_body(row.omega_body);
    if (picture.dissipates)
        rho *= picture.rho_growth(stage.motion.sample(row.time_s, omega_alone).state.omega_body);
    return rho;
}

Drawer measured_track(const Panel& panel, StageStore& store,
                      const std::function<Eigen::Vector3d(const MeasuredRow&)>& point,
                      const std::function<Eigen::Affine3d(const FrameInput&)>& placement) {
    const StageContext& stage = *panel.stage;
    const auto spans = stretches_of(stage.scene.measured.motion.rows, stage.options.first_time_s,
                                    stage.options.last_time_s);
    std::size_t n_rows = 0;
    for (const auto& rows : spans) n_rows += rows.size();
    const std::size_t every = (n_rows + most_dots - 1) / most_dots;
    if (every > 1)
        store.note(
            fmt::format("of {} measured points at most one in {} has a dot; the line joins all",
                        n_rows, every));

    const LineStyle& ink = stage.theme.measured;
    const double least_apart = least_apart_px * panel.px * panel.units_per_px;
    std::vector<MeasuredDot> dots;
    std::vector<MeasuredStretch> stretches;
    std::size_t row_number = 0;
    for (const auto& rows : spans) {
        MeasuredStretch stretch;
        CurveGeometry geometry;
        for (const MeasuredRow& row : rows) {
            geometry.points.push_back(point(row));
            stretch.times_s.push_back(row.time_s);
            const Eigen::Vector3d& at = geometry.points.back();
            const bool is_free = dots.empty() || (at - dots.back().at).norm() >= least_apart;
            if (row_number++ % every == 0 && is_free) dots.push_back({row.time_s, at});
        }
        if (rows.size() < 2) continue;
        // The rows are joined by straight lines: what lies between them was not measured.
        stretch.curve =
            curve_of(panel, keep(panel, store, std::move(geometry), 0.0, "the measured track"), ink,
                     track_px);
        stretch.curve.opacity = track_opacity;
        stretch.curve.hidden_opacity = behind;
        stretches.push_back(std::move(stretch));
    }
    const bool whole = stage.options.repeat_s > 0.0;  // a loop has no first instant
    return [&panel, placement, dots, stretches, ink, whole](const FrameInput& instant,
                                                            ViewBuilder& builder) {
        const Eigen::Affine3d place =
            raised(panel, builder.view.camera, 1.5 * dot_px * panel.px) * placement(instant);
        for (const MeasuredStretch& stretch : stretches) {
            const auto end =
                std::upper_bound(stretch.times_s.begin(), stretch.times_s.end(), instant.time_s);
            Curve shown = stretch.curve;
            shown.placement = place;
            if (!whole) shown.last = static_cast<double>(end - stretch.times_s.begin()) - 1.0;
            if (shown.last > 0.0) builder.view.curves.push_back(shown);
        }
        for (const MeasuredDot& dot : dots) {
            if (!whole && dot.time_s > instant.time_s) break;
            // In the colour of their name; the rims part dots that stand side by side.
            Dot shown = dot_at(panel, place * dot.at, ink, dot_px);
            shown.rim_px = rim_px * panel.px;
            shown.hidden_opacity = behind;
            builder.view.dots.push_back(shown);
        }
    };
}

// The rows on the ellipsoid, which turns with the body, and on the plane, both in picture axes.
Drawer make_measured(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    if (!has_measured(stage))
        throw InputError(
            "show: \"measured\" needs a measured motion; name its table in [measured], or leave "
            "the element out");
    const ConstructionPicture& picture = picture_of(panel);
    const double per_rho = picture.picture_per_rho;
    const Drawer on_ellipsoid = measured_track(
        panel, store,
        [&](const MeasuredRow& row) { return Eigen::Vector3d(per_rho * measured_rho(stage, row)); },
        [&picture](const FrameInput& instant) {
            return Eigen::Affine3d(picture.picture_from_body(instant));
        });
    // With dissipation the plane rises, and the path traced on it with it.
    const auto foot_at = [&stage, &picture](double time_s) {
        FrameInput instant;
        if (picture.dissipates) instant.state = stage.motion.sample(time_s, omega_alone).state;
        return picture.foot(instant);
    };
    const Drawer on_plane = measured_track(
        panel, store,
        [&](const MeasuredRow& row) {
            const Eigen::Quaterniond attitude =
                stage.turned_from_space(row.time_s) * stage.measured_state(row).space_from_body;
            return Eigen::Vector3d(picture.picture_from_space * attitude *
                                       (per_rho * measured_rho(stage, row)) -
                                   foot_at(row.time_s));
        },
        [&picture](const FrameInput& instant) {
            return Eigen::Affine3d(Eigen::Translation3d(picture.foot(instant)));
        });
    return [on_ellipsoid, on_plane](const FrameInput& instant, ViewBuilder& builder) {
        on_ellipsoid(instant, builder);
        const std::size_t n_curves = builder.view.curves.size();
        on_plane(instant, builder);
        for (std::size_t i = n_curves; i < builder.view.curves.size(); ++i)
            builder.view.curves[i].name = {"measured", 0, "plane"};
    };
}

}  // namespace poinsot
