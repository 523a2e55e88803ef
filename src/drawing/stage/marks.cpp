#include "drawing/stage/marks.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "numerics/smooth_step.h"
#include "scene/scene_error.h"
#include "shapes/projection.h"

namespace poinsot {

Eigen::Vector3d omega_tip(const Eigen::Vector3d& rho) {
    constexpr double omega_length = 1.30;
    return rho * (omega_length * std::max(1.0, 1.0 / rho.norm()));
}

Eigen::Vector3d past_contact(const Eigen::Vector3d& rho) {
    constexpr double beyond = 0.2;
    return rho + beyond * rho.stableNormalized();
}

Eigen::Vector3d spin_axis_end(const Eigen::Vector3d& rho) {
    // Less than L beyond the plane, so that the head of L is seen where both are along one line.
    constexpr double beyond = 0.26;
    return rho + beyond * rho.stableNormalized();
}

Eigen::Vector3d momentum_tip(const ConstructionPicture& picture) {
    return (picture.plane_distance + momentum_beyond_plane) * picture.normal;
}

Arrow arrow_between(const Panel& panel, const Eigen::Vector3d& tail, const Eigen::Vector3d& tip,
                    const LineStyle& ink, double weight) {
    Arrow arrow;
    arrow.tail = tail;
    arrow.tip = tip;
    arrow.colour = ink;
    weight *= ink.weight;
    arrow.shaft_px = 4.0 * weight * panel.px;
    arrow.head_px = 16.0 * weight * panel.px;
    arrow.head_length_px = 26.0 * weight * panel.px;
    const double length_px = (tip - tail).norm() / panel.units_per_px;
    const double scale = std::min(1.0, 0.4 * length_px / arrow.head_length_px);
    arrow.shaft_px *= scale;
    arrow.head_px *= scale;
    arrow.head_length_px *= scale;
    arrow.dash_px = dash_of(panel, ink);
    return arrow;
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

void mark_arrows_at_viewer(const Panel& panel, View& view) {
    // Excludes heads of arcs, and arrows hardly longer than their heads.
    const double least_length_px = 80.0 * panel.px;
    for (Arrow& arrow : view.arrows) {
        const Projected tip = project(view, arrow.tip);
        const Eigen::Vector3d way = arrow.tip - arrow.tail;
        const double length_px = way.norm() / units_per_pixel(view, tip.depth);
        if (!(length_px > least_length_px) || !(arrow.opacity > 0.0)) continue;
        const Eigen::Vector3d to_eye =
            view.camera.orthographic ? Eigen::Vector3d(camera_axes(view.camera).col(2))
                                     : Eigen::Vector3d((view.camera.eye - arrow.tip).normalized());
        if (!(way.dot(to_eye) > 0.5 * way.norm())) continue;
        const double seen_px = (tip.px - project(view, arrow.tail).px).norm();
        const double presence = smooth_step(1.6 - seen_px / (0.75 * arrow.head_length_px));
        if (!(presence > 0.0)) continue;
        Dot ring;
        ring.at = arrow.tip;
        ring.radius_px = 0.62 * arrow.head_px;
        ring.rim_px = 0.2 * arrow.head_px;
        ring.colour = panel.stage->theme.halo;
        ring.rim_colour = arrow.colour;
        ring.opacity = presence * arrow.opacity;
        ring.hidden_opacity = arrow.hidden_opacity;
        ring.name = {arrow.name.element, arrow.name.number, "ring"};
        Dot point = ring;
        point.at += 1e-3 * to_eye;
        point.radius_px = 0.2 * arrow.head_px;
        point.rim_px = 0.0;
        point.colour = arrow.colour;
        view.dots.push_back(ring);
        view.dots.push_back(point);
        arrow.opacity *= 1.0 - presence;
    }
}

Ellipsoid ellipsoid_of(const Panel& panel) {
    Ellipsoid ellipsoid;
    ellipsoid.colour = panel.stage->theme.ellipsoid;
    ellipsoid.opacity = panel.stage->theme.ellipsoid_opacity;
    ellipsoid.line_colour = panel.stage->theme.ellipsoid_lines;
    ellipsoid.section_px = 1.7 * panel.px;
    ellipsoid.ruling_px = 0.9 * panel.px;
    return ellipsoid;
}

double paper_type_px(const Scene& scene, double px, const LeastSizes& least) {
    constexpr double script_share = 0.7;  // of a subscript, as the fonts for formulas say
    const double name_px = label_size * scene.type_scale;
    return std::max({px, least.type_px / name_px, least.script_px / (script_share * name_px)});
}

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

namespace {

// Whether the L at a position of a formula is a complete symbol: the length of L.
bool is_length_of_L(std::string_view formula, std::size_t at) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    if (formula[at] != 'L') return false;
    if (at > 0 && (is_letter(formula[at - 1]) || formula[at - 1] == '\\')) return false;
    return at + 1 == formula.size() || !is_letter(formula[at + 1]);
}

// Whether an L in words is a separate word: between spaces, ends of the text, or characters of
// other scripts.
bool is_word_L(std::string_view words, std::size_t at) {
    const auto parts = [](char c) { return c == ' ' || static_cast<unsigned char>(c) >= 0x80; };
    return words[at] == 'L' && (at == 0 || parts(words[at - 1])) &&
           (at + 1 == words.size() || parts(words[at + 1]));
}

}  // namespace

std::string named_by_scene(const Scene& scene, std::string_view formula) {
    const SymbolsSpec& own = scene.symbols;
    struct Name {
        std::string_view symbol;
        const std::string& own;
        std::string by;
    };
    const Name names[] = {
        {"\\boldsymbol{\\omega}", own.omega, own.omega},
        {"\\mathbf{L}", own.momentum, own.momentum},
        {"\\boldsymbol{\\rho}", own.rho, own.rho},
        {"\\mathbf{e}_1", own.e1, own.e1},
        {"\\mathbf{e}_2", own.e2, own.e2},
        {"\\mathbf{e}_3", own.e3, own.e3},
        {"\\omega_", own.omega, fmt::format("{{{}}}_", own.omega)},
        {"L_", own.momentum, fmt::format("{{{}}}_", own.momentum)},
    };
    std::string named;
    // Inserted text is not searched again, since it may contain the symbol itself.
    for (std::size_t at = 0; at < formula.size();) {
        const auto* const name =
            std::find_if(std::begin(names), std::end(names), [&](const Name& each) {
                return !each.own.empty() && formula.substr(at).starts_with(each.symbol);
            });
        if (name != std::end(names)) {
            named += name->by;
            at += name->symbol.size();
        } else if (!own.momentum.empty() && is_length_of_L(formula, at)) {
            named += fmt::format("|{}|", own.momentum);
            ++at;
        } else {
            named += formula[at++];
        }
    }
    return named;
}

std::string title_named_by_scene(const Scene& scene, std::string_view title) {
    std::string named;
    while (!title.empty()) {
        const std::size_t end = std::min(title.find('$'), title.size());
        const std::string_view words = title.substr(0, end);
        for (std::size_t at = 0; at < words.size(); ++at)
            named += !scene.symbols.momentum.empty() && is_word_L(words, at)
                         ? fmt::format("${}$", scene.symbols.momentum)
                         : std::string(1, words[at]);
        title.remove_prefix(end);
        if (title.empty()) break;
        const std::size_t close = std::min(title.find('$', 1), title.size());
        named += fmt::format("${}$", named_by_scene(scene, title.substr(1, close - 1)));
        title.remove_prefix(std::min(close + 1, title.size()));
    }
    return named;
}

void wish_at_tip(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                 ViewBuilder& builder, double turn_rad) {
    wish_beside(panel, arrow.tip, arrow.tail, type, arrow.colour, builder);
    // y is down in the picture, so that a positive angle is clockwise.
    Eigen::Vector2d& away = builder.requests.back().away;
    away = Eigen::Rotation2Dd(turn_rad) * away;
    builder.requests.back().at = arrow.tip;
    builder.requests.back().side = turn_rad < 0.0 ? -1 : 1;
}

void add_named_arrow(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                     ViewBuilder& builder, double turn_rad) {
    builder.view.arrows.push_back(arrow);
    wish_at_tip(panel, arrow, type, builder, turn_rad);
}

void add_principal_axes(const Panel& panel, const Eigen::Matrix3d& tips, double weight,
                        const std::array<TextBlock, 3>& types, ViewBuilder& builder,
                        double turn_rad) {
    for (int i = 0; i < 3; ++i)
        add_named_arrow(panel, arrow_to(panel, tips.col(i), panel.stage->theme.axes[i], weight),
                        types[static_cast<std::size_t>(i)], builder, turn_rad);
}

void wish_beside(const Panel& panel, const Eigen::Vector3d& at, const Eigen::Vector3d& away_from,
                 const TextBlock& type, const Colour& colour, ViewBuilder& builder) {
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

Dot dot_at(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour, double radius_px) {
    Dot dot;
    dot.at = at;
    dot.radius_px = radius_px * panel.px;
    dot.rim_px = 1.6 * panel.px;
    dot.colour = colour;
    dot.rim_colour = panel.stage->theme.halo;
    dot.hidden_opacity = 0.8;
    return dot;
}

double dash_of(const Panel& panel, const LineStyle& ink, double usual_px) {
    if (!ink.line) return usual_px * panel.px;
    switch (*ink.line) {
        case DashPattern::dashed:
            return 13.0 * panel.px;
        case DashPattern::dotted:
            return 4.0 * panel.px;
        default:
            return 0.0;
    }
}

Curve curve_of(const Panel& panel, const CurveGeometry* geometry, const LineStyle& ink,
               double width_px) {
    Curve curve;
    curve.geometry = geometry;
    curve.width_px = width_px * ink.weight * panel.px;
    curve.colour = ink;
    curve.dash_px = dash_of(panel, ink);
    return curve;
}

double least_type_px(const StageContext& stage) {
    constexpr double least = 1080.0 / 45.0;
    return stage.options.line_scale > 0.0 ? stage.options.least.type_px
                                          : least * stage.scene.type_scale * stage.px;
}

double px_per_pt(const StageContext& stage) {
    constexpr double slide_height_pt = 540.0;
    return stage.options.px_per_pt > 0.0 ? stage.options.px_per_pt
                                         : stage.options.height_px / slide_height_pt;
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

Curve arc_about(const Panel& panel, const Eigen::Vector3d& centre, const Eigen::Vector3d& from,
                const Eigen::Vector3d& towards, double radius, double angle_rad,
                const LineStyle& ink, double width_px) {
    const CurveGeometry* circle = panel.unit_circle;
    Curve arc = curve_of(panel, circle, ink, width_px);
    const Eigen::Vector3d across = angle_rad < 0.0 ? Eigen::Vector3d(-towards) : towards;
    Eigen::Matrix3d axes;
    axes << from, across, from.cross(across);
    arc.placement.linear() = radius * axes;
    arc.placement.translation() = centre;
    const double turns = std::abs(angle_rad) / (2.0 * std::numbers::pi);
    if (turns < 1.0) arc.last = turns * static_cast<double>(circle->points.size());
    if (!(radius > 0.0)) arc.opacity = 0.0;
    return arc;
}

Curve line_between(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const LineStyle& ink, double width_px) {
    Curve line = curve_of(panel, panel.unit_segment, ink, width_px);
    const double length = (b - a).norm();
    if (!(length > 0.0)) {
        line.opacity = 0.0;
        return line;
    }
    const Eigen::Vector3d along = (b - a) / length;
    const Eigen::Vector3d across = along.unitOrthogonal();
    Eigen::Matrix3d axes;
    axes << along, across, along.cross(across);
    line.placement.linear() = length * axes;
    line.placement.translation() = a;
    return line;
}

double arc_head_rad(double radius) { return std::min(0.45, 0.12 / radius); }

void add_arc_arrow(const Panel& panel, const Turn& turn, const Eigen::Vector3d& from,
                   const LineStyle& ink, ViewBuilder& builder) {
    const Eigen::Vector3d towards = turn.axis.cross(from);
    builder.view.curves.push_back(
        arc_about(panel, turn.centre, from, towards, turn.radius, turn.angle_rad, ink, 3.2));
    const auto at = [&](double angle) {
        return Eigen::Vector3d(turn.centre +
                               turn.radius * (std::cos(angle) * from + std::sin(angle) * towards));
    };
    // The head follows the arc's end; the arc hides its shaft.
    const double head = std::copysign(arc_head_rad(turn.radius), turn.angle_rad);
    Arrow arrow = arrow_between(panel, at(turn.angle_rad - 0.2 * head),
                                at(turn.angle_rad + 0.8 * head), ink, 0.85);
    arrow.shaft_px = 3.2 * ink.weight * panel.px;
    builder.view.arrows.push_back(arrow);
}

void add_turn(const Panel& panel, const Turn& turn, const LineStyle& ink, const TextBlock& type,
              ViewBuilder& builder) {
    add_arc_arrow(panel, turn, turn.axis.unitOrthogonal(), ink, builder);
    // The label is to the right, away from the axis and the arrow.
    const Eigen::Vector3d right = camera_axes(builder.view.camera).col(0);
    wish_beside(panel, turn.centre + 1.1 * turn.radius * right, turn.centre, type, ink, builder);
}

}  // namespace poinsot
