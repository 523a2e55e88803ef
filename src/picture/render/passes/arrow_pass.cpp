#include "render/passes/arrow_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/passes/colour.h"
#include "shapes/depth_order.h"

namespace poinsot {
namespace {

// The shape of an arrow: sizes in view units, positions in the picture.
struct ArrowShape {
    bool seen = false;
    Eigen::Vector3d axis, tail, neck, tip;
    double shaft_radius = 0.0, head_radius = 0.0, head_length = 0.0, length = 0.0;
    Eigen::Vector2d tail_px, neck_px, tip_px;
    double tail_scale = 1.0, neck_scale = 1.0, tip_scale = 1.0;  // pixels per unit
    double open = 0.0;  // minor over major axis of the ellipses as which circles about the axis
                        // appear
    PixelBox box;
};

ArrowShape shape_of(const Projection& p, const Camera& camera, const Arrow& arrow) {
    ArrowShape shape;
    const Eigen::Vector3d run = arrow.tip - arrow.tail;
    shape.length = run.norm();
    if (!(shape.length > 0.0) || arrow.opacity <= 0.0) return shape;
    shape.axis = run / shape.length;
    // Sizes apply at the depth of the camera's target.
    const double unit_px = p.scale(std::max(p.depth(camera.target), 1e-9));
    shape.shaft_radius = 0.5 * arrow.shaft_px / unit_px;
    shape.head_radius = 0.5 * arrow.head_px / unit_px;
    shape.head_length = std::min(arrow.head_length_px / unit_px, shape.length);
    shape.tail = arrow.tail;
    shape.tip = arrow.tip;
    shape.neck = arrow.tip - shape.head_length * shape.axis;
    const double reach = std::max(shape.head_radius, shape.shaft_radius);
    if (p.perspective && std::min(p.depth(shape.tail), p.depth(shape.tip)) <= p.near_depth + reach)
        return shape;
    shape.tail_px = p.place(shape.tail);
    shape.neck_px = p.place(shape.neck);
    shape.tip_px = p.place(shape.tip);
    shape.tail_scale = p.scale(p.depth(shape.tail));
    shape.neck_scale = p.scale(p.depth(shape.neck));
    shape.tip_scale = p.scale(p.depth(shape.tip));
    // Circles about the axis appear open where the line of sight to the head is parallel to the
    // axis.
    const Eigen::Vector3d sight = p.perspective ? (shape.neck - p.eye).normalized() : p.forward;
    shape.open = std::max(std::abs(sight.dot(shape.axis)), 0.03);
    shape.box.add(shape.tail_px, reach * shape.tail_scale + 2.0);
    shape.box.add(shape.neck_px, reach * shape.neck_scale + 2.0);
    shape.box.add(shape.tip_px, 2.0);
    shape.seen = !shape.box.within(box_of(p)).empty();
    return shape;
}

// Rectangles along the arrow's axis, in pixels from the tail. The shaft's rectangle ends where the
// head's begins; the head's has the ends of their common edge among its corners, so that no pixel
// is in both, however corners are rounded.
struct ArrowFrame {
    Eigen::Vector2d origin, along, across;
    double start, head_start, end;
    double shaft_reach, head_reach;

