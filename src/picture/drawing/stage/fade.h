// Fades: drawers whose shapes have the opacity that the film's timeline gives.
#pragma once

#include <string>
#include <string_view>

#include "drawing/stage/drawer.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"

namespace poinsot {

// Names the shapes and label requests that have no name yet. The element's solids have its plain
// name, or else its arrows, or its lines, or its dots; the others are parts of it. Several arrows
// are numbered, and so are several requests.
void name_shapes(std::string_view element, ViewBuilder& builder);

// Returns a drawer that names its shapes. If a fade uses the name, it also scales the opacity of
// every shape and draws nothing at opacity 0; the store records that fades may use the name. If the
// scene says `labels = false` or lists this name among the unlabelled, its labels are omitted.
Drawer fading(const StageContext& stage, StageStore& store, const std::string& name, Drawer draw);

}  // namespace poinsot
