// The table of panels: views of one motion in any grid, all at the same instant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/stage/stage_data.h"
#include "text/languages.h"

namespace poinsot {

// Position and size of a panel in the picture, pixels, y down.
struct PanelBox {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

// One panel of a stage: its box, its camera, and its drawer.
struct Panel {
    StageData* stage = nullptr;
    PanelSpec spec;
    PanelBox box;
    double px = 1.0;         // pixels per pixel of a panel with 1080 rows; scales lines
    double type_px = 1.0;    // the same for text, which shrinks less so that it stays legible
    double header_px = 0.0;  // rows at the top for the panel's name, 0 without one
    std::optional<Timeline> user_timeline;    // of its own camera; else that of [camera]
    bool orthographic = false;                // projection of its camera
    Camera camera;                            // at the film's start
    std::function<Camera(double)> camera_at;  // if it moves; argument: film time, s
    double units_per_px = 0.001;              // at the camera's target
    // Largest distance of polylines from their curves, in the panel's units.
    double curve_units() const { return stage->curve_px * units_per_px; }
    // As StageData has it, by the polyline's distance from the curve in the panel's units.
    const CurveGeometry* keep(CurveGeometry geometry, double off_units,
                              std::string_view what) const {
        return stage->keep(std::move(geometry), off_units / units_per_px, what);
    }
    Light light;                     // the theme's, unless the panel turns it
    Quantities needs = omega_alone;  // what its drawer reads of an instant besides ω
    bool shows_comparison = false;   // whether it reads FrameInput::beside
    Drawer draw;
};

// The construction in picture axes. Precondition: the motion rotates and conserves L.
inline const ConstructionPicture& picture_of(const Panel& panel) { return *panel.stage->rolling; }

// The camera's timeline: its own or that of [camera].
const Timeline& timeline_of(const Panel& panel);

// A camera in the panel's projection: an orthographic one is placed far away, with the height of
// view that the perspective camera has at its target.
Camera projected(const Panel& panel, const Camera& camera);

// Aims a panel's camera and stores the size of a pixel at its target.
void aim(Panel& panel, const Camera& camera);

// The part of the camera settings that a panel uses: none, because the panel is flat; direction,
// field and projection (in body axes or in space), because it is framed; or all, including distance
// and target.
enum class CameraUse { none, given_direction, direction, all };

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    Phrase title;  // shown above it if there are several panels
    bool fills;    // alone, it still leaves rows for the title and the caption
    // Whether it can show this motion; `requirement` completes the sentence "this panel needs …".
    bool (*possible)(const StageData& stage);
    std::string_view requirement;
    // Sets the panel's camera, its drawer and the quantities that the drawer reads.
    void (*make)(Panel& panel);
    CameraUse camera = CameraUse::none;
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// Keys of [camera] that the scene gives and that none of its panels uses.
std::vector<std::string> idle_camera_keys(const Scene& scene);

// The default kind of panel for a motion.
std::string_view default_panel(const StageData& stage);

}  // namespace poinsot
