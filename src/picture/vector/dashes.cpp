#include "vector/dashes.h"

#include <algorithm>
#include <cmath>

namespace poinsot::vector {

namespace {

Dash stretched(const Dash& dash, double factor) {
    return {factor * dash.on_pt, factor * dash.off_pt};
}

int n_gaps(DashEnd begin, DashEnd end) {
    return (begin == DashEnd::gap ? 1 : 0) + (end == DashEnd::gap ? 1 : 0);
}

}  // namespace

Dash fitted_dash(const Dash& wanted, double length_pt, DashEnd begin, DashEnd end) {
    // n dashes have n − 1 gaps between them, and those at the ends.
    const int at_ends = n_gaps(begin, end);
    const double fewest = at_ends == 0 ? 2.0 : 1.0;
    const double fitting =
        (length_pt + (1 - at_ends) * wanted.off_pt) / (wanted.on_pt + wanted.off_pt);
    const double n = std::max(fewest, std::round(fitting));
    return stretched(wanted, length_pt / (n * wanted.on_pt + (n - 1.0 + at_ends) * wanted.off_pt));
}

Dash fitted_dash(const Dash& wanted, double length_pt) {
    const double period = wanted.on_pt + wanted.off_pt;
    return stretched(wanted, length_pt / (std::max(1.0, std::round(length_pt / period)) * period));
}

DashPattern dashes_along(const Dash& wanted, std::span<const double> pieces_pt, DashEnd begin,
                         DashEnd end) {
    if (pieces_pt.size() == 1) {
        const Dash dash = fitted_dash(wanted, pieces_pt[0], begin, end);
        return {{dash.on_pt, dash.off_pt}, begin == DashEnd::gap ? dash.on_pt : 0.0};
    }
    // The pattern of the whole line, in which the dashes on both sides of a corner are one. Its
    // last gap is the one at the end and the one at the beginning together.
    DashPattern pattern;
    double first_gap_pt = 0.0, last_gap_pt = 0.0;
    for (std::size_t k = 0; k < pieces_pt.size(); ++k) {
        const DashEnd from = k == 0 ? begin : DashEnd::dash;
        const DashEnd to = k + 1 == pieces_pt.size() ? end : DashEnd::dash;
        const Dash dash = fitted_dash(wanted, pieces_pt[k], from, to);
        const double total = pieces_pt[k] + (1 - n_gaps(from, to)) * dash.off_pt;
        const auto n = static_cast<int>(std::lround(total / (dash.on_pt + dash.off_pt)));
        if (from == DashEnd::gap) first_gap_pt = dash.off_pt;
        if (to == DashEnd::gap) last_gap_pt = dash.off_pt;
        for (int i = 0; i < n; ++i) {
            if (i == 0 && k > 0) {
                pattern.lengths_pt.back() += dash.on_pt;
                continue;
            }
            if (i > 0) pattern.lengths_pt.push_back(dash.off_pt);
            pattern.lengths_pt.push_back(dash.on_pt);
        }
    }
    pattern.lengths_pt.push_back(last_gap_pt + first_gap_pt);
    if (first_gap_pt > 0.0) {
        for (const double length : pattern.lengths_pt) pattern.offset_pt += length;
        pattern.offset_pt -= first_gap_pt;
    }
    return pattern;
}

double length_on_paper(const Projection& projection, const Track& track, double from, double to) {
    // Gauss–Legendre quadrature of the speed with five points, on a quarter of each smooth
    // interval.
    constexpr double places[] = {0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    constexpr int n_parts = 4;
    const auto speed = [&](double s) {
        return on_paper(projection, track.flow(s)).velocity.norm();
    };
    std::vector<double> ends{from};
    for (const double knot : track.knots)
        if (from < knot && knot < to) ends.push_back(knot);
    ends.push_back(to);
    double length = 0.0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double half = 0.5 * (ends[k] - ends[k - 1]) / n_parts;
        for (int part = 0; part < n_parts; ++part) {
            const double middle = ends[k - 1] + (2 * part + 1) * half;
            length += half * weights[0] * speed(middle);
            for (int i = 1; i < 3; ++i)
                length += half * weights[i] *
                          (speed(middle - half * places[i]) + speed(middle + half * places[i]));
        }
    }
    return length;
}

std::vector<double> corners_between(const Projection& projection, const Track& track, double from,
                                    double to) {
    constexpr double least_cosine = 0.9;
    std::vector<double> corners;
    const double beside = 1e-9 * (to - from);
    for (const double knot : track.knots) {
        if (!(from + beside < knot && knot < to - beside)) continue;
        const Eigen::Vector2d before = on_paper(projection, track.flow(knot - beside)).velocity;
        const Eigen::Vector2d after = on_paper(projection, track.flow(knot + beside)).velocity;
        if (before.dot(after) < least_cosine * before.norm() * after.norm())
            corners.push_back(knot);
    }
    return corners;
}

}  // namespace poinsot::vector
