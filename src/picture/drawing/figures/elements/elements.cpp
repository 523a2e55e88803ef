#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drawing/figures/elements/element_rows.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/overlay.h"
#include "error/error.h"
#include "scene/scene_error.h"
#include "text/nearest.h"

namespace poinsot {

Drawer make_ellipsoid(const Panel& panel, StageStore&) {
    const Ellipsoid ellipsoid = ellipsoid_of(panel);
    return [&panel, ellipsoid](const FrameInput& instant, ViewBuilder& builder) {
        builder.view.ellipsoids.push_back(ellipsoid);
        builder.view.ellipsoids.back().half_axes =
            picture_of(panel).principal_axes(instant) * picture_of(panel).half_axes.asDiagonal();
    };
}

Drawer make_axes(const Panel& panel, StageStore& store) {
    const std::array<TextBlock, 3> types = set_axis_labels(panel, store);
    // The arcs of the turn end on the principal axes.
    const double least_length = is_shown(*panel.stage, "turn") ? given_axis_length : 0.0;
    return [&panel, types, least_length](const FrameInput& instant, ViewBuilder& builder) {
        const Eigen::Vector3d lengths =
            (picture_of(panel).half_axes.array() + axis_overhang).max(least_length);
        add_principal_axes(panel, picture_of(panel).principal_axes(instant) * lengths.asDiagonal(),
                           0.85, types, builder, axis_label_turn_rad);
    };
}

Drawer make_cones(const Panel& panel, StageStore&) {
    if (!picture_of(panel).cones) {
        throw InputError("show: cones need a body with exactly two equal moments; leave them out");
    }
    // Both cones have their apex at the centre and share a generator along ω that ends at the
    // plane: their rims touch at the contact point.
    return [&panel, cones = *picture_of(panel).cones](const FrameInput& instant,
                                                      ViewBuilder& builder) {
        const double reach = picture_of(panel).contact(instant).norm();
        const Eigen::Matrix3d axes = picture_of(panel).principal_axes(instant);
        const Eigen::Vector3d symmetry = axes.col(cones.symmetry_axis);
        Cone body;
        body.axis = picture_of(panel).contact(instant).dot(symmetry) < 0.0
                        ? Eigen::Vector3d(-symmetry)
                        : symmetry;
        body.half_angle_rad = cones.body_half_angle_rad;
        body.length = reach * std::cos(cones.body_half_angle_rad);
        body.colour = panel.stage->theme.body_cone;
        body.reference = axes.col((cones.symmetry_axis + 1) % 3);
        body.rim_px = 2.0 * panel.px;
        body.name = {"cones", 0, "body"};
        builder.view.cones.push_back(body);

        Cone space;
        space.axis = picture_of(panel).normal;
        space.half_angle_rad = cones.space_half_angle_rad;
        space.length = reach * std::cos(cones.space_half_angle_rad);
        space.colour = panel.stage->theme.space_cone;
        space.reference = Eigen::Vector3d::UnitX();
        space.rim_px = 2.0 * panel.px;
        space.name = {"cones", 0, "space"};
        builder.view.cones.push_back(space);
    };
}

std::span<const Element> elements() { return element_rows; }

bool is_shown(const StageContext& stage, std::string_view name) {
    const std::vector<std::string>& show = stage.scene.show;
    if (show.empty()) return element_named(name).by_default(stage);
    return std::find(show.begin(), show.end(), name) != show.end();
}

void check_element_names(const Scene& scene) {
    const auto check = [](const std::vector<std::string>& names) {
        for (const std::string& name : names)
            if (!is_overlay(name)) element_named(name);
    };
    at_scene_key(scene, "page.elements",
                 [&] { check(scene.page.elements.value_or(std::vector<std::string>{})); });
    at_scene_key(scene, "show", [&] { check(scene.show); });
}

Drawer make_shown_elements(Panel& panel, StageStore& store, PanelUses shown_in) {
    const StageContext& stage = *panel.stage;
    check_element_names(stage.scene);
    std::vector<Drawer> drawers;
    const auto make = [&] {
        for (const Element& element : elements()) {
            if (element.shown_in != shown_in || !is_shown(stage, element.name)) continue;
            panel.needs = united(panel.needs, element.needs);
            panel.shows_comparison = panel.shows_comparison || element.reads_comparison;
            drawers.push_back(
                fading(stage, store, std::string(element.name), element.make(panel, store)));
        }
    };
    if (stage.scene.show.empty())
        make();
    else
        at_scene_key(stage.scene, "show", make);
    return [drawers](const FrameInput& instant, ViewBuilder& builder) {
        for (const Drawer& draw : drawers) draw(instant, builder);
    };
}

const Element& element_named(std::string_view name) {
    if (const Element* row = find_row(element_rows, name)) return *row;
    throw InputError(unknown("element", name, names_of(element_rows)));
}

}  // namespace poinsot
