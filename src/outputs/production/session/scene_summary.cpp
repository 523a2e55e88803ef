#include "production/session/scene_summary.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "construction/montgomery_phase.h"
#include "construction/poinsot_construction.h"
#include "construction/polhode.h"
#include "drawing/stage/stage.h"
#include "mechanics/free/free_rotation.h"
#include "mechanics/motion_errors.h"
#include "mechanics/regime_sentence.h"
#include "mechanics/top/heavy_top.h"
#include "numerics/power_of_two.h"
#include "production/session/measured_summary.h"
#include "production/session/motion_hints.h"
#include "production/session/picture_setting.h"
#include "scene/film_clock.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

void add_number(std::vector<SummaryLine>& lines, std::string key, std::string label, double value,
                std::string_view unit) {
    lines.push_back({std::move(key), json_number(value), std::move(label),
                     fmt::format("{:.9g} {}", value, unit)});
}

// Adds the lines of a torque-free motion and its construction.
void add_free_motion(const Session& session, std::vector<SummaryLine>& lines) {
    const MotionProblem& problem = session.motion.problem();
    const FreeRotationConstants constants = session.motion.free_constants();
    lines.push_back({"regime", json_string(name_of(session.motion.regime())), "regime",
                     motion_in_words(session.motion)});
    add_number(lines, "kinetic_energy_J", "T", constants.kinetic_energy_J, "J");
    add_number(lines, "momentum_kg_m2_s", "L", constants.momentum_kg_m2_s, "kg m²/s");
    if (session.motion.regime() == Regime::at_rest) return;

    const PoinsotConstruction construction(problem.inertia, problem.start);
    add_number(lines, "plane_distance", "plane at √(2T)/L", construction.plane_distance(),
               "1/√(kg m²)");
    const Eigen::Vector3d half_axes = construction.half_axes();
    lines.push_back({"half_axes", json_numbers(half_axes[0], half_axes[1], half_axes[2]),
                     "half-axes 1/√I",
                     fmt::format("{:.6g}, {:.6g}, {:.6g} 1/√(kg m²)", half_axes[0], half_axes[1],
                                 half_axes[2])});
    if (constants.polhode_period_s) {
        add_number(lines, "polhode_period_s", "period of the polhode", *constants.polhode_period_s,
                   "s");
    } else if (session.motion.regime() == Regime::separatrix) {
        lines.push_back({"polhode_period_s", "null", "period of the polhode", "infinite"});
    }
    if (constants.advance_per_period_rad) {
        const double turns = *constants.advance_per_period_rad / (2.0 * std::numbers::pi);
        lines.push_back({"herpolhode_advance_rad", json_number(*constants.advance_per_period_rad),
                         "herpolhode advances",
                         fmt::format("{:.9g} rad ({:.6g} turns) a period",
                                     *constants.advance_per_period_rad, turns)});
    }
    if (const auto phase = montgomery_phase(problem)) {
        const auto degrees = [](double rad) { return rad * 180.0 / std::numbers::pi; };
        lines.push_back(
            {"montgomery_phase_rad",
             json_numbers(phase->turned_rad, phase->dynamic_rad, phase->solid_angle_rad),
             "Montgomery's phase",
             fmt::format("in a polhode period the body turns about L by {:.6g}° = 2TP/L ({:.6g}°) "
                         "− S, where S = {:.6g}° is the solid angle that L encloses in the body",
                         degrees(phase->turned_rad), degrees(phase->dynamic_rad),
                         degrees(phase->solid_angle_rad))});
    }
    const Polhode::Annulus annulus =
        Polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix).annulus();
    lines.push_back({"herpolhode_radii", json_numbers(annulus.inner, annulus.outer),
                     "herpolhode's radii",
                     fmt::format("{:.9g} … {:.9g} 1/√(kg m²)", annulus.inner, annulus.outer)});
    if (const auto cones = rolling_cones(problem.inertia, problem.start.omega_body)) {
        add_number(lines, "body_precession_rad_s", "ω precesses in the body at Ω = (I₃−I₁)ω₃/I₁",
                   cones->body_precession_rad_s, "rad/s");
        add_number(lines, "space_precession_rad_s", "the axis precesses about L at L/I₁",
                   cones->space_precession_rad_s, "rad/s");
        lines.push_back({"cones_half_angles_rad",
                         json_numbers(cones->body_half_angle_rad, cones->space_half_angle_rad),
                         "half-angles of the cones",
                         fmt::format("body {:.4f}°, space {:.4f}°",
                                     cones->body_half_angle_rad * 180.0 / std::numbers::pi,
                                     cones->space_half_angle_rad * 180.0 / std::numbers::pi)});
    }
}

