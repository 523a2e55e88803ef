// The table of panels: views of one motion in any grid, all at the same instant. Every panel has a
// file of its own beside this one.
#pragma once

#include "drawing/figures/elements/body_axes.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/possible_motions.h"

namespace poinsot {

// Each sets the panel's camera, its drawer and what the drawer needs.
void make_space_panel(Panel& panel, StageStore& store);
void make_body_panel(Panel& panel, StageStore& store);
void make_plan_panel(Panel& panel, StageStore& store);
void make_momentum_panel(Panel& panel, StageStore& store);
void make_plot_panel(Panel& panel, StageStore& store);
void make_potential_panel(Panel& panel, StageStore& store);
void make_top_panel(Panel& panel, StageStore& store);
void make_object_panel(Panel& panel, StageStore& store);
void make_sweep_panel(Panel& panel, StageStore& store);

inline bool sweeps(const StageContext& stage) { return !stage.scene.construction.sweep.empty(); }

// Titles above the panels.
inline constexpr Phrase invariable_plane_title{"Invariable plane",  "Invariable Ebene",
                                               "Plan invariable",   "Plano invariable",
                                               "Piano invariabile", "不変平面"};
inline constexpr Phrase body_axes_title{
    "Body axes",       "Körperfeste Achsen",     "Axes liés au corps",
    "Ejes del cuerpo", "Assi solidali al corpo", "物体座標系"};
inline constexpr Phrase herpolhode_title{"Herpolhode", "Herpolhodie", "Herpolhodie",
                                         "Herpolodia", "Erpolodia",   "ハーポルホード"};
inline constexpr Phrase momentum_in_body_axes_title{"Momentum in body axes",
                                                    "Drehimpuls in körperfesten Achsen",
                                                    "Moment cinétique dans les axes du corps",
                                                    "Momento angular en ejes del cuerpo",
                                                    "Momento angolare in assi solidali",
                                                    "物体座標系の角運動量"};
inline constexpr Phrase body_in_space_title{
    "Body in space",        "Körper im Raum",     "Corps dans l\u2019espace",
    "Cuerpo en el espacio", "Corpo nello spazio", "空間内の物体"};
inline constexpr Phrase heavy_top_title{"Heavy top",     "Schwerer Kreisel", "Toupie pesante",
                                        "Peonza pesada", "Trottola pesante", "重いこま"};
inline constexpr Phrase effective_potential_title{"Effective potential", "Effektives Potential",
                                                  "Potentiel effectif",  "Potencial efectivo",
                                                  "Potenziale efficace", "有効ポテンシャル"};

inline constexpr PanelKind panel_rows[] = {
    {.name = "space",
     .summary = "the ellipsoid rolling on the invariable plane",
     .title = invariable_plane_title,
     .possible = keeps_momentum,
     .requirement = needs_turning,
     .make = make_space_panel,
     .uses = uses_elements | uses_direction_marks | uses_marks_on_ellipsoid | uses_marks_in_space |
             uses_mark_trails | uses_comparison | uses_names | uses_measured | uses_inset,
     .camera = CameraUse::all,
     .titled_after = "invariable-plane"},
    {.name = "body",
     .summary = "the ellipsoid at rest, all its polhodes and the separatrices",
     .title = body_axes_title,
     .fills = true,
     .possible = keeps_momentum,
     .requirement = needs_turning,
     .make = make_body_panel,
     .uses = uses_curves | uses_polhode_trail | uses_marks_on_ellipsoid | uses_comparison |
             uses_names | uses_measured,
     .camera = CameraUse::direction,
     .default_view_direction = principal_view_direction},
    {.name = "plan",
     .summary = "the herpolhode on the plane, seen along its normal",
     .title = herpolhode_title,
     .fills = true,
     .possible = rolls,
     .requirement = needs_free_turning,
     .make = make_plan_panel,
     .uses = uses_herpolhode | uses_direction_marks | uses_azimuth | uses_comparison | uses_names |
             uses_measured,
     .titled_after = "herpolhode"},
    {.name = "momentum",
     .summary =
         "the sphere of constant |L| and the energy ellipsoid, which meet in the path of L in body "
         "axes",
     .title = momentum_in_body_axes_title,
     .fills = true,
     .possible = keeps_momentum,
     .requirement = needs_turning,
     .make = make_momentum_panel,
     .uses = uses_polhode_trail | uses_comparison | uses_solid_angle | uses_names,
     .camera = CameraUse::direction,
     .default_view_direction = principal_view_direction},
    {.name = "object",
     .summary = "the turning body itself, with its principal axes, ω and L",
     .title = body_in_space_title,
     .fills = true,
     .possible = any_motion,
     .make = make_object_panel,
     .uses = uses_object | uses_marks_on_body | uses_mark_trails | uses_comparison | uses_forces,
     .camera = CameraUse::direction},
    {.name = "plot",
     .summary = "ω, angles, energies or residuals against time, with a moving cursor",
     .fills = true,
     .possible = any_motion,
     .make = make_plot_panel,
     .uses = uses_quantity | uses_comparison | uses_measured},
    {.name = "top",
     .summary = "a heavy top with its Euler angles and the path of its axis on the unit sphere",
     .title = heavy_top_title,
     .fills = true,
     .possible = is_heavy_top,
     .requirement = needs_heavy_top,
     .make = make_top_panel,
     .uses = uses_axis_path | uses_comparison | uses_names,
     .camera = CameraUse::direction},
    {.name = "potential",
     .summary = "effective potential of a heavy top, with its energy E and its current tilt",
     .title = effective_potential_title,
     .fills = true,
     .possible = is_heavy_top,
     .requirement = needs_heavy_top,
     .make = make_potential_panel},
    {.name = "sweep",
     .summary =
         "the quantity that [construction] sweep varies: an axis of a body at rest, or √(2T)/L",
     .fills = true,
     .possible = sweeps,
     .requirement = "[construction] sweep",
     .make = make_sweep_panel,
     .uses = uses_object | uses_names,
     .camera = CameraUse::direction},
};

}  // namespace poinsot
