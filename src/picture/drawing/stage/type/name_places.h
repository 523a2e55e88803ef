// The choice among the places for a name, by their costs.
#pragma once

#include <array>
#include <optional>

#include "drawing/stage/type/name_spots.h"
#include "drawing/stage/type/name_surroundings.h"

namespace poinsot {

// The places that are tried: directions in the picture, and distances.
inline constexpr int n_name_directions = 24;
inline constexpr std::array<double, 5> name_levels{0.0, 1.0, 2.0, 3.2, 4.6};
inline constexpr int n_name_sides = n_name_directions * static_cast<int>(name_levels.size());
// The side of this index.
NameSide side_of(int index);

// The cost from which on a name is better absent.
double most_cost_of(const NamedThing& thing);

// The cost of a place by itself: directions near the preferred one, and near places, are better.
double preference_cost(const NamedThing& thing, const NameSide& side);

// The cost of a place without that of its direction and distance.
double room_cost(const Spot& spot, const NamedThing& thing, const Surroundings& around,
                 double em_px);

struct PlacedName {
    Spot spot;
    bool has_room = false;
};
std::optional<PlacedName> placed_at(const Spots& spots, const ThingName& name, const NameSide& side,
                                    const Surroundings& around);

// The place with the least cost at an instant.
std::optional<PlacedName> best_place(const Spots& spots, const ThingName& name,
                                     const Surroundings& around);

// The share by which a thing is seen: a thing of which less is seen has no name; fading things take
// their names along quickly.
double seen_share(const Spots& spots);

}  // namespace poinsot
