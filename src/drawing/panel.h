// The table of panels: views of one motion from several sides, in any grid, on one clock.
#pragma once

#include <span>
#include <string_view>

#include "drawing/stage_data.h"

namespace poinsot {

// Where a panel stands in the picture, pixels, y down.
struct PanelBox {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

// One panel of a stage: its place, its camera, and what it draws.
struct Panel {
    StageData* stage = nullptr;
    PanelSpec spec;
    PanelBox box;
    double px = 1.0;  // pixels for one pixel of a panel with 1080 rows: lines and type follow the
                      // panel's size
    Camera camera;
    double units_per_px = 0.001;  // at the camera's target
    Drawer draw;
};

// Aims a panel's camera and notes how large a pixel is at its target.
void aim(Panel& panel, const Camera& camera);

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    // Whether this motion can be shown so; `without` finishes the sentence "this panel needs …".
    bool (*possible)(const StageData& stage);
    std::string_view needs;
    // Sets the panel's camera and its drawer.
    void (*make)(Panel& panel);
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// The rows, one file each.
void make_space_panel(Panel& panel);

}  // namespace poinsot
