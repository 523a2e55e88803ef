#include "drawing/figures/charts/plot_record.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot {

const PlotValues& PlotRecord::at(double time_s) {
    const auto [entry, is_new] = known_.try_emplace(time_s);
    if (is_new) entry->second = shown_values(*stage_, *quantity_, instant(time_s));
    return entry->second;
}

std::pair<double, double> PlotRecord::range(std::size_t first, std::size_t last,
                                            double from_s) const {
    double least = INFINITY;
    double most = -INFINITY;
    for (auto entry = known_.lower_bound(from_s); entry != known_.end(); ++entry) {
        const PlotValues& values = entry->second;
        for (std::size_t i = first; i <= last; ++i) {
            least = std::min(least, values[i]);
            most = std::max(most, values[i]);
        }
    }
    return {least, most};
}

FrameInput PlotRecord::instant(double time_s) const {
    return {motion_->sample(time_s, quantity_->needs), time_s};
}

int n_pieces_of(const StageContext& stage, double width_px) {
    const double n_turns = (stage.film_last_s - stage.film_first_s) *
                           (2.0 * stage.quickest_rate_rad_s()) / std::numbers::pi;
    return static_cast<int>(std::clamp(n_turns, 16.0, std::max(16.0, 2.0 * width_px)));
}

bool is_ruined(const PlotQuantity& quantity, std::pair<double, double> whole,
               std::pair<double, double> after_start) {
    if (quantity.from_zero) {
        for (auto* range : {&whole, &after_start}) {
            range->first = std::min(range->first, 0.0);
            range->second = std::max(range->second, 0.0);
        }
    }
    const double rest = after_start.second - after_start.first;
    const double all = whole.second - whole.first;
    // On a logarithmic axis, three extra decades are too many.
    if (quantity.decades) return all - rest >= 3.0;
    // A motion that comes to rest is shown with its start, and the rounding noise of a constant is
    // not a range.
    constexpr double times = 4.0;
    constexpr double at_rest = 1e-3;
    constexpr double rounding = 1e-9;
    const double largest = std::max(std::abs(whole.first), std::abs(whole.second));
    return all > times * rest && rest > at_rest * all && rest > rounding * largest;
}

std::pair<double, double> common_range(const PlotQuantity& quantity,
                                       std::pair<double, double> first,
                                       std::pair<double, double> beside) {
    if (quantity.from_zero) first = {std::min(first.first, 0.0), std::max(first.second, 0.0)};
    const double most_added = quantity.decades ? INFINITY : first.second - first.first;
    return {std::min(first.first, std::max(beside.first, first.first - most_added)),
            std::max(first.second, std::min(beside.second, first.second + most_added))};
}

}  // namespace poinsot
