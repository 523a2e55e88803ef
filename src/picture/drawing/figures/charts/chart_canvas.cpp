#include "drawing/figures/charts/chart_canvas.h"

#include <cmath>
#include <utility>

#include "shapes/identity.h"

namespace poinsot {

ChartCanvas::ChartCanvas(const Theme& theme, FontSource fonts, int width_px, int height_px,
                         double scale)
    : theme_(&theme),
      width_px_(width_px),
      height_px_(height_px),
      scale_(scale),
      type_case_(std::move(fonts)) {}

void ChartCanvas::add_line(std::vector<Eigen::Vector3d> points, double width_px,
                           const Colour& colour, double dash_px) {
    CurveGeometry& geometry = geometries_.emplace_back();
    geometry.id = next_identity();
    // y is down in the picture's pixels and up in the view.
    for (Eigen::Vector3d& point : points) point.y() = height_px_ - point.y();
    geometry.points = std::move(points);
    Curve curve;
    curve.geometry = &geometry;
    curve.width_px = width_px * scale_;
    curve.colour = colour;
    curve.dash_px = dash_px * scale_;
    curve.occlusion = Occlusion::none;
    curves_.push_back(curve);
}

void ChartCanvas::add_dot(double x_px, double y_px, double radius_px, const Colour& colour,
                          const Colour& rim_colour, double rim_px) {
    Dot dot;
    dot.at = {x_px, height_px_ - y_px, 0.0};
    dot.radius_px = radius_px * scale_;
    dot.colour = colour;
    dot.rim_colour = rim_colour;
    dot.rim_px = rim_px * scale_;
    dot.occlusion = Occlusion::none;
    dots_.push_back(dot);
}

double ChartCanvas::add_type(const std::string& text, double size_px, const Eigen::Vector2d& at_px,
                             const Eigen::Vector2d& align, const Colour& colour) {
    const TextBlock type =
        type_case_.set(text, {.size_px = size_px * scale_, .mode = TypeMode::text});
    if (type.mask->width == 0) return 0.0;
    Label label;
    label.mask = type.mask;
    label.top_left_px = {std::round(at_px.x() - align.x() * type.mask->width),
                         std::round(at_px.y() - align.y() * type.mask->height)};
    label.colour = colour;
    labels_.push_back(label);
    return type.mask->width;
}

void ChartCanvas::request_name(const std::string& name, const Eigen::Vector3d& beside,
                               const Eigen::Vector2d& away, const Colour& colour) {
    if (name.empty()) return;
    LabelRequest request;
    request.type = type_case_.set(name, {.size_px = 26.0 * scale_, .mode = TypeMode::text});
    request.anchor_px = beside.head<2>();
    request.away = away;
    request.gap_px = 12.0 * scale_;
    request.colour = colour;
    if (request.type.mask->width > 0) requests_.push_back(request);
}

Drawing ChartCanvas::drawing() const {
    View view;
    view.width_px = width_px_;
    view.height_px = height_px_;
    view.background = theme_->background;
    view.background.top = view.background.bottom;
    view.camera.orthographic = true;
    view.camera.height_units = height_px_;
    view.camera.target = {0.5 * width_px_, 0.5 * height_px_, 0.0};
    view.camera.eye = view.camera.target + Eigen::Vector3d(0.0, 0.0, height_px_);
    view.camera.up = Eigen::Vector3d::UnitY();
    view.curves = curves_;
    view.dots = dots_;
    view.labels = labels_;
    LabelRules rules;
    rules.halo = theme_->halo;
    rules.halo_px = 3.0 * scale_;
    rules.margin_px = 0.0;
    place_labels(requests_, rules, view);

    Drawing drawing;
    drawing.width_px = width_px_;
    drawing.height_px = height_px_;
    drawing.background = view.background;
    drawing.views.push_back(std::move(view));
    return drawing;
}

}  // namespace poinsot
