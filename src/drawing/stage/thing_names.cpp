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
#include <variant>

#include "drawing/stage/label_requests.h"
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

// In this order: a name gives way to those before it. The last three are of no scene's `names`:
// they are shown where all names are.
constexpr std::array<NamedThing, named_things.size() + 3> things{{
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
    {"momentum-sphere",
     "momentum-sphere",
     "",
     "text",
     135.0,
     true,
     {"momentum sphere", "Drehimpulskugel", "sphère du moment", "esfera del momento",
      "sfera del momento", "角運動量球"}},
    {"energy-ellipsoid",
     "momentum-sphere",
     "ellipsoid",
     "text",
     225.0,
     true,
     {"energy ellipsoid", "Energieellipsoid", "ellipsoïde d'énergie", "elipsoide de energía",
      "ellissoide dell'energia", "エネルギー楕円体"}},
    {"rotation-axis",
     "spin-axis",
     "",
     "omega",
     290.0,
     true,
     {"axis of rotation", "Drehachse", "axe de rotation", "eje de rotación", "asse di rotazione",
      "回転軸"}},
}};

// Shapes and labels that a name keeps away from.
struct Surroundings {
    std::vector<LabelBox> labels;
    struct Shaft {
        Eigen::Vector2d tail, tip;
        double head_px, opacity;
    };
    std::vector<Shaft> shafts;
    // Of all curves, with those of the thing itself marked by their names.
    struct Line {
        Eigen::Vector2d a, b;
        std::string_view element, part;
        double weight = 1.0;  // of a curve's hidden part: less
    };
    std::vector<Line> lines;
    const View* view = nullptr;
    double margin_px = 6.0;
};

// Adds the whole of a curve on a body, of which a part is behind it and pale.
void add_hidden(const Curve& curve, Surroundings& around) {
    constexpr int n_pieces = 96;
    const Projection projection(*around.view);
    const std::vector<Eigen::Vector3d>& points = curve.geometry->points;
    const auto n = static_cast<double>(points.size());
    const double first = std::max(curve.first, 0.0);
    const double last = std::min(curve.last, curve.geometry->closed ? n : n - 1.0);
    Eigen::Vector2d before_px = Eigen::Vector2d::Zero();
    bool is_joined = false;  // to the point before
    for (int k = 0; k <= n_pieces && first < last; ++k) {
        const auto index = static_cast<std::size_t>(first + (last - first) * k / n_pieces);
        const Eigen::Vector3d at = curve.placement * points[index % points.size()];
        if (projection.depth(at) <= projection.near_depth) {
            is_joined = false;
            continue;
        }
        const Eigen::Vector2d px = projection.place(at);
        if (is_joined)
            around.lines.push_back({before_px, px, curve.name.element, curve.name.part, 0.4});
        before_px = px;
        is_joined = true;
    }
}

Surroundings surroundings_of(const View& view, const std::vector<LabelBox>& overlays,
                             double margin_px) {
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
        // A curve over everything else is no obstacle, except a curve on the plane in a plan.
        const bool is_over = curve.occlusion == Occlusion::none && curve.on_plane < 0;
        if (curve.opacity < 0.3 || is_over) continue;
        for (const VisiblePoint& point : outline_of(view, curve, 192))
            around.lines.push_back(
                {point.before_px, point.px, curve.name.element, curve.name.part});
        if (curve.on_surface >= 0 && curve.hidden_opacity > 0.15) add_hidden(curve, around);
    }
    return around;
}

// How much two boxes read as one phrase: 1 for neighbours on one line.
double phrase_share(const LabelBox& box, const LabelBox& other, double em_px) {
    const Eigen::Vector2d apart =
        (box.centre_px - other.centre_px).cwiseAbs() - box.half_px - other.half_px;
    const double on_one_line =
        std::clamp(-apart.y() / std::min(box.half_px.y(), other.half_px.y()), 0.0, 1.0);
    return smooth_step(2.0 * on_one_line) * smooth_step((1.5 * em_px - apart.x()) / (0.7 * em_px));
}

