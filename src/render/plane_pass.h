// Backgrounds, planes with their grids, and the shadows that ellipsoids cast on them.
#pragma once

#include "render/program.h"
#include "render/view_scene.h"

namespace poinsot {

class BackgroundPass {
 public:
    BackgroundPass();
    void draw(const Background& background, const PixelBox& box) const;

 private:
    Program program_;
    GLint box_, bands_, alpha_;
};

class PlanePass {
 public:
    PlanePass();
    void draw(const ViewScene& scene, std::size_t plane) const;

 private:
    Program program_;
    GLint corners_, map_, anchor_, disc_, colour_, grid_colour_;
};

class ShadowPass {
 public:
    ShadowPass();
    void draw(const ViewScene& scene, std::size_t plane) const;

 private:
    Program program_;
    GLint corners_, map_, anchor_, disc_, tint_, n_casters_, sphere_map_, normal_, light_;
};

// Where a plane's disc, or the part of it in shadow, may be seen.
PixelBox disc_box(const ViewScene& scene, std::size_t plane);
PixelBox shadow_box(const ViewScene& scene, std::size_t plane);

}  // namespace poinsot
