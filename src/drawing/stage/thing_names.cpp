#include "drawing/stage/thing_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "drawing/stage/marks.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/style/theme_roles.h"
#include "numerics/smooth_step.h"
#include "scene/scene.h"
#include "scene/scene_error.h"
#include "shapes/outlines.h"
#include "shapes/projection.h"
#include "text/languages.h"

namespace poinsot {

// A row of the table of things: which shapes it has, and its name.
struct NamedThing {
    std::string_view name;     // of named_things
    std::string_view element;  // of its shapes
    std::string_view part;     // of its shape
    std::string_view role;     // of its colour in the theme
    double preferred_deg;      // where its name stands if there is room: 0 right, 90 below
    bool keeps_off_bodies;     // whether its name stands beside the ellipsoid
    Phrase words;
};

namespace {

// In this order: a name gives way to those before it.
constexpr std::array<NamedThing, named_things.size()> things{{
    {"body-cone",
     "cones",
     "body",
     "body_cone",
     225.0,
     true,
     {"body cone", "Gangpolkegel", "cône du corps", "cono del cuerpo", "cono solidale", "物体錐"}},
    {"space-cone",
     "cones",
     "space",
     "space_cone",
     30.0,
     true,
     {"space cone", "Rastpolkegel", "cône fixe", "cono fijo", "cono fisso", "空間錐"}},
    {"herpolhode",
     "herpolhode",
     "",
     "herpolhode",
     40.0,
     true,
     {"herpolhode", "Herpolhodie", "herpolhodie", "herpolodia", "erpolodia", "ハーポルホード"}},
    {"polhode",
     "polhode",
     "",
     "polhode",
     200.0,
     false,
     {"polhode", "Polhodie", "polhodie", "polodia", "polodia", "ポルホード"}},
    {"separatrix",
     "separatrix",
     "",
     "separatrix",
     320.0,
     false,
     {"separatrix", "Separatrix", "séparatrice", "separatriz", "separatrice", "分離線"}},
    {"inertia-ellipsoid",
     "ellipsoid",
     "",
     "text",
     225.0,
     true,
     {"inertia ellipsoid", "Trägheitsellipsoid", "ellipsoïde d'inertie", "elipsoide de inercia",
      "ellissoide d'inerzia", "慣性楕円体"}},
    {"unit-sphere",
     "unit-sphere",
     "",
     "text",
     135.0,
     true,
     {"unit sphere", "Einheitskugel", "sphère unité", "esfera unidad", "sfera unitaria", "単位球"}},
    {"invariable-plane",
     "plane",
     "",
     "text",
     140.0,
     true,
     {"invariable plane", "invariable Ebene", "plan invariable", "plano invariable",
      "piano invariabile", "不変平面"}},
    {"measured",
     "measured",
     "",
     "measured",
     320.0,
     true,
     {"measured", "gemessen", "mesuré", "medido", "misurato", "測定値"}},
}};

constexpr double size_of_names = 0.8;  // of the names of vectors

// What a name keeps away from.
struct Surroundings {
    std::vector<LabelBox> labels;
    struct Shaft {
        Eigen::Vector2d tail, tip;
        double head_px, opacity;
    };
    std::vector<Shaft> shafts;
    Outline lines;  // of all curves
    const View* view = nullptr;
    double margin_px = 6.0;
};

Surroundings surroundings_of(const View& view, const std::vector<LabelBox>& overlays,
                             double margin_px, bool with_lines) {
    Surroundings around;
    around.view = &view;
    around.margin_px = margin_px;
    around.labels = overlays;
    for (const Label& label : view.labels) around.labels.push_back(label_box(label));
    const Projection projection(view);
    for (const Arrow& arrow : view.arrows) {
        if (projection.depth(arrow.tail) <= projection.near_depth ||
            projection.depth(arrow.tip) <= projection.near_depth)
            continue;
        around.shafts.push_back({projection.place(arrow.tail), projection.place(arrow.tip),
                                 std::max(arrow.head_px, arrow.head_length_px),
                                 std::clamp(arrow.opacity, 0.0, 1.0)});
    }
    for (const Curve& curve : view.curves) {
        if (!with_lines || curve.opacity < 0.3 || curve.occlusion == Occlusion::none) continue;
        const Outline outline = outline_of(view, curve, 96);
        around.lines.insert(around.lines.end(), outline.begin(), outline.end());
    }
    return around;
}

// How bad a place is: 0 for a free one, about 1.5 for one on a line, and 8 on another label.
double cost_of(const LabelBox& box, const Surroundings& around, const NamedThing& thing) {
    const double height = 2.0 * box.half_px.y();
    const auto within = [height](double distance) {
        return smooth_step((0.6 * height - distance) / (0.8 * height));
    };
    double cost = 0.0;
    const View& view = *around.view;
    const Eigen::Vector2d low = box.centre_px - box.half_px, high = box.centre_px + box.half_px;
    const double outside = around.margin_px + std::max({view.x_px - low.x(), view.y_px - low.y(),
                                                        high.x() - view.x_px - view.width_px,
                                                        high.y() - view.y_px - view.height_px});
    cost += 8.0 * smooth_step(1.0 + outside / height);
    for (const LabelBox& other : around.labels)
        cost += 8.0 * other.opacity * within(box.distance(other));
    for (const Surroundings::Shaft& shaft : around.shafts) {
        cost += 6.0 * shaft.opacity * within(box.distance(shaft.tip) - 0.5 * shaft.head_px);
        cost += 2.0 * shaft.opacity *
                smooth_step(box.length_inside(shaft.tail, shaft.tip) / (1.5 * height));
    }
    double length = 0.0;
    for (const VisiblePoint& point : around.lines)
        length += box.length_inside(point.before_px, point.px);
    cost += 1.5 * smooth_step(length / (3.0 * height));
    if (thing.keeps_off_bodies)
        for (const Ellipsoid& ellipsoid : view.ellipsoids) {
            if (ellipsoid.opacity < 0.4) continue;
            const double nearness = nearness_to_ellipsoid(view, ellipsoid, box.centre_px);
            double on_body = smooth_step((1.25 - nearness) / 0.3);
            // The end of a long name may lie on the body, too.
            if (ellipsoid.name.element != thing.element)
                for (const double side : {-1.0, 1.0}) {
                    const Eigen::Vector2d end_px =
                        box.centre_px + Eigen::Vector2d(side * box.half_px.x(), 0.0);
                    const double end = nearness_to_ellipsoid(view, ellipsoid, end_px);
                    on_body = std::max(on_body, smooth_step((1.05 - end) / 0.15));
                }
            cost += 1.2 * ellipsoid.presence * on_body;
        }
    // On another thing's cone it would be read as that cone's name.
    for (const Cone& cone : view.cones) {
        if (cone.name.element == thing.element && cone.name.part == thing.part) continue;
        const double nearness = nearness_to_cone(view, cone, box.centre_px);
        cost += 3.0 * cone.presence * smooth_step((1.6 - nearness) / 0.6);
    }
    return cost;
}

// How much of a leader is drawn over a distance: none where the name is beside its thing.
double leader_share(double away_px, double px) {
    return smooth_step((away_px - 20.0 * px) / (14.0 * px));
}

// A place for a name: the point that it names, and the centre of its box.
struct Spot {
    Eigen::Vector3d at;
    Eigen::Vector2d anchor_px;
    LabelBox box;
    double spread_px = 0.0;
    double leader = 0.0;  // how much of a leader is drawn to the box, 0…1
};

// Where the name of a thing may stand: a direction in the picture, and a level, from 0 (near) on.
class Spots {
 public:
    // `grown`: the outline of the thing in the end, instead of its own.
    Spots(const View& view, const NamedThing& thing, const TextBlock& type, double px,
          const Outline& grown = {})
        : view_(view), half_(0.5 * Eigen::Vector2d(type.width_px(), type.height_px())), px_(px) {
        const auto is_own = [&thing](const auto& shape) {
            return shape.name.element == thing.element && shape.name.part == thing.part;
        };
        const auto add = [this](const Outline& outline, double opacity) {
            outline_.insert(outline_.end(), outline.begin(), outline.end());
            opacity_ = std::max(opacity_, opacity);
        };
        constexpr int n_points = 512;
        for (const Curve& curve : view.curves)
            if (is_own(curve)) add(outline_of(view, curve, n_points), curve.opacity);
        for (const Ellipsoid& ellipsoid : view.ellipsoids)
            if (is_own(ellipsoid)) add(outline_of(view, ellipsoid, 96), ellipsoid.presence);
        for (const Cone& cone : view.cones)
            if (is_own(cone)) add(outline_of(view, cone, 96), cone.presence);
        for (const Plane& plane : view.planes)
            if (is_own(plane)) {
                plane_ = &plane;
                opacity_ = std::clamp(plane.opacity, 0.0, 1.0);
            }
        if (opacity_ > 0.0 && !grown.empty()) outline_ = grown;
        double length_px = 0.0;
        for (const VisiblePoint& point : outline_) length_px += point.weight_px;
        is_shown_ = opacity_ > 0.0;
        // The name of a curve that grows appears with it.
        if (plane_ == nullptr) opacity_ *= smooth_step(length_px / (60.0 * px_));
    }

