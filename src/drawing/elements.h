// The table of things that can be shown: a name beside the function that makes it once and the one
// that draws an instant.
#pragma once

#include <span>
#include <string_view>

#include "drawing/stage_data.h"

namespace poinsot {

struct Element {
    std::string_view name;
    std::string_view summary;
    // Whether it is shown when the scene does not say.
    bool (*by_default)(const StageData& stage);
    // Makes the geometry that all instants share; null if there is none.
    void (*prepare)(StageData& stage);
    // Adds its shapes to the view.
    void (*draw)(const StageData& stage, const Instant& instant, View& view);
};

std::span<const Element> elements();

// Throws InputError with the nearest name and the list.
const Element& element_named(std::string_view name);

}  // namespace poinsot
