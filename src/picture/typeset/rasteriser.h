// Computes the exact area coverage of outlines in each pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "typeset/glyph_outline.h"

namespace poinsot {

// Accumulates the signed area to the right of every edge per pixel, and sums it along each row. The
// running sum is the winding number averaged over the pixel, so that nothing is sampled. (Exact
// area coverage with a difference buffer is known from FreeType's smooth renderer and from R.
// Levien's font-rs.) Overlapping contours of the same direction count once, since the absolute sum
// is clamped to 1. Uses only correctly rounded operations, so that the results are the same on
// every machine.
//
// Axes: pixels, x right, y down; the buffer holds columns 0…width and n_rows rows from first_row
// on. Precondition: all input lies within the columns; parts outside the rows are ignored.
class Rasteriser {
 public:
    Rasteriser(int width, int first_row, int n_rows);

    // Adds an outline at (x_px, y_px), scaled by px_per_unit, with its y axis pointing down.
    void add(const GlyphOutline& outline, double x_px, double y_px, double px_per_unit);
    // Adds an axis-parallel rectangle with the orientation of an outer contour
    // (`outer_is_anticlockwise` refers to y-up axes).
    void add_rectangle(double left, double top, double right, double bottom);

    // Coverage 0…1 of each pixel, row by row.
    std::vector<double> coverage() const;
    // Coverage in 1/255, rounded to nearest, written to n_rows rows of `width` bytes.
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
