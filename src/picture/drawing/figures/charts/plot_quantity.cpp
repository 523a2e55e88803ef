#include "drawing/figures/charts/plot_quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "construction/quantities.h"
#include "drawing/figures/charts/plot_frame.h"
#include "drawing/stage/possible_motions.h"
#include "error/error.h"
#include "numerics/power_of_two.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

template <int axis>
LineStyle axis_colour(const Theme& theme) {
    return theme.axes[axis];
}
template <int angle>
LineStyle angle_colour(const Theme& theme) {
    return theme.angles[angle];
}
LineStyle energy_colour(const Theme& theme) { return theme.energy; }
LineStyle potential_colour(const Theme& theme) { return theme.potential; }
LineStyle omega_colour(const Theme& theme) { return theme.omega; }
LineStyle momentum_colour(const Theme& theme) { return theme.momentum; }
LineStyle contact_colour(const Theme& theme) { return theme.herpolhode; }
LineStyle plane_colour(const Theme& theme) { return theme.polhode; }

LineStyle body_cone_colour(const Theme& theme) { return theme.body_cone; }
LineStyle space_cone_colour(const Theme& theme) { return theme.space_cone; }

const InertiaTensor& inertia_of(const StageContext& stage) {
    return stage.motion.motion().problem().inertia;
}

bool rolls_with_cones(const StageContext& stage) { return rolls(stage) && stage.rolling->cones; }

constexpr Quantities euler_angles{.attitude = false, .herpolhode = false, .euler_angles = true};

// Words of the rows below, in all languages.
constexpr Phrase turns_title{"turns", "Umdrehungen", "tours", "vueltas", "giri", "回転数"};
constexpr Phrase angle_title{"angle from L", "Winkel zu L",  "angle avec L",
                             "ángulo con L", "angolo con L", "Lとの角度"};
constexpr Phrase momentum_tilt_title{"tilt of L",        "Neigung von L",     "inclinaison de L",
                                     "inclinación de L", "inclinazione di L", "Lの傾き"};
constexpr Phrase residual_title{"relative residual", "relativer Rest",   "résidu relatif",
                                "residuo relativo",  "residuo relativo", "相対残差"};
constexpr Phrase wobble_label{"\\mathrm{wobble}",  "\\mathrm{Taumeln}",   "\\mathrm{nutation}",
                              "\\mathrm{cabeceo}", "\\mathrm{nutazione}", "\\mathrm{ふらつき}"};
constexpr Phrase spin_label{"\\mathrm{spin}",
                            "\\mathrm{Spin}",
                            "\\mathrm{rotation propre}",
                            "\\mathrm{giro propio}",
                            "\\mathrm{rotazione propria}",
                            "\\mathrm{自転}"};
constexpr Phrase gap_label{"\\mathrm{gap}",        "\\mathrm{Abstand}", "\\mathrm{écart}",
                           "\\mathrm{separación}", "\\mathrm{scarto}",  "\\mathrm{隙間}"};
constexpr Phrase slip_label{"\\mathrm{slip}",        "\\mathrm{Schlupf}",
                            "\\mathrm{glissement}",  "\\mathrm{deslizamiento}",
                            "\\mathrm{slittamento}", "\\mathrm{滑り}"};

constexpr PlotCurve omega_curves[] = {
    {formula("\\omega_1"), axis_colour<0>, DashPattern::solid},
    {formula("\\omega_2"), axis_colour<1>, DashPattern::dashed},
    {formula("\\omega_3"), axis_colour<2>, DashPattern::dotted},
};
// Components along the principal axes.
PlotValues omega_values(const StageContext& stage, const FrameInput& instant) {
    const Eigen::Vector3d omega = omega_principal(inertia_of(stage), instant);
    return {omega[0], omega[1], omega[2]};
}

constexpr PlotCurve euler_curves[] = {
    {formula("\\theta"), angle_colour<0>, DashPattern::solid},
    {formula("\\varphi"), angle_colour<1>, DashPattern::solid},
    {formula("\\psi"), angle_colour<2>, DashPattern::solid},
};
PlotValues euler_values(const StageContext&, const FrameInput& instant) {
    return {instant.euler.theta_rad, instant.euler.phi_rad, instant.euler.psi_rad};
}

