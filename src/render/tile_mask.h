// The squares of the picture that something may be drawn on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/pixel_area.h"

namespace poinsot {

// Whole pixels, end exclusive.
struct PixelRect {
    int left = 0, top = 0, right = 0, bottom = 0;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

class TileMask {
 public:
    // Squares of this side; a mask within another one has a divisor of its side.
    explicit TileMask(int side_px = 16) : side_px_(side_px) {}
    int side_px() const { return side_px_; }

    void resize(int width_px, int height_px);
    void clear();
    void fill();
    void mark(const PixelBox& box);
    // Only what lies within `limits` as well.
    void mark(const PixelPolygon& polygon, const PixelBox& limits);

    // Tiles one by one, row by row.
    std::size_t n_tiles() const { return marks_.size(); }
    bool is_marked(std::size_t tile) const { return marks_[tile] != 0; }
    void mark(std::size_t tile) { marks_[tile] = 1; }
    PixelRect rect(std::size_t tile) const;

    // Whether any tile that the box lies on is marked.
    bool touches(const PixelBox& box) const;

    // Adds the marked tiles as rectangles, neighbours joined; only those that lie on marked tiles
    // of a coarser mask of the same picture, if one is given.
    void add_rects(const TileMask* within, std::vector<PixelRect>& rects) const;

 private:
    // First and last column and row of the tiles that a box lies on; empty if it lies on none.
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
