// The cached pixels of a lasting curve.
#pragma once

#include <cstdint>
#include <vector>

#include "render/passes/stroke.h"
#include "render/tile_mask.h"

namespace poinsot {

// Everything on which the cached pixels of a curve depend.
struct TraceKey {
    std::uint64_t geometry = 0;
    Camera camera;
    PixelBox view;
    int width_px = 0, height_px = 0;  // of the picture
    Eigen::Matrix4d placement = Eigen::Matrix4d::Zero();
    Eigen::Matrix3d surface = Eigen::Matrix3d::Zero();  // half-axes of the ellipsoid on which the
                                                        // curve lies
    Eigen::Vector3d surface_centre = Eigen::Vector3d::Zero();
    double stroke_px = 0.0;
    StrokeDashes dashes;
    double first = 0.0;  // first point drawn

    TraceKey() = default;
    TraceKey(const ViewScene& scene, const Curve& curve, const StrokeDashes& shown_dashes);
    bool operator==(const TraceKey& other) const;
};

// Textures that shaders/trace.frag writes and curve.frag reads.
struct KeptTextures {
    GlTexture points, coverage;
    KeptTextures() = default;
    // with_surface: whether the curve lies on an ellipsoid.
    KeptTextures(int width_px, int height_px, bool with_surface);
    // Binds them for curve.frag.
    void bind() const;
};

// Coverage and depth of the complete segments of a curve, from the first one on, in a layer over
// the part of the picture that the curve can reach. The layer grows with the curve.
class CurveLayer {
 public:
    static constexpr int cell_px = 8;

    bool holds(const TraceKey& key) const { return serial_ != 0 && key_ == key; }
    std::uint64_t geometry() const { return key_.geometry; }
    // Clears the layer for another curve, beginning with this segment. box: pixels that the curve
    // may reach; serial: a number unique to this call.
    void restart(const TraceKey& key, const PixelBox& box, int first_segment, std::uint64_t serial);
    // Binds the layer for drawing the segments from end_segment() to this one, and records their
    // tiles.
    void begin_growth(const ViewScene& scene, const Curve& curve, int end_segment,
                      std::uint64_t picture);
    // One past the last cached segment.
    int end_segment() const { return end_segment_; }

    // The serial of the last restart.
    std::uint64_t serial() const { return serial_; }
    // The position of the layer in the picture; its corner is the corner of a tile.
    const PixelRect& rect() const { return rect_; }
    const KeptTextures& textures() const { return textures_; }
    // The small squares of the picture in which something is cached.
    const TileMask& cells() const { return cells_; }
    // For each tile, the number of the picture in which it last changed; 0 if nothing is cached
    // there.
    const std::vector<std::uint64_t>& changed() const { return changed_; }

    std::uint64_t last_picture = 0;

 private:
    void resize(int width_px, int height_px, bool with_surface);

    TraceKey key_;
    std::uint64_t serial_ = 0;
    PixelRect rect_;
    KeptTextures textures_;
    GlFramebuffer framebuffer_;
    int width_px_ = 0, height_px_ = 0;  // of the textures
    bool with_surface_ = false;
    int end_segment_ = 0;
    TileMask cells_{cell_px}, grown_;
    std::vector<std::uint64_t> changed_;
};

// A segment of an open curve in the picture, clipped to the part in front of the eye.
struct SeenSegment {
    bool seen = false;
    double from = 0.0, to = 1.0;  // shares of the segment
    Eigen::Vector3d start, end;   // in the view's axes
    Eigen::Vector2d start_px, end_px;
};
SeenSegment seen_segment(const Projection& projection, const Curve& curve, int segment,
                         double from = 0.0, double to = 1.0);

// Marks the tiles that a stroke of this width along a segment may cover.
void mark_stroke(const SeenSegment& segment, double width_px, const PixelBox& limits,
                 TileMask& marks);

}  // namespace poinsot