// Of an axis that stays vertical: θ is constant.
template <int sign>
constexpr PlotCurve vertical_curves[] = {
    {formula(sign > 0 ? "\\varphi + \\psi" : "\\varphi - \\psi"), momentum_colour,
     DashPattern::solid},
};
template <int sign>
PlotValues vertical_values(const StageContext&, const FrameInput& instant) {
    return {instant.euler.phi_rad + sign * instant.euler.psi_rad};
}

constexpr PlotCurve energy_curves[] = {
    {formula("T"), energy_colour, DashPattern::solid},
    {formula("V"), potential_colour, DashPattern::dashed},
    {formula("E"), energy_colour, DashPattern::dotted},
};
PlotValues energy_values(const StageContext& stage, const FrameInput& instant) {
    const double kinetic = kinetic_energy_J(inertia_of(stage), instant);
    const double potential =
        potential_J(stage.motion.motion().problem().torque, instant.state.space_from_body);
    return {kinetic, potential, kinetic + potential};
}

constexpr PlotCurve momentum_curves[] = {
    {formula("L_1"), axis_colour<0>, DashPattern::solid},
    {formula("L_2"), axis_colour<1>, DashPattern::dashed},
    {formula("L_3"), axis_colour<2>, DashPattern::dotted},
    {formula("L"), momentum_colour, DashPattern::solid},
};
// Components along the principal axes, which change in the body, and the length, which is
// conserved.
PlotValues momentum_values(const StageContext& stage, const FrameInput& instant) {
    const Eigen::Vector3d momentum = momentum_principal(inertia_of(stage), instant);
    return {momentum[0], momentum[1], momentum[2], norm_of(momentum)};
}

constexpr PlotCurve kinetic_curves[] = {{formula("T"), energy_colour, DashPattern::solid}};
PlotValues kinetic_values(const StageContext& stage, const FrameInput& instant) {
    return {kinetic_energy_J(inertia_of(stage), instant)};
}
constexpr PlotCurve length_curves[] = {{formula("L"), momentum_colour, DashPattern::solid}};
PlotValues length_values(const StageContext& stage, const FrameInput& instant) {
    return {norm_of(momentum_body(inertia_of(stage), instant))};
}
constexpr PlotCurve invariant_curves[] = {
    {formula("T"), energy_colour, DashPattern::solid},
    {formula("L"), momentum_colour, DashPattern::dashed},
};
// T and |L|, which a free motion conserves.
PlotValues invariant_values(const StageContext& stage, const FrameInput& instant) {
    return {kinetic_values(stage, instant)[0], length_values(stage, instant)[0]};
}

constexpr PlotCurve tilt_curves[] = {
    {formula("\\mathbf{e}_1"), axis_colour<0>, DashPattern::solid},
    {formula("\\mathbf{e}_2"), axis_colour<1>, DashPattern::dashed},
    {formula("\\mathbf{e}_3"), axis_colour<2>, DashPattern::dotted},
};
// Angles of the principal axes from L, accurate also near 0 and π.
PlotValues tilt_values(const StageContext& stage, const FrameInput& instant) {
    const PlotValues L = momentum_values(stage, instant);
    const auto angle = [&L](std::size_t i) {
        return std::atan2(std::hypot(L[(i + 1) % 3], L[(i + 2) % 3]), L[i]);
    };
    return {angle(0), angle(1), angle(2)};
}

