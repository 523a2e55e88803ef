// The layout of dashes along a line: only whole dashes, so that ends and corners are drawn.
#pragma once

#include <span>
#include <vector>

#include "vector/occluders.h"
#include "vector/paper_flow.h"

namespace poinsot::vector {

// The length of a dash, and of the gap between two, in points.
struct Dash {
    double on_pt = 0.0, off_pt = 0.0;
};

// The end of a dashed stretch: a dash where the line ends; a gap where it continues solid, because
// a dash would lengthen the solid part.
enum class DashEnd { dash, gap };

// Dash and gap stretched by one factor, so that a whole number of dashes fills the length between
// these ends. A stretch that ends in dashes has two at least, any other one.
Dash fitted_dash(const Dash& wanted, double length_pt, DashEnd begin, DashEnd end);
// The same for a closed line: a whole number of dashes and gaps.
Dash fitted_dash(const Dash& wanted, double length_pt);

// Dashes and gaps in turn, repeated, and the position in them at which a stroke begins: as in
// Stroke.
struct DashPattern {
    std::vector<double> lengths_pt;
    double offset_pt = 0.0;
};

// The pattern along a line whose corners divide it into pieces of these lengths. There is a whole
// dash on both sides of each corner.
DashPattern dashes_along(const Dash& wanted, std::span<const double> pieces_pt, DashEnd begin,
                         DashEnd end);

// The length of a part of a track on paper.
double length_on_paper(const Projection& projection, const Track& track, double from, double to);

// The parameters between `from` and `to` at which the track has a corner on paper.
std::vector<double> corners_between(const Projection& projection, const Track& track, double from,
                                    double to);

}  // namespace poinsot::vector
