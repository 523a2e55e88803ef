// The picture being drawn: a cache of its static content, and the moving content over it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/deep_image.h"
#include "image/image.h"
#include "render/context/gl_handles.h"
#include "render/context/light_format.h"
#include "render/encoding.h"
#include "render/tile_mask.h"

namespace poinsot {

// Layers contain premultiplied linear light of 16 bits per component. As long as the static content
// does not change, only the marked tiles are restored, read back and encoded.
class Canvas {
 public:
    explicit Canvas(LightBits light) : light_(light) {}

    // Resizes the layers to the picture; returns true if they are new.
    bool resize(int width_px, int height_px);

    // Begins drawing on an empty picture.
    void begin_whole();
    // Continues drawing on the picture after another framebuffer was bound.
    void resume() const;
    // Begins drawing the static content below everything that moves; then, until keep_still, the
    // static content on top. The latter is not restored where something moves.
    void begin_still();
    void begin_still_on_top();
    void keep_still(bool transparent, std::size_t n_tiles);
    // Begins drawing over the static content, on the marked tiles only.
    void begin_over_still(const TileMask& marks);

    // The cached picture also keeps tiles of lasting curves on which nothing moves. Each tile has
    // the stamp of its content; 0: only static content.
    std::uint64_t kept_stamp(std::size_t tile) const { return kept_stamps_[tile]; }
    void keep_tile(const TileMask& marks, std::size_t tile, std::uint64_t stamp,
                   const Image& image);

    // Reads the picture: all of it, or the marked tiles over the static content.
    void read_whole(Image& image, bool transparent);
    void read_whole(DeepImage& image, bool transparent);
    // The whole picture, for a pass that reads it.
    const GlTexture& light() const { return picture_.texture; }
    // If the image is unchanged since one of the last calls, writes only the differences.
    void read_over_still(const TileMask& marks, Image& image, bool transparent);

 private:
    struct Layer {
        GlTexture texture;
        // Of picture_ only: prevents curves from blending with themselves. CurvePass clears it.
        GlRenderbuffer depth;
        GlFramebuffer framebuffer;
    };
    Layer make_layer(bool with_depth) const;
    void begin(const Layer& layer) const;
    // Copies the static content to these parts of the picture, and binds the picture.
    void restore(const std::vector<PixelRect>& rects) const;
    void read(const PixelRect& rect, Image& image, bool transparent);
    void copy(const PixelRect& rect, const Image& from, Image& to) const;
    void read_all(const Layer& layer, Image& image, bool transparent);

    LightBits light_;
    Encoder encoder_;
    Layer still_, picture_;
    Image still_image_;
    // For each tile of the cached picture: its stamp, and the number of the picture in which it was
    // stored.
    std::vector<std::uint64_t> kept_stamps_, kept_at_;
    // The last images written: the identifier of their content, the tiles where they differ from
    // the cached picture, and their picture number. The oldest entry is replaced.
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