    explicit ArrowFrame(const ArrowShape& shape) : origin(shape.tail_px) {
        constexpr double margin = 1.5;
        const Eigen::Vector2d run = shape.tip_px - shape.tail_px;
        along = run.norm() > 1e-3 ? Eigen::Vector2d(run.normalized()) : Eigen::Vector2d::UnitX();
        across = {-along.y(), along.x()};
        const double neck = along.dot(shape.neck_px - shape.tail_px);
        const double head = shape.head_radius * shape.neck_scale;
        const double tail = shape.shaft_radius * shape.tail_scale;
        shaft_reach = std::max(tail, shape.shaft_radius * shape.neck_scale) + margin;
        head_reach = std::max(head, shaft_reach - margin) + margin;
        start = -shape.open * tail - margin;
        head_start = neck - shape.open * head - margin;
        end = std::max(run.norm(), neck + shape.open * head) + margin;
    }
    Eigen::Vector2d corner(double at, double aside) const {
        return origin + at * along + aside * across;
    }
};

PixelPolygon shaft_polygon(const ArrowShape& shape) {
    const ArrowFrame frame(shape);
    PixelPolygon polygon;
    if (frame.start >= frame.head_start) return polygon;
    polygon.add(frame.corner(frame.start, -frame.shaft_reach));
    polygon.add(frame.corner(frame.head_start, -frame.shaft_reach));
    polygon.add(frame.corner(frame.head_start, frame.shaft_reach));
    polygon.add(frame.corner(frame.start, frame.shaft_reach));
    return polygon;
}

PixelPolygon head_polygon(const ArrowShape& shape) {
    const ArrowFrame frame(shape);
    PixelPolygon polygon;
    if (frame.head_start >= frame.end) return polygon;
    polygon.add(frame.corner(frame.end, -frame.head_reach));
    polygon.add(frame.corner(frame.end, frame.head_reach));
    for (const double aside :
         {frame.head_reach, frame.shaft_reach, -frame.shaft_reach, -frame.head_reach})
        polygon.add(frame.corner(frame.head_start, aside));
    return polygon;
}

glm::vec4 ends(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return {to_glm(a), to_glm(b)};
}

double layer_number(ArrowPass::Layer layer) {
    return layer == ArrowPass::Layer::visible ? 1.0 : 0.0;
}

}  // namespace

ArrowPass::ArrowProgram::ArrowProgram(const Solids& solids)
    : PolygonProgram("arrow.frag", 17 + solids.n_constants(), solids.defines()) {}

ArrowPass::DotProgram::DotProgram(const Solids& solids)
    : PolygonProgram("dot.frag", 9 + solids.n_constants(), solids.defines()) {}

void ArrowPass::order(const ViewScene& scene) {
    const View& view = *scene.view;
    const Projection& p = scene.projection;
    const auto seen = [&p](const Eigen::Vector3d& point) {
        return SeenPoint{p.place(point), p.depth(point)};
    };
    std::vector<SeenAxis> arrows;
    arrows.reserve(view.arrows.size());
    for (const Arrow& arrow : view.arrows) arrows.push_back({seen(arrow.tail), seen(arrow.tip)});
    std::vector<SeenPoint> dots;
    dots.reserve(view.dots.size());
    for (const Dot& dot : view.dots) dots.push_back(seen(dot.at));
    order_ = back_to_front(arrows, dots, p.perspective);
}

void ArrowPass::draw(const ViewScene& scene, Layer layer) {
    const auto n_arrows = scene.view->arrows.size();
    for (const std::size_t i : order_) {
        if (i < n_arrows)
            draw_arrow(scene, scene.view->arrows[i], layer);
        else
            draw_dot(scene, scene.view->dots[i - n_arrows], layer);
    }
}

void ArrowPass::draw_arrow(const ViewScene& scene, const Arrow& arrow, Layer layer) {
    const Projection& p = scene.projection;
    const bool occluded = arrow.occlusion == Occlusion::by_solids;
    if (!occluded && layer == Layer::hidden) return;
    const ArrowShape shape = shape_of(p, scene.view->camera, arrow);
    if (!shape.seen) return;
    const ArrowProgram& made =
        occluded ? arrow_programs_.of(scene.solids()) : arrow_programs_.of(Solids{});
    const double shaft_length = std::max(shape.length - shape.head_length, 1e-9);
    // Lines of sight start beside the arrow's middle, for numerical accuracy.
    const Eigen::Vector3d middle = 0.5 * (shape.tail + shape.tip);
    const Eigen::Vector2d anchor = p.place(middle);
    Constants constants;
    scene.add_view(constants);
    scene.add_light(constants);
    constants.add(ends(shape.tail_px, shape.neck_px));
    constants.add(ends(shape.neck_px, shape.tip_px));
    constants.add(shape.shaft_radius * shape.tail_scale, shape.shaft_radius * shape.neck_scale,
                  shape.open, 0.0);
    constants.add(shape.head_radius * shape.neck_scale, 0.0, shape.open, 0.0);
    constants.add(shape.axis, arrow.hidden_opacity);
    constants.add(0.0, shaft_length, shape.shaft_radius, shape.shaft_radius);
    constants.add(shaft_length, shape.head_length, shape.head_radius, 0.0);
    constants.add(middle - shape.tail, p.depth(middle));
    constants.add(anchor.x(), anchor.y(), layer_number(layer), 0.0);
    constants.add(linear_from_srgb(arrow.colour, arrow.opacity));
    if (occluded) scene.add_solids(constants);
    made.draw(shaft_polygon(shape), constants, *scene.drawing);
    made.draw(head_polygon(shape), constants, *scene.drawing);
}

void ArrowPass::draw_dot(const ViewScene& scene, const Dot& dot, Layer layer) {
    const Projection& p = scene.projection;
    const bool occluded = dot.occlusion == Occlusion::by_solids;
    if (!occluded && layer == Layer::hidden) return;
    const double depth = p.depth(dot.at);
    if (dot.opacity <= 0.0 || (p.perspective && depth <= p.near_depth)) return;
    PixelBox box;
    box.add(p.place(dot.at), dot.radius_px + 1.5);
    if (box.within(box_of(p)).empty()) return;
    const DotProgram& made =
        occluded ? dot_programs_.of(scene.solids()) : dot_programs_.of(Solids{});
    const Eigen::Vector2d pixel = p.place(dot.at);
    Constants constants;
    scene.add_view(constants);
    constants.add(pixel.x(), pixel.y(), depth, dot.radius_px);
    constants.add(linear_from_srgb(dot.colour, dot.opacity));
    constants.add(linear_from_srgb(dot.rim_colour, dot.rim_px));
    constants.add(dot.hidden_opacity, layer_number(layer), 0.0, 0.0);
    if (occluded) scene.add_solids(constants);
    made.draw(polygon_of(box), constants, *scene.drawing);
}

void ArrowPass::mark(const ViewScene& scene, TileMask& marks) const {
    const Projection& p = scene.projection;
    for (const Arrow& arrow : scene.view->arrows) {
        const ArrowShape shape = shape_of(p, scene.view->camera, arrow);
        if (!shape.seen) continue;
        marks.mark(shaft_polygon(shape), box_of(p));
        marks.mark(head_polygon(shape), box_of(p));
    }
    for (const Dot& dot : scene.view->dots) {
        if (p.perspective && p.depth(dot.at) <= p.near_depth) continue;
        PixelBox box;
        box.add(p.place(dot.at), dot.radius_px + 1.5);
        marks.mark(box.within(box_of(p)));
    }
}

}  // namespace poinsot