// Adds a heavy top's conserved momenta and energy, and the limits and rates of its nutation.
void add_heavy_top(const HeavyTop& top, std::vector<SummaryLine>& lines) {
    lines.push_back({"top_regime", json_string(name_of(top.regime())), "kind of its motion",
                     regime_sentence(top)});
    const TopInvariants& kept = top.invariants();
    add_number(lines, "p_phi_kg_m2_s", "p_φ, along the vertical", kept.p_phi_kg_m2_s, "kg m²/s");
    add_number(lines, "p_psi_kg_m2_s", "p_ψ = I₃ω₃, along the axis", kept.p_psi_kg_m2_s, "kg m²/s");
    add_number(lines, "energy_J", "E = T + Mgl cos θ", kept.energy_J, "J");
    const TopNutation& nutation = top.nutation();
    const double least = nutation.theta_min_rad, most = nutation.theta_max_rad;
    const bool nods = least < most;
    constexpr double deg = 180.0 / std::numbers::pi;
    lines.push_back({"theta_rad", json_numbers(least, most), nods ? "θ between" : "θ",
                     nods ? fmt::format("{:.9g} and {:.9g} rad ({:.4f}° and {:.4f}°)", least, most,
                                        deg * least, deg * most)
                          : fmt::format("{:.9g} rad ({:.4f}°)", least, deg * least)});
    if (std::isinf(nutation.period_s)) {
        lines.push_back({"nutation_period_s", "null", "period of the nutation", "infinite"});
    } else if (nutation.period_s > 0.0) {
        add_number(lines, "nutation_period_s",
                   nods ? "period of the nutation" : "period of a small nutation about it",
                   nutation.period_s, "s");
    }
    // φ is undefined while the axis is vertical.
    const bool is_vertical = top.regime() == TopRegime::sleeping ||
                             top.regime() == TopRegime::sleeping_unstable ||
                             top.regime() == TopRegime::hanging;
    if (!is_vertical)
        add_number(lines, "precession_rate_rad_s", "mean φ̇", nutation.precession_rate_rad_s,
                   "rad/s");
}

// Adds T and L at the start, since they vary under a torque.
void add_start(const MotionProblem& problem, std::vector<SummaryLine>& lines) {
    const Eigen::Vector3d& omega = problem.start.omega_body;
    const Eigen::Vector3d momentum = problem.inertia.matrix_body() * omega;
    add_number(lines, "start_kinetic_energy_J", "T at t = 0", 0.5 * omega.dot(momentum), "J");
    add_number(lines, "start_momentum_kg_m2_s", "L at t = 0", norm_of(momentum), "kg m²/s");
}

// Adds the requested accuracy in pixels as an angle, and the achieved accuracy.
void add_accuracy(const Session& session, const PictureBound& bound,
                  std::vector<SummaryLine>& lines) {
    const bool stepped = session.motion.integrated() != nullptr;
    lines.push_back({"accuracy_px", json_number(session.accuracy.asked_px), "accuracy requested",
                     fmt::format("{:g} px", session.accuracy.asked_px)});
    lines.push_back(
        {"motion_error_px", json_number(bound.motion_px), "accuracy of the motion",
         fmt::format("{:.2g} px ({})", bound.motion_px,
                     stepped ? "measured over the film" : "bound for rounding errors")});
    lines.push_back({"curve_error_px", json_number(bound.curves_px), "accuracy of the curves",
                     fmt::format("{:.2g} px, by subdivision", bound.curves_px)});
    lines.push_back({"bound_px", json_number(bound.total_px()), "largest error in the picture",
                     fmt::format("{:.2g} px", bound.total_px())});
    if (stepped) {
        const MethodChoice& method = session.motion.problem().method;
        if (method.step_s) add_number(lines, "step_s", "step", *method.step_s, "s");
        if (method.tolerance) add_number(lines, "tolerance", "tolerance", *method.tolerance, "");
    }
}

// Adds the differences of the second method's motion from the first one's.
void add_comparison(const Session& session, const FilmPlan& film, std::vector<SummaryLine>& lines) {
    if (!session.comparison) return;
    std::vector<double> times;
    for (std::int64_t frame = 0; frame < film.n_frames; ++frame) {
        times.push_back(film.time_of(frame));
    }
    const MotionErrors errors = worst_errors(*session.comparison, session.motion, times);
    const std::string& name = session.comparison->problem().method.name;
    const IntegratedRotation* stepped = session.comparison->integrated();
    lines.push_back({"beside", json_string(name), "comparison method",
                     stepped != nullptr && stepped->method().takes_step
                         ? fmt::format("{}, step {:g} s", name, stepped->step_s())
                         : name});
    add_number(lines, "beside_attitude_rad", "its largest attitude difference", errors.attitude_rad,
               "rad");
    lines.push_back({"beside_energy", json_number(errors.energy_relative), "its drift of T",
                     fmt::format("{:.3g} of T", errors.energy_relative)});
    lines.push_back({"beside_momentum", json_number(errors.momentum_relative), "its drift of L",
                     fmt::format("{:.3g} of L", errors.momentum_relative)});
}

