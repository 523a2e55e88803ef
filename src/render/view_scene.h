// One view made ready for drawing: its projection, and its solids as lines of sight meet them.
#pragma once

#include <glad/gl.h>

#include <vector>

#include "drawing/drawing.h"
#include "render/gl_handles.h"
#include "render/projection.h"
#include "render/quadric.h"

namespace poinsot {

// Most solids of a view that hide other things; more are drawn, but hide nothing.
constexpr int max_quadrics = 8;
constexpr int max_flats = 4;

struct ViewScene {
    const View* view = nullptr;
    Projection projection;
    std::vector<Quadric> quadrics;    // one for each ellipsoid of the view
    std::vector<PlaneMap> maps;       // one for each plane
    std::vector<bool> before_solids;  // whether the plane lies between the eye and the ellipsoids

    void prepare(const View& shown);
    int n_quadrics() const;
    int n_flats() const;
};

Eigen::Vector3d across_of(const Plane& plane);

// The uniform block "View" of shaders/view.glsl, one stretch of a buffer for each view.
class ViewBlocks {
 public:
    ViewBlocks();
    void upload(const Drawing& drawing, const std::vector<ViewScene>& scenes);
    void bind(std::size_t view) const;

 private:
    GlBuffer buffer_;
    std::size_t stride_ = 0;
    std::vector<unsigned char> bytes_;
};

}  // namespace poinsot
