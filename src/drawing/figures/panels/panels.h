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
    {"space", "the ellipsoid rolling on the invariable plane", invariable_plane_title, false,
     keeps_momentum, needs_turning, make_space_panel,
     uses_elements | uses_direction_marks | uses_marks_on_ellipsoid | uses_marks_in_space |
         uses_mark_trails | uses_comparison | uses_names | uses_measured | uses_inset,
     CameraUse::all, nullptr, "invariable-plane"},
    {"body", "the ellipsoid at rest, all its polhodes and the separatrices", body_axes_title, true,
     keeps_momentum, needs_turning, make_body_panel,
     uses_curves | uses_polhode_trail | uses_marks_on_ellipsoid | uses_comparison | uses_names |
         uses_measured,
     CameraUse::direction, principal_view_direction},
    {"plan", "the herpolhode on the plane, seen along its normal", herpolhode_title, true, rolls,
     needs_free_turning, make_plan_panel,
     uses_herpolhode | uses_direction_marks | uses_azimuth | uses_comparison | uses_names |
         uses_measured,
     CameraUse::none, nullptr, "herpolhode"},
    {"momentum",
     "the sphere of constant |L| and the energy ellipsoid, which meet in the path of L in body "
     "axes",
     momentum_in_body_axes_title, true, keeps_momentum, needs_turning, make_momentum_panel,
     uses_polhode_trail | uses_comparison | uses_solid_angle | uses_names, CameraUse::direction,
     principal_view_direction},
    {"object", "the turning body itself, with its principal axes, ω and L", body_in_space_title,
     true, any_motion, "", make_object_panel,
     uses_object | uses_marks_on_body | uses_mark_trails | uses_comparison | uses_forces,
     CameraUse::direction},
    {"plot", "ω, angles, energies or residuals against time, with a moving cursor", no_words, true,
     any_motion, "", make_plot_panel, uses_quantity | uses_comparison | uses_measured},
    {"top", "a heavy top with its Euler angles and the path of its axis on the unit sphere",
     heavy_top_title, true, is_heavy_top, needs_heavy_top, make_top_panel,
     uses_axis_path | uses_comparison | uses_names, CameraUse::direction},
    {"potential", "effective potential of a heavy top, with its energy E and its current tilt",
     effective_potential_title, true, is_heavy_top, needs_heavy_top, make_potential_panel,
     uses_nothing},
    {"sweep",
     "the quantity that [construction] sweep varies: an axis of a body at rest, or √(2T)/L",
     no_words, true, sweeps, "[construction] sweep", make_sweep_panel, uses_object | uses_names,
     CameraUse::direction},
};

}  // namespace poinsot