// Adds the principal axes as the columns of a matrix, in words only where they are not the given
// ones.
void add_principal_axes(const InertiaTensor& inertia, std::vector<SummaryLine>& lines) {
    const Eigen::Matrix3d axes = inertia.body_from_principal().array() + 0.0;  // no negative zero
    std::vector<std::string> json;
    std::string words;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d e = axes.col(k);
        json.push_back(json_numbers(axes(k, 0), axes(k, 1), axes(k, 2)));
        words += fmt::format("e{} = ({:.6g}, {:.6g}, {:.6g}){}", k + 1, e[0], e[1], e[2],
                             k < 2 ? ", " : " in the given axes");
    }
    const bool as_given = axes == Eigen::Matrix3d::Identity();
    lines.push_back({"principal_axes", json_list(json), as_given ? "" : "principal axes", words});
}

// Adds the scene's data and the kind of motion.
void add_motion(const Session& session, std::vector<SummaryLine>& lines) {
    const MotionProblem& problem = session.motion.problem();
    lines.push_back(
        {"scene", json_string(session.scene.file.string()), "scene", session.scene.file.string()});
    lines.push_back({"title", json_string(session.scene.title), "title", session.scene.title});
    const Eigen::Vector3d& I = problem.inertia.moments_kg_m2();
    lines.push_back(
        {"moments_kg_m2", json_numbers(I[0], I[1], I[2]), "moments I₁, I₂, I₃",
         fmt::format("{:.9g}, {:.9g}, {:.9g} kg m²{}", I[0], I[1], I[2],
                     problem.inertia.planar() ? " (planar: one is the sum of the others)" : "")});
    add_principal_axes(problem.inertia, lines);
    lines.push_back({"method", json_string(problem.method.name), "method", problem.method.name});
    if (is_free(problem.torque)) {
        add_free_motion(session, lines);
    } else {
        lines.push_back({"regime", json_string(name_of(session.motion.regime())), "regime",
                         std::string(name_of(session.motion.regime()))});
        if (const auto top = session.motion.closed_form_of_top()) add_heavy_top(*top, lines);
        add_start(problem, lines);
    }
}

void add_film(const Session& session, const FilmPlan& film, std::vector<SummaryLine>& lines) {
    lines.push_back(
        {"n_frames", fmt::format("{}", film.n_frames), "film",
         fmt::format("{:.4g} s, {} frames of {}×{} at {:.6g}/s; motion from {:.6g} s to {:.6g} s",
                     film.length_s, film.n_frames, session.scene.film.width_px,
                     session.scene.film.height_px, film.rate.per_second(), film.start_s,
                     film.last_time_s())});
    lines.push_back({"film_s", json_number(film.length_s), "", ""});

    if (session.loop) {
        lines.push_back(
            {"loop_s", json_number(session.loop->repeat_s), "loop",
             fmt::format("{:.9g} s: {}", session.loop->repeat_s, session.loop->in_words)});
        lines.push_back({"loop_change", json_string(session.loop->change),
                         session.loop->change.empty() ? "" : "changed for the loop",
                         session.loop->change});
    }
}

void add_certificate(const Certificate& certificate, std::vector<SummaryLine>& lines) {
    lines.push_back({"certificate_holds", fmt::format("{}", certificate.holds()), "", ""});
    for (const CertifiedClaim& claim : certificate.claims)
        lines.push_back({fmt::format("worst_{}", claim.name),
                         claim.measured() ? json_number(claim.worst) : "null", "", ""});
}

}  // namespace

SceneSummary summarise(const Session& session, bool plan, const Task& task) {
    SceneSummary summary;
    std::vector<SummaryLine>& lines = summary.lines;
    const FilmPlan film = film_plan(session);
    add_motion(session, lines);
    if (can_certify(session)) {
        add_flips(session, film, lines);
        add_near_loops(session, lines);
    } else if (!is_free(session.motion.problem().torque) && !session.motion.heavy_top()) {
        add_stepped_motion(session, film, lines);
    }
    add_film(session, film, lines);
    // Making the stage checks that the scene can be drawn; it opens no context.
    const PictureSetting setting = setting_of(session.scene);
    const Stage stage = stage_of(
        session, {.first_time_s = film.start_s, .last_time_s = film.last_time_s()}, setting);
    tell_stage_notes(stage, task);
    add_accuracy(session, bound_of(session, stage, setting.samples), lines);
    add_comparison(session, film, lines);
    if (session.scene.measured.given())
        add_measured(session, film.start_s, film_end_time_s(session.scene), lines);
    if (can_certify(session)) {
        summary.certificate = certify_film(session, film, task);
        add_certificate(*summary.certificate, lines);
    }
    if (plan) summary.plan = plan_of(session, film, stage);
    return summary;
}

}  // namespace poinsot
