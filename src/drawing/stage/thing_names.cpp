#include "drawing/stage/thing_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>

#include "drawing/stage/marks.h"
#include "drawing/stage/outlines.h"
#include "drawing/style/colour_vision.h"
#include "drawing/style/theme_roles.h"
#include "numerics/smooth_step.h"
#include "scene/named_things.h"
#include "scene/scene_error.h"
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

constexpr std::array<NamedThing, named_things.size()> things{{
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
}};

constexpr double size_of_names = 0.8;  // of the names of vectors

// The colour of a thing, changed towards that of text until letters can be read on the ground.
Colour readable(const Colour& colour, const Theme& theme) {
    constexpr double least = 4.5;
    const auto worst = [&theme](const Colour& each) {
        return std::min(contrast(each, theme.background.top),
                        contrast(each, theme.background.bottom));
    };
    for (int tenth = 0; tenth < 10; ++tenth) {
        const double share = 0.1 * tenth;
        const auto mixed = [share](double a, double b) { return a + share * (b - a); };
        const Colour each{mixed(colour.r, theme.text.r), mixed(colour.g, theme.text.g),
                          mixed(colour.b, theme.text.b)};
        if (worst(each) >= least) return each;
    }
    return theme.text;
}

struct NameBox {
    Eigen::Vector2d centre, half;

    // Distance of a point from the box along the worse of the axes; negative inside.
    double distance(const Eigen::Vector2d& px) const {
        return ((px - centre).cwiseAbs() - half).maxCoeff();
    }
    double distance(const NameBox& other) const {
        return ((other.centre - centre).cwiseAbs() - half - other.half).maxCoeff();
    }
    // Length of a segment inside the box.
    double length_inside(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
        const Eigen::Vector2d way = to - from;
        double first = 0.0, last = 1.0;
        for (int i = 0; i < 2; ++i) {
            const double low = centre[i] - half[i] - from[i], high = centre[i] + half[i] - from[i];
            if (std::abs(way[i]) < 1e-9) {
                if (low > 0.0 || high < 0.0) return 0.0;
                continue;
            }
            const double a = low / way[i], b = high / way[i];
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        }
        return std::max(0.0, last - first) * way.norm();
    }
};

// What a name keeps away from.
struct Surroundings {
    std::vector<std::pair<NameBox, double>> labels;  // and their opacity
    struct Shaft {
        Eigen::Vector2d tail, tip;
        double head_px, opacity;
    };
    std::vector<Shaft> shafts;
    Outline lines;  // points of all curves
    const View* view = nullptr;
    double margin_px = 6.0;
};

Surroundings surroundings_of(const View& view, const std::vector<LabelBox>& overlays,
                             double margin_px) {
    Surroundings around;
    around.view = &view;
    around.margin_px = margin_px;
    for (const LabelBox& box : overlays)
        around.labels.push_back({{box.centre_px, box.half_px}, box.opacity});
    for (const Label& label : view.labels) {
        const LabelBox box = label_box(label);
        around.labels.push_back({{box.centre_px, box.half_px}, box.opacity});
    }
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
        if (curve.opacity < 0.3 || curve.occlusion == Occlusion::none) continue;
        const Outline outline = outline_of(view, curve, 96);
        around.lines.insert(around.lines.end(), outline.begin(), outline.end());
    }
    return around;
}

// How bad a place is: 0 for a free one, some 1 for one on a line, and 8 on another label.
double cost_of(const NameBox& box, const Surroundings& around, bool keeps_off_bodies) {
    const double height = 2.0 * box.half.y();
    const auto within = [height](double distance) {
        return smooth_step((0.3 * height - distance) / (0.5 * height));
    };
    double cost = 0.0;
    const View& view = *around.view;
    const double outside =
        std::max({view.x_px + around.margin_px - (box.centre.x() - box.half.x()),
                  box.centre.x() + box.half.x() + around.margin_px - view.x_px - view.width_px,
                  view.y_px + around.margin_px - (box.centre.y() - box.half.y()),
                  box.centre.y() + box.half.y() + around.margin_px - view.y_px - view.height_px});
    cost += 8.0 * smooth_step(1.0 + outside / (0.5 * height));
    for (const auto& [other, opacity] : around.labels)
        cost += 8.0 * opacity * within(box.distance(other));
    for (const Surroundings::Shaft& shaft : around.shafts) {
        cost += 6.0 * shaft.opacity * within(box.distance(shaft.tip) - 0.5 * shaft.head_px);
        cost += 2.0 * shaft.opacity *
                smooth_step(box.length_inside(shaft.tail, shaft.tip) / (1.5 * height));
    }
    double length = 0.0;
    for (const VisiblePoint& point : around.lines)
        if (point.length_px > 0.0)
            length += point.length_px * smooth_step(-box.distance(point.px) / (0.3 * height) + 0.5);
    cost += 1.5 * smooth_step(length / (3.0 * height));
    if (keeps_off_bodies) {
        for (const Ellipsoid& ellipsoid : view.ellipsoids) {
            if (ellipsoid.opacity < 0.4) continue;
            const double nearness = nearness_to_ellipsoid(view, ellipsoid, box.centre);
            cost += 1.2 * ellipsoid.presence * smooth_step((1.25 - nearness) / 0.3);
        }
    }
    return cost;
}

