#include "vector/gradients.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "vector/paper_flow.h"

namespace poinsot::vector {

namespace {

using Place = std::pair<double, double>;
Place place_of(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

Eigen::Vector3d vector_of(const Colour& c) { return {c.r, c.g, c.b}; }
Colour colour_of(const Eigen::Vector3d& v) {
    const auto component = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return {component(v.x()), component(v.y()), component(v.z())};
}

// The colours of points by one linear gradient: constant + slope·(direction·(p − origin)).
struct Gradient {
    Eigen::Vector2d origin, direction;
    Eigen::Vector3d constant, slope;

    double along(const Eigen::Vector2d& p) const { return direction.dot(p - origin); }
    Eigen::Vector3d at(double t) const { return constant + t * slope; }
};

// Triangles under one gradient.
class Region {
 public:
    Region(std::span<const ShadedTriangle> all, double most_off) : all_(all), most_off_(most_off) {}

    // Adds a triangle if one gradient still fits all corners.
    bool take(std::size_t number) {
        triangles_.push_back(number);
        // Without shading a whole body has one colour.
        const bool was_uniform =
            std::exchange(is_uniform_, is_uniform_ && has_first_colour(number));
        if (is_uniform_) return true;
        const Gradient gradient = fitted();
        const double most_off = allowed();
        for (const std::size_t k : triangles_)
            for (int i = 0; i < 3; ++i) {
                const Eigen::Vector3d off =
                    gradient.at(gradient.along(all_[k].corners[i])) - vector_of(all_[k].colours[i]);
                if (off.cwiseAbs().maxCoeff() <= most_off) continue;
                if (triangles_.size() > 1) {
                    triangles_.pop_back();
                    is_uniform_ = was_uniform;
                }
                return false;
            }
        return true;
    }

    // The fill, continued under triangles that will be filled later: viewers blend both with the
    // background at a common edge, which would show as a seam.
    Fill fill(const std::vector<std::size_t>& under) const {
        const Gradient gradient = fitted();
        double low = 1e300, high = -1e300;
        for (const std::size_t k : triangles_)
            for (const Eigen::Vector2d& corner : all_[k].corners) {
                low = std::min(low, gradient.along(corner));
                high = std::max(high, gradient.along(corner));
            }
        Fill fill;
        std::vector<std::size_t> all = triangles_;
        all.insert(all.end(), under.begin(), under.end());
        fill.path = outline(all);
        const double unseen = 0.5 * allowed();
        if ((gradient.slope * (high - low)).cwiseAbs().maxCoeff() < unseen)
            fill.paint = PaperInk{colour_of(gradient.at(0.5 * (low + high))), 1.0};
        else
            fill.paint = LinearFade{gradient.origin + low * gradient.direction,
                                    gradient.origin + high * gradient.direction,
                                    {{0.0, {colour_of(gradient.at(low)), 1.0}},
                                     {1.0, {colour_of(gradient.at(high)), 1.0}}}};
        return fill;
    }

 private:
    bool has_first_colour(std::size_t number) const {
        const auto& colours = all_[number].colours;
        return std::all_of(std::begin(colours), std::end(colours), [&](const Colour& colour) {
            return colour == all_[triangles_[0]].colours[0];
        });
    }

    // The allowed deviation: larger on small details, such as the strings of a racket.
    double allowed() const {
        constexpr double full_size_pt = 4.0, most = 6.0;
        Eigen::Vector2d low(1e300, 1e300), high = -low;
        for_each_corner([&](const Eigen::Vector2d& p, const Eigen::Vector3d&) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        });
        const double size_pt = std::max((high - low).norm(), 1e-9);
        return most_off_ * std::clamp(full_size_pt / size_pt, 1.0, most);
    }

    // By least squares: the direction from a plane through the tones, then a line for each
    // component.
    Gradient fitted() const {
        Gradient gradient;
        const double n = 3.0 * static_cast<double>(triangles_.size());
        gradient.origin.setZero();
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for_each_corner([&](const Eigen::Vector2d& p, const Eigen::Vector3d& colour) {
            gradient.origin += p / n;
            mean += colour / n;
        });
        Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
        Eigen::Vector2d product = Eigen::Vector2d::Zero();
        for_each_corner([&](const Eigen::Vector2d& p, const Eigen::Vector3d& colour) {
            const Eigen::Vector2d off = p - gradient.origin;
            square += off * off.transpose();
            product += off * (colour - mean).sum();
        });
        // Points on one line have no gradient across it.
        square += 1e-9 * square.trace() * Eigen::Matrix2d::Identity();
        const Eigen::Vector2d tone = square.inverse() * product;
        gradient.direction =
            tone.norm() > 1e-12 ? tone.normalized().eval() : Eigen::Vector2d::UnitX();
        gradient.constant = mean;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double sum_square = 0.0;
        for_each_corner([&](const Eigen::Vector2d& p, const Eigen::Vector3d& colour) {
            const double t = gradient.along(p);
            sum += t * (colour - mean);
            sum_square += t * t;
        });
        gradient.slope = sum / std::max(sum_square, 1e-300);
        return gradient;
    }

    template <typename Function>
    void for_each_corner(const Function& function) const {
        for (const std::size_t k : triangles_)
            for (int i = 0; i < 3; ++i) function(all_[k].corners[i], vector_of(all_[k].colours[i]));
    }

    // The common outline: sides that two triangles share run in both directions and cancel.
    Path outline(const std::vector<std::size_t>& triangles) const {
        std::map<Place, std::vector<Place>> sides;
        const auto take = [&sides](const Place& from, const Place& to) {
            const auto found = sides.find(from);
            if (found == sides.end()) return false;
            const auto at = std::find(found->second.begin(), found->second.end(), to);
            if (at == found->second.end()) return false;
            found->second.erase(at);
            if (found->second.empty()) sides.erase(found);
            return true;
        };
        for (const std::size_t number : triangles) {
            const auto& p = all_[number].corners;
            const bool turned = cross(p[1] - p[0], p[2] - p[0]) < 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                Place a = place_of(p[k]), b = place_of(p[(k + 1) % 3]);
                if (turned) std::swap(a, b);
                if (!take(b, a)) sides[a].push_back(b);
            }
        }
        Path path;
        while (!sides.empty()) {
            const Place start = sides.begin()->first;
            Place at = start;
            path.move({at.first, at.second});
            do {
                const Place next = sides.at(at).back();
                take(at, next);
                at = next;
                if (at != start) path.line({at.first, at.second});
            } while (at != start && sides.contains(at));
            path.close();
        }
        return path;
    }

