#include "shapes/arrow_separation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "shapes/projection.h"

namespace poinsot {

namespace {

double distance_to_segment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                           const Eigen::Vector2d& to) {
    const Eigen::Vector2d way = to - from;
    const double length2 = way.squaredNorm();
    const double u = length2 > 0.0 ? std::clamp((point - from).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (from + u * way - point).norm();
}

// View, and indices of two arrows in it.
using PairOfArrows = std::tuple<int, int, int>;

template <typename Function>
void for_each_pair(const std::vector<PlacedArrow>& arrows, const Function& function) {
    for (std::size_t i = 0; i < arrows.size(); ++i)
        for (std::size_t j = i + 1; j < arrows.size(); ++j)
            if (arrows[i].view == arrows[j].view)
                function(PairOfArrows{arrows[i].view, arrows[i].index, arrows[j].index}, arrows[i],
                         arrows[j]);
}

}  // namespace

void append_arrows(const View& view, int index_of_view, std::vector<PlacedArrow>& arrows) {
    constexpr double least_opacity = 0.05;
    const Projection projection(view);
    const auto is_in_front = [&](const Eigen::Vector3d& point) {
        return !projection.perspective || projection.depth(point) > projection.near_depth;
    };
    for (std::size_t i = 0; i < view.arrows.size(); ++i) {
        const Arrow& arrow = view.arrows[i];
        const Eigen::Vector3d way = arrow.tip - arrow.tail;
        const double length = way.norm();
        if (arrow.opacity < least_opacity || !(length > 0.0) || !is_in_front(arrow.tail) ||
            !is_in_front(arrow.tip))
            continue;
        arrows.push_back({index_of_view, static_cast<int>(i), projection.place(arrow.tail),
                          projection.place(arrow.tip), way / length});
    }
}

double separation_px(const PlacedArrow& a, const PlacedArrow& b) {
    return std::min(distance_to_segment(a.tip_px, b.tail_px, b.tip_px),
                    distance_to_segment(b.tip_px, a.tail_px, a.tip_px));
}

std::size_t clearest_picture(std::span<const std::vector<PlacedArrow>> pictures, double step_px,
                             double enough_px) {
    constexpr double parallel = 1e-6;  // sine of the angle
    std::map<PairOfArrows, bool> is_ever_apart;
    for (const auto& arrows : pictures)
        for_each_pair(arrows, [&](const PairOfArrows& pair, const auto& a, const auto& b) {
            is_ever_apart[pair] |= a.direction.cross(b.direction).norm() > parallel;
        });
    std::size_t best = 0;
    double best_steps = -1.0;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        double least_px = enough_px;
        for_each_pair(pictures[k], [&](const PairOfArrows& pair, const auto& a, const auto& b) {
            if (is_ever_apart.at(pair)) least_px = std::min(least_px, separation_px(a, b));
        });
        const double steps = std::floor(least_px / step_px);
        if (steps < best_steps) continue;
        best = k;
        best_steps = steps;
    }
    return best;
}

}  // namespace poinsot
