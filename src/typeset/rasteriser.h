// From outlines to coverage: the exact area of a shape within each pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "typeset/glyph_outline.h"

namespace poinsot {

// Collects the signed area to the right of every edge, pixel by pixel, and sums it along each row:
// the running sum is the winding number averaged over the pixel, so no sampling is involved. (The
// idea of exact-area coverage with a difference buffer is known from FreeType's smooth renderer and
// from R. Levien's font-rs.) Overlapping contours of the same direction count as one, the absolute
// sum being cut at 1. Uses only correctly rounded operations: the same numbers on every machine.
//
// Axes: pixels, x right, y down; the buffer holds columns 0…width and rows first_row…+n_rows.
// Everything must lie within the columns; what lies outside the rows is passed over.
class Rasteriser {
 public:
    Rasteriser(int width, int first_row, int n_rows);

    // Adds an outline placed at (x_px, y_px), scaled by px_per_unit, its y axis turned down.
    void add(const GlyphOutline& outline, double x_px, double y_px, double px_per_unit);
    // Adds an axis-parallel rectangle, turned like an outer contour of an outline (anticlockwise in
    // y-up axes is `outer_is_anticlockwise`).
    void add_rectangle(double left, double top, double right, double bottom);

    // Coverage 0…1 of each pixel, row by row.
    std::vector<double> coverage() const;
    // The same in 255ths, rounded to nearest, written to n_rows rows of `width` bytes.
    void write(std::uint8_t* rows) const;

 private:
    void line(OutlinePoint from, OutlinePoint to);
    void cubic(OutlinePoint p0, OutlinePoint p1, OutlinePoint p2, OutlinePoint p3);
    void row_part(double* row, double x0, double x1, double height);
    template <typename Store>
    void sum_rows(Store store) const;

    int width_;
    int first_row_;
    int n_rows_;
    std::size_t stride_;
    std::vector<double> difference_;
};

}  // namespace poinsot