    // Whether the view has the thing, seen or hidden.
    bool is_shown() const { return is_shown_; }
    double opacity() const { return opacity_; }
    bool has_leader() const { return plane_ == nullptr; }
    // The visible point of the thing that is nearest to a box; null if there is none.
    const VisiblePoint* nearest(const LabelBox& box) const {
        const auto far = [&box](const VisiblePoint& point) {
            return (box.nearest(point.px) - point.px).squaredNorm();
        };
        const auto found = std::min_element(
            outline_.begin(), outline_.end(),
            [&far](const VisiblePoint& a, const VisiblePoint& b) { return far(a) < far(b); });
        return found == outline_.end() ? nullptr : &*found;
    }

    std::optional<Spot> at(double angle_rad, double level) const {
        const Eigen::Vector2d way(std::cos(angle_rad), std::sin(angle_rad));
        if (plane_ != nullptr) return on_plane(way, level);
        const auto point = outermost(outline_, way, 2.0 * px_);
        if (!point) return std::nullopt;
        // Beyond the line through the point across the way.
        const double reach = half_.dot(way.cwiseAbs());
        const double gap = (9.0 + 40.0 * level) * px_;
        const LabelBox box{point->px + (gap + reach) * way, half_};
        return Spot{point->at, point->px, box, point->spread_px,
                    leader_share(box.distance(point->px), px_)};
    }

