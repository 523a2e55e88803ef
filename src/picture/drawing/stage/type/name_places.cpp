#include "drawing/stage/type/name_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numerics/smooth_step.h"
#include "shapes/outlines.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

double angle_of(int direction) { return 2.0 * std::numbers::pi * direction / n_name_directions; }

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

}  // namespace

// Cones are the subject where they are shown; a
// plane has room for its name beside what is drawn on it, or needs none.
double most_cost_of(const NamedThing& thing) {
    if (thing.element == "cones") return 5.0;
    return thing.element == "plane" ? 2.3 : 2.8;
}

double preference_cost(const NamedThing& thing, const NameSide& side) {
    const double from_preferred = std::remainder(
        side.angle_rad - thing.preferred_deg * std::numbers::pi / 180.0, 2.0 * std::numbers::pi);
    // The clockwise side costs more, so that two sides are seldom equally good.
    return 0.35 * (1.0 - std::cos(from_preferred)) +
           0.25 * (0.5 + 0.5 * from_preferred / std::numbers::pi) + 0.35 * side.level;
}

double room_cost(const Spot& spot, const NamedThing& thing, const Surroundings& around,
                 double em_px) {
    const double spread = 2.0 * smooth_step(spot.spread_px / (2.0 * em_px) - 0.5);
    return spread + cost_of(spot.box, around, thing, em_px) +
           leader_cost(spot, around, thing, em_px);
}

NameSide side_of(int index) {
    constexpr int n_levels = static_cast<int>(name_levels.size());
    return {angle_of(index / n_levels), name_levels[static_cast<std::size_t>(index % n_levels)]};
}
std::optional<PlacedName> placed_at(const Spots& spots, const ThingName& name, const NameSide& side,
                                    const Surroundings& around) {
    const auto spot = spots.at(side.angle_rad, side.level);
    if (!spot) return std::nullopt;
    return PlacedName{
        *spot, room_cost(*spot, *name.thing, around, name.em_px) < most_cost_of(*name.thing)};
}

std::optional<PlacedName> best_place(const Spots& spots, const ThingName& name,
                                     const Surroundings& around) {
    std::optional<PlacedName> best;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < n_name_sides; ++k) {
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

double seen_share(const Spots& spots) {
    return smooth_step((std::min(1.0, spots.opacity()) - 0.35) / 0.3);
}

}  // namespace poinsot
