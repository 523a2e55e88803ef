#include "shapes/depth_order.h"

#include <algorithm>
#include <cmath>

namespace poinsot {
namespace {

// The depth of an axis where it is nearest to a position in the picture.
double depth_near(const SeenAxis& axis, const Eigen::Vector2d& at, bool perspective) {
    const Eigen::Vector2d run = axis.tip.at - axis.tail.at;
    const double square = run.squaredNorm();
    const double t = square > 0.0 ? std::clamp(run.dot(at - axis.tail.at) / square, 0.0, 1.0) : 0.0;
    const double from = axis.tail.depth, to = axis.tip.depth;
    return perspective ? from * to / (to + t * (from - to)) : from + t * (to - from);
}

// The position where two arrows may cover each other: the crossing of their axes, or else the
// middle of the shorter one.
Eigen::Vector2d meeting_of(const SeenAxis& a, const SeenAxis& b) {
    const Eigen::Vector2d u = a.tip.at - a.tail.at, v = b.tip.at - b.tail.at;
    const Eigen::Vector2d w = b.tail.at - a.tail.at;
    const auto cross = [](const Eigen::Vector2d& x, const Eigen::Vector2d& y) {
        return x.x() * y.y() - x.y() * y.x();
    };
    const double area = cross(u, v);
    if (std::abs(area) > 1e-9 * u.norm() * v.norm()) {
        const double s = cross(w, v) / area, t = cross(w, u) / area;
        // A common tail does not count as a crossing: there, the arrow that points towards the eye
        // is in front.
        if (s > 0.02 && s < 1.0 && t > 0.02 && t < 1.0) return a.tail.at + s * u;
    }
    return 0.5 * (u.norm() < v.norm() ? a.tail.at + a.tip.at : b.tail.at + b.tip.at);
}

}  // namespace

std::vector<std::size_t> back_to_front(std::span<const SeenAxis> arrows,
                                       std::span<const SeenPoint> dots, bool perspective) {
    constexpr double same = 1.0 - 1e-9;
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < arrows.size() + dots.size(); ++k) {
        // Whether `other`, already in the list, lies behind; the order of the others does not
        // change.
        const auto is_behind = [&](std::size_t other) {
            if (k < arrows.size()) {
                const Eigen::Vector2d meeting = meeting_of(arrows[k], arrows[other]);
                return depth_near(arrows[other], meeting, perspective) >=
                       same * depth_near(arrows[k], meeting, perspective);
            }
            const SeenPoint& dot = dots[k - arrows.size()];
            if (other >= arrows.size())
                return dots[other - arrows.size()].depth >= same * dot.depth;
            // A dot on an arrow is in front of the arrow.
            return depth_near(arrows[other], dot.at, perspective) >= dot.depth * (1.0 - 1e-2);
        };
        order.insert(std::find_if_not(order.begin(), order.end(), is_behind), k);
    }
    return order;
}

}  // namespace poinsot
