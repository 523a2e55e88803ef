#include "render/tile_mask.h"

#include <algorithm>
#include <cmath>

namespace poinsot {

void TileMask::resize(int width_px, int height_px) {
    n_columns_ = (width_px + side_px - 1) / side_px;
    n_rows_ = (height_px + side_px - 1) / side_px;
    marks_.assign(static_cast<std::size_t>(n_columns_ * n_rows_), 0);
}

void TileMask::clear() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{0}); }

void TileMask::fill() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{1}); }

void TileMask::mark(const PixelBox& box) {
    if (box.empty()) return;
    const auto tile = [](double px, int n) {
        return static_cast<int>(std::clamp(std::floor(px / side_px), 0.0, n - 1.0));
    };
    if (box.right < 0.0 || box.bottom < 0.0) return;
    if (box.left >= n_columns_ * side_px || box.top >= n_rows_ * side_px) return;
    for (int row = tile(box.top, n_rows_); row <= tile(box.bottom, n_rows_); ++row) {
        const auto start = marks_.begin() + row * n_columns_;
        std::fill(start + tile(box.left, n_columns_), start + tile(box.right, n_columns_) + 1,
                  std::uint8_t{1});
    }
}

void TileMask::join(const TileMask& other) {
    for (std::size_t k = 0; k < marks_.size(); ++k)
        marks_[k] = static_cast<std::uint8_t>(marks_[k] | other.marks_[k]);
}

void TileMask::append_triangles(std::vector<float>& corners) const {
    for (int row = 0; row < n_rows_; ++row) {
        for (int column = 0; column < n_columns_;) {
            if (!marked(column, row)) {
                ++column;
                continue;
            }
            int end = column + 1;
            while (end < n_columns_ && marked(end, row)) ++end;
            const auto left = static_cast<float>(column * side_px);
            const auto right = static_cast<float>(end * side_px);
            const auto top = static_cast<float>(row * side_px);
            const auto bottom = static_cast<float>((row + 1) * side_px);
            corners.insert(corners.end(), {left, top, right, top, right, bottom,  //
                                           left, top, right, bottom, left, bottom});
            column = end;
        }
    }
}

}  // namespace poinsot
