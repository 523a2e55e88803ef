// Scenes with [style], and the objects of one colour in their views.
#pragma once

#include <Eigen/Core>
#include <string>

#include "scenes_by_hand.h"

namespace poinsot::style_tests {

inline const Eigen::Vector3d moments{1.0, 2.0, 2.9};
inline const Eigen::Vector3d omega{1.4, 0.5, 1.6};

inline Scene a_scene(const std::string& panel = "space") {
    return free_scene(moments, omega, panel);
}

// Only the view is returned: the stage's geometry, such as points of curves, is destroyed.
inline View view_of(const Scene& scene, double time_s = 0.0) {
    const StagedScene staged(scene, 10.0);
    return staged.stage.at(time_s).views.at(0);
}

inline LookSpec look(double r, double g, double b) {
    LookSpec spec;
    spec.srgb = {r, g, b};
    return spec;
}

inline const Arrow* arrow_in(const View& view, const Colour& colour) {
    for (const Arrow& arrow : view.arrows)
        if (arrow.colour == colour) return &arrow;
    return nullptr;
}
inline const Curve* curve_in(const View& view, const Colour& colour) {
    for (const Curve& curve : view.curves)
        if (curve.colour == colour) return &curve;
    return nullptr;
}

}  // namespace poinsot::style_tests
