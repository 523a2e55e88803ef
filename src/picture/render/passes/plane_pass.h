// Draws backgrounds, planes with their grids, and the shadows of ellipsoids on them.
#pragma once

#include "render/passes/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class BackgroundPass {
 public:
    BackgroundPass();
    void draw(const Drawing& drawing, const Background& background, const PixelBox& box) const;

 private:
    Program program_;
    GLint projection_, box_, bands_;
};

class PlanePass {
 public:
    PlanePass();
    void draw(const ViewScene& scene, std::size_t plane) const;

 private:
    PolygonProgram program_;
};

class ShadowPass {
 public:
    ShadowPass();
    // Makes the shadow webs of everything in the view that casts shadows.
    static void prepare(ViewScene& scene);
    void draw(const ViewScene& scene, std::size_t plane) const;
    void mark(const ViewScene& scene, TileMask& marks) const;

 private:
    Program program_;
    GLint projection_, tint_;
    GlVertexArray vertex_array_;
    GlBuffer corners_, indices_;
    GLsizei n_indices_ = 0;
};

// The outline of a plane's disc in the picture.
PixelPolygon disc_polygon(const ViewScene& scene, std::size_t plane);

}  // namespace poinsot
