// A mask of the tiles of the picture on which something may be drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/pixel_area.h"

namespace poinsot {

// Whole pixels; right and bottom are exclusive.
struct PixelRect {
    int left = 0, top = 0, right = 0, bottom = 0;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

class TileMask {
 public:
    // side_px: the side of a tile; the side of a finer mask must divide that of the coarser one.
    explicit TileMask(int side_px = 16) : side_px_(side_px) {}
    int side_px() const { return side_px_; }

    void resize(int width_px, int height_px);
    void clear();
    void fill();
    void mark(const PixelBox& box);
    // Marks only tiles that are also inside `limits`.
    void mark(const PixelPolygon& polygon, const PixelBox& limits);

    // Tiles one by one, row by row.
    std::size_t n_tiles() const { return marks_.size(); }
    bool is_marked(std::size_t tile) const { return marks_[tile] != 0; }
    void mark(std::size_t tile) { marks_[tile] = 1; }
    PixelRect rect(std::size_t tile) const;

    // Whether the box overlaps any marked tile.
    bool touches(const PixelBox& box) const;

    // Adds the marked tiles as rectangles, merging neighbours; with `within`, only those on marked
    // tiles of this coarser mask of the same picture.
    void add_rects(const TileMask* within, std::vector<PixelRect>& rects) const;

 private:
    // First and last column and row of the tiles that a box overlaps; empty if there are none.
    struct Tiles {
        int left = 0, top = 0, right = -1, bottom = -1;
    };
    Tiles tiles_of(const PixelBox& box) const;

    int side_px_;
    int width_px_ = 0, height_px_ = 0;
    int n_columns_ = 0, n_rows_ = 0;
    std::vector<std::uint8_t> marks_;
};

}  // namespace poinsot
