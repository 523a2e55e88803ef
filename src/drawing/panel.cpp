#include "drawing/panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "error/error.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

// The rows, one file each.
void make_space_panel(Panel& panel);
void make_body_panel(Panel& panel);
void make_plan_panel(Panel& panel);
void make_momentum_panel(Panel& panel);
void make_plot_panel(Panel& panel);
void make_potential_panel(Panel& panel);
void make_top_panel(Panel& panel);
void make_object_panel(Panel& panel);
void make_sweep_panel(Panel& panel);

namespace {

bool rolls(const StageData& stage) { return stage.rolling.has_value(); }

bool any(const StageData&) { return true; }
bool sweeps(const StageData& stage) { return !stage.scene.construction.sweep.empty(); }
bool is_heavy_top(const StageData& stage) { return stage.motion.motion().heavy_top() != nullptr; }

constexpr std::string_view heavy_top = "a heavy symmetric top";
constexpr std::string_view free_turning = "a torque-free body that turns";

const std::array<PanelKind, 9> table{{
    {"space", "the ellipsoid rolling on the invariable plane", "Invariable plane", false, rolls,
     free_turning, make_space_panel},
    {"body", "the ellipsoid at rest, all its polhodes and the separatrices", "Body axes", true,
     rolls, free_turning, make_body_panel},
    {"plan", "the herpolhode on the plane, seen along its normal", "Herpolhode", true, rolls,
     free_turning, make_plan_panel},
    {"momentum", "the sphere |L| and the energy ellipsoid meeting, in body axes",
     "Momentum in body axes", true, rolls, free_turning, make_momentum_panel},
    {"object", "the body itself turning, with its principal axes, ω and L", "Body in space", true,
     any, "", make_object_panel},
    {"plot", "ω, angles, energies or residuals against time, with a moving cursor", "", true, any,
     "", make_plot_panel},
    {"top", "a heavy top with its Euler angles and the path of its axis on the unit sphere",
     "Heavy top", true, is_heavy_top, heavy_top, make_top_panel},
    {"potential", "effective potential of a heavy top with E and the moving point",
     "Effective potential", true, is_heavy_top, heavy_top, make_potential_panel},
    {"sweep", "what [construction] sweep runs through: an axis of a body at rest, or √(2T)/L", "",
     true, sweeps, "[construction] sweep", make_sweep_panel},
}};

}  // namespace

void aim(Panel& panel, const Camera& camera) {
    panel.camera = camera;
    const double distance = (camera.eye - camera.target).norm();
    panel.units_per_px =
        camera.orthographic
            ? camera.height_units / panel.box.height_px
            : 2.0 * distance * std::tan(0.5 * camera.vertical_field_rad) / panel.box.height_px;
}

std::string_view default_panel(const StageData& stage) {
    if (sweeps(stage)) return "sweep";
    if (is_heavy_top(stage)) return "top";
    const auto& torque = stage.motion.motion().problem().torque;
    return std::holds_alternative<NoTorque>(torque) ? "space" : "object";
}

std::span<const PanelKind> panel_kinds() { return table; }

const PanelKind& panel_kind_named(std::string_view name) {
    std::vector<std::string_view> names;
    for (const PanelKind& kind : table) {
        if (kind.name == name) return kind;
        names.push_back(kind.name);
    }
    throw InputError(fmt::format("unknown panel \"{}\"{}; choose from: {}", printable(name),
                                 did_you_mean(name, names), fmt::join(names, ", ")));
}

}  // namespace poinsot
