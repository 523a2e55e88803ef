// Scenes for the tests of the drawing layer, made without a file.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "drawing/stage/panel.h"
#include "drawing/stage/stage.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"
#include "mechanics/motion.h"
#include "mechanics/top/heavy_top.h"
#include "scene/scene.h"
#include "shapes/views.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

struct NamedScene {
    std::string name;
    Scene scene;
};

inline Scene free_scene(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega,
                        const std::string& panel) {
    Scene scene;
    scene.names.emplace();        // none: thing_names_test.cpp tests them
    scene.crossings = "through";  // whole curves: line_style_test.cpp cuts them
    scene.body.inertia = InertiaTensor::from_principal_moments(moments, Physicality::waived);
    scene.start.omega_rad_s = omega;
    scene.film.duration_s = 10.0;
    scene.film.width_px = 640;
    scene.film.height_px = 360;
    PanelSpec spec;
    spec.kind = panel;
    scene.panels = {spec};
    return scene;
}

inline Scene top_scene(const TopStart& top, const std::string& panel, double mgl_N_m = 1.0) {
    Scene scene = free_scene({1.0, 1.0, 0.5}, {0.0, 0.0, 0.0}, panel);
    const RotationState start = start_of({1.0, 0.5, mgl_N_m, top.theta_rad, top.theta_dot_rad_s,
                                          top.phi_dot_rad_s, top.omega3_rad_s});
    scene.start.omega_rad_s = start.omega_body;
    scene.start.space_from_body = start.space_from_body;
    scene.start.top = top;
    scene.torque = Gravity{mgl_N_m, {0.0, 0.0, 1.0}};
    return scene;
}

// Gives the scene a measured motion: its own, with ω multiplied by a factor.
inline void measure(Scene& scene, double last_time_s, int n_rows, double factor = 1.0,
                    bool with_attitude = true) {
    const Motion motion(problem_of(scene));
    MeasuredMotion& measured = scene.measured.motion;
    scene.measured.file = "gyro.csv";
    measured.has_omega = true;
    measured.has_attitude = with_attitude;
    for (int i = 0; i < n_rows; ++i) {
        const double time_s = last_time_s * i / (n_rows - 1);
        const RotationState state = motion.at(time_s);
        measured.rows.push_back(
            {time_s, factor * state.omega_body,
             with_attitude ? state.space_from_body : Eigen::Quaterniond::Identity()});
    }
}

// A stage with the motion that it refers to.
struct StagedScene {
    Scene scene;
    Motion motion;
    Stage stage;

    // `is_still`: only the last instant is drawn, as a picture of its own.
    StagedScene(const Scene& scene_, double last_time_s, double line_scale = 0.0,
                bool is_still = false)
        : scene(scene_),
          motion(problem_of(scene)),
          stage(scene, theme_of(scene), motion,
                {.width_px = scene.film.width_px,
                 .height_px = scene.film.height_px,
                 .line_scale = line_scale,
                 .first_time_s = scene.film.start_s,
                 .last_time_s = last_time_s,
                 .first_shown_s = is_still ? std::optional(last_time_s) : std::nullopt,
                 .is_still = is_still,
                 .fonts = installed_fonts()}) {}
};

}  // namespace poinsot
