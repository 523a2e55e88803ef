#include "bodies/circle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poinsot {

Eigen::Vector2d on_unit_circle(int i, int n) {
    const int quarter = n / 4;
    const int in_quarter = i % quarter;
    const double angle = 2.0 * std::numbers::pi * std::min(in_quarter, quarter - in_quarter) / n;
    double c = std::cos(angle);
    double s = std::sin(angle);
    if (2 * in_quarter > quarter) std::swap(c, s);
    switch (i / quarter % 4) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

double equal_area_factor(int n) {
    const double step = 2.0 * std::numbers::pi / n;
    return std::sqrt(step / std::sin(step));
}

std::vector<ProfilePoint> tube_profile(double centre_line_radius_m, double tube_radius_m, int n) {
    std::vector<ProfilePoint> profile;
    const double factor = equal_area_factor(n);
    for (int i = 0; i < n; ++i) {
        const Eigen::Vector2d at = factor * tube_radius_m * on_unit_circle(i, n);
        profile.push_back({centre_line_radius_m + at.x(), at.y()});
    }
    return profile;
}

}  // namespace poinsot
