// The curves and surfaces that have names in the picture, and the names that are set for them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "scene/scene.h"
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

// In this order: a name gives way to those before it. The last three are of no scene's `names`:
// they are shown where all names are.
std::span<const NamedThing> things_with_names();

// The side of a thing: a direction in the picture, from right to below, and a distance from 0,
// near, on.
struct NameSide {
    double angle_rad = 0.0;
    double level = 0.0;
};

// The time in which a name fades in a film.
inline constexpr double name_fade_s = 0.3;

// A part of a film in which a name stands on one side.
struct NameSpan {
    double begin_s = 0.0, end_s = 0.0;  // of the film; infinite: the film's own begin or end
    NameSide side{};

    // Opacity: the name fades within its span, a little from either end.
    double presence(double film_s) const;
};

// A name that a panel shows if it shows the thing.
struct ThingName {
    const NamedThing* thing = nullptr;
    TextBlock type;
    Colour colour;
    double em_px = 0.0;                                   // of its letters
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();  // by hand
    // Of a film, in order; absent: the best side of the instant.
    std::optional<std::vector<NameSpan>> spans{};
};

// The words for curves and cones in texts of the scene, and the roles of their colours in the
// theme. Surfaces have no words here: their colours are too pale for letters.
struct ThingWords {
    std::string text;
    std::string_view role;
};
std::vector<ThingWords> words_of_things(const Scene& scene);

// The words for a thing or a panel in the scene's language; for the invariable plane, if drag slows
// the body and the plane moves, those for the tangent plane.
std::string_view words_of_plane(const Scene& scene, std::string_view thing, const Phrase& words);

}  // namespace poinsot
