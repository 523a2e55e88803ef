// The elements that panels can show, most of them the space panel: each name with the function that
// makes its drawer. The rows are in element_rows.h.
#pragma once

#include <span>
#include <string_view>

#include "drawing/stage/panel.h"
#include "drawing/stage/panel_kind.h"

namespace poinsot {

struct Element {
    std::string_view name;
    std::string_view summary;
    // Whether it is shown if the scene does not list elements.
    bool (*by_default)(const StageContext& stage);
    // The quantities of an instant that its drawer reads besides ω.
    Quantities needs;
    // Makes what all instants share, kept in the store, and the function that draws an instant.
    Drawer (*make)(const Panel& panel, StageStore& store);
    bool reads_comparison = false;       // whether its drawer reads FrameInput::comparison
    PanelUses shown_in = uses_elements;  // the panels that show it
};

std::span<const Element> elements();

// Whether its panels show it: the scene lists it, or lists no elements and it suits the
// motion.
bool is_shown(const StageContext& stage, std::string_view name);

// Throws SceneError for a name in `show` or page.elements that is neither an element nor an
// overlay.
void check_element_names(const Scene& scene);

// Makes the drawers of the elements shown in panels that take this key, adds what they need to the
// panel's needs, and returns one drawer for all.
Drawer make_shown_elements(Panel& panel, StageStore& store, PanelUses shown_in);

// Throws InputError with the nearest name and the list.
const Element& element_named(std::string_view name);

}  // namespace poinsot
