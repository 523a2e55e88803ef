#include "scene/easing.h"

#include <array>

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

const std::array<Easing, 7> easing_rows{{
    {"linear", "at a constant rate", [](double u) { return u; },
     [](double u) { return 0.5 * u * u; }},
    {"smooth", "starts and ends at rest", [](double u) { return u * u * (3.0 - 2.0 * u); },
     [](double u) { return u * u * u * (1.0 - 0.5 * u); }},
    {"smoother", "starts and ends at rest, with zero acceleration at both ends",
     [](double u) { return u * u * u * (10.0 + u * (6.0 * u - 15.0)); },
     [](double u) { return u * u * u * u * (2.5 + u * (u - 3.0)); }},
    {"in", "starts at rest", [](double u) { return u * u; },
     [](double u) { return u * u * u / 3.0; }},
    {"out", "ends at rest", [](double u) { return u * (2.0 - u); },
     [](double u) { return u * u * (1.0 - u / 3.0); }},
    {"through", "passes through the keyframe without stopping, if another keyframe follows",
     [](double u) { return u * u * (3.0 - 2.0 * u); },
     [](double u) { return u * u * u * (1.0 - 0.5 * u); }, true},
    {"hold", "keeps its value and jumps at the end", [](double u) { return u < 1.0 ? 0.0 : 1.0; },
     [](double) { return 0.0; }},
}};

}  // namespace

std::span<const Easing> easings() { return easing_rows; }

const Easing& easing_named(std::string_view name) {
    if (const Easing* row = find_row(easing_rows, name)) return *row;
    throw InputError(unknown("easing", name, names_of(easing_rows)));
}

}  // namespace poinsot