    std::span<const ShadedTriangle> all_;
    double most_off_;
    std::vector<std::size_t> triangles_;
    bool is_uniform_ = true;  // all corners have one colour
};

// The neighbours of each triangle, across its sides.
using Neighbours = std::vector<std::vector<std::size_t>>;
Neighbours neighbours_of(std::span<const ShadedTriangle> triangles) {
    std::map<std::pair<Place, Place>, std::vector<std::size_t>> at_side;
    for (std::size_t k = 0; k < triangles.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            const Place a = place_of(triangles[k].corners[i]);
            const Place b = place_of(triangles[k].corners[(i + 1) % 3]);
            at_side[{std::min(a, b), std::max(a, b)}].push_back(k);
        }
    Neighbours neighbours(triangles.size());
    for (const auto& [side, both] : at_side)
        for (const std::size_t a : both)
            for (const std::size_t b : both)
                if (a != b) neighbours[a].push_back(b);
    return neighbours;
}

std::vector<Fill> fills_of(std::span<const ShadedTriangle> triangles, const Neighbours& neighbours,
                           const std::vector<std::size_t>& order, double most_off) {
    std::vector<bool> is_filled(triangles.size(), false);
    std::vector<Fill> fills;
    for (const std::size_t seed : order) {
        if (is_filled[seed]) continue;
        Region region(triangles, most_off);
        region.take(seed);
        is_filled[seed] = true;
        // In the order of their distance in steps, so that regions are compact.
        std::vector<std::size_t> reached{seed};
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (const std::size_t beside : neighbours[reached[next]])
                if (!is_filled[beside] && triangles[beside].layer == triangles[seed].layer &&
                    region.take(beside)) {
                    is_filled[beside] = true;
                    reached.push_back(beside);
                }
        std::set<std::size_t> under;
        for (const std::size_t number : reached)
            for (const std::size_t beside : neighbours[number])
                if (!is_filled[beside]) under.insert(beside);
        fills.push_back(region.fill({under.begin(), under.end()}));
    }
    return fills;
}

}  // namespace

std::vector<Fill> gradient_fills(std::span<const ShadedTriangle> triangles, double most_off,
                                 std::size_t wanted_fills) {
    const Neighbours neighbours = neighbours_of(triangles);
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return triangles[a].layer < triangles[b].layer;
    });
    constexpr double coarser = 1.4, coarsest = 10.0 / 255.0;
    for (double off = most_off;; off *= coarser) {
        std::vector<Fill> fills = fills_of(triangles, neighbours, order, off);
        if (fills.size() <= wanted_fills || off > coarsest) return fills;
    }
}

}  // namespace poinsot::vector