// How bad a place is: 0 for a free one, about 2 for one on a line, and 8 on another label.
double cost_of(const LabelBox& box, const Surroundings& around, const NamedThing& thing,
               double em_px) {
    const auto within = [em_px](double distance) {
        return smooth_step((0.6 * em_px - distance) / (0.8 * em_px));
    };
    double cost = 0.0;
    const View& view = *around.view;
    const Eigen::Vector2d low = box.centre_px - box.half_px, high = box.centre_px + box.half_px;
    const double outside = around.margin_px + std::max({view.x_px - low.x(), view.y_px - low.y(),
                                                        high.x() - view.x_px - view.width_px,
                                                        high.y() - view.y_px - view.height_px});
    cost += 8.0 * smooth_step(1.0 + outside / em_px);
    for (const LabelBox& other : around.labels)
        cost += other.opacity *
                (8.0 * within(box.distance(other)) + 2.0 * phrase_share(box, other, em_px));
    for (const Surroundings::Shaft& shaft : around.shafts) {
        cost += 6.0 * shaft.opacity * within(box.distance(shaft.tip) - 0.5 * shaft.head_px);
        cost += 2.0 * shaft.opacity *
                smooth_step(box.length_inside(shaft.tail, shaft.tip) / (1.5 * em_px));
    }
    double length = 0.0, own_length = 0.0;
    for (const Surroundings::Line& line : around.lines) {
        if (std::max(line.a.x(), line.b.x()) < low.x() ||
            std::min(line.a.x(), line.b.x()) > high.x() ||
            std::max(line.a.y(), line.b.y()) < low.y() ||
            std::min(line.a.y(), line.b.y()) > high.y())
            continue;
        const bool is_own = line.element == thing.element && line.part == thing.part;
        (is_own ? own_length : length) += line.weight * box.length_inside(line.a, line.b);
    }
    // The name of a plane has room beside the curves on it.
    cost += (thing.element == "plane" ? 4.0 : 2.0) * smooth_step(length / (2.0 * em_px));
    // A name never lies on its own line.
    cost += 4.0 * smooth_step(own_length / (0.6 * em_px));
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
        cost += 3.0 * cone.presence * smooth_step((1.3 - nearness) / 0.4);
    }
    return cost;
}

