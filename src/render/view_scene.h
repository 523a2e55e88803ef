// One view made ready for drawing: its projection, and its solids as lines of sight meet them.
#pragma once

#include <vector>

#include "drawing/drawing.h"
#include "render/constants.h"
#include "render/projection.h"
#include "render/quadric.h"

namespace poinsot {

// Most solids of a view that hide other things; more are drawn, but hide nothing.
constexpr int max_quadrics = 8;
constexpr int max_flats = 4;

struct ViewScene {
    const Drawing* drawing = nullptr;
    const View* view = nullptr;
    Projection projection;
    std::vector<Quadric> quadrics;    // one for each ellipsoid of the view
    std::vector<PlaneMap> maps;       // one for each plane
    std::vector<bool> before_solids;  // whether the plane lies between the eye and the ellipsoids

    void prepare(const Drawing& whole, const View& shown);
    int n_quadrics() const;
    int n_flats() const;

    // Constants as shaders/view.glsl (5), quadric.glsl (7) and occlusion.glsl count them, and two
    // for the light: towards it, and its strength, first the key light, then the sky.
    void add_view(Constants& constants) const;
    void add_light(Constants& constants) const;
    void add_quadric(Constants& constants, std::size_t ellipsoid) const;
    void add_solids(Constants& constants) const;
};

// How many constants add_solids adds.
constexpr int n_solid_constants(int n_quadrics, int n_flats) {
    return 7 * n_quadrics + 3 * n_flats;
}

Eigen::Vector3d across_of(const Plane& plane);

}  // namespace poinsot
