// Curves as strokes of constant width in pixels.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class CurvePass {
 public:
    CurvePass();

    // Uploads geometries not seen before; forgets those not used for many pictures.
    void begin_picture();
    void draw(const ViewScene& scene, const Curve& curve);
    // Marks the tiles that the curve may touch.
    void mark(const ViewScene& scene, const Curve& curve, TileMask& marks);

 private:
    // A stretch of the curve and a ball that holds it, in the geometry's axes.
    struct Stretch {
        int first = 0, last = 0;
        Eigen::Vector3d centre;
        double radius = 0.0;
    };
    struct Uploaded {
        GlBuffer buffer;
        GlTexture texture;
        int n_points = 0;
        double length = 0.0;
        std::vector<Stretch> stretches;
        std::uint64_t last_picture = 0;
    };
    Uploaded& uploaded(const CurveGeometry& geometry);
    void reserve_segments(int n_segments);

    struct Stroke {
        explicit Stroke(const Solids& solids);
        ConstantProgram program;
        GLint n_points, closed, stroke, on_ellipsoid;
    };
    BySolids<Stroke> strokes_;
    GlVertexArray vertex_array_;
    GlBuffer indices_;
    int n_segments_ = 0;
    std::unordered_map<std::uint64_t, Uploaded> uploads_;
    std::uint64_t picture_ = 0;
    int n_drawn_ = 0;  // since the depth buffer was emptied
};

}  // namespace poinsot
