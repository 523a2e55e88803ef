// The picture under way: what stands still, kept from one picture to the next, and what moves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/deep_image.h"
#include "image/image.h"
#include "render/context/gl_handles.h"
#include "render/encoding.h"
#include "render/tile_mask.h"

namespace poinsot {

// Layers hold linear light, premultiplied, 16 bits a component. While nothing that stands still
// changes, only the marked tiles are restored, read back and encoded.
class Canvas {
 public:
    // Makes the layers as large as the picture; true if they are new.
    bool resize(int width_px, int height_px);

    // What follows is drawn on an empty picture.
    void begin_whole();
    // Draws on the picture again after another framebuffer was bound.
    void resume() const;
    // What follows is kept as what stands still, under all that moves; then, up to keep_still, what
    // stands still on top of it. The latter is not restored where something moves.
    void begin_still();
    void begin_still_on_top();
    void keep_still(bool transparent, std::size_t n_tiles);
    // What follows is drawn over what stands still, on the marked tiles only.
    void begin_over_still(const TileMask& marks);

    // The still picture also keeps tiles that show what lasts, and nothing that moves. Each tile
    // has the stamp it was kept with; 0: what stands still alone.
    std::uint64_t kept_stamp(std::size_t tile) const { return kept_stamps_[tile]; }
    void keep_tile(const TileMask& marks, std::size_t tile, std::uint64_t stamp,
                   const Image& image);

    // The picture: all of it, or the marked tiles over what stands still.
    void read_whole(Image& image, bool transparent);
    void read_whole(DeepImage& image, bool transparent);
    // Of an image that still is as it was after one of the last calls only what differs is written.
    void read_over_still(const TileMask& marks, Image& image, bool transparent);

 private:
    struct Layer {
        GlTexture texture;
        // Of the picture only: it keeps curves from mixing with themselves. CurvePass empties it.
        GlRenderbuffer depth;
        GlFramebuffer framebuffer;
    };
    Layer make_layer(bool with_depth) const;
    void begin(const Layer& layer) const;
    // Puts what stands still into these parts of the picture, and binds it.
    void restore(const std::vector<PixelRect>& rects) const;
    void read(const PixelRect& rect, Image& image, bool transparent);
    void copy(const PixelRect& rect, const Image& from, Image& to) const;
    void read_all(const Layer& layer, Image& image, bool transparent);

    Encoder encoder_;
    Layer still_, picture_;
    Image still_image_;
    // Of each tile of the still picture: its stamp, and the number of the picture it came with.
    std::vector<std::uint64_t> kept_stamps_, kept_at_;
    // What images were given: the number that knows them, where they differ from the still picture,
    // and the number of their picture. The oldest is replaced.
    struct Written {
        std::uint64_t content = 0, picture = 0;
        TileMask marks;
    };
    std::array<Written, 8> written_;
    std::uint64_t n_pictures_ = 0;
    TileMask copied_;
    std::vector<PixelRect> rects_;
    std::vector<std::uint16_t> scratch_;
    int width_px_ = 0, height_px_ = 0;
};

}  // namespace poinsot
