// Curves that last: what has been drawn of them is kept, so that a video frame costs the same
// however long they are.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/keep/curve_layer.h"
#include "render/passes/curve_pass.h"
#include "render/passes/stroke.h"

namespace poinsot {

class LastingCurvePass {
 public:
    // Whether the curve is kept: it says that it lasts, and nothing of it changes but its end.
    static bool keeps(const Curve& curve);

    // Before each picture, and then for each of its views: brings the layers of its curves up to
    // date. Binds framebuffers of its own.
    void begin_picture();
    void prepare(const ViewScene& scene, CurveStore& store);
    // After the last view.
    void end_preparation();

    // Precondition: the curve was prepared for this picture. within: where the picture is drawn;
    // null: everywhere.
    void draw(const ViewScene& scene, const Curve& curve, const TileMask* within, CurvePass& pass,
              CurveStore& store);
    // Marks the tiles of the last segments, which are not kept.
    void mark(const ViewScene& scene, TileMask& marks) const;
    // For each tile of the picture a number that changes when what is kept there looks otherwise,
    // but for what moves over it or hides it; 0 where nothing is kept. Precondition: one 0 a tile.
    void add_stamps(std::vector<std::uint64_t>& stamps) const;

    // Segments drawn into the layers for the picture under way.
    std::int64_t n_segments_drawn() const { return n_segments_drawn_; }

 private:
    // How a kept curve looks in a picture.
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
        SeenSegment last;  // the segment that is not kept
        StrokeEnds ends;   // the same for the shader
        DashPattern dashes;
    };
    CurveLayer& layer_of(const TraceKey& key);
    void grow(const Shown& shown, int end_segment, CurveStore& store);

    std::optional<StrokeProgram> trace_;  // made when a curve is first kept
    std::vector<std::unique_ptr<CurveLayer>> layers_;
    std::vector<Shown> shown_;
    std::vector<Look> looks_;
    TileMask cells_{CurveLayer::cell_px};
    std::vector<PixelRect> rects_;
    std::uint64_t picture_ = 0, looks_since_ = 0, n_restarts_ = 0;
    std::int64_t n_segments_drawn_ = 0;
};

}  // namespace poinsot
