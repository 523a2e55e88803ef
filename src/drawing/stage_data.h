// What the elements draw from: the constants of the motion in the picture's axes, and geometry made
// once.
//
// Picture axes: the fixed centre is the origin, z is along L, and the ellipsoid's largest half-axis
// is 1.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "construction/herpolhode.h"
#include "construction/poinsot_construction.h"
#include "construction/polhode.h"
#include "drawing/drawing.h"
#include "drawing/labels.h"
#include "drawing/stage.h"
#include "drawing/theme.h"

namespace poinsot {

// One instant as the elements see it.
struct Instant {
    double time_s = 0.0;
    RotationState state;
    Eigen::Quaterniond picture_from_body = Eigen::Quaterniond::Identity();
    Eigen::Vector3d contact = Eigen::Vector3d::Zero();  // picture axes
};

// A view in the making: its shapes, and the labels that still look for their place.
struct Sheet {
    View view;
    std::vector<LabelWish> wishes;
};

// Adds an element's shapes of one instant to its view; owns nothing, refers to the stage's
// geometry.
using Drawer = std::function<void(const Instant&, Sheet&)>;

struct StageData {
    Scene scene;
    const Motion* motion = nullptr;
    StageOptions options;
    const Theme* theme = nullptr;
    double px = 1.0;  // pixels of the picture for one pixel at 1080 rows

    PoinsotConstruction construction;
    Polhode polhode;
    std::optional<RollingCones> cones;

    double picture_per_rho = 1.0;  // scale: largest half-axis → 1
    Eigen::Quaterniond picture_from_space = Eigen::Quaterniond::Identity();
    Eigen::Vector3d half_axes = Eigen::Vector3d::Ones();  // picture units
    double plane_distance = 1.0;                          // picture units
    double herpolhode_radius = 0.0;  // outer radius of the annulus, picture units
    Camera camera;
    double units_per_px = 0.001;  // at the centre of the picture

    // Geometry made once for all instants; addresses stay valid for the stage's life.
    TypeCase type_case;
    std::deque<CurveGeometry> curves;
    std::deque<MeshGeometry> meshes;
    std::vector<Drawer> drawers;  // one for each element shown, in the table's order

    const CurveGeometry* keep(CurveGeometry geometry);
    const MeshGeometry* keep(MeshGeometry geometry);

    StageData(const Scene& scene, const Motion& motion, const StageOptions& options);
};

}  // namespace poinsot
