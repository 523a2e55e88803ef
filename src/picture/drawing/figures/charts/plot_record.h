// The values that a plot shows of one motion over the film, and their range.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "drawing/figures/charts/plot_quantity.h"

namespace poinsot {

// Cached values of one motion over the film: each instant is evaluated once, for all curves. The
// stage, the motion and the quantity must outlive it.
class PlotRecord {
 public:
    PlotRecord(const StageContext& stage, const CountedMotion& motion, const PlotQuantity& quantity)
        : stage_(&stage), motion_(&motion), quantity_(&quantity) {}

    const PlotValues& at(double time_s);

    // Least and greatest of the values computed so far, from an instant on, of the curves first to
    // last.
    std::pair<double, double> range(std::size_t first, std::size_t last,
                                    double from_s = -std::numeric_limits<double>::infinity()) const;

 private:
    FrameInput instant(double time_s) const;

    const StageContext* stage_;
    const CountedMotion* motion_;
    const PlotQuantity* quantity_;
    std::map<double, PlotValues> known_;
};

// Number of intervals to sample the film in: no curve turns by more than about half a turn in one,
// limited to what a plot of this width can resolve.
int n_pieces_of(const StageContext& stage, double width_px);

// Whether the first instants widen the range so much that the later values would hardly be visible.
bool is_ruined(const PlotQuantity& quantity, std::pair<double, double> whole,
               std::pair<double, double> after_start);

// A range that shows both motions. The comparison motion extends it by at most the first one's
// width on either side: if it diverges, it leaves the chart instead of flattening it.
std::pair<double, double> common_range(const PlotQuantity& quantity,
                                       std::pair<double, double> first,
                                       std::pair<double, double> beside);

}  // namespace poinsot