 private:
    // On the plane, around its centre.
    std::optional<Spot> on_plane(const Eigen::Vector2d& way, double level) const {
        const Projection projection(view_);
        Eigen::Vector3d along =
            projection.right - projection.right.dot(plane_->normal) * plane_->normal;
        if (along.norm() < 1e-6) along = plane_->normal.unitOrthogonal();
        along.normalize();
        Eigen::Vector3d down = plane_->normal.cross(along);
        if (down.dot(projection.down) < 0.0) down = -down;
        // The second place is outside of the first, where the plane begins to fade; the last one
        // is under the body.
        const double share = level > 1.0 ? 0.95 - 0.25 * level : 0.95 + 0.3 * level;
        const double radius = plane_->radius * plane_->fade_from * share;
        const Eigen::Vector3d at = plane_->centre + radius * (way.x() * along + way.y() * down);
        if (projection.depth(at) <= projection.near_depth) return std::nullopt;
        const Eigen::Vector2d px = projection.place(at);
        return Spot{at, px, {px, half_}};
    }

    const View& view_;
    Eigen::Vector2d half_;
    double px_;
    Outline outline_;
    const Plane* plane_ = nullptr;
    double opacity_ = 0.0;
    bool is_shown_ = false;
};

struct PlacedName {
    Spot spot;
    double room = 0.0;  // 1: enough, 0: none
};

// The places that are tried: directions in the picture, and distances.
constexpr int n_directions = 24;
constexpr std::array<double, 3> levels{0.0, 1.0, 2.5};
constexpr double most_cost = 2.2;

double angle_of(int direction) { return 2.0 * std::numbers::pi * direction / n_directions; }

// The cost of a place by itself: directions near the preferred one, and near places, are better.
double preference_cost(const NamedThing& thing, double angle, double level) {
    const double from_preferred = std::remainder(
        angle - thing.preferred_deg * std::numbers::pi / 180.0, 2.0 * std::numbers::pi);
    // The clockwise side costs more, so that two sides are seldom equally good.
    return 0.35 * (1.0 - std::cos(from_preferred)) +
           0.25 * (0.5 + 0.5 * from_preferred / std::numbers::pi) + 0.45 * level;
}

// A leader that touches another label would name that label's thing.
double leader_cost(const Spot& spot, const Surroundings& around) {
    if (!(spot.leader > 0.0)) return 0.0;
    const double height = 2.0 * spot.box.half_px.y();
    const Eigen::Vector2d end_px = spot.box.nearest(spot.anchor_px);
    double cost = 0.0;
    for (const LabelBox& other : around.labels) {
        const double touched_px = other.length_inside(spot.anchor_px, end_px);
        cost += 3.0 * spot.leader * other.opacity * smooth_step(touched_px / (0.5 * height));
    }
    return cost;
}

double cost_at(const Spot& spot, const NamedThing& thing, const NameSide& side,
               const Surroundings& around) {
    const double spread = 2.0 * smooth_step(spot.spread_px / (4.0 * spot.box.half_px.y()) - 0.5);
    return preference_cost(thing, side.angle_rad, side.level) + spread +
           cost_of(spot.box, around, thing) + leader_cost(spot, around);
}

// The side with the least sum of costs; `cost` of a side: infinite if it has no place.
template <typename Cost>
NameSide best_side(const Cost& cost) {
    NameSide best;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < n_directions; ++k)
        for (const double level : levels) {
            const NameSide side{angle_of(k), level};
            const double found = cost(side);
            if (!(found < least)) continue;
            least = found;
            best = side;
        }
    return best;
}

std::optional<PlacedName> placed_at(const Spots& spots, const NamedThing& thing,
                                    const NameSide& side, const Surroundings& around) {
    const auto spot = spots.at(side.angle_rad, side.level);
    if (!spot) return std::nullopt;
    const double cost =
        cost_at(*spot, thing, side, around) - preference_cost(thing, side.angle_rad, side.level);
    return PlacedName{*spot, smooth_step((most_cost - cost) / 0.5 + 0.5)};
}

// The outline of a curve that grows in time, as it is in the end: the side of a film's name does
// not depend on how much of the curve is drawn. Empty for other things.
Outline grown_outline(const View& view, const NamedThing& thing, const Panel& panel) {
    const StageContext& stage = *panel.stage;
    if (!stage.rolling) return {};
    const bool is_whole = stage.scene.trail.polhode == "whole" && !stage.rolling->dissipates;
    if (thing.name == "polhode" && !is_whole && !view.ellipsoids.empty())
        return outline_of(view, view.ellipsoids.front(), 96);
    if (thing.name != "herpolhode" || view.planes.empty()) return {};
    const Plane& plane = view.planes.front();
    return outline_of(view, plane.centre, plane.normal,
                      panel.herpolhode_radius.value_or(stage.rolling->herpolhode_radius), 96);
}

double margin_of(const Panel& panel) {
    return std::max(3.0 * px_per_pt(*panel.stage), 6.0 * panel.px);
}

}  // namespace

