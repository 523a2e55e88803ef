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

// The scene keys that only some panels take, as bits of PanelKind::takes.
enum TakenKeys : unsigned {
    takes_nothing = 0,
    takes_elements = 1u << 0,         // most elements of show
    takes_quantity = 1u << 1,         // panels.quantity
    takes_curves = 1u << 2,           // panels.curves
    takes_spiral = 1u << 3,           // trail.polhode, of a dissipating body
    takes_herpolhode = 1u << 4,       // trail.herpolhode
    takes_direction_marks = 1u << 5,  // trail.direction_marks
    takes_object = 1u << 6,           // object.name and object.mesh
    takes_marks_on_ellipsoid = 1u << 7,
    takes_marks_in_space = 1u << 8,
    takes_marks_on_body = 1u << 9,
    takes_mark_trails = 1u << 10,
    takes_comparison = 1u << 11,  // [beside]
    takes_azimuth = 1u << 12,     // camera.azimuth_deg, although it is flat
    takes_axis_path = 1u << 13,   // trail.axis
    takes_names = 1u << 14,       // names
    takes_measured = 1u << 15,    // [measured]
    // Elements that other panels than "space" show.
    takes_forces = 1u << 16,
    takes_solid_angle = 1u << 17,
    takes_inset = 1u << 18,  // panels.inset
};

// A row of the table of panels.
struct PanelKind {
    std::string_view name;
    std::string_view summary;
    Phrase title;  // shown above it if there are several panels
    bool fills;    // its figure extends to the box's edges: title and caption get rows of their own
    // Whether it can show this motion; `requirement` completes the sentence "this panel needs …".
    bool (*possible)(const StageContext& stage);
    std::string_view requirement;
    // Sets the panel's camera, its drawer and the quantities that the drawer reads. Adds what all
    // instants share to the store.
    void (*make)(Panel& panel, StageStore& store);
    unsigned takes = takes_nothing;  // bits of TakenKeys
    CameraUse camera = CameraUse::none;
    // The direction to its camera in axes of its own, where that of [camera] would mean nothing;
    // null: the panel has the axes of [camera].
    Eigen::Vector3d (*own_direction)(const Panel& panel) = nullptr;
    // The thing whose name the title is, one of named_things; empty: of none.
    std::string_view titled_after{};
};

std::span<const PanelKind> panel_kinds();

// Throws InputError with the nearest name and the list.
const PanelKind& panel_kind_named(std::string_view name);

// The names of the kinds for which this holds: "\"space\", \"body\" or \"plan\"".
std::string panels_where(const std::function<bool(const PanelKind&)>& holds,
                         std::string_view conjunction);
std::string panels_that_take(TakenKeys key, std::string_view conjunction);

// The kind of the only panel of a scene that lists none. `is_heavy_top`: of its motion.
std::string_view default_panel(const Scene& scene, bool is_heavy_top);

}  // namespace poinsot