// How much of a leader is drawn over a distance: none where the name is beside its thing, and all
// of it from one and a quarter of the letters' size on.
double leader_share(double away_px, double em_px) {
    return smooth_step((away_px - 0.8 * em_px) / (0.45 * em_px));
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
    Spots(const View& view, const ThingName& name)
        : view_(view),
          half_(0.5 * Eigen::Vector2d(name.type.width_px(), name.type.height_px())),
          em_px_(name.em_px) {
        const NamedThing& thing = *name.thing;
        const auto is_own = [&thing](const auto& shape) {
            return shape.name.element == thing.element && shape.name.part == thing.part;
        };
        const auto add = [this](const Outline& outline, double opacity) {
            outline_.insert(outline_.end(), outline.begin(), outline.end());
            opacity_ = std::max(opacity_, opacity);
        };
        constexpr int n_points = 512;
        for (const Curve& curve : view.curves) {
            if (!is_own(curve)) continue;
            Outline outline = outline_of(view, curve, n_points);
            // A name does not stand where a trail has faded.
            if (curve.fade_points > 0.0)
                for (VisiblePoint& point : outline) {
                    const double whole = curve.opacity * (point.px - point.before_px).norm();
                    if (whole > 0.0)
                        point.weight_px *= smooth_step(4.0 * point.weight_px / whole - 2.0);
                }
            if (thing.name == "rotation-axis") keep_free_end(curve, outline);
            grows_ = grows_ || thing.name != "rotation-axis";
            add(outline, curve.opacity);
        }
        for (const Ellipsoid& ellipsoid : view.ellipsoids)
            if (is_own(ellipsoid)) add(outline_of(view, ellipsoid, 96), ellipsoid.presence);
        for (const Cone& cone : view.cones)
            if (is_own(cone)) add(away_from_others(view, cone), cone.presence);
        for (const Plane& plane : view.planes)
            if (is_own(plane)) {
                plane_ = &plane;
                opacity_ = std::clamp(2.0 * plane.opacity, 0.0, 1.0);  // as whole as its letters
            }
        double length_px = 0.0;
        for (const VisiblePoint& point : outline_) length_px += point.weight_px;
        is_shown_ = opacity_ > 0.0;
        // The name of a curve that grows appears with it.
        if (grows_) opacity_ *= smooth_step(length_px / (1.2 * em_px_));
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
        const auto point = outermost(outline_, way, 0.06 * em_px_);
        if (!point) return std::nullopt;
        // Beyond the line through the point across the way.
        const double reach = half_.dot(way.cwiseAbs());
        const double gap = (0.35 + 1.3 * level) * em_px_;
        const LabelBox box{point->px + (gap + reach) * way, half_};
        return Spot{point->at, point->px, box, point->spread_px,
                    leader_share(box.distance(point->px), em_px_)};
    }

 private:
    // The end of the axis of rotation away from the contact, where names crowd.
    static void keep_free_end(const Curve& axis, Outline& outline) {
        const Eigen::Vector3d end = axis.placement * axis.geometry->points.front();
        const double length = axis.placement.linear().col(0).norm();
        std::erase_if(outline, [&](const VisiblePoint& point) {
            return (point.at - end).norm() > 0.4 * length;
        });
    }

    // The rim of a cone, where it is far from the other cones of the view: a name at the generator
    // that two cones share would name either.
    static Outline away_from_others(const View& view, const Cone& cone) {
        const Outline rim = outline_of(view, cone, 96);
        const auto apart_rad = [&](const VisiblePoint& point) {
            double least = std::numbers::pi;
            for (const Cone& other : view.cones) {
                if (&other == &cone) continue;
                const Eigen::Vector3d way = (point.at - other.apex).stableNormalized();
                const double angle = std::acos(std::clamp(way.dot(other.axis), -1.0, 1.0));
                least = std::min(least, std::abs(angle - other.half_angle_rad));
            }
            return least;
        };
        double most = 0.0;
        for (const VisiblePoint& point : rim) most = std::max(most, apart_rad(point));
        Outline kept;
        for (VisiblePoint point : rim) {
            point.weight_px *= smooth_step(4.0 * apart_rad(point) / most - 2.4);
            if (point.weight_px > 0.0) kept.push_back(point);
        }
        return kept;
    }

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
        const double share = level > 1.0 ? 0.95 - 0.22 * (level - 1.0) : 0.95 + 0.3 * level;
        const double radius = plane_->radius * plane_->fade_from * share;
        const Eigen::Vector3d at = plane_->centre + radius * (way.x() * along + way.y() * down);
        if (projection.depth(at) <= projection.near_depth) return std::nullopt;
        const Eigen::Vector2d px = projection.place(at);
        return Spot{at, px, {px, half_}};
    }

    const View& view_;
    Eigen::Vector2d half_;
    double em_px_;
    Outline outline_;
    const Plane* plane_ = nullptr;
    double opacity_ = 0.0;
    bool is_shown_ = false, grows_ = false;
};

// The places that are tried: directions in the picture, and distances.
constexpr int n_directions = 24;
constexpr std::array<double, 5> levels{0.0, 1.0, 2.0, 3.2, 4.6};
// The cost from which on a name is better absent. Cones are the subject where they are shown; a
// plane has room for its name beside what is drawn on it, or needs none.
double most_cost_of(const NamedThing& thing) {
    if (thing.element == "cones") return 5.0;
    return thing.element == "plane" ? 2.3 : 2.8;
}

double angle_of(int direction) { return 2.0 * std::numbers::pi * direction / n_directions; }

// The cost of a place by itself: directions near the preferred one, and near places, are better.
double preference_cost(const NamedThing& thing, double angle, double level) {
    const double from_preferred = std::remainder(
        angle - thing.preferred_deg * std::numbers::pi / 180.0, 2.0 * std::numbers::pi);
    // The clockwise side costs more, so that two sides are seldom equally good.
    return 0.35 * (1.0 - std::cos(from_preferred)) +
           0.25 * (0.5 + 0.5 * from_preferred / std::numbers::pi) + 0.35 * level;
}

