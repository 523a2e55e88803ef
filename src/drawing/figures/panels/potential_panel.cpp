// The potential panel: the effective potential of a heavy top over θ with the energy, the turning
// points at their intersections, and the moving point.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "construction/adaptive_curve.h"
#include "drawing/figures/charts/plot_frame.h"
#include "drawing/stage/drawing_primitives.h"
#include "mechanics/top/heavy_top.h"
#include "text/languages.h"

namespace poinsot {

namespace {

using std::numbers::pi;

// The potential well of the motion, and the part of it that is shown.
struct Well {
    double theta_bottom = 0.0;
    double bottom_J = 0.0;
    double first_theta = 0.0, last_theta = pi;
    double first_J = 0.0, last_J = 1.0;
};

// V where it is finite; a wall, which exists if p_φ ≠ ±p_ψ, is cut at a height.
double potential_below(const HeavyTop& top, double theta, double most_J) {
    const double V = top.effective_potential_J(theta);
    return V < most_J ? V : most_J;
}

// The minimum between two angles: from the best of many samples, by golden-section search.
double lowest_between(const HeavyTop& top, double from, double to) {
    constexpr int n = 400;
    int best = 0;
    const auto theta = [&](int k) { return from + (to - from) * k / n; };
    for (int k = 0; k <= n; ++k) {
        if (top.effective_potential_J(theta(k)) < top.effective_potential_J(theta(best))) best = k;
    }
    double a = theta(std::max(best - 1, 0));
    double b = theta(std::min(best + 1, n));
    constexpr double golden = 0.6180339887498949;
    for (int round = 0; round < 60; ++round) {
        const double c = b - golden * (b - a);
        const double d = a + golden * (b - a);
        (top.effective_potential_J(c) <= top.effective_potential_J(d) ? b : a) =
            top.effective_potential_J(c) <= top.effective_potential_J(d) ? d : c;
    }
    return 0.5 * (a + b);
}

// The angle at which V, rising from `inside` to `outside`, reaches a height; `outside` if it does
// not.
double reaches(const HeavyTop& top, double inside, double outside, double height_J) {
    if (!(top.effective_potential_J(outside) > height_J)) return outside;
    for (int round = 0; round < 80; ++round) {
        const double middle = 0.5 * (inside + outside);
        (top.effective_potential_J(middle) > height_J ? outside : inside) = middle;
    }
    return inside;
}

Well well_of(const HeavyTop& top) {
    const TopNutation& nutation = top.nutation();
    const double energy = top.invariants().energy_J;
    Well well;
    well.theta_bottom = lowest_between(top, 0.0, pi);
    well.bottom_J = std::min(top.effective_potential_J(well.theta_bottom), energy);

    // Twice the height of E above the minimum, or the rise over a quarter radian for steady motion.
    constexpr double least_half_width = 0.25;
    const auto rise_at = [&](double theta) {
        const double V = top.effective_potential_J(std::clamp(theta, 0.0, pi));
        return std::isfinite(V) ? V - well.bottom_J : 0.0;
    };
    const double width = nutation.theta_max_rad - nutation.theta_min_rad;
    double depth = energy - well.bottom_J;
    if (!(width > 0.1)) {
        depth = std::max({depth, 0.5 * rise_at(well.theta_bottom - least_half_width),
                          0.5 * rise_at(well.theta_bottom + least_half_width)});
    }
    if (!(depth > 0.0)) depth = std::max(1e-3 * std::abs(energy), 1e-300);
    well.first_J = well.bottom_J - 0.25 * depth;
    well.last_J = std::max(energy, well.bottom_J) + depth;
    well.first_theta = reaches(top, well.theta_bottom, 0.0, well.last_J);
    well.last_theta = reaches(top, well.theta_bottom, pi, well.last_J);
    // The motion itself is always included.
    well.first_theta = std::min(well.first_theta, nutation.theta_min_rad);
    well.last_theta = std::max(well.last_theta, nutation.theta_max_rad);
    if (!(well.last_theta - well.first_theta > 1e-6)) {
        well.first_theta = std::max(0.0, well.theta_bottom - least_half_width);
        well.last_theta = std::min(pi, well.theta_bottom + least_half_width);
    }
    return well;
}

}  // namespace

void make_potential_panel(Panel& panel, StageStore& store) {
    panel.needs = {.attitude = false, .herpolhode = false, .euler_angles = true};
    aim_at_pixels(panel);
    const HeavyTop& top = *panel.stage->motion.motion().heavy_top();
    const Theme& theme = panel.stage->theme;
    const Well well = well_of(top);
    const double energy = top.invariants().energy_J;

    const TextBlock energy_type =
        set_chart_type(panel, store, "E", TypeMode::math, chart_name_size);
    const TextBlock potential_type =
        set_chart_type(panel, store, "V_{\\mathrm{eff}}", TypeMode::math, chart_name_size);
    const double margin = chart_margin * panel.px;
    const ChartArea region{margin, 0.5 * margin, panel.box.width_px - margin,
                           panel.box.height_px - 0.5 * margin - panel.header_px};
    const auto n_ticks = [&](double px, double apart) {
        return std::clamp(static_cast<int>(px / (apart * panel.type_px)), 2, 10);
    };
    const double theta_margin = 0.04 * (well.last_theta - well.first_theta);
    const Axis x =
        linear_axis(std::max(0.0, well.first_theta - theta_margin),
                    std::min(pi, well.last_theta + theta_margin), n_ticks(region.width(), 120.0));
    const Axis y = linear_axis(well.first_J, well.last_J, n_ticks(region.height(), 75.0));
    const PlotFrame chart(
        panel, store, region, x, y, axis_title("$\\theta$", "rad", x.exponent),
        axis_title(phrase_in(panel.stage->scene.language, energy_title), "J", y.exponent),
        PlotFrame::numbers_px(panel, store, y),
        std::max(energy_type.width_px(), potential_type.width_px()) + 16.0 * panel.px);

    // The curve, clipped to the chart.
    CurveGeometry geometry;
    const auto point = [&](double theta) {
        return chart.at(theta, potential_below(top, theta, well.last_J));
    };
    double off_px = 0.0;
    for (const CurveSample& sample :
         sample_adaptively(point, reaches(top, well.theta_bottom, x.first, well.last_J),
                           reaches(top, well.theta_bottom, x.last, well.last_J), 64,
                           panel.stage->curve_px, most_curve_points, &off_px)) {
        geometry.points.push_back(sample.point);
    }
    const Eigen::Vector3d end = geometry.points.back();
    Curve curve = curve_of(panel, store.keep(std::move(geometry), off_px, "the potential"),
                           theme.potential, 3.6);
    curve.occlusion = Occlusion::none;

    std::vector<Curve> lines;
    std::vector<Label> labels;
    lines.push_back(PlotFrame::line(panel, chart.at(x.first, energy), chart.at(x.last, energy),
                                    theme.energy, 3.0));
    labels.push_back(chart_label(panel, energy_type, chart.area().right + 10.0 * panel.px,
                                 chart.at(0.0, energy).y(), Anchor::left_middle, theme.energy));
    labels.push_back(chart_label(panel, potential_type, end.x() + 10.0 * panel.px, end.y(),
                                 Anchor::left_middle, theme.potential));

    // Turning points, with lines down to the axis; steady motion has one.
    const TopNutation& nutation = top.nutation();
    std::vector<double> turns{nutation.theta_min_rad};
    if (nutation.theta_max_rad - nutation.theta_min_rad > 0.01 * (x.last - x.first)) {
        turns.push_back(nutation.theta_max_rad);
    }
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Eigen::Vector3d at = chart.at(turns[i], energy);
        Curve drop =
            PlotFrame::line(panel, at, {at.x(), chart.area().bottom, 0.0}, theme.angles[0], 1.8);
        drop.dash_px = 7.0 * panel.px;
        lines.push_back(drop);
        const TextBlock type = set_chart_type(panel, store,
                                              turns.size() == 1 ? "\\theta_0"
                                              : i == 0          ? "\\theta_1"
                                                                : "\\theta_2",
                                              TypeMode::math, chart_name_size);
        labels.push_back(chart_label(panel, type, at.x() + 8.0 * panel.px,
                                     chart.area().bottom + 8.0 * panel.px, Anchor::bottom_left,
                                     theme.angles[0]));
    }

