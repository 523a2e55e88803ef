// The kinds of panels, as rows of a table. The rows are in figures/panels/panels.h; the stage lays
// out whatever kinds it finds there.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "drawing/stage/panel.h"
#include "text/languages.h"

namespace poinsot {

class StageStore;
struct StageContext;

// The part of the camera settings that a panel uses: none, because the panel is flat; direction,
// field and projection, because it is framed; or all, including distance and target.
enum class CameraUse { none, direction, all };

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    Phrase title;  // shown above it if there are several panels
    bool fills;    // alone, it still leaves rows for the title and the caption
    // Whether it can show this motion; `requirement` completes the sentence "this panel needs …".
    bool (*possible)(const StageContext& stage);
    std::string_view requirement;
    // Sets the panel's camera, its drawer and the quantities that the drawer reads. Adds what all
    // instants share to the store.
    void (*make)(Panel& panel, StageStore& store);
    CameraUse camera = CameraUse::none;
    // The direction to its camera in axes of its own, where that of [camera] would mean nothing;
    // null: the panel has the axes of [camera].
    Eigen::Vector3d (*own_direction)(const Panel& panel) = nullptr;
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// The default kind of panel for a motion.
std::string_view default_panel(const StageContext& stage);

}  // namespace poinsot
