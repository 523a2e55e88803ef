// One view prepared for drawing: its projection, and its solids for intersections with lines of
// sight.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "render/passes/constants.h"
#include "render/pixel_area.h"
#include "render/quadric.h"
#include "render/shadow_web.h"
#include "shapes/views.h"

namespace poinsot {

// The largest numbers of solids that hide other objects; further solids are drawn, but hide
// nothing.
constexpr int max_quadrics = 8;
constexpr int max_flats = 4;

// The numbers of solids over which a program's loops run.
struct Solids {
    int n_quadrics = 0, n_flats = 0, n_meshes = 0;
    bool operator==(const Solids&) const = default;
    int n_constants() const { return 7 * n_quadrics + 3 * n_flats + 2 * n_meshes; }
    std::vector<std::string> defines() const;
};

// The position of the layer of meshes, and the depths between which they lie. Empty if there are no
// meshes.
struct MeshLayer {
    int left = 0, top = 0, width = 0, height = 0;
    double nearest = 0.0, farthest = 0.0;
    double opacity = 1.0;

    // From the camera's axes to OpenGL's clip space, with the rows of the picture downwards.
    // shift_px: where the middle of a pixel is displaced to.
    glm::dmat4 projection(const Projection& of_view,
                          const glm::dvec2& shift_px = glm::dvec2(0.0)) const;
};

struct ViewScene {
    const Drawing* drawing = nullptr;
    const View* view = nullptr;
    Projection projection;
    std::vector<Quadric> quadrics;    // one per ellipsoid of the view
    std::vector<PlaneMap> maps;       // one per plane
    std::vector<bool> before_solids;  // whether the plane lies between the eye and the ellipsoids
    std::vector<Quadric> casters;     // objects that cast shadows on the planes
    std::vector<ShadowWeb> shadows;   // the shadows
    MeshLayer mesh_layer;

    void prepare(const Drawing& whole, const View& shown);
    // The numbers of solids that hide others.
    Solids solids() const;
    int n_quadrics() const;
    // The unit vector to the middle of the sky: above the plane on which the body stands, or
    // towards the top of the picture.
    Eigen::Vector3d up() const;

    // From the view's axes to the camera's: right, up and backward.
    glm::dmat4 camera_from_view() const;

    // Adds constants as numbered in shaders/view.glsl (5), quadric.glsl (7) and occlusion.glsl, and
    // two for the light: the direction and strength of the key light, then of the sky.
    void add_view(Constants& constants) const;
    void add_light(Constants& constants) const;
    void add_quadric(Constants& constants, std::size_t ellipsoid) const;
    void add_solids(Constants& constants) const;
};

Eigen::Vector3d across_of(const Plane& plane);

}  // namespace poinsot
