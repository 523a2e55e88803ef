// What a plot shows of one motion: its values over the film, and their range.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "drawing/charts/plot_quantity.h"

namespace poinsot {

// Values over the film of one motion, asked for once an instant however many curves need it. The
// stage, the motion and the quantity must outlive it.
class PlotRecord {
 public:
    PlotRecord(const StageData& stage, const CountedMotion& motion, const PlotQuantity& quantity)
        : stage_(&stage), motion_(&motion), quantity_(&quantity) {}

    const PlotValues& at(double time_s);

    // Least and greatest of the values known so far from an instant on, of the curves first to
    // last.
    std::pair<double, double> range(std::size_t first, std::size_t last,
                                    double from_s = -std::numeric_limits<double>::infinity()) const;

 private:
    Instant instant(double time_s) const;

    const StageData* stage_;
    const CountedMotion* motion_;
    const PlotQuantity* quantity_;
    std::map<double, PlotValues> known_;
};

// So many pieces of the film that no curve turns by more than about half a turn within one; no more
// than a plot of this width can show.
int n_pieces_of(const StageData& stage, double width_px);

// Whether the first instants would ruin a range: whether it is so much wider than what follows them
// that this would hardly be seen.
bool is_ruined(const PlotQuantity& quantity, std::pair<double, double> whole,
               std::pair<double, double> after_start);

// The range that shows both motions, but of the one beside no more than the first one's range again
// on either side: one that blows up leaves the chart instead of flattening it.
std::pair<double, double> common_range(const PlotQuantity& quantity,
                                       std::pair<double, double> first,
                                       std::pair<double, double> beside);

}  // namespace poinsot
