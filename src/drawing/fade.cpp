#include "drawing/fade.h"

#include <span>

namespace poinsot {

namespace {

// How many shapes of each kind a sheet holds.
struct Filling {
    std::size_t n_planes, n_ellipsoids, n_cones, n_meshes, n_curves, n_arrows, n_dots, n_labels,
        n_wishes;
    explicit Filling(const Sheet& sheet)
        : n_planes(sheet.view.planes.size()),
          n_ellipsoids(sheet.view.ellipsoids.size()),
          n_cones(sheet.view.cones.size()),
          n_meshes(sheet.view.meshes.size()),
          n_curves(sheet.view.curves.size()),
          n_arrows(sheet.view.arrows.size()),
          n_dots(sheet.view.dots.size()),
          n_labels(sheet.view.labels.size()),
          n_wishes(sheet.wishes.size()) {}
};

template <typename Shape>
void scale(std::vector<Shape>& shapes, std::size_t from, double Shape::*opacity, double by) {
    for (Shape& shape : std::span(shapes).subspan(from)) shape.*opacity *= by;
}

// Scales what has been added since. Ellipsoids and cones have surfaces of their own opacity, with
// lines on them: their presence says how much is there of all that.
void scale_added(const Filling& since, double by, Sheet& sheet) {
    View& view = sheet.view;
    scale(view.planes, since.n_planes, &Plane::opacity, by);
    scale(view.ellipsoids, since.n_ellipsoids, &Ellipsoid::presence, by);
    scale(view.cones, since.n_cones, &Cone::presence, by);
    scale(view.meshes, since.n_meshes, &Mesh::opacity, by);
    scale(view.curves, since.n_curves, &Curve::opacity, by);
    scale(view.arrows, since.n_arrows, &Arrow::opacity, by);
    scale(view.dots, since.n_dots, &Dot::opacity, by);
    scale(view.labels, since.n_labels, &Label::opacity, by);
    scale(sheet.wishes, since.n_wishes, &LabelWish::opacity, by);
}

}  // namespace

Drawer fading(StageData& stage, const std::string& name, Drawer draw) {
    stage.can_fade.insert(name);
    if (!stage.timeline.fades(name)) return draw;
    return [&stage, name, draw = std::move(draw)](const Instant& instant, Sheet& sheet) {
        const double opacity = stage.timeline.opacity_of(name, instant.film_s);
        if (!(opacity > 0.0)) return;
        const Filling before(sheet);
        draw(instant, sheet);
        if (opacity < 1.0) scale_added(before, opacity, sheet);
    };
}

}  // namespace poinsot