// A leader that touches another label would name that label's thing; one along a shaft or a curve
// is not seen.
double leader_cost(const Spot& spot, const Surroundings& around, const NamedThing& thing,
                   double em_px) {
    if (!(spot.leader > 0.0)) return 0.0;
    const Eigen::Vector2d end_px = spot.box.nearest(spot.anchor_px);
    double cost = 0.0;
    for (const LabelBox& other : around.labels) {
        const double touched_px = other.length_inside(spot.anchor_px, end_px);
        cost += 3.0 * spot.leader * other.opacity * smooth_step(touched_px / (0.5 * em_px));
    }
    for (const Cone& cone : around.view->cones) {
        if (cone.name.element == thing.element && cone.name.part == thing.part) continue;
        const Eigen::Vector2d middle_px = 0.5 * (spot.anchor_px + end_px);
        const double nearness = nearness_to_cone(*around.view, cone, middle_px);
        cost += 0.8 * spot.leader * cone.presence * smooth_step((1.2 - nearness) / 0.4);
    }
    // Where two curves touch, it would name either.
    for (const Dot& dot : around.view->dots) {
        if (dot.name.element != "contact") continue;
        const double apart_px = (project(*around.view, dot.at).px - spot.anchor_px).norm();
        cost += 1.5 * spot.leader * smooth_step(2.0 - apart_px / em_px);
    }
    return cost;
}

// The cost of a place without that of its direction and distance.
double room_cost(const Spot& spot, const NamedThing& thing, const Surroundings& around,
                 double em_px) {
    const double spread = 2.0 * smooth_step(spot.spread_px / (2.0 * em_px) - 0.5);
    return spread + cost_of(spot.box, around, thing, em_px) +
           leader_cost(spot, around, thing, em_px);
}

NameSide side_of(int index) {
    constexpr int n_levels = static_cast<int>(levels.size());
    return {angle_of(index / n_levels), levels[static_cast<std::size_t>(index % n_levels)]};
}
constexpr int n_sides = n_directions * static_cast<int>(levels.size());

double preference_cost(const NamedThing& thing, const NameSide& side) {
    return preference_cost(thing, side.angle_rad, side.level);
}

struct PlacedName {
    Spot spot;
    bool has_room = false;
};

std::optional<PlacedName> placed_at(const Spots& spots, const ThingName& name, const NameSide& side,
                                    const Surroundings& around) {
    const auto spot = spots.at(side.angle_rad, side.level);
    if (!spot) return std::nullopt;
    return PlacedName{
        *spot, room_cost(*spot, *name.thing, around, name.em_px) < most_cost_of(*name.thing)};
}

// Where there is most room at an instant.
std::optional<PlacedName> best_place(const Spots& spots, const ThingName& name,
                                     const Surroundings& around) {
    std::optional<PlacedName> best;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < n_sides; ++k) {
        const NameSide side = side_of(k);
        const auto spot = spots.at(side.angle_rad, side.level);
        if (!spot) continue;
        const double room = room_cost(*spot, *name.thing, around, name.em_px);
        const double cost = room + preference_cost(*name.thing, side);
        if (!(cost < least)) continue;
        least = cost;
        best = PlacedName{*spot, room < most_cost_of(*name.thing)};
    }
    return best;
}

// Whether a title of the scene or of one of its chapters contains the words.
bool is_spoken_of(const Scene& scene, std::string_view words) {
    const auto lower = [](std::string_view text) {
        std::string made(text);
        for (char& c : made)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return made;
    };
    const std::string name = lower(words);
    const auto has = [&](const std::string& title) {
        return lower(title).find(name) != std::string::npos;
    };
    return !name.empty() &&
           (has(scene.title) ||
            std::any_of(scene.chapters.begin(), scene.chapters.end(),
                        [&](const ChapterSpec& chapter) { return has(chapter.title); }));
}

double margin_of(const Panel& panel) {
    return std::max(3.0 * px_per_pt(*panel.stage), 6.0 * panel.px);
}

}  // namespace

std::string_view words_of_plane(const Scene& scene, std::string_view thing, const Phrase& words) {
    static constexpr Phrase tangent_plane{"tangent plane",  "Tangentialebene", "plan tangent",
                                          "plano tangente", "piano tangente",  "接平面"};
    const bool moves =
        thing == "invariable-plane" && std::holds_alternative<DragTorque>(scene.torque);
    return phrase_in(scene.language, moves ? tangent_plane : words);
}

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

namespace {

constexpr double fade_s = 0.3;  // of a name in a film

}  // namespace

double NameSpan::presence(double film_s) const {
    return smooth_step(std::min(film_s - begin_s, end_s - film_s) / fade_s);
}

