// The visibility of a part of an arrow, along lines on its near side.
#pragma once

#include <vector>

#include "vector/passes/arrow_shape.h"

namespace poinsot::vector {

// Lines on the near side of a part of an arrow, side by side from one edge to the other, each with
// the spans of its visibility. They cut the part along the outline of what hides it, at any slant.
class ArrowStrands {
 public:
    // The canvas and the shape must outlive it.
    ArrowStrands(const Canvas& canvas, const ArrowShape& shape, ArrowPart part);

    // All different covers.
    std::vector<Cover> covers() const;

    // The stretch of the axis beside which the part has this cover.
    Span stretch_of(const Cover& cover) const;

    // The region of the paper with this cover.
    Path region_of(const Cover& cover) const;

 private:
    struct Strand {
        double side = 0.0;  // −1 … 1 across the part
        std::vector<Span> spans;
    };

    Strand strand_at(const Canvas& canvas, double side) const;
    void refine(const Canvas& canvas, const Strand& one, const Strand& other, int depth);
    CurveFlow at(double side, double s) const;
    static bool is_like(const Strand& a, const Strand& b);
    Eigen::Vector2d place(double side, double s) const;
    Eigen::Vector2d border(std::size_t k, std::ptrdiff_t step, double s) const;
    std::vector<Eigen::Vector2d> bends_of(std::size_t k, std::size_t i, std::ptrdiff_t step) const;
    std::vector<Eigen::Vector2d> edge_of(std::size_t first, std::size_t end, std::size_t i,
                                         bool at_end) const;

    const Projection& projection_;
    const ArrowShape& shape_;
    ArrowPart part_;
    double from_, to_;
    double beyond_ = 0.0;  // the continuation of the lines at both ends
    std::vector<Strand> strands_;
};

}  // namespace poinsot::vector
