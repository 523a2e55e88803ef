#include "drawing/figures/elements/axis_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "construction/adaptive_curve.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/label_requests.h"
#include "text/languages.h"

namespace poinsot {

namespace {

// The direction n at a fraction of the sweep, principal axes: a spiral from e3 to −e3 whose turns
// are equally spaced on the sphere.
Eigen::Vector3d direction_at(double share) {
    constexpr double n_turns = 15.0;
    const double theta = std::numbers::pi * share;
    const double phi = 2.0 * std::numbers::pi * n_turns * share;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// I(n) = Σ I_i n_i² in units of the least moment.
double moment_about(const Eigen::Vector3d& half_axes, const Eigen::Vector3d& n) {
    return n.cwiseQuotient(half_axes).squaredNorm();
}

// A moment as a number to the right of the figure. `formula`: with a decimal point.
void add_moment(const Panel& panel, const TextCache& text, const std::string& formula,
                ViewBuilder& builder) {
    LabelRequest number;
    number.type = text.set_live(
        with_decimal_mark(formula, decimal_mark_in_formula(panel.stage->scene.language)),
        {.size_px = label_em_px(panel)}, builder.view);
    // Long numbers end before the panel's edge; labels begin near their anchors.
    const double last_px = panel.box.width_px - 0.87 * number.type.width_px();
    number.anchor_px = {panel.box.x_px + std::min(0.76 * panel.box.width_px, last_px),
                        panel.box.y_px + 0.5 * panel.box.height_px};
    number.away = {0.0, 0.0};
    number.gap_px = 6.0 * panel.stage->options.samples;
    number.colour = panel.stage->theme.text;
    builder.requests.push_back(number);
    name_shapes("moment", builder);
}

}  // namespace

AxisSweep::AxisSweep(const Panel& panel, StageStore& store, const Eigen::Vector3d& half_axes)
    : panel_(&panel),
      text_(&std::as_const(store).text()),
      half_axes_(half_axes),
      n_type_(set_label(panel, store, "\\mathbf{n}")),
      rho_type_(set_label(panel, store, "\\boldsymbol{\\rho}")) {
    const auto rho_at = [&](double share) {
        const Eigen::Vector3d n = direction_at(share);
        return Eigen::Vector3d(n / std::sqrt(moment_about(half_axes, n)));
    };
    const SampledCurve sampled = sample_adaptively(
        rho_at, {.n_pieces = 256, .tolerance = panel.curve_units(), .max_points = 200'000});
    CurveGeometry geometry;
    for (const CurveSample& sample : sampled.samples) {
        geometry.points.push_back(sample.point);
        shares_.push_back(sample.parameter);
    }
    trace_ = curve_of(panel, keep(panel, store, std::move(geometry), sampled.off, "the trace of ρ"),
                      panel.stage->theme.rho, 2.4);
    trace_.on_surface = first_ellipsoid;
    trace_.hidden_opacity = 0.3;
}

double AxisSweep::index_at(double share) const {
    const auto after = std::upper_bound(shares_.begin(), shares_.end(), share);
    if (after == shares_.begin()) return 0.0;
    const auto i = static_cast<double>(after - shares_.begin()) - 1.0;
    if (after == shares_.end()) return i;
    return i + (share - *(after - 1)) / (*after - *(after - 1));
}

void AxisSweep::add_trace(const Eigen::Matrix3d& picture_from_principal, double share,
                          ViewBuilder& builder) const {
    const Panel& panel = *panel_;
    const Theme& theme = panel.stage->theme;
    Curve traced = trace_;
    traced.placement.linear() = picture_from_principal;
    traced.lasting = picture_from_principal.isIdentity(0.0);
    traced.last = index_at(share);
    builder.view.curves.push_back(traced);
    name_shapes("trace", builder);
    const Eigen::Vector3d along = direction_at(share);
    const Eigen::Vector3d rho =
        picture_from_principal * along / std::sqrt(moment_about(half_axes_, along));
    Arrow rho_arrow = arrow_to(panel, rho, theme.rho, 1.35);
    rho_arrow.hidden_opacity = 0.9;
    builder.view.arrows.push_back(rho_arrow);
    request_label_beside(panel, 0.62 * rho, rho, rho_type_, theme.rho, builder);
    name_shapes("radius", builder);
}

void AxisSweep::add_direction(const Eigen::Matrix3d& picture_from_principal, double share,
                              ViewBuilder& builder) const {
    const Panel& panel = *panel_;
    const Theme& theme = panel.stage->theme;
    const Eigen::Vector3d along = direction_at(share);
    const double moment = moment_about(half_axes_, along);
    const Eigen::Vector3d n = picture_from_principal * along;
    const Eigen::Vector3d rho = n / std::sqrt(moment);
    Curve axis = line_between(panel, -rho - beyond * n, rho, theme.text, 2.0);
    axis.hidden_opacity = 0.5;
    builder.view.curves.push_back(axis);
    add_named_arrow(panel, arrow_between(panel, rho, rho + beyond * n, theme.text, 0.9), n_type_,
                    builder);
    name_shapes("direction", builder);
    const double kg_m2 =
        moment * panel.stage->motion.motion().problem().inertia.moments_kg_m2().minCoeff();
    add_moment(panel, *text_, fmt::format("I(\\mathbf{{n}}) = {:.3g}~\\mathrm{{kg\\,m^2}}", kg_m2),
               builder);
}

namespace {

// The part of the sweep, 0…1, that is done at a second of the film: it runs from the start of the
// fade that shows "direction", or else the film's beginning, until "direction" fades out.
class SweepTime {
 public:
    explicit SweepTime(const Scene& scene) {
        end_s_ = FilmClock(scene).length_s().value_or(default_film_s);
        bool is_first = true;
        for (const FadeSpec& fade : scene.fades) {
            const auto& names = fade.elements;
            if (std::find(names.begin(), names.end(), "direction") == names.end()) continue;
            if (!(fade.opacity > 0.0))
                end_s_ = fade.at_s;
            else if (is_first)
                begin_s_ = fade.at_s;
            is_first = false;
        }
    }

    double share_at(double film_s) const {
        return end_s_ > begin_s_ ? std::clamp((film_s - begin_s_) / (end_s_ - begin_s_), 0.0, 1.0)
                                 : 1.0;
    }

 private:
    double begin_s_ = 0.0;
    double end_s_ = 0.0;
};

}  // namespace

Drawer make_direction(const Panel& panel, StageStore& store) {
    const AxisSweep sweep(panel, store, picture_of(panel).half_axes);
    const SweepTime time(panel.stage->scene);
    return [&panel, sweep, time](const FrameInput& instant, ViewBuilder& builder) {
        sweep.add_direction(picture_of(panel).principal_axes(instant),
                            time.share_at(instant.film_s), builder);
    };
}

Drawer make_direction_trace(const Panel& panel, StageStore& store) {
    const AxisSweep sweep(panel, store, picture_of(panel).half_axes);
    const SweepTime time(panel.stage->scene);
    return [&panel, sweep, time](const FrameInput& instant, ViewBuilder& builder) {
        sweep.add_trace(picture_of(panel).principal_axes(instant), time.share_at(instant.film_s),
                        builder);
    };
}

// n beyond the tip of ω, so that both arrows are seen, and its moment: 2T = I(n) ω², where
// ω = √(2T) ρ makes this 1/ρ².
Drawer make_spin_direction(const Panel& panel, StageStore& store) {
    const TextBlock type = set_label(panel, store, "\\mathbf{n}");
    const TextCache& text = std::as_const(store).text();
    const double least_kg_m2 =
        panel.stage->motion.motion().problem().inertia.moments_kg_m2().minCoeff();
    return [&panel, &text, type, least_kg_m2](const FrameInput& instant, ViewBuilder& builder) {
        const Theme& theme = panel.stage->theme;
        const Eigen::Vector3d rho = picture_of(panel).contact(instant);
        const Eigen::Vector3d n = rho.stableNormalized();
        const Eigen::Vector3d end = spin_axis_end(rho);
        Curve axis = line_between(panel, -end, Eigen::Vector3d::Zero(), theme.text, 2.0);
        axis.hidden_opacity = 0.5;
        builder.view.curves.push_back(axis);
        add_named_arrow(
            panel, arrow_between(panel, end, end + 0.75 * AxisSweep::beyond * n, theme.text, 0.9),
            type, builder);
        name_shapes("spin-direction", builder);
        add_moment(panel, text,
                   fmt::format("I(\\mathbf{{n}}) = 2T/\\omega^2 = {:.3g}~\\mathrm{{kg\\,m^2}}",
                               least_kg_m2 / rho.squaredNorm()),
                   builder);
    };
}

}  // namespace poinsot