std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const Scene& scene = stage.scene;
    const auto is_in = [](const std::vector<std::string>& list, std::string_view name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    std::vector<ThingName> names;
    if ((panel_kind_named(panel.spec.kind).uses & uses_names) == 0) return names;
    if (!scene.labels || is_in(scene.unlabelled, panel.spec.kind)) return names;
    for (const NamedThing& thing : things) {
        if (scene.names && !is_in(*scene.names, thing.name)) continue;
        if (is_in(scene.unlabelled, thing.element)) continue;
        const auto own = scene.symbols.things.find(thing.name);
        const std::string key = fmt::format("symbols.{}", thing.name);
        const std::string text = own != scene.symbols.things.end()
                                     ? own->second
                                     : std::string(words_of_plane(scene, thing.name, thing.words));
        if (text.empty()) continue;
        const TypeStyle style{
            .size_px = std::max(type_sizes(stage).thing_name * panel.type_px, least_type_px(stage)),
            .mode = TypeMode::text};
        const Colour colour = line_of(stage.theme, thing.role);
        names.push_back({.thing = &thing,
                         .type = at_scene_key(scene, key, [&] { return store.set(text, style); }),
                         .colour = colour,
                         .em_px = style.size_px,
                         .offset_px = offset_of_label(stage, thing.name)});
    }
    // Things that the scene's titles mention come first.
    std::stable_partition(names.begin(), names.end(), [&](const ThingName& name) {
        return is_spoken_of(scene, name.type.mask->source.text);
    });
    return names;
}

namespace {

// A thing of which less is seen has no name; fading things take their names along quickly.
double seen_share(const Spots& spots) {
    return smooth_step((std::min(1.0, spots.opacity()) - 0.35) / 0.3);
}

// Where a name stands, and how opaque it is.
struct ShownName {
    std::optional<PlacedName> placed;
    double opacity = 0.0;
};

// Whether a box lies on a label, on an arrowhead or beyond the view, 0…1: a step, but for a little
// of the letters' size, so that a name fades quickly.
double covered_share(const LabelBox& box, const Surroundings& around, double em_px) {
    const auto covered = [em_px](double distance_px) {
        return smooth_step(0.5 - 12.0 * distance_px / em_px);
    };
    const View& view = *around.view;
    const Eigen::Vector2d low = box.centre_px - box.half_px, high = box.centre_px + box.half_px;
    const double inside =
        std::min({low.x() - view.x_px, low.y() - view.y_px, view.x_px + view.width_px - high.x(),
                  view.y_px + view.height_px - high.y()});
    double free = 1.0 - covered(inside - around.margin_px);
    for (const LabelBox& other : around.labels)
        free *= 1.0 - other.opacity * covered(box.distance(other));
    for (const Surroundings::Shaft& shaft : around.shafts) {
        const Eigen::Vector2d way = shaft.tip - shaft.tail;
        const double length = std::max(way.norm(), 1e-9);
        const Eigen::Vector2d middle =
            shaft.tip - std::min(0.5 * length, 0.5 * shaft.head_px) / length * way;
        free *= 1.0 - shaft.opacity * covered(box.distance(middle) - 0.3 * shaft.head_px);
    }
    return 1.0 - free;
}

// The places that are planned for a second of the film: two while the name changes its side. What
// crosses the name between the instants of the plan makes it fade.
std::vector<ShownName> planned_places(const Spots& spots, const ThingName& name,
                                      const Surroundings& around, double film_s) {
    std::vector<ShownName> found;
    for (const NameSpan& span : *name.spans) {
        ShownName shown{{}, span.presence(film_s)};
        if (!(shown.opacity > 0.0)) continue;
        shown.placed = placed_at(spots, name, span.side, around);
        if (!shown.placed) continue;
        shown.opacity *= 1.0 - covered_share(shown.placed->spot.box, around, name.em_px);
        found.push_back(shown);
    }
    // Where its two places overlap, the name fades at one and then appears at the other.
    if (found.size() == 2 && found[0].placed->spot.box.distance(found[1].placed->spot.box) <= 0.0)
        for (ShownName& shown : found) shown.opacity = std::max(0.0, 2.0 * shown.opacity - 1.0);
    return found;
}

// Adds a name's label to the view, and its leader.
void add_name(const Panel& panel, const ThingName& name, const Spots& spots, const Spot& spot,
              double opacity, View& view) {
    Label label;
    label.mask = name.type.mask;
    label.top_left_px = spot.box.centre_px - spot.box.half_px + name.offset_px;
    label.colour = name.colour;
    label.halo_colour = panel.stage->theme.halo;
    label.halo_px = 4.0 * panel.px;
    label.opacity = opacity;
    label.rank = rank_of_things;
    label.at = spot.at;
    label.name = {name.thing->name, 0, ""};
    view.labels.push_back(label);
    const LabelBox box = label_box(label);
    if (!spots.has_leader()) return;
    // A name that was moved by hand may be nearer to another point of its thing.
    const VisiblePoint* const nearest = name.offset_px.isZero() ? nullptr : spots.nearest(box);
    const Leader leader{.at = nearest != nullptr ? nearest->at : spot.at,
                        .from_px = nearest != nullptr ? nearest->px : spot.anchor_px,
                        .to = box,
                        .colour = name.colour,
                        .width_px = 1.6 * panel.px,
                        .name = {name.thing->name, 0, "leader"}};
    const double drawn = leader_share(box.distance(leader.from_px), name.em_px);
    const bool is_still = panel.stage->options.is_still;
    add_leader(leader, label.opacity * (is_still ? whole_or_absent(drawn) : drawn),
               panel.unit_segment, view);
}

}  // namespace

