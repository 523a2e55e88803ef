#include "drawing/stage/type/spread_apart.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace poinsot {

std::vector<double> spread_apart(const std::vector<double>& wished,
                                 const std::vector<double>& heights, double gap, double least,
                                 double most) {
    const std::size_t n = wished.size();
    if (n == 0) return {};
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return wished[i] < wished[j]; });

    // Packed as closely as possible, the k-th item has its middle at packed[k]. The differences to
    // these only have to be non-decreasing: isotonic regression, by merging neighbours out of order
    // into blocks at the mean (Barlow, Bartholomew, Bremner & Brunk 1972).
    std::vector<double> packed(n, 0.0);
    struct Block {
        double sum;
        std::size_t count;
        double mean() const { return sum / static_cast<double>(count); }
    };
    std::vector<Block> blocks;
    for (std::size_t k = 0; k < n; ++k) {
        if (k > 0) {
            const double apart = 0.5 * (heights[order[k - 1]] + heights[order[k]]) + gap;
            packed[k] = packed[k - 1] + apart;
        }
        blocks.push_back({wished[order[k]] - packed[k], 1});
        while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() >= blocks.back().mean()) {
            const Block last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().count += last.count;
        }
    }

    const double lowest = least + 0.5 * heights[order.front()];
    const double highest = most - 0.5 * heights[order.back()] - packed.back();
    std::vector<double> middles(n);
    std::size_t k = 0;
    for (const Block& block : blocks) {
        const double base = std::max(lowest, std::min(highest, block.mean()));
        for (const std::size_t end = k + block.count; k < end; ++k) {
            middles[order[k]] = base + packed[k];
        }
    }
    return middles;
}

}  // namespace poinsot
