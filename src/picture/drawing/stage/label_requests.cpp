#include "drawing/stage/label_requests.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "drawing/stage/type/scene_symbols.h"
#include "scene/scene_error.h"
#include "shapes/projection.h"

namespace poinsot {

double label_em_px(const Panel& panel) {
    return type_sizes(*panel.stage).vector_name * panel.type_px;
}

TextBlock set_label(const Panel& panel, StageStore& store, std::string_view text, double scale) {
    // On paper all names have one size.
    constexpr double least_name_scale = 0.75;
    if (is_on_paper(*panel.stage) && scale >= least_name_scale) scale = 1.0;
    const TypeStyle style{.size_px =
                              std::max(scale * label_em_px(panel) *
                                           panel.stage->scene.style.label_scale.value_or(1.0),
                                       least_type_px(*panel.stage))};
    return at_scene_key(panel.stage->scene, "symbols",
                        [&] { return store.set(named_by_scene(panel.stage->scene, text), style); });
}

std::array<TextBlock, 3> set_axis_labels(const Panel& panel, StageStore& store) {
    constexpr double scale = 0.85;
    return {set_label(panel, store, "\\mathbf{e}_1", scale),
            set_label(panel, store, "\\mathbf{e}_2", scale),
            set_label(panel, store, "\\mathbf{e}_3", scale)};
}

std::array<TextBlock, 3> set_half_axis_labels(const Panel& panel, StageStore& store, double scale) {
    return {set_label(panel, store, "1/\\sqrt{I_1}", scale),
            set_label(panel, store, "1/\\sqrt{I_2}", scale),
            set_label(panel, store, "1/\\sqrt{I_3}", scale)};
}

void request_label_beside(const Panel& panel, const Eigen::Vector3d& at,
                          const Eigen::Vector3d& away_from, const TextBlock& type,
                          const Colour& colour, ViewBuilder& builder) {
    const Eigen::Vector2d anchor = project(builder.view, at).px;
    LabelRequest request;
    request.type = type;
    request.anchor_px = anchor;
    request.away = (anchor - project(builder.view, away_from).px) / (100.0 * panel.px);
    request.gap_px = 9.0 * panel.px;
    request.colour = colour;
    request.at = at;
    builder.requests.push_back(request);
}

void request_label_at_tip(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                          ViewBuilder& builder, double turn_rad) {
    request_label_beside(panel, arrow.tip, arrow.tail, type, arrow.colour, builder);
    // y is down in the picture, so that a positive angle is clockwise.
    Eigen::Vector2d& away = builder.requests.back().away;
    away = Eigen::Rotation2Dd(turn_rad) * away;
    builder.requests.back().at = arrow.tip;
    builder.requests.back().side = turn_rad < 0.0 ? -1 : 1;
}

void add_named_arrow(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                     ViewBuilder& builder, double turn_rad) {
    builder.view.arrows.push_back(arrow);
    request_label_at_tip(panel, arrow, type, builder, turn_rad);
}

void add_principal_axes(const Panel& panel, const Eigen::Matrix3d& tips, double weight,
                        const std::array<TextBlock, 3>& types, ViewBuilder& builder,
                        double turn_rad) {
    for (int i = 0; i < 3; ++i)
        add_named_arrow(panel, arrow_to(panel, tips.col(i), panel.stage->theme.axes[i], weight),
                        types[static_cast<std::size_t>(i)], builder, turn_rad);
}

void add_turn(const Panel& panel, const Turn& turn, const LineStyle& ink, const TextBlock& type,
              ViewBuilder& builder) {
    add_arc_arrow(panel, turn, turn.axis.unitOrthogonal(), ink, builder);
    // The label is to the right, away from the axis and the arrow.
    const Eigen::Vector3d right = camera_axes(builder.view.camera).col(0);
    request_label_beside(panel, turn.centre + 1.1 * turn.radius * right, turn.centre, type, ink,
                         builder);
}

Eigen::Vector2d offset_of_label(const StageContext& stage, std::string_view name) {
    const auto found = stage.scene.label_offsets_pt.find(name);
    if (found == stage.scene.label_offsets_pt.end()) return Eigen::Vector2d::Zero();
    return px_per_pt(stage) * found->second;
}

std::string_view name_of_label(const ShapeName& name) {
    if (name.element == "axes" && name.number >= 1 && name.number <= 3)
        return std::array<std::string_view, 3>{"e1", "e2",
                                               "e3"}[static_cast<std::size_t>(name.number - 1)];
    return name.element == "radius" ? "rho" : name.element;
}

}  // namespace poinsot
