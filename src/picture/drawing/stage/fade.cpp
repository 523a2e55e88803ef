#include "drawing/stage/fade.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace poinsot {

namespace {

// Number of shapes in each list of a builder.
std::vector<std::size_t> filling_of(ViewBuilder& builder) {
    std::vector<std::size_t> sizes;
    for_each_list(builder.view, [&](const auto& list) { sizes.push_back(list.size()); });
    sizes.push_back(builder.requests.size());
    return sizes;
}

// The value that scales a shape's opacity. Shapes with a surface and lines on it have `presence`,
// which scales both.
template <typename Shape>
double& share_of(Shape& shape) {
    if constexpr (requires { shape.presence; })
        return shape.presence;
    else
        return shape.opacity;
}

// Scales the shapes added since the counts `since` were taken.
void scale_added(const std::vector<std::size_t>& since, double by, ViewBuilder& builder) {
    auto n_before = since.begin();
    const auto scale = [&](auto& list) {
        for (auto& shape : std::span(list).subspan(*n_before++)) share_of(shape) *= by;
    };
    for_each_list(builder.view, scale);
    scale(builder.requests);
}

// A drawer without the labels.
Drawer without_names(Drawer draw) {
    return [draw = std::move(draw)](const FrameInput& instant, ViewBuilder& builder) {
        const std::size_t n_before = builder.requests.size();
        draw(instant, builder);
        builder.requests.erase(builder.requests.begin() + static_cast<std::ptrdiff_t>(n_before),
                               builder.requests.end());
    };
}

template <typename Shape>
bool is_unnamed(const Shape& shape) {
    return shape.name.element.empty();
}

template <typename Shape>
bool has_unnamed(const std::vector<Shape>& shapes) {
    return std::any_of(shapes.begin(), shapes.end(), is_unnamed<Shape>);
}

template <typename Shape>
void name_all(ShapeName name, bool numbers, std::vector<Shape>& shapes) {
    numbers = numbers && std::count_if(shapes.begin(), shapes.end(), is_unnamed<Shape>) > 1;
    for (Shape& shape : shapes) {
        if (!is_unnamed(shape)) continue;
        if (numbers) ++name.number;
        shape.name = name;
    }
}

}  // namespace

void name_shapes(std::string_view element, ViewBuilder& builder) {
    View& view = builder.view;
    bool has_main = false;
    for_each(static_cast<SolidLists&>(view), [&](auto& solids) {
        has_main = has_main || has_unnamed(solids);
        name_all({element}, false, solids);
    });
    const auto name = [&](auto& shapes, std::string_view part, bool numbers) {
        if (!has_unnamed(shapes)) return;
        name_all({element, 0, has_main ? part : ""}, numbers, shapes);
        has_main = true;
    };
    name(view.arrows, "arrow", true);
    name(view.curves, "lines", false);
    name(view.dots, "dots", false);
    name_all({element}, false, view.labels);
    name_all({element}, true, builder.requests);
}

Drawer fading(const StageContext& stage, StageStore& store, const std::string& name, Drawer draw) {
    const std::string_view kept = store.add_name(name);
    const std::vector<std::string>& without = stage.scene.unlabelled;
    if (!stage.scene.labels || std::find(without.begin(), without.end(), name) != without.end())
        draw = without_names(std::move(draw));
    draw = [kept, draw = std::move(draw)](const FrameInput& instant, ViewBuilder& builder) {
        draw(instant, builder);
        name_shapes(kept, builder);
    };
    if (!stage.timeline.fades(name)) return draw;
    return [&stage, name, draw = std::move(draw)](const FrameInput& instant, ViewBuilder& builder) {
        const double opacity = stage.timeline.opacity_of(name, instant.film_s);
        if (!(opacity > 0.0)) return;
        const std::vector<std::size_t> before = filling_of(builder);
        draw(instant, builder);
        if (opacity < 1.0) scale_added(before, opacity, builder);
    };
}

}  // namespace poinsot
