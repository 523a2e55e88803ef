// Draws lasting curves: their pixels are cached, so that the cost of a video frame does not depend
// on their length.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/passes/curve_layer.h"
#include "render/passes/curve_pass.h"
#include "render/passes/stroke.h"

namespace poinsot {

class CachedCurvePass {
 public:
    // Whether the curve can be cached: `lasting` is set, and only its end changes.
    static bool keeps(const Curve& curve);

    // Before each picture, and then for each of its views: updates the layers of the curves. Binds
    // its own framebuffers.
    void begin_picture();
    void prepare(const ViewScene& scene, CurveStore& store);
    // Called after the last view.
    void end_preparation();

    // Draws a curve. Precondition: the curve was prepared for this picture. within: the tiles being
    // drawn; null: all.
    void draw(const ViewScene& scene, const Curve& curve, const TileMask* within, CurvePass& pass,
              CurveStore& store);
    // Marks the tiles of the last segments, which are not cached.
    void mark(const ViewScene& scene, TileMask& marks) const;
    // Adds for each tile a number that changes when the cached curves there look different, apart
    // from objects that move over or hide them; 0 if nothing is cached. Precondition: `stamps` has
    // one 0 per tile.
    void add_stamps(std::vector<std::uint64_t>& stamps) const;

    // Segments drawn into the layers for the current picture.
    std::int64_t n_segments_drawn() const { return n_segments_drawn_; }

 private:
    // The appearance of a cached curve in a picture.
    struct Look {
        std::uint64_t serial;
        Colour colour;
        double opacity, hidden_opacity;
        HiddenStyle hidden;
        Occlusion occlusion;
        int on_surface, on_plane;
        bool operator==(const Look&) const = default;
    };
    struct Shown {
        const ViewScene* scene;
        const Curve* curve;
        CurveLayer* layer;
        SeenSegment last;  // the segment that is not cached
        StrokeEnds ends;   // the same segment for the shader
        StrokeDashes dashes;
    };
    CurveLayer& layer_of(const TraceKey& key);
    void grow(const Shown& shown, int end_segment, CurveStore& store);

    std::optional<StrokeProgram> trace_;  // made when the first curve is cached
    std::vector<std::unique_ptr<CurveLayer>> layers_;
    std::vector<Shown> shown_;
    std::vector<Look> looks_;
    TileMask cells_{CurveLayer::cell_px};
    std::vector<PixelRect> rects_;
    std::uint64_t picture_ = 0, looks_since_ = 0, n_restarts_ = 0;
    std::int64_t n_segments_drawn_ = 0;
};

}  // namespace poinsot
