#include "drawing/stage/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

// The panels, one file each.
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

bool keeps_momentum(const StageData& stage) { return stage.rolling.has_value(); }
bool rolls(const StageData& stage) {
    return stage.rolling.has_value() && !stage.rolling->dissipates;
}

bool any(const StageData&) { return true; }
bool sweeps(const StageData& stage) { return !stage.scene.construction.sweep.empty(); }
bool is_heavy_top(const StageData& stage) { return stage.motion.motion().heavy_top() != nullptr; }

constexpr std::string_view heavy_top = "a heavy symmetric top";
constexpr std::string_view free_turning = "a torque-free body that turns";
constexpr std::string_view turning = "a body that turns without torque; friction inside is allowed";

// Titles above the panels.
constexpr Phrase invariable_plane_title{"Invariable plane", "Invariable Ebene",  "Plan invariable",
                                        "Plano invariable", "Piano invariabile", "不変平面"};
constexpr Phrase body_axes_title{"Body axes",       "Körperfeste Achsen",     "Axes liés au corps",
                                 "Ejes del cuerpo", "Assi solidali al corpo", "物体座標系"};
constexpr Phrase herpolhode_title{"Herpolhode",  "Herpolhodie", "Herpolhodie",
                                  "Herpolhodia", "Erpoloide",   "ハーポロード"};
constexpr Phrase momentum_in_body_axes_title{"Momentum in body axes",
                                             "Drehimpuls in körperfesten Achsen",
                                             "Moment cinétique dans les axes du corps",
                                             "Momento angular en ejes del cuerpo",
                                             "Momento angolare in assi solidali",
                                             "物体座標系の角運動量"};
constexpr Phrase body_in_space_title{
    "Body in space",        "Körper im Raum",     "Corps dans l\u2019espace",
    "Cuerpo en el espacio", "Corpo nello spazio", "空間内の物体"};
constexpr Phrase heavy_top_title{"Heavy top",     "Schwerer Kreisel", "Toupie pesante",
                                 "Peonza pesada", "Trottola pesante", "重いこま"};
constexpr Phrase effective_potential_title{"Effective potential", "Effektives Potential",
                                           "Potentiel effectif",  "Potencial efectivo",
                                           "Potenziale efficace", "有効ポテンシャル"};

const PanelKind panel_rows[] = {
    {"space", "the ellipsoid rolling on the invariable plane", invariable_plane_title, false,
     keeps_momentum, turning, make_space_panel, CameraUse::all},
    {"body", "the ellipsoid at rest, all its polhodes and the separatrices", body_axes_title, true,
     keeps_momentum, turning, make_body_panel, CameraUse::given_direction},
    {"plan", "the herpolhode on the plane, seen along its normal", herpolhode_title, true, rolls,
     free_turning, make_plan_panel},
    {"momentum",
     "the sphere of constant |L| and the energy ellipsoid, which meet in the path of L in body "
     "axes",
     momentum_in_body_axes_title, true, keeps_momentum, turning, make_momentum_panel,
     CameraUse::given_direction},
    {"object", "the turning body itself, with its principal axes, ω and L", body_in_space_title,
     true, any, "", make_object_panel, CameraUse::direction},
    {"plot", "ω, angles, energies or residuals against time, with a moving cursor", no_words, true,
     any, "", make_plot_panel},
    {"top", "a heavy top with its Euler angles and the path of its axis on the unit sphere",
     heavy_top_title, true, is_heavy_top, heavy_top, make_top_panel, CameraUse::direction},
    {"potential", "effective potential of a heavy top, with its energy E and its current tilt",
     effective_potential_title, true, is_heavy_top, heavy_top, make_potential_panel},
    {"sweep",
     "the quantity that [construction] sweep varies: an axis of a body at rest, or √(2T)/L",
     no_words, true, sweeps, "[construction] sweep", make_sweep_panel, CameraUse::direction},
};

}  // namespace

const Timeline& timeline_of(const Panel& panel) {
    return panel.user_timeline ? *panel.user_timeline : panel.stage->timeline;
}

Camera projected(const Panel& panel, const Camera& camera) {
    if (!panel.orthographic || camera.orthographic) return camera;
    constexpr double far_off = 100.0;
    const Eigen::Vector3d sight = camera.eye - camera.target;
    Camera flat = camera;
    flat.orthographic = true;
    flat.height_units = 2.0 * sight.norm() * std::tan(0.5 * camera.vertical_field_rad);
    flat.eye = camera.target + far_off * sight.normalized();
    return flat;
}

void aim(Panel& panel, const Camera& camera) {
    panel.camera = projected(panel, camera);
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
    const bool keeps_L = std::holds_alternative<NoTorque>(torque) ||
                         std::holds_alternative<DissipationTorque>(torque);
    return keeps_L ? "space" : "object";
}

std::span<const PanelKind> panel_kinds() { return panel_rows; }

std::vector<std::string> idle_camera_keys(const Scene& scene) {
    // The part of [camera] that the panels without a direction of their own use.
    CameraUse use = CameraUse::none;
    bool any_view = scene.panels.empty();
    for (const PanelSpec& spec : scene.panels) {
        const auto kind =
            std::find_if(std::begin(panel_rows), std::end(panel_rows),
                         [&spec](const PanelKind& row) { return row.name == spec.kind; });
        if (kind == std::end(panel_rows)) return {};
        // The plan is flat, but follows the azimuth of the space panel's camera.
        if (kind->name == "plan") return {};
        any_view = any_view || kind->camera != CameraUse::none;
        if (kind->camera != CameraUse::given_direction) use = std::max(use, kind->camera);
    }
    if (scene.panels.empty()) {
        const bool keeps_L = std::holds_alternative<NoTorque>(scene.torque) ||
                             std::holds_alternative<DissipationTorque>(scene.torque);
        use = keeps_L && scene.construction.sweep.empty() ? CameraUse::all : CameraUse::direction;
    }
    std::vector<std::string> idle;
    const auto add = [&](std::string_view leaf) {
        std::string path = fmt::format("camera.{}", leaf);
        if (scene.locations.contains(path)) idle.push_back(std::move(path));
    };
    if (!any_view)
        for (const char* leaf : {"field_deg", "projection"}) add(leaf);
    if (use < CameraUse::direction)
        for (const char* leaf : {"azimuth_deg", "elevation_deg", "view"}) add(leaf);
    if (use < CameraUse::all)
        for (const char* leaf : {"distance", "target", "look_at"}) add(leaf);
    return idle;
}

const PanelKind& panel_kind_named(std::string_view name) {
    if (const PanelKind* row = find_row(panel_rows, name)) return *row;
    throw InputError(unknown("panel", name, names_of(panel_rows)));
}

}  // namespace poinsot
