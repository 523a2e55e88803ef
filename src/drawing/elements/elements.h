// The table of things that the space panel can show: a name beside the function that makes its
// drawer.
#pragma once

#include <span>
#include <string_view>

#include "drawing/panel.h"

namespace poinsot {

struct Element {
    std::string_view name;
    std::string_view summary;
    // Whether it is shown when the scene does not say.
    bool (*by_default)(const StageData& stage);
    // What its drawer reads of an instant besides ω.
    Quantities asks;
    // Makes what all instants share, kept by the stage, and the function that draws an instant.
    Drawer (*make)(Panel& panel);
};

std::span<const Element> elements();

// Whether the space panel shows it: the scene names it, or names none and it suits the motion.
bool is_shown(const StageData& stage, std::string_view name);

// Throws InputError with the nearest name and the list.
const Element& element_named(std::string_view name);

}  // namespace poinsot