constexpr PlotCurve conserved_curves[] = {
    {formula("p_\\varphi"), angle_colour<1>, DashPattern::solid},
    {formula("p_\\psi"), angle_colour<2>, DashPattern::dashed},
    {formula("E"), energy_colour, DashPattern::dotted},
    {formula("V"), potential_colour, DashPattern::solid},
};
// p_φ = A φ̇ sin²θ + p_ψ cos θ is the vertical component of L, p_ψ = C ω₃ the component along the
// top's axis; both, and E = T + V with V = Mgl cos θ, are computed from the state at the instant.
// Source: Landau & Lifshitz §35, problem 1.
PlotValues conserved_values(const StageContext& stage, const FrameInput& instant) {
    const auto& gravity = std::get<Gravity>(stage.motion.motion().problem().torque);
    const Eigen::Vector3d momentum = momentum_body(inertia_of(stage), instant);
    const double along_axis = momentum.dot(gravity.arm_body);
    const double along_vertical = (instant.state.space_from_body * momentum).z();
    const PlotValues energy = energy_values(stage, instant);
    return {along_vertical, along_axis, energy[2], energy[1]};
}

constexpr PlotCurve turn_curves[] = {
    {wobble_label, space_cone_colour, DashPattern::solid},
    {spin_label, body_cone_colour, DashPattern::dashed},
};
// Turns since t = 0, seen along L: of the axis of symmetry, φ = L t/I₁, and of marks on the body
// about it, φ + ψ with ψ = −Ω t; φ − ψ if the axis points downwards. Source: Landau & Lifshitz §35.
PlotValues turn_values(const StageContext& stage, const FrameInput& instant) {
    const MotionProblem& problem = stage.motion.motion().problem();
    const RollingCones& cones = *stage.rolling->cones;
    const double spin_rad_s = problem.inertia.body_from_principal()
                                  .col(cones.symmetry_axis)
                                  .dot(problem.start.omega_body);
    const double turns = instant.time_s / (2.0 * std::numbers::pi);
    const double psi_dot = -std::copysign(1.0, spin_rad_s) * cones.body_precession_rad_s;
    return {cones.space_precession_rad_s * turns, (cones.space_precession_rad_s + psi_dot) * turns};
}

constexpr PlotCurve residual_curves[] = {
    {formula("\\Delta T"), energy_colour, DashPattern::solid},
    {formula("\\Delta\\mathbf{L}"), momentum_colour, DashPattern::dashed},
    {gap_label, contact_colour, DashPattern::dotted},
    {slip_label, omega_colour, DashPattern::solid},
    {formula("|q|-1"), plane_colour, DashPattern::dashed},
};
// Values below 10^-14 are rounding noise that depends on the last bit: they are drawn on the axis's
// lowest line. The exact motion's residuals reach 2e-15.
constexpr double rounding_decade = -14.0;
PlotValues residual_values(const StageContext& stage, const FrameInput& instant) {
    const RollingResiduals r = stage.rolling->construction.residuals(instant.state);
    const auto decade = [](double x) { return std::max(std::log10(x), rounding_decade); };
    return {decade(r.energy), decade(r.momentum),
            decade(std::max(r.contact_plane_gap, r.tangency_gap)), decade(r.slip),
            decade(r.unit_quaternion)};
}

// The angle between L in space and L at the start: like T and |L| alone, a constant of the free
// motion on whose axis the drift of a measured motion is visible.
constexpr PlotCurve momentum_tilt_curves[] = {
    {formula("\\mathbf{L}"), momentum_colour, DashPattern::solid}};
PlotValues momentum_tilt_values(const StageContext& stage, const FrameInput& instant) {
    const Eigen::Vector3d momentum =
        instant.state.space_from_body * momentum_body(inertia_of(stage), instant);
    const Eigen::Vector3d& normal = stage.rolling->construction.normal_space();
    return {std::atan2(momentum.cross(normal).norm(), momentum.dot(normal))};
}
bool has_measured_momentum(const StageContext& stage) {
    return has_measured(stage) && stage.scene.measured.motion.has_attitude && keeps_momentum(stage);
}