std::vector<UnnamedThing> place_thing_names(const Panel& panel, const std::vector<ThingName>& names,
                                            const std::vector<LabelBox>& overlays, double film_s,
                                            bool is_planned, View& view) {
    std::vector<UnnamedThing> left_out;
    const bool is_still = panel.stage->options.is_still;
    // Nobody misses a name that no scene can ask for.
    const auto leave_out = [&left_out](const ThingName& name, bool is_in_sight) {
        const std::string_view of = name.thing->name;
        if (std::find(named_things.begin(), named_things.end(), of) != named_things.end())
            left_out.push_back({of, is_in_sight});
    };
    std::optional<Surroundings> around;  // made for the first name that the view shows
    for (const ThingName& name : names) {
        if (name.type.mask->width == 0) continue;
        const Spots spots(view, name);
        const double share = seen_share(spots);
        if (spots.is_shown() && share < 0.5) leave_out(name, false);
        const bool has_plan = name.spans && is_planned;
        // The plan fades the name; what has nearly vanished has none between its instants.
        const double seen = has_plan   ? smooth_step(10.0 * spots.opacity() - 1.5)
                            : is_still ? whole_or_absent(share)
                                       : share;
        if (!(seen > 0.0)) continue;
        if (!around) around = surroundings_of(view, overlays, margin_of(panel));
        std::vector<ShownName> places;
        if (has_plan) {
            places = planned_places(spots, name, *around, film_s);
        } else if (std::optional<PlacedName> best = best_place(spots, name, *around)) {
            places.push_back({best, best->has_room ? 1.0 : 0.0});
        }
        double whole = 0.0;
        for (ShownName& shown : places) {
            if (is_still) shown.opacity = whole_or_absent(shown.opacity);
            whole = std::max(whole, shown.opacity);
        }
        if (whole < 0.5) leave_out(name, true);
        for (const ShownName& shown : places)
            if (shown.opacity > 0.0)
                add_name(panel, name, spots, shown.placed->spot, shown.opacity * seen, view);
        for (const ShownName& shown : places)
            if (shown.opacity > 0.0)
                around->labels.push_back({shown.placed->spot.box.centre_px + name.offset_px,
                                          shown.placed->spot.box.half_px, shown.opacity * seen});
    }
    return left_out;
}

