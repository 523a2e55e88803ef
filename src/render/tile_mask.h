// The squares of the picture that something may be drawn on.
#pragma once

#include <cstdint>
#include <vector>

#include "render/projection.h"

namespace poinsot {

// Tiles as large as llvmpipe's own, so that a tile is drawn without looking at its edges.
class TileMask {
 public:
    static constexpr int side_px = 64;

    void resize(int width_px, int height_px);
    void clear();
    void fill();
    void mark(const PixelBox& box);

    int n_columns() const { return n_columns_; }
    int n_rows() const { return n_rows_; }
    bool marked(int column, int row) const {
        return marks_[static_cast<std::size_t>(row * n_columns_ + column)] != 0;
    }
    void join(const TileMask& other);
    void swap(TileMask& other) noexcept { marks_.swap(other.marks_); }

    // Rectangles of tiles as two triangles each, x and y in pixels: neighbours in a row as one.
    void append_triangles(std::vector<float>& corners) const;

 private:
    int n_columns_ = 0;
    int n_rows_ = 0;
    std::vector<std::uint8_t> marks_;
};

}  // namespace poinsot
