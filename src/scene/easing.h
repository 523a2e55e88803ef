// The table of easings: how a value goes from one keyframe to the next.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

// A function of the share u of the way in time, 0…1, from 0 at u = 0 to 1 at u = 1, with its
// integral from 0 to u, so that what it drives can be integrated in closed form.
struct Easing {
    std::string_view name;
    std::string_view summary;
    double (*value)(double u);
    double (*integral)(double u);
    // Whether the way goes on through the key where it arrives: then a Track lays a cubic through
    // it and its neighbours, and the functions stand for a way that has none.
    bool goes_on = false;
};

std::span<const Easing> easings();

// Throws InputError with the nearest name and the list.
const Easing& easing_named(std::string_view name);

}  // namespace poinsot