std::vector<ThingWords> words_of_things(const Scene& scene) {
    std::vector<ThingWords> words;
    for (const NamedThing& thing : things) {
        constexpr std::array lines{"body-cone", "space-cone", "herpolhode", "polhode",
                                   "separatrix"};
        if (std::find(lines.begin(), lines.end(), thing.name) == lines.end()) continue;
        words.push_back({std::string(phrase_in(scene.language, thing.words)), thing.role});
        const auto own = scene.symbols.things.find(thing.name);
        if (own != scene.symbols.things.end() && own->second.find('$') == std::string::npos)
            words.push_back({own->second, thing.role});
    }
    return words;
}

std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const Scene& scene = stage.scene;
    const auto is_in = [](const std::vector<std::string>& list, std::string_view name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    std::vector<ThingName> names;
    if ((panel_kind_named(panel.spec.kind).takes & takes_names) == 0) return names;
    if (!scene.labels || is_in(scene.unlabelled, panel.spec.kind)) return names;
    for (const NamedThing& thing : things) {
        if (scene.names && !is_in(*scene.names, thing.name)) continue;
        if (is_in(scene.unlabelled, thing.element)) continue;
        const auto own = scene.symbols.things.find(thing.name);
        const std::string key = fmt::format("symbols.{}", thing.name);
        const std::string text = own != scene.symbols.things.end()
                                     ? own->second
                                     : std::string(phrase_in(scene.language, thing.words));
        if (text.empty()) continue;
        const TypeStyle style{
            .size_px = std::max(size_of_names * label_size * panel.type_px, least_type_px(stage)),
            .mode = TypeMode::text};
        const Colour colour = line_of(stage.theme, thing.role);
        names.push_back({&thing, at_scene_key(scene, key, [&] { return store.set(text, style); }),
                         colour, offset_of_label(stage, thing.name)});
    }
    return names;
}

