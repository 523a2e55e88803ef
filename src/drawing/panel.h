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
    double px = 1.0;       // pixels for one pixel of a panel with 1080 rows: lines follow its size
    double type_px = 1.0;  // the same for type, which shrinks less: it must stay readable
    double header_px = 0.0;  // rows at the top that the panel's name takes, 0 without one
    Camera camera;           // at the film's beginning
    std::function<Camera(double)> camera_at;  // of a second of the film, if it moves
    double units_per_px = 0.001;              // at the camera's target
    // What polylines may leave their curves by, in the panel's units.
    double curve_units() const { return stage->curve_px * units_per_px; }
    Light light;                    // the theme's, unless the panel turns it
    Quantities asks = omega_alone;  // what its drawer reads of an instant besides ω
    bool shows_beside = false;      // whether it reads Instant::beside
    Drawer draw;
};

// Aims a panel's camera and notes how large a pixel is at its target.
void aim(Panel& panel, const Camera& camera);

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    std::string_view title;  // stands over it when it is not alone
    bool fills;              // alone, it still leaves the title and the caption their room
    // Whether this motion can be shown so; `without` finishes the sentence "this panel needs …".
    bool (*possible)(const StageData& stage);
    std::string_view needs;
    // Sets the panel's camera, its drawer and what that asks for.
    void (*make)(Panel& panel);
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// The kind of panel that suits a motion when the scene names none.
std::string_view default_panel(const StageData& stage);

}  // namespace poinsot
