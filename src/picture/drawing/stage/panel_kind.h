// The kinds of panels, as rows of a table. The rows are in figures/panels/panels.h; the stage lays
// out whatever kinds it finds there.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "drawing/stage/panel.h"
#include "text/languages.h"

namespace poinsot {

// The part of the camera settings that a panel uses: none, because the panel is flat; direction,
// field and projection, because it is framed; or all, including distance and target.
enum class CameraUse { none, direction, all };

// The scene keys that only some panels use, as bits of PanelKind::uses.
enum PanelUses : unsigned {
    uses_nothing = 0,
    uses_elements = 1u << 0,         // most elements of show
    uses_quantity = 1u << 1,         // panels.quantity
    uses_curves = 1u << 2,           // panels.curves
    uses_polhode_trail = 1u << 3,    // trail.polhode, of a dissipating body
    uses_herpolhode = 1u << 4,       // trail.herpolhode
    uses_direction_marks = 1u << 5,  // trail.direction_marks
    uses_object = 1u << 6,           // object.name and object.mesh
    uses_marks_on_ellipsoid = 1u << 7,
    uses_marks_in_space = 1u << 8,
    uses_marks_on_body = 1u << 9,
    uses_mark_trails = 1u << 10,
    uses_comparison = 1u << 11,  // [beside]
    uses_azimuth = 1u << 12,     // camera.azimuth_deg, although it is flat
    uses_axis_path = 1u << 13,   // trail.axis
    uses_names = 1u << 14,       // names
    uses_measured = 1u << 15,    // [measured]
    // Elements that other panels than "space" show.
    uses_forces = 1u << 16,
    uses_solid_angle = 1u << 17,
    uses_inset = 1u << 18,  // panels.inset
};

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    Phrase title = no_words;  // shown above it if there are several panels
    // Whether its figure extends to the box's edges: title and caption get rows of their own.
    bool fills = false;
    // Whether it can show this motion; `requirement` completes the sentence "this panel needs …".
    bool (*possible)(const StageContext& stage);
    std::string_view requirement{};
    // Sets the panel's camera, its drawer and the quantities that the drawer reads. Adds what all
    // instants share to the store.
    void (*make)(Panel& panel, StageStore& store);
    unsigned uses = uses_nothing;  // bits of PanelUses
    CameraUse camera = CameraUse::none;
    // The direction to its camera, for a panel with axes of its own; null: its axes are those of
    // [camera].
    Eigen::Vector3d (*default_view_direction)(const Panel& panel) = nullptr;
    // The thing whose name the title is, one of named_things; empty: of none.
    std::string_view titled_after{};
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// The names of the kinds for which this holds: "\"space\", \"body\" or \"plan\"".
std::string panels_where(const std::function<bool(const PanelKind&)>& holds,
                         std::string_view conjunction);
std::string panels_that_use(PanelUses key, std::string_view conjunction);

// The kind of the only panel of a scene that lists none. `is_heavy_top`: of its motion.
std::string_view default_panel(const Scene& scene, bool is_heavy_top);

}  // namespace poinsot