namespace {

// Costs a second of film of a name's places, and of changes between them: a name that would stay
// for a second or two is not worth its coming and going.
constexpr double greatest_cost = 6.0;
constexpr double cost_of_coming = 2.5, cost_of_change = 6.0;
constexpr double least_stay_s = 2.0;

constexpr int absent = n_sides;  // the state after those of the sides

// The states of least total cost over the instants, by dynamic programming. `costs`: of all states
// at each instant, per second; `comes_free`: whether the name may come and go without cost before
// an instant.
std::vector<int> cheapest_states(const std::vector<std::vector<double>>& costs,
                                 const std::vector<bool>& comes_free, double step_s) {
    std::vector<double> sums(n_sides + 1, 0.0);
    std::vector<std::vector<int>> from(costs.size(), std::vector<int>(n_sides + 1, 0));
    for (std::size_t k = 0; k < costs.size(); ++k) {
        const auto best = std::min_element(sums.begin(), sums.begin() + n_sides);
        const int best_side = static_cast<int>(best - sums.begin());
        const double change = k == 0 ? 0.0 : cost_of_change;
        const double coming = k == 0 || comes_free[k] ? 0.0 : cost_of_coming;
        std::vector<double> next(n_sides + 1);
        for (int s = 0; s <= n_sides; ++s) {
            const auto i = static_cast<std::size_t>(s);
            double least = sums[i];
            int before = s;
            const auto look_at = [&](int state, double with) {
                const double sum = sums[static_cast<std::size_t>(state)] + with;
                if (sum < least) {
                    least = sum;
                    before = state;
                }
            };
            if (s != absent) look_at(absent, coming);
            look_at(best_side, s == absent ? coming : change);
            next[i] = least + step_s * costs[k][i];
            from[k][i] = before;
        }
        sums = std::move(next);
    }
    std::vector<int> states(costs.size());
    int state = static_cast<int>(std::min_element(sums.begin(), sums.end()) - sums.begin());
    for (std::size_t k = costs.size(); k-- > 0;) {
        states[k] = state;
        state = from[k][static_cast<std::size_t>(state)];
    }
    return states;
}

// Removes stays that are too short to be read.
void drop_short_stays(double step_s, std::vector<int>& states) {
    for (std::size_t first = 0; first < states.size();) {
        std::size_t end = first;
        while (end < states.size() && (states[end] == absent) == (states[first] == absent)) ++end;
        const bool is_whole = first == 0 && end == states.size();
        if (states[first] != absent && !is_whole &&
            step_s * static_cast<double>(end - first) < least_stay_s)
            std::fill(states.begin() + static_cast<std::ptrdiff_t>(first),
                      states.begin() + static_cast<std::ptrdiff_t>(end), absent);
        first = end;
    }
}

// Plans the states within the loop of a stop anew, with the same one at both ends: the picture of
// the stop is followed by that of the loop's beginning.
void close_loop(const FilmLoop& loop, const std::vector<double>& film_s,
                const std::vector<std::vector<double>>& costs, const std::vector<bool>& comes_free,
                double step_s, std::vector<int>& states) {
    const auto first = std::lower_bound(film_s.begin(), film_s.end(), loop.begin_s);
    const auto end = std::lower_bound(first, film_s.end(), loop.end_s);
    if (first == end) return;
    const auto from = first - film_s.begin(), to = end - film_s.begin();
    if (states[static_cast<std::size_t>(from)] == states[static_cast<std::size_t>(to - 1)]) return;
    const std::vector<std::vector<double>> within(costs.begin() + from, costs.begin() + to);
    const std::vector<bool> free_within(comes_free.begin() + from, comes_free.begin() + to);
    constexpr double forbidden = 1e9;
    double least = std::numeric_limits<double>::infinity();
    for (int s = 0; s <= n_sides; ++s) {
        std::vector<std::vector<double>> held = within;
        for (std::vector<double>* ends : {&held.front(), &held.back()})
            for (std::size_t other = 0; other < ends->size(); ++other)
                if (other != static_cast<std::size_t>(s)) (*ends)[other] += forbidden;
        const std::vector<int> tried = cheapest_states(held, free_within, step_s);
        double sum = 0.0;
        for (std::size_t k = 0; k < tried.size(); ++k) {
            sum += step_s * held[k][static_cast<std::size_t>(tried[k])];
            if (k > 0 && tried[k] != tried[k - 1]) sum += cost_of_change;
        }
        if (sum >= least) continue;
        least = sum;
        std::copy(tried.begin(), tried.end(), states.begin() + from);
    }
}

// The second of the film at which a name changes between two instants of the plan: halfway, but not
// while the loop of a stop begins or ends.
double change_between(double before_s, double after_s, const std::vector<FilmLoop>& loops) {
    for (const FilmLoop& loop : loops) {
        if (before_s < loop.begin_s && loop.begin_s <= after_s) return loop.begin_s - fade_s;
        if (before_s < loop.end_s && loop.end_s <= after_s) return loop.end_s + fade_s;
    }
    return 0.5 * (before_s + after_s);
}

// The spans of states at evenly spaced instants.
std::vector<NameSpan> spans_of(const std::vector<int>& states, const std::vector<double>& film_s,
                               const std::vector<FilmLoop>& loops) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<NameSpan> spans;
    for (std::size_t first = 0; first < states.size();) {
        std::size_t end = first;
        while (end < states.size() && states[end] == states[first]) ++end;
        if (states[first] != absent)
            spans.push_back(
                {first == 0 ? -infinite : change_between(film_s[first - 1], film_s[first], loops),
                 end == states.size() ? infinite
                                      : change_between(film_s[end - 1], film_s[end], loops),
                 side_of(states[first])});
        first = end;
    }
    // A name that changes its side appears on the new one while it fades on the old one.
    for (std::size_t k = 1; k < spans.size(); ++k)
        if (spans[k].begin_s <= spans[k - 1].end_s) {
            spans[k].begin_s -= 0.5 * fade_s;
            spans[k - 1].end_s += 0.5 * fade_s;
        }
    return spans;
}

}  // namespace

