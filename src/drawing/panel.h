// The table of panels: views of one motion from several sides, in any grid, on one clock.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/stage_data.h"
#include "text/languages.h"

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
    std::optional<Timeline> own_timeline;     // of a camera of its own; else that of [camera]
    bool orthographic = false;                // as its camera's projection says
    Camera camera;                            // at the film's beginning
    std::function<Camera(double)> camera_at;  // of a second of the film, if it moves
    double units_per_px = 0.001;              // at the camera's target
    // What polylines may leave their curves by, in the panel's units.
    double curve_units() const { return stage->curve_px * units_per_px; }
    // As StageData has it, by the polyline's distance from the curve in the panel's units.
    const CurveGeometry* keep(CurveGeometry geometry, double off_units,
                              std::string_view what) const {
        return stage->keep(std::move(geometry), off_units / units_per_px, what);
    }
    Light light;                    // the theme's, unless the panel turns it
    Quantities asks = omega_alone;  // what its drawer reads of an instant besides ω
    bool shows_beside = false;      // whether it reads Instant::beside
    Drawer draw;
};

// The construction as it is drawn. Precondition: the motion turns and keeps L.
inline const ConstructionPicture& picture_of(const Panel& panel) { return *panel.stage->rolling; }

// Where the panel's camera stands at any second of the film.
const Timeline& timeline_of(const Panel& panel);

// A camera as the panel has it: where it is orthographic, from afar, with that height of view which
// a perspective camera has at its target.
Camera projected(const Panel& panel, const Camera& camera);

// Aims a panel's camera and notes how large a pixel is at its target.
void aim(Panel& panel, const Camera& camera);

// What a panel takes of a camera: nothing, for it is flat; in body axes or in space the direction,
// the field and the projection, for it is framed; or the distance and the target too.
enum class CameraUse { none, own_direction, direction, all };

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    Phrase title;  // stands over it when it is not alone
    bool fills;    // alone, it still leaves the title and the caption their room
    // Whether this motion can be shown so; `without` finishes the sentence "this panel needs …".
    bool (*possible)(const StageData& stage);
    std::string_view needs;
    // Sets the panel's camera, its drawer and what that asks for.
    void (*make)(Panel& panel);
    CameraUse camera = CameraUse::none;
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// Keys of [camera] that the scene gives though none of its panels is seen as they say.
std::vector<std::string> idle_camera_keys(const Scene& scene);

// The kind of panel that suits a motion when the scene names none.
std::string_view default_panel(const StageData& stage);

}  // namespace poinsot
