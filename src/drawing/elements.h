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
    // Makes what all instants share, kept by the stage, and the function that draws an instant.
    Drawer (*make)(StageData& stage);
};

std::span<const Element> elements();

// Throws InputError with the nearest name and the list.
const Element& element_named(std::string_view name);

}  // namespace poinsot
