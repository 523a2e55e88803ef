// A cache of uploaded curve points.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <unordered_map>
#include <vector>

#include "render/context/gl_handles.h"
#include "render/tile_mask.h"
#include "shapes/views.h"

namespace poinsot {

// A stretch of a curve and its bounding sphere, in the geometry's axes.
struct CurveStretch {
    int first = 0, last = 0;
    Eigen::Vector3d centre;
    double radius = 0.0;
};

struct StoredCurve {
    GlTexture texture;  // in rows; xyz: point; w: length of the curve up to this point
    int n_points = 0;
    std::vector<float> lengths;  // of the curve up to each point
    double length = 0.0;         // of the whole curve
    std::vector<CurveStretch> stretches;
    std::uint64_t last_picture = 0;
};

class CurveStore {
 public:
    CurveStore();

    // Removes geometry that was not drawn for many pictures.
    void begin_picture();
    // Returns the geometry's points, uploading them if necessary.
    const StoredCurve& of(const CurveGeometry& geometry);
    // Binds an index buffer for this many consecutive rectangles of four corners.
    void bind_elements(int n_rectangles);

    // Binds these rectangles in place of the curve's points, and an index buffer for them.
    void bind_rectangles(const std::vector<PixelRect>& rects);

    // Points uploaded for the current picture.
    std::int64_t n_points_uploaded() const { return n_points_uploaded_; }

 private:
    GlVertexArray vertex_array_;
    GlBuffer indices_;
    int n_rectangles_ = 0;
    GlTexture corners_;
    std::vector<glm::vec4> corners_px_;
    std::unordered_map<std::uint64_t, StoredCurve> curves_;
    std::uint64_t picture_ = 0;
    std::int64_t n_points_uploaded_ = 0;
};

}  // namespace poinsot
