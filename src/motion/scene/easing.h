// The table of easings: how a value moves from one keyframe to the next.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

// A function of the elapsed part u of the time, 0…1, that rises from 0 at u = 0 to 1 at u = 1, with
// its integral from 0 to u, so that a value moved by it can be integrated in closed form.
struct Easing {
    std::string_view name;
    std::string_view summary;
    double (*value)(double u);
    double (*integral)(double u);
    // Whether the value keeps moving through the key where it arrives: a Track then uses a cubic
    // through the key and its neighbours, and the functions apply to a value without other keys.
    bool goes_on = false;
};

std::span<const Easing> easings();

// Returns an easing by name. Throws InputError with the nearest name and the list.
const Easing& easing_named(std::string_view name);

}  // namespace poinsot