// ω across the axis of symmetry, relative to its constant length A: it shows the wobble of a body
// whatever its tilt. `i`, `j`: the two axes with equal moments.
template <int i, int j>
constexpr PlotCurve wobble_curves[] = {
    {formula(i == 0 ? "\\omega_1" : "\\omega_2"), axis_colour<i>, DashPattern::solid},
    {formula(j == 1 ? "\\omega_2" : "\\omega_3"), axis_colour<j>, DashPattern::dashed},
};
template <int i, int j>
PlotValues wobble_values(const StageContext& stage, const FrameInput& instant) {
    const PlotValues omega = omega_values(stage, instant);
    const double amplitude = std::max(std::hypot(omega[i], omega[j]), 1e-300);
    return {omega[i] / amplitude, omega[j] / amplitude};
}

constexpr PlotQuantity quantity_rows[] = {
    {.name = "omega",
     .summary = "ω1, ω2, ω3 along the principal axes",
     .title = formula("$\\omega_i$"),
     .unit = "rad/s",
     .from_zero = true,
     .needs = omega_alone,
     .possible = any_motion,
     .curves = omega_curves,
     .values = omega_values},
    {.name = "euler_angles",
     .summary = "θ, φ, ψ of a heavy top",
     .title = no_words,
     .unit = "rad",
     .stacked = true,
     .needs = euler_angles,
     .possible = is_heavy_top,
     .requirement = needs_heavy_top,
     .curves = euler_curves,
     .values = euler_values,
     .of_measured = false},
    {.name = "energy",
     .summary = "kinetic energy T; under gravity also the potential energy V and the sum E",
     .title = energy_title,
     .unit = "J",
     .from_zero = true,
     .needs = attitude_too,
     .possible = any_motion,
     .curves = energy_curves,
     .values = energy_values},
    {.name = "momentum",
     .summary = "L1, L2, L3 along the principal axes, and L",
     .title = formula("$L_i$, $L$"),
     .unit = "kg m²/s",
     .from_zero = true,
     .needs = omega_alone,
     .possible = any_motion,
     .curves = momentum_curves,
     .values = momentum_values},
    {.name = "invariants",
     .summary = "T and L, which are constant without torque",
     .title = formula("$T$ / J;  $L$"),
     .unit = "kg m²/s",
     .from_zero = true,
     .needs = omega_alone,
     .possible = any_motion,
     .curves = invariant_curves,
     .values = invariant_values},
    {.name = "tilt",
     .summary = "angles of the principal axes e1, e2, e3 from L",
     .title = angle_title,
     .unit = "rad",
     .from_zero = true,
     .needs = omega_alone,
     .possible = keeps_momentum,
     .requirement = needs_turning,
     .curves = tilt_curves,
     .values = tilt_values},
    {.name = "conserved",
     .summary = "p_φ, p_ψ and E of a heavy top, which are constant, and V, which varies",
     .title = formula("$p_\\varphi$, $p_\\psi$ / (kg m²/s);  $E$, $V$"),
     .unit = "J",
     .from_zero = true,
     .needs = attitude_too,
     .possible = is_heavy_top,
     .requirement = needs_heavy_top,
     .curves = conserved_curves,
     .values = conserved_values},
    {.name = "turns",
     .summary =
         "turns of a symmetric body's axis about L (wobble) and of a mark on the body (spin)",
     .title = turns_title,
     .from_zero = true,
     .needs = omega_alone,
     .possible = rolls_with_cones,
     .requirement = "a torque-free body with exactly two equal moments",
     .curves = turn_curves,
     .values = turn_values,
     .of_measured = false},
    {.name = "wobble",
     .summary = "ω across the axis of a symmetric body, relative to its length A",
     .title = formula("$\\omega_i/A$"),
     .from_zero = true,
     .needs = omega_alone,
     .possible = rolls_with_cones,
     .requirement = "a torque-free body with exactly two equal moments",
     .curves = wobble_curves<0, 1>,
     .values = wobble_values<0, 1>,
     .of_measured = false},
    {.name = "residuals",
     .summary = "relative errors of T, L, the contact point and the attitude",
     .title = residual_title,
     .decades = true,
     .needs = attitude_too,
     .possible = rolls,
     .requirement = needs_free_turning,
     .curves = residual_curves,
     .values = residual_values,
     .of_measured = false},
    {.name = "measured_energy",
     .summary = "T of the measured motion in [measured] beside the exact one",
     .title = energy_title,
     .unit = "J",
     .needs = omega_alone,
     .possible = has_measured,
     .requirement = needs_measured,
     .curves = kinetic_curves,
     .values = kinetic_values},
    {.name = "measured_momentum",
     .summary = "L of the measured motion in [measured] beside the exact one",
     .title = formula("$L$"),
     .unit = "kg m²/s",
     .needs = omega_alone,
     .possible = has_measured,
     .requirement = needs_measured,
     .curves = length_curves,
     .values = length_values},
    {.name = "measured_tilt",
     .summary = "angle of the measured L from the exact one, in space; needs measured attitudes",
     .title = momentum_tilt_title,
     .unit = "rad",
     .from_zero = true,
     .needs = attitude_too,
     .possible = has_measured_momentum,
     .requirement =
         "a measured motion with attitudes, in [measured], of a body that turns without torque",
     .curves = momentum_tilt_curves,
     .values = momentum_tilt_values},
};