    panel.draw = [&panel, &top, chart, curve, lines, labels, turns, energy, well](
                     const FrameInput& instant, ViewBuilder& builder) {
        const Theme& colours = panel.stage->theme;
        chart.draw(builder);
        builder.view.curves.insert(builder.view.curves.end(), lines.begin(), lines.end());
        builder.view.curves.push_back(curve);
        builder.view.labels.insert(builder.view.labels.end(), labels.begin(), labels.end());
        for (const double turn : turns) {
            builder.view.dots.push_back(
                PlotFrame::dot(panel, chart.at(turn, energy), colours.energy, 5.0));
        }
        // The moving point on the curve; the difference to E is the energy of the nutation.
        const double theta = instant.euler.theta_rad;
        const Eigen::Vector3d at =
            chart.at(theta, std::clamp(potential_below(top, theta, well.last_J), well.first_J,
                                       std::max(energy, well.first_J)));
        Curve kinetic = PlotFrame::line(panel, at, chart.at(theta, energy), colours.energy, 2.4);
        kinetic.opacity = 0.8;
        if (kinetic.geometry != nullptr && (chart.at(theta, energy) - at).norm() > 0.0) {
            builder.view.curves.push_back(kinetic);
        }
        builder.view.dots.push_back(PlotFrame::dot(panel, at, colours.angles[0], 8.0));
    };
}

}  // namespace poinsot
