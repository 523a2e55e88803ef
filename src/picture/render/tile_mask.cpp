#include "render/tile_mask.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/to_glm.h"

namespace poinsot {
void TileMask::resize(int width_px, int height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    n_columns_ = (width_px + side_px_ - 1) / side_px_;
    n_rows_ = (height_px + side_px_ - 1) / side_px_;
    marks_.assign(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_), 0);
}

void TileMask::clear() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{0}); }

void TileMask::fill() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{1}); }

TileMask::Tiles TileMask::tiles_of(const PixelBox& box) const {
    if (box.empty() || box.right < 0.0 || box.bottom < 0.0 || box.left >= width_px_ ||
        box.top >= height_px_)
        return {};
    const auto tile = [this](double px, int n) {
        return static_cast<int>(std::clamp(std::floor(px / side_px_), 0.0, n - 1.0));
    };
    return {tile(box.left, n_columns_), tile(box.top, n_rows_), tile(box.right, n_columns_),
            tile(box.bottom, n_rows_)};
}

void TileMask::mark(const PixelBox& box) {
    const Tiles tiles = tiles_of(box);
    for (int row = tiles.top; row <= tiles.bottom; ++row) {
        const auto start = marks_.begin() + static_cast<std::ptrdiff_t>(row) * n_columns_;
        std::fill(start + tiles.left, start + tiles.right + 1, std::uint8_t{1});
    }
}

bool TileMask::touches(const PixelBox& box) const {
    const Tiles tiles = tiles_of(box);
    for (int row = tiles.top; row <= tiles.bottom; ++row) {
        const auto start = marks_.begin() + static_cast<std::ptrdiff_t>(row) * n_columns_;
        if (std::find(start + tiles.left, start + tiles.right + 1, 1) != start + tiles.right + 1)
            return true;
    }
    return false;
}

void TileMask::mark(const PixelPolygon& polygon, const PixelBox& limits) {
    const PixelBox box = polygon.box.within(limits);
    if (box.empty()) return;
    const int first = static_cast<int>(std::floor(std::max(box.top, 0.0) / side_px_));
    for (int row = first; row * side_px_ < std::min<double>(box.bottom, height_px_); ++row) {
        // The extent of the row's upper and lower edges, and of the corners between them.
        const double top = row * side_px_, bottom = top + side_px_;
        PixelBox part;
        for (int k = 0; k < polygon.n_corners; ++k) {
            const auto corner = [&](int i) {
                return to_eigen(polygon.corners[static_cast<std::size_t>(i % polygon.n_corners)]);
            };
            const Eigen::Vector2d a = corner(k), b = corner(k + 1);
            if (a.y() >= top && a.y() <= bottom) part.add(a);
            for (const double y : {top, bottom}) {
                const double t = (y - a.y()) / (b.y() - a.y());
                if (t >= 0.0 && t <= 1.0) part.add(a + t * (b - a));
            }
        }
        part.top = top, part.bottom = bottom - 1.0;
        mark(part.within(limits));
    }
}

PixelRect TileMask::rect(std::size_t tile) const {
    const int column = static_cast<int>(tile) % n_columns_,
              row = static_cast<int>(tile) / n_columns_;
    return {column * side_px_, row * side_px_, std::min((column + 1) * side_px_, width_px_),
            std::min((row + 1) * side_px_, height_px_)};
}

void TileMask::add_rects(const TileMask* within, std::vector<PixelRect>& rects) const {
    const int ratio = within == nullptr ? 1 : within->side_px_ / side_px_;
    const auto row_of = [](const TileMask& mask, int row) {
        return mask.marks_.data() +
               static_cast<std::size_t>(row) * static_cast<std::size_t>(mask.n_columns_);
    };
    std::vector<std::size_t> above, here;  // rectangles that end in the previous row, and in this
                                           // row
    for (int row = 0; row < n_rows_; ++row) {
        const std::uint8_t* marks = row_of(*this, row);
        const std::uint8_t* coarse = within == nullptr ? nullptr : row_of(*within, row / ratio);
        const auto wanted = [&](int column) {
            return marks[column] != 0 && (coarse == nullptr || coarse[column / ratio] != 0);
        };
        const int top = row * side_px_, bottom = std::min(top + side_px_, height_px_);
        here.clear();
        std::size_t k = 0;
        for (int column = 0; column < n_columns_; ++column) {
            if (!wanted(column)) continue;
            int end = column + 1;
            while (end < n_columns_ && wanted(end)) ++end;
            const PixelRect rect{column * side_px_, top, std::min(end * side_px_, width_px_),
                                 bottom};
            while (k < above.size() && rects[above[k]].left < rect.left) ++k;
            if (k < above.size() && rects[above[k]].left == rect.left &&
                rects[above[k]].right == rect.right) {
                rects[above[k]].bottom = bottom;
                here.push_back(above[k]);
            } else {
                here.push_back(rects.size());
                rects.push_back(rect);
            }
            column = end;
        }
        std::swap(above, here);
    }
}

}  // namespace poinsot
