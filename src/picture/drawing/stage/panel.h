// One panel of a stage: a view of the motion, at the same instant as all other panels.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "drawing/stage/drawer.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"
#include "drawing/stage/timeline.h"
#include "shapes/camera.h"

namespace poinsot {

// Position and size of a panel in the picture, pixels, y down.
struct PanelBox {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

// Rows that the overlays take at the top and at the bottom of the picture, and the right end of the
// title.
struct OverlayBands {
    int top_px = 0;
    int bottom_px = 0;
    double title_right_px = 0.0;
};

// A panel's place, its camera, and its drawer. The layout sets the first part; the function of its
// kind reads that and sets the second part. Afterwards it does not change.
struct Panel {
    const StageContext* stage = nullptr;
    PanelSpec spec;
    std::size_t index = 0;            // in the list of panels
    std::optional<std::size_t> host;  // of an inset: the panel in whose corner it stands
    PanelBox box;
    OverlayBands overlays;   // of the picture
    double px = 1.0;         // pixels per pixel of a panel with 1080 rows; scales lines
    double type_px = 1.0;    // the same for text, which shrinks less so that it stays legible
    double header_px = 0.0;  // rows at the top for the panel's name, 0 without one
    std::optional<Timeline> user_timeline;       // of its own camera; else that of [camera]
    bool orthographic = false;                   // projection of its camera
    const CurveGeometry* unit_circle = nullptr;  // as in the store
    const CurveGeometry* unit_segment = nullptr;

    Camera camera;                            // at the film's start
    std::function<Camera(double)> camera_at;  // if it moves; argument: film time, s
    double units_per_px = 0.001;              // at the camera's target
    std::optional<double> herpolhode_radius;  // of its outer circle, if it has lengths of its own
    Light light;                              // the theme's, unless the panel turns it
    Quantities needs = omega_alone;           // what its drawer reads of an instant besides ω
    bool shows_comparison = false;            // whether it reads FrameInput::comparison
    Drawer draw;

    // Largest distance of polylines from their curves, in the panel's units.
    double curve_units() const { return stage->curve_px * units_per_px; }
};

// As StageStore::keep, by the polyline's distance from the curve in the panel's units.
inline const CurveGeometry* keep(const Panel& panel, StageStore& store, CurveGeometry geometry,
                                 double off_units, std::string_view what) {
    return store.keep(std::move(geometry), off_units / panel.units_per_px, what);
}

// The construction in picture axes. Precondition: the motion rotates and conserves L.
inline const ConstructionPicture& picture_of(const Panel& panel) { return *panel.stage->rolling; }

// The camera's timeline: its own or that of [camera].
const Timeline& timeline_of(const Panel& panel);

// A camera in the panel's projection: an orthographic one is placed far away, with the height of
// view that the perspective camera has at its target.
Camera projected(const Panel& panel, const Camera& camera);

// Aims a panel's camera, unless the stage's options give its view, and stores the size of a pixel
// at its target.
void aim(Panel& panel, const Camera& camera);

}  // namespace poinsot