// A place for a name: the point that it names, and the centre of its box.
struct Spot {
    Eigen::Vector3d at;
    Eigen::Vector2d anchor_px;
    NameBox box;
    double spread_px = 0.0;
};

// Where the name of a thing may stand: a direction in the picture, and a level from 0 (near) to 1.
class Spots {
 public:
    Spots(const View& view, const NamedThing& thing, const TextBlock& type, double px)
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
        double length_px = 0.0;
        for (const VisiblePoint& point : outline_) length_px += point.length_px;
        // The name of a curve that grows appears with it.
        if (plane_ == nullptr) opacity_ *= smooth_step(length_px / (60.0 * px_));
    }

    double opacity() const { return opacity_; }
    bool has_leader() const { return plane_ == nullptr; }

    std::optional<Spot> at(double angle_rad, double level) const {
        const Eigen::Vector2d way(std::cos(angle_rad), std::sin(angle_rad));
        if (plane_ != nullptr) return on_plane(way, level);
        const auto point = outermost(outline_, way, 2.0 * px_);
        if (!point) return std::nullopt;
        // Beyond the line through the point across the way.
        const double reach = half_.dot(way.cwiseAbs());
        const double gap = (9.0 + 40.0 * level) * px_;
        return Spot{
            point->at, point->px, {point->px + (gap + reach) * way, half_}, point->spread_px};
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
        const double radius = plane_->radius * plane_->fade_from * (0.95 - 0.25 * level);
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
};

struct PlacedName {
    Spot spot;
    double level = 0.0;
    double room = 0.0;  // 1: enough, 0: none
};

// The costs of the directions around a thing, each at the level that is best there.
struct Direction {
    double angle = 0.0;
    double level = 0.0;
    double cost = 1e300;
    double next_cost = 1e300;  // of the second-best level
};

