// Points of curves, uploaded once and kept while they are drawn.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/context/gl_handles.h"
#include "render/tile_mask.h"
#include "shapes/views.h"

namespace poinsot {

// A stretch of a curve and a ball that holds it, in the geometry's axes.
struct CurveStretch {
    int first = 0, last = 0;
    Eigen::Vector3d centre;
    double radius = 0.0;
};

struct StoredCurve {
    GlBuffer buffer;
    GlTexture texture;  // xyz: point; w: length of the curve up to it
    int n_points = 0;
    std::vector<float> lengths;  // of the curve up to each point
    double length = 0.0;         // of all of it
    std::vector<CurveStretch> stretches;
    std::uint64_t last_picture = 0;
};

class CurveStore {
 public:
    CurveStore();

    // Forgets what was not drawn for many pictures.
    void begin_picture();
    // The geometry's points, uploaded if they were not seen before.
    const StoredCurve& of(const CurveGeometry& geometry);
    // Binds elements for this many rectangles in a row, four corners each.
    void bind_elements(int n_rectangles);

    // Binds these rectangles where the programs of curves look for points, and elements for them.
    void bind_rectangles(const std::vector<PixelRect>& rects);

    // Points uploaded for the picture under way.
    std::int64_t n_points_uploaded() const { return n_points_uploaded_; }

 private:
    GlVertexArray vertex_array_;
    GlBuffer indices_;
    int n_rectangles_ = 0;
    GlBuffer corners_;
    GlTexture corners_texture_;
    std::vector<Eigen::Vector4f> corners_px_;
    std::unordered_map<std::uint64_t, StoredCurve> curves_;
    std::uint64_t picture_ = 0;
    std::int64_t n_points_uploaded_ = 0;
};

}  // namespace poinsot