// Without a potential E is T, so that the curve of T is enough.
const PlotQuantity& without_potential(const PlotQuantity& energy) {
    static const PlotQuantity kinetic = [&energy] {
        PlotQuantity alone = energy;
        alone.curves = energy.curves.first(1);
        return alone;
    }();
    return kinetic;
}

// φ and ψ of a vertical axis have a meaning only in their sum or difference.
template <int sign>
const PlotQuantity& of_vertical_axis(const PlotQuantity& euler) {
    static const PlotQuantity one_angle = [&euler] {
        PlotQuantity vertical = euler;
        vertical.curves = vertical_curves<sign>;
        vertical.values = vertical_values<sign>;
        return vertical;
    }();
    return one_angle;
}

// The two axes across which a body wobbles depend on its axis of symmetry.
template <int i, int j>
const PlotQuantity& wobble_across(const PlotQuantity& wobble) {
    static const PlotQuantity across = [&wobble] {
        PlotQuantity other = wobble;
        other.curves = wobble_curves<i, j>;
        other.values = wobble_values<i, j>;
        return other;
    }();
    return across;
}

}  // namespace

std::span<const PlotQuantity> plot_quantities() { return quantity_rows; }

ShownUnit unit_of(const StageContext& stage, const PlotQuantity& quantity) {
    const bool one_unit =
        !quantity.unit.empty() && quantity.title[0].find(" / ") == std::string_view::npos;
    if (!one_unit) return {std::string(quantity.unit), 1.0};
    return unit_shown(stage.scene.units, quantity.unit);
}

PlotValues shown_values(const StageContext& stage, const PlotQuantity& quantity,
                        const FrameInput& instant) {
    PlotValues values = quantity.values(stage, instant);
    const double per_SI = unit_of(stage, quantity).per_SI;
    if (per_SI != 1.0)
        for (double& value : values) value *= per_SI;
    return values;
}

const PlotQuantity& plot_quantity_of(const StageContext& stage, std::string_view name) {
    if (name.empty()) name = is_heavy_top(stage) ? "euler_angles" : "omega";
    const PlotQuantity* row = find_row(quantity_rows, name);
    if (row == nullptr) throw InputError(unknown("quantity", name, names_of(quantity_rows)));
    if (!row->possible(stage)) {
        throw InputError(fmt::format("a plot of \"{}\" needs {}; choose another quantity",
                                     row->name, row->requirement));
    }
    if (const int vertical = vertical_axis(stage); vertical != 0 && row->values == euler_values)
        return vertical > 0 ? of_vertical_axis<1>(*row) : of_vertical_axis<-1>(*row);
    if (row->values == wobble_values<0, 1>) {
        const int axis = stage.rolling->cones->symmetry_axis;
        if (axis != 2) return axis == 0 ? wobble_across<1, 2>(*row) : wobble_across<0, 2>(*row);
    }
    const bool falls = has_weight(stage.motion.motion().problem().torque);
    return row->values == energy_values && !falls ? without_potential(*row) : *row;
}

}  // namespace poinsot