// The place of a name: the mean of the best directions, which moves smoothly as costs change. Only
// directions without a worse one between them are in one mean. While one such set replaces another,
// the name fades out and in again.
std::optional<PlacedName> best_place(const Spots& spots, const NamedThing& thing,
                                     const Surroundings& around) {
    constexpr int n = 24;
    // In units of cost: of the mean; the difference at which one place is clearly better; how much
    // worse a direction between two others keeps them apart; the most that a place may have.
    constexpr double softness = 0.07, clear = 0.05, least_barrier = 0.1, barrier = 0.4, most = 2.2;
    const double preferred = thing.preferred_deg * std::numbers::pi / 180.0;
    const auto cost_at = [&](const Spot& spot, double angle, double level) {
        // The second term breaks ties between the sides of the preferred direction.
        const double from_preferred = std::remainder(angle - preferred, 2.0 * std::numbers::pi);
        const double taste = 0.35 * (1.0 - std::cos(from_preferred)) +
                             0.25 * (0.5 + 0.5 * from_preferred / std::numbers::pi);
        const double spread = 2.0 * smooth_step(spot.spread_px / (4.0 * spot.box.half.y()) - 0.5);
        return taste + 0.45 * level + spread + cost_of(spot.box, around, thing.keeps_off_bodies);
    };
    std::array<Direction, n> directions;
    for (int k = 0; k < n; ++k) {
        Direction& direction = directions[static_cast<std::size_t>(k)];
        direction.angle = 2.0 * std::numbers::pi * k / n;
        for (const double level : {0.0, 1.0, 2.5}) {
            const auto spot = spots.at(direction.angle, level);
            if (!spot) continue;
            const double cost = cost_at(*spot, direction.angle, level);
            direction.next_cost = std::min(direction.next_cost, std::max(cost, direction.cost));
            if (cost >= direction.cost) continue;
            direction.cost = cost;
            direction.level = level;
        }
    }
    const auto at = [&directions](int k) -> const Direction& {
        return directions[static_cast<std::size_t>(((k % n) + n) % n)];
    };
    int best = 0;
    for (int k = 1; k < n; ++k)
        if (at(k).cost < at(best).cost) best = k;
    const double least = at(best).cost;
    if (!(least < most)) return std::nullopt;

    std::complex<double> mean = 0.0;
    double sum = 0.0, level = 0.0;
    // 1 where another place is as good, and a worse direction lies between.
    double conflict = 1.0 - smooth_step((at(best).next_cost - least) / clear);
    std::array<double, n> way_to;  // the highest cost on the better way from the best direction
    way_to.fill(1e300);
    way_to[static_cast<std::size_t>(best)] = least;
    for (const int sense : {1, -1}) {
        double highest = least;
        for (int step = sense; std::abs(step) < n; step += sense) {
            highest = std::max(highest, at(best + step).cost);
            double& way = way_to[static_cast<std::size_t>((((best + step) % n) + n) % n)];
            way = std::min(way, highest);
        }
    }
    for (int k = 0; k < n; ++k) {
        const Direction& direction = at(k);
        const double way = way_to[static_cast<std::size_t>(k)];
        conflict = std::max(conflict, (1.0 - smooth_step((direction.cost - least) / clear)) *
                                          smooth_step((way - direction.cost - least_barrier) /
                                                      (barrier - least_barrier)));
        if (way - least > barrier) continue;
        const double weight = std::exp((least - direction.cost) / softness);
        mean += weight * std::polar(1.0, direction.angle);
        level += weight * direction.level;
        sum += weight;
    }
    const double angle = std::arg(mean);
    level /= sum;
    const auto spot = spots.at(angle, level);
    if (!spot) return std::nullopt;
    const double room =
        (1.0 - conflict) * smooth_step((most - cost_at(*spot, angle, level)) / 0.25);
    return PlacedName{*spot, level, room};
}

}  // namespace

std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const Scene& scene = stage.scene;
    const auto is_in = [](const std::vector<std::string>& list, std::string_view name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    Theme theme = stage.theme;
    std::vector<ThingName> names;
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
        const Colour colour = readable(*look_of(theme, thing.role).colour, theme);
        names.push_back({&thing, at_scene_key(scene, key, [&] { return store.set(text, style); }),
                         colour, offset_of_label(stage, thing.name)});
    }
    return names;
}

std::vector<std::string_view> place_thing_names(const Panel& panel,
                                                const std::vector<ThingName>& names,
                                                const std::vector<LabelBox>& overlays, View& view) {
    std::vector<std::string_view> left_out;
    for (const ThingName& name : names) {
        if (name.type.mask->width == 0) continue;
        const Spots spots(view, *name.thing, name.type, panel.px);
        if (!(spots.opacity() > 0.0)) continue;
        const double margin_px = std::max(3.0 * px_per_pt(*panel.stage), 6.0 * panel.px);
        const Surroundings around = surroundings_of(view, overlays, margin_px);
        const auto placed = best_place(spots, *name.thing, around);
        if (!placed || placed->room < 0.5) left_out.push_back(name.thing->name);
        if (!placed || !(placed->room > 0.0)) continue;
        Label label;
        label.mask = name.type.mask;
        label.top_left_px = placed->spot.box.centre - placed->spot.box.half + name.offset_px;
        label.colour = name.colour;
        label.halo_colour = panel.stage->theme.halo;
        label.halo_px = 4.0 * panel.px;
        label.opacity = placed->room * std::min(1.0, spots.opacity());
        label.rank = rank_of_things;
        label.at = placed->spot.at;
        label.name = {name.thing->name, 0, ""};
        view.labels.push_back(label);
        if (!spots.has_leader()) continue;
        const NameBox box{label.top_left_px + placed->spot.box.half, placed->spot.box.half};
        const Leader leader{.at = placed->spot.at,
                            .from_px = placed->spot.anchor_px,
                            .to = label_box(label),
                            .colour = name.colour,
                            .width_px = 1.6 * panel.px,
                            .name = {name.thing->name, 0, "leader"}};
        const double away_px = box.distance(leader.from_px);
        add_leader(leader,
                   label.opacity * smooth_step((away_px - 20.0 * panel.px) / (14.0 * panel.px)),
                   panel.unit_segment, view);
    }
    return left_out;
}

}  // namespace poinsot