std::vector<UnnamedThing> place_thing_names(const Panel& panel, const std::vector<ThingName>& names,
                                            const std::vector<LabelBox>& overlays, View& view) {
    std::vector<UnnamedThing> left_out;
    const auto shown = [&panel](double opacity) {
        return panel.stage->options.is_still ? whole_or_absent(opacity) : opacity;
    };
    std::optional<Surroundings> around;  // made for the first name that the view shows
    for (const ThingName& name : names) {
        if (name.type.mask->width == 0) continue;
        const Spots spots(view, *name.thing, name.type, panel.px);
        const double seen = shown(std::min(1.0, spots.opacity()));
        if (spots.is_shown() && seen < 0.5) left_out.push_back({name.thing->name, false});
        if (!(seen > 0.0)) continue;
        if (!around) around = surroundings_of(view, overlays, margin_of(panel), true);
        const NameSide side = name.side ? *name.side : best_side([&](const NameSide& each) {
            const auto spot = spots.at(each.angle_rad, each.level);
            return spot ? cost_at(*spot, *name.thing, each, *around)
                        : std::numeric_limits<double>::infinity();
        });
        const auto placed = placed_at(spots, *name.thing, side, *around);
        const double room = placed ? shown(placed->room) : 0.0;
        if (room < 0.5) left_out.push_back({name.thing->name});
        if (!(room > 0.0)) continue;
        Label label;
        label.mask = name.type.mask;
        label.top_left_px = placed->spot.box.centre_px - placed->spot.box.half_px + name.offset_px;
        label.colour = name.colour;
        label.halo_colour = panel.stage->theme.halo;
        label.halo_px = 4.0 * panel.px;
        label.opacity = room * seen;
        label.rank = rank_of_things;
        label.at = placed->spot.at;
        label.name = {name.thing->name, 0, ""};
        view.labels.push_back(label);
        const LabelBox box = label_box(label);
        around->labels.push_back(box);
        if (!spots.has_leader()) continue;
        // A name that was moved by hand may be nearer to another point of its thing.
        const VisiblePoint* const nearest = name.offset_px.isZero() ? nullptr : spots.nearest(box);
        const Leader leader{.at = nearest != nullptr ? nearest->at : placed->spot.at,
                            .from_px = nearest != nullptr ? nearest->px : placed->spot.anchor_px,
                            .to = box,
                            .colour = name.colour,
                            .width_px = 1.6 * panel.px,
                            .name = {name.thing->name, 0, "leader"}};
        const double away_px = box.distance(leader.from_px);
        add_leader(leader, label.opacity * shown(leader_share(away_px, panel.px)),
                   panel.unit_segment, view);
    }
    return left_out;
}

void choose_sides(const Panel& panel, std::vector<PlacedLabels> instants,
                  std::vector<ThingName>& names) {
    for (ThingName& name : names) {
        if (name.type.mask->width == 0) continue;
        struct Seen {
            PlacedLabels* instant;
            Spots spots;
            Surroundings around;
        };
        std::vector<Seen> seen;
        for (PlacedLabels& instant : instants) {
            const View& view = *instant.view;
            Spots spots(view, *name.thing, name.type, panel.px,
                        grown_outline(view, *name.thing, panel));
            if (spots.opacity() > 0.0)
                seen.push_back({&instant, std::move(spots),
                                surroundings_of(view, instant.taken, margin_of(panel), false)});
        }
        // The cost of each side, at most that of no room, added up over the instants.
        name.side = best_side([&](const NameSide& side) {
            double sum = preference_cost(*name.thing, side.angle_rad, side.level);
            for (const auto& [instant, spots, around] : seen) {
                const auto spot = spots.at(side.angle_rad, side.level);
                sum += spot ? std::min(most_cost, cost_at(*spot, *name.thing, side, around))
                            : most_cost;
            }
            return sum;
        });
        // The names after it keep off it.
        for (const auto& [instant, spots, around] : seen)
            if (const auto placed = placed_at(spots, *name.thing, *name.side, around))
                instant->taken.push_back(
                    {placed->spot.box.centre_px, placed->spot.box.half_px, placed->room});
    }
}

}  // namespace poinsot
