// Objects with surfaces: ellipsoids, planes, cones and meshes.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "shapes/colour.h"
#include "shapes/shape_name.h"

namespace poinsot {

// Ray-cast ellipsoid: x = centre + half_axes·u with |u| = 1. Columns of half_axes are orthogonal
// vectors. Its body-fixed lines are the three principal sections, and meridians and parallels about
// the axis of column 2.
struct Ellipsoid {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d half_axes = Eigen::Matrix3d::Identity();
    Colour colour{0.85, 0.62, 0.33};
    double opacity = 0.75;  // of the front surface seen face on; higher towards the limb
    double presence = 1.0;  // 0…1, for fading in and out; includes lines and shadow
    // Whether the far parts of the curves on it are drawn as hidden in full, however transparent
    // it is.
    bool hides_far_curves = false;
    Colour line_colour{0.35, 0.22, 0.08};
    double section_px = 1.6;  // principal sections (0: none)
    double ruling_px = 0.8;   // meridians and parallels (0: none)
    double ruling_opacity = 0.35;
    int n_meridians = 12;
    int n_parallels = 5;  // between the poles
    // A line along the inner side of the limb, which keeps the outline visible before a ground of
    // the same tone (0: none).
    double contour_px = 0.0;
    Colour contour_colour{0.35, 0.22, 0.08};
    bool casts_shadow = true;  // contact shadow on the planes below it
    ShapeName name{};
};

// A disc with a grid of lines through its centre; it fades towards its rim.
struct Plane {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit
    Eigen::Vector3d along =
        Eigen::Vector3d::UnitX();  // unit, in the plane: direction of one set of lines
    double radius = 3.0;
    double fade_from = 0.55;  // fraction of the radius at which fading begins
    double grid_spacing = 0.25;
    double grid_px = 1.0;
    Colour colour{0.80, 0.85, 0.92};
    Colour grid_colour{0.45, 0.52, 0.62};
    double opacity = 0.9;
    ShapeName name{};
    bool operator==(const Plane&) const = default;
};

// Open circular cone, drawn translucent with its rim.
struct Cone {
    Eigen::Vector3d apex = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit, from the apex into the cone
    double half_angle_rad = 0.5;                      // 0…π/2
    double length = 1.0;                              // along the axis
    Colour colour{0.4, 0.6, 0.8};
    double opacity = 0.35;
    double presence = 1.0;  // as for an ellipsoid
    double rim_px = 1.5;
    int n_rulings = 12;      // generators, which make rolling visible
    double phase_rad = 0.0;  // of ruling 0, from `reference`
    Eigen::Vector3d reference = Eigen::Vector3d::UnitX();
    ShapeName name{};
};

// A picture on a surface instead of a colour: rows of sRGB-encoded R, G, B, top row first. Texture
// coordinates run from (0, 0), the outer corner of the first pixel, to (1, 1).
struct SurfacePicture {
    int width_px = 0, height_px = 0;
    std::vector<std::uint8_t> rgb;
};

// Triangles with one normal per corner, owned by the stage as CurveGeometry is.
struct MeshGeometry {
    std::uint64_t id = 0;
    std::vector<Eigen::Vector3f> positions;  // three per triangle
    std::vector<Eigen::Vector3f> normals;    // one per position
    std::vector<Eigen::Vector2f> places{};   // texture coordinates, one per position if the surface
                                             // has a picture; else empty
    SurfacePicture picture{};
};

struct Mesh {
    const MeshGeometry* geometry = nullptr;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    Colour colour{0.6, 0.65, 0.72};
    double opacity = 1.0;
    bool casts_shadow = true;
    ShapeName name{};
};

// The solids of a view. for_each passes each list to a function.
struct SolidLists {
    std::vector<Plane> planes;
    std::vector<Ellipsoid> ellipsoids;
    std::vector<Cone> cones;
    std::vector<Mesh> meshes;
};
template <typename Function>
void for_each(SolidLists& lists, const Function& function) {
    function(lists.planes);
    function(lists.ellipsoids);
    function(lists.cones);
    function(lists.meshes);
}

}  // namespace poinsot
