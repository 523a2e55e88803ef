// [start]: angular velocity and attitude at t = 0, or a top's Euler angles and rates.
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <vector>

#include "mechanics/top/heavy_top.h"
#include "scene/draft_checks.h"

namespace poinsot {

namespace {

const std::vector<std::string> top_keys{"start.theta_rad", "start.theta_dot_rad_s",
                                        "start.phi_dot_rad_s", "start.omega3_rad_s"};

// The attitude that a rotation matrix describes, corrected for rounding.
Eigen::Vector4d attitude_of_matrix(Scene& scene, const Eigen::Matrix3d& matrix) {
    const std::string key = "start.attitude_matrix";
    const double largest = matrix.cwiseAbs().maxCoeff();
    const double residual =
        largest > 2.0
            ? largest
            : (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (residual > 1e-6) {
        refuse(scene, key,
               fmt::format("{} is not a rotation: its columns are not unit vectors at right "
                           "angles (off by {:.2g}); give an orthogonal matrix",
                           key, residual));
    }
    if (matrix.determinant() < 0.0) {
        refuse(scene, key,
               fmt::format("{} is a reflection (determinant -1), not a rotation; change the sign "
                           "of one column",
                           key));
    }
    if (residual > 1e-12) {
        scene.notes.push_back(fmt::format(
            "{} deviates from orthogonal by {:.2g}; a rotation near it is used", key, residual));
    }
    const Eigen::Quaterniond q = Eigen::Quaterniond(matrix).normalized();
    return {q.w(), q.x(), q.y(), q.z()};
}

// A top's start in body axes: R = Rx(θ), and ω from the rates at φ = ψ = 0.
void complete_top(SceneDraft& draft) {
    Scene& scene = draft.scene;
    if (!draft.has("start.theta_rad")) {
        const auto given = std::find_if(top_keys.begin(), top_keys.end(),
                                        [&](const std::string& key) { return draft.has(key); });
        refuse(scene, *given,
               fmt::format("{} is given but start.theta_rad is not; give the tilt at t = 0, as in "
                           "theta_rad = 0.7",
                           *given));
    }
    const TopStart& top = draft.top;
    scene.start.top = top;
    HeavyTopProblem problem;
    problem.theta_rad = top.theta_rad;
    problem.theta_dot_rad_s = top.theta_dot_rad_s;
    problem.phi_dot_rad_s = top.phi_dot_rad_s;
    problem.omega3_rad_s = top.omega3_rad_s;
    const RotationState state = start_of(problem);
    scene.start.space_from_body = state.space_from_body;
    scene.start.omega_rad_s = state.omega_body;
}

const std::vector<std::string> conserved_keys{"start.energy_J", "start.momentum_kg_m2_s",
                                              "start.plane_distance"};

// ω from T, and L or the plane's distance.
void complete_conserved(SceneDraft& draft) {
    Scene& scene = draft.scene;
    if (!draft.energy_J) {
        const std::string& given = draft.momentum_kg_m2_s ? conserved_keys[1] : conserved_keys[2];
        refuse(scene, given,
               fmt::format("{} is given but start.energy_J is not; give the kinetic energy, as in "
                           "energy_J = 2.0",
                           given));
    }
    if (!draft.momentum_kg_m2_s && !draft.plane_distance)
        refuse(scene, "start.energy_J",
               "start.energy_J needs start.momentum_kg_m2_s or start.plane_distance beside it: T "
               "alone does not choose a polhode");
    const std::array<std::vector<std::string>, 2> ways{{{conserved_keys[1]}, {conserved_keys[2]}}};
    refuse_mixed(scene, ways, "with energy_J give one of them");

    ConservedStartSpec conserved;
    conserved.quantities = {*draft.energy_J, draft.momentum_kg_m2_s, draft.plane_distance};
    if (draft.has("start.omega_rad_s")) {
        conserved.direction_rad_s = scene.start.omega_rad_s;
        if (scene.start.omega_rad_s.isZero(0.0))
            refuse(scene, "start.omega_rad_s",
                   "start.omega_rad_s is zero; with energy_J it says in which direction ω starts: "
                   "give a direction, or leave it out");
    }
    const std::string& key = draft.momentum_kg_m2_s ? conserved_keys[1] : conserved_keys[2];
    conserved.start = at_scene_key(scene, key, [&] {
        return start_on_polhode(scene.body.inertia, conserved.quantities,
                                conserved.direction_rad_s);
    });
    scene.start.omega_rad_s = conserved.start.omega_body;
    scene.start.conserved = conserved;
}

}  // namespace

void complete_start(SceneDraft& draft) {
    Scene& scene = draft.scene;
    const std::array<std::vector<std::string>, 2> ways_of_start{{{"start.omega_rad_s"}, top_keys}};
    refuse_mixed(scene, ways_of_start,
                 "give omega_rad_s, or the Euler angles and rates of a top, not both");
    const std::array<std::vector<std::string>, 2> conserved_or_top{{conserved_keys, top_keys}};
    refuse_mixed(scene, conserved_or_top,
                 "give T and L, or the Euler angles and rates of a top, not both");
    const std::array<std::vector<std::string>, 3> ways_of_attitude{
        {{"start.attitude"}, {"start.attitude_matrix"}, top_keys}};
    refuse_mixed(scene, ways_of_attitude, "give the attitude in one way only");

    const bool top = std::any_of(top_keys.begin(), top_keys.end(),
                                 [&](const std::string& key) { return draft.has(key); });
    if (top) return complete_top(draft);
    const bool conserved = std::any_of(conserved_keys.begin(), conserved_keys.end(),
                                       [&](const std::string& key) { return draft.has(key); });
    if (conserved) {
        complete_conserved(draft);
    } else if (!draft.has("start.omega_rad_s")) {
        refuse(scene, "start",
               "start.omega_rad_s is missing; under [start] give the angular velocity at t = 0 in "
               "body axes, as in omega_rad_s = [0.01, 2.0, 0.01]");
    }
    Eigen::Vector4d attitude(1.0, 0.0, 0.0, 0.0);
    if (draft.attitude) attitude = unit(scene, "start.attitude", *draft.attitude);
    if (draft.attitude_matrix) attitude = attitude_of_matrix(scene, *draft.attitude_matrix);
    // q and −q are the same attitude; the one with w ≥ 0 is used.
    if (attitude[0] < 0.0) attitude = -attitude;
    scene.start.space_from_body =
        Eigen::Quaterniond(attitude[0], attitude[1], attitude[2], attitude[3]);
}

}  // namespace poinsot
