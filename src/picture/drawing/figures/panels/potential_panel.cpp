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

// The chart of V_eff(θ) with the line of E. What all instants share, and the drawer of an instant.
class PotentialFigure {
 public:
    // The panel and its motion must outlive it.
    PotentialFigure(const Panel& panel, StageStore& store, const HeavyTop& top)
        : panel_(&panel),
          top_(&top),
          well_(well_of(top)),
          energy_J_(top.invariants().energy_J),
          energy_type_(set_chart_type(panel, store, "E", TypeMode::math, chart_name_size)),
          potential_type_(
              set_chart_type(panel, store, "V_{\\mathrm{eff}}", TypeMode::math, chart_name_size)),
          chart_(make_chart(store)) {
        add_energy();
        add_potential(store);
        add_turning_points(store);
    }

    void operator()(const FrameInput& instant, ViewBuilder& builder) const {
        const Theme& theme = panel_->stage->theme;
        chart_.draw(builder);
        builder.view.curves.insert(builder.view.curves.end(), lines_.begin(), lines_.end());
        builder.view.curves.push_back(potential_);
        builder.view.labels.insert(builder.view.labels.end(), labels_.begin(), labels_.end());
        for (const double turn : turning_points_) {
            builder.view.dots.push_back(
                PlotFrame::dot(*panel_, chart_.at(turn, energy_J_), theme.energy, 5.0));
        }
        // The moving point on the curve; the difference to E is the energy of the nutation.
        const double theta = instant.euler.theta_rad;
        const Eigen::Vector3d at =
            chart_.at(theta, std::clamp(potential_below(*top_, theta, well_.last_J), well_.first_J,
                                        std::max(energy_J_, well_.first_J)));
        const Eigen::Vector3d above = chart_.at(theta, energy_J_);
        Curve kinetic = PlotFrame::line(*panel_, at, above, theme.energy, 2.4);
        kinetic.opacity = 0.8;
        if (kinetic.geometry != nullptr && (above - at).norm() > 0.0)
            builder.view.curves.push_back(kinetic);
        builder.view.dots.push_back(PlotFrame::dot(*panel_, at, theme.angles[0], 8.0));
    }

 private:
    PlotFrame make_chart(StageStore& store) const {
        const Panel& panel = *panel_;
        const double margin = chart_margin * panel.px;
        const ChartArea region{margin, 0.5 * margin, panel.box.width_px - margin,
                               panel.box.height_px - 0.5 * margin - panel.header_px};
        const auto n_ticks = [&](double px, double apart) {
            return std::clamp(static_cast<int>(px / (apart * panel.type_px)), 2, 10);
        };
        const double theta_margin = 0.04 * (well_.last_theta - well_.first_theta);
        const Axis x = linear_axis(std::max(0.0, well_.first_theta - theta_margin),
                                   std::min(pi, well_.last_theta + theta_margin),
                                   n_ticks(region.width(), 120.0));
        const Axis y = linear_axis(well_.first_J, well_.last_J, n_ticks(region.height(), 75.0));
        return PlotFrame(
            panel, store,
            {.region = region,
             .x = x,
             .y = y,
             .x_title = axis_title("$\\theta$", "rad", x.exponent),
             .y_title =
                 axis_title(phrase_in(panel.stage->scene.language, energy_title), "J", y.exponent),
             .left_px = PlotFrame::numbers_px(panel, store, y),
             .right_px =
                 std::max(energy_type_.width_px(), potential_type_.width_px()) + 16.0 * panel.px});
    }

    // The curve, clipped to the chart, and its name at its end.
    void add_potential(StageStore& store) {
        const Panel& panel = *panel_;
        CurveGeometry geometry;
        const auto point = [&](double theta) {
            return chart_.at(theta, potential_below(*top_, theta, well_.last_J));
        };
        const auto end_towards = [&](double theta) {
            return reaches(*top_, well_.theta_bottom, theta, well_.last_J);
        };
        const SampledCurve sampled =
            sample_adaptively(point, {.first = end_towards(chart_.x().first),
                                      .last = end_towards(chart_.x().last),
                                      .n_pieces = 64,
                                      .tolerance = panel.stage->curve_px});
        for (const CurveSample& sample : sampled.samples) geometry.points.push_back(sample.point);
        const Eigen::Vector3d end = geometry.points.back();
        const LineStyle& ink = panel.stage->theme.potential;
        potential_ = curve_of(panel, store.keep(std::move(geometry), sampled.off, "the potential"),
                              ink, 3.6);
        potential_.occlusion = Occlusion::none;
        labels_.push_back(chart_label(panel, potential_type_, end.x() + 10.0 * panel.px, end.y(),
                                      Anchor::left_middle, ink));
    }

    // The line of E with its name.
    void add_energy() {
        const Panel& panel = *panel_;
        const LineStyle& ink = panel.stage->theme.energy;
        const Axis& x = chart_.x();
        lines_.push_back(PlotFrame::line(panel, chart_.at(x.first, energy_J_),
                                         chart_.at(x.last, energy_J_), ink, 3.0));
        labels_.push_back(chart_label(panel, energy_type_, chart_.area().right + 10.0 * panel.px,
                                      chart_.at(0.0, energy_J_).y(), Anchor::left_middle, ink));
    }

    // Turning points, with lines down to the axis; steady motion has one.
    void add_turning_points(StageStore& store) {
        const Panel& panel = *panel_;
        const LineStyle& ink = panel.stage->theme.angles[0];
        const TopNutation& nutation = top_->nutation();
        const Axis& x = chart_.x();
        turning_points_ = {nutation.theta_min_rad};
        if (nutation.theta_max_rad - nutation.theta_min_rad > 0.01 * (x.last - x.first))
            turning_points_.push_back(nutation.theta_max_rad);
        for (std::size_t i = 0; i < turning_points_.size(); ++i) {
            const Eigen::Vector3d at = chart_.at(turning_points_[i], energy_J_);
            Curve drop = PlotFrame::line(panel, at, {at.x(), chart_.area().bottom, 0.0}, ink, 1.8);
            drop.dash_px = 7.0 * panel.px;
            lines_.push_back(drop);
            const TextBlock type = set_chart_type(panel, store,
                                                  turning_points_.size() == 1 ? "\\theta_0"
                                                  : i == 0                    ? "\\theta_1"
                                                                              : "\\theta_2",
                                                  TypeMode::math, chart_name_size);
            labels_.push_back(chart_label(panel, type, at.x() + 8.0 * panel.px,
                                          chart_.area().bottom + 8.0 * panel.px,
                                          Anchor::bottom_left, ink));
        }
    }

    const Panel* panel_;
    const HeavyTop* top_;
    Well well_;
    double energy_J_;
    TextBlock energy_type_, potential_type_;
    PlotFrame chart_;
    Curve potential_;
    std::vector<Curve> lines_;
    std::vector<Label> labels_;
    std::vector<double> turning_points_;
};

}  // namespace

void make_potential_panel(Panel& panel, StageStore& store) {
    panel.needs = {.attitude = false, .herpolhode = false, .euler_angles = true};
    aim_at_pixels(panel);
    panel.draw = PotentialFigure(panel, store, *panel.stage->motion.motion().heavy_top());
}

}  // namespace poinsot
