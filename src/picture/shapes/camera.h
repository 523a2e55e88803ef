// Camera, light and background of a view.
#pragma once

#include <Eigen/Core>

#include "shapes/colour.h"

namespace poinsot {

// A camera. Orthographic views use height_units instead of the angle.
struct Camera {
    Eigen::Vector3d eye{3.0, -4.0, 2.0};
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    double vertical_field_rad = 0.6;  // full angle, top to bottom of the view
    bool orthographic = false;
    double height_units = 2.0;  // full height of the view, orthographic only
    bool operator==(const Camera&) const = default;
};

// One directional light, plus uniform sky light.
struct Light {
    Eigen::Vector3d towards{0.3, -0.6,
                            0.8};  // unit; from the scene towards the light, picture axes
    double key = 0.75;
    double sky = 0.35;
    bool operator==(const Light&) const = default;
};

// A vertical gradient behind a view; alpha 0 leaves the picture transparent.
struct Background {
    Colour top{0.93, 0.95, 0.98};
    Colour bottom{1.0, 1.0, 1.0};
    double alpha = 1.0;
    bool operator==(const Background&) const = default;
};

}  // namespace poinsot
