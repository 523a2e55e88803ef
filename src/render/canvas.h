// The layers of a picture: what stands still, what moves over it, and the encoded result.
#pragma once

#include <vector>

#include "image/image.h"
#include "render/gl_handles.h"
#include "render/program.h"
#include "render/tile_mask.h"

namespace poinsot {

// Layers hold linear light, premultiplied. Only tiles on which something moves, or moved in the
// picture before, are cleared, composed and encoded again.
class Canvas {
 public:
    Canvas();

    // Makes the layers as large as the picture; true if they are new, so that all must be drawn.
    bool resize(int width_px, int height_px);

    // Directs drawing to the layer that stands still, cleared, or to the moving one with the marked
    // tiles cleared.
    void begin_still();
    void begin_moving(const TileMask& marks);
    // Composes and encodes the marked tiles and those marked in the picture before.
    void compose(const TileMask& marks, bool transparent);
    void read(Image& image) const;

 private:
    struct Layer {
        GlTexture texture;
        GlFramebuffer framebuffer;
    };
    static Layer layer_of(int width_px, int height_px, GLint format);
    void draw_tiles(const Program& program, const TileMask& marks);

    Program clear_, compose_opaque_, compose_transparent_;
    GlVertexArray vertex_array_;
    GlBuffer corners_;
    std::vector<float> corner_scratch_;
    Layer still_, moving_, encoded_;
    TileMask before_, both_;
    int width_px_ = 0, height_px_ = 0;
};

}  // namespace poinsot
