// One view made ready for drawing: its projection, and its solids as lines of sight meet them.
#pragma once

#include <string>
#include <vector>

#include "render/passes/constants.h"
#include "render/pixel_area.h"
#include "render/quadric.h"
#include "render/shadow_web.h"
#include "shapes/views.h"

namespace poinsot {

// Most solids of a view that hide other things; more are drawn, but hide nothing.
constexpr int max_quadrics = 8;
constexpr int max_flats = 4;

// The numbers of solids that a program's loops run over.
struct Solids {
    int n_quadrics = 0, n_flats = 0, n_meshes = 0;
    bool operator==(const Solids&) const = default;
    int n_constants() const { return 7 * n_quadrics + 3 * n_flats + 2 * n_meshes; }
    std::vector<std::string> defines() const;
};

// Where the meshes of the view were drawn beforehand, and what their depth buffer holds: offset +
// slope/depth (orthographic: offset + slope·depth). Empty if there are none.
struct MeshLayer {
    int left = 0, top = 0, width = 0, height = 0;
    double depth_offset = 0.0, depth_slope = 0.0;
    double opacity = 1.0;
};

struct ViewScene {
    const Drawing* drawing = nullptr;
    const View* view = nullptr;
    Projection projection;
    std::vector<Quadric> quadrics;    // one for each ellipsoid of the view
    std::vector<PlaneMap> maps;       // one for each plane
    std::vector<bool> before_solids;  // whether the plane lies between the eye and the ellipsoids
    std::vector<Quadric> casters;     // what casts shadows on the planes
    std::vector<ShadowWeb> shadows;   // the shadows
    MeshLayer mesh_layer;

    void prepare(const Drawing& whole, const View& shown);
    // Of the solids that hide others.
    Solids solids() const;
    int n_quadrics() const;
    // Towards the middle of the sky: above the plane that the body stands on, or at the top of the
    // picture. Unit.
    Eigen::Vector3d up() const;

    // Constants as shaders/view.glsl (5), quadric.glsl (7) and occlusion.glsl count them, and two
    // for the light: towards it, and its strength, first the key light, then the sky. corner_px: of
    // what is drawn into, in the picture.
    void add_view(Constants& constants,
                  const Eigen::Vector2d& corner_px = Eigen::Vector2d::Zero()) const;
    void add_light(Constants& constants) const;
    void add_quadric(Constants& constants, std::size_t ellipsoid) const;
    void add_solids(Constants& constants) const;
};

Eigen::Vector3d across_of(const Plane& plane);

}  // namespace poinsot