void plan_names(const Panel& panel, std::vector<PlacedLabels> instants, bool is_loop,
                const std::vector<FilmLoop>& loops, std::vector<ThingName>& names) {
    const std::size_t n = instants.size();
    const double step_s = instants[1].film_s - instants[0].film_s;
    std::vector<double> film_s;
    std::vector<Surroundings> around;
    for (const PlacedLabels& instant : instants) {
        film_s.push_back(instant.film_s);
        around.push_back(surroundings_of(*instant.view, instant.taken, margin_of(panel)));
    }
    for (ThingName& name : names) {
        name.spans.emplace();
        if (name.type.mask->width == 0) continue;
        std::vector<std::vector<double>> costs(n, std::vector<double>(n_sides + 1, 0.0));
        std::vector<bool> is_shown(n), comes_free(n);
        std::vector<Spots> spots;
        spots.reserve(n);
        for (std::size_t k = 0; k < n; ++k) {
            spots.emplace_back(*instants[k].view, name);
            is_shown[k] = seen_share(spots[k]) >= 0.5;
            costs[k][absent] = is_shown[k] ? most_cost_of(*name.thing) : 0.0;
            for (int s = 0; s < n_sides; ++s) {
                const NameSide side = side_of(s);
                const auto spot =
                    is_shown[k] ? spots[k].at(side.angle_rad, side.level) : std::nullopt;
                costs[k][static_cast<std::size_t>(s)] =
                    spot ? std::min(greatest_cost,
                                    room_cost(*spot, *name.thing, around[k], name.em_px) +
                                        preference_cost(*name.thing, side))
                         : greatest_cost;
            }
        }
        if (std::find(is_shown.begin(), is_shown.end(), true) == is_shown.end()) continue;
        for (std::size_t k = 0; k < n; ++k)
            comes_free[k] = is_shown[k] != is_shown[k > 0 ? k - 1 : n - 1];
        // A loop is planned as the middle one of three, so that it has no seam.
        std::vector<int> states;
        if (is_loop) {
            std::vector<std::vector<double>> thrice;
            std::vector<bool> free_thrice;
            for (int turn = 0; turn < 3; ++turn) {
                thrice.insert(thrice.end(), costs.begin(), costs.end());
                free_thrice.insert(free_thrice.end(), comes_free.begin(), comes_free.end());
            }
            states = cheapest_states(thrice, free_thrice, step_s);
            states = {states.begin() + static_cast<std::ptrdiff_t>(n),
                      states.begin() + static_cast<std::ptrdiff_t>(2 * n)};
        } else {
            states = cheapest_states(costs, comes_free, step_s);
        }
        drop_short_stays(step_s, states);
        for (const FilmLoop& loop : loops)
            close_loop(loop, film_s, costs, comes_free, step_s, states);
        name.spans = spans_of(states, film_s, loops);
        if (is_loop && states.front() != states.back()) {
            // A change at the seam.
            if (states.front() != absent)
                name.spans->front().begin_s = film_s.front() - 0.5 * step_s;
            if (states.back() != absent) name.spans->back().end_s = film_s.back() + 0.5 * step_s;
        }
        // The names after it keep off it.
        for (std::size_t k = 0; k < n; ++k) {
            if (states[k] == absent) continue;
            const NameSide side = side_of(states[k]);
            if (const auto spot = spots[k].at(side.angle_rad, side.level))
                around[k].labels.push_back({spot->box.centre_px, spot->box.half_px, 1.0});
        }
    }
}

}  // namespace poinsot
