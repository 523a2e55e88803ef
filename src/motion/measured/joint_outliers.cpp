#include "measured/joint_outliers.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poinsot {

namespace {

double median_in(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

using BodyNumbers = Eigen::Matrix<double, 5, 1>;
constexpr std::array<const char*, 5> names_of_body{
    "I2/I1", "I3/I1", "axes (turned about e1)", "axes (turned about e2)", "axes (turned about e3)"};

// ln I2, ln I3 and small turns from a reference.
BodyNumbers numbers_of(const FittedMotion& fit, const FittedMotion& reference) {
    Eigen::Matrix3d axes = fit.instrument_from_principal;
    for (int k = 0; k < 3; ++k)
        if (axes.col(k).dot(reference.instrument_from_principal.col(k)) < 0.0) axes.col(k) *= -1.0;
    const Eigen::Matrix3d turn = reference.instrument_from_principal.transpose() * axes;
    BodyNumbers numbers;
    numbers << std::log(fit.moments[1]), std::log(fit.moments[2]), 0.5 * (turn(2, 1) - turn(1, 2)),
        0.5 * (turn(0, 2) - turn(2, 0)), 0.5 * (turn(1, 0) - turn(0, 1));
    return numbers;
}
BodyNumbers deviations_of(const FittedMotion& fit) {
    BodyNumbers sd;
    sd << fit.moments_sd[1] / fit.moments[1], fit.moments_sd[2] / fit.moments[2], fit.axes_sd_rad;
    return sd;
}

}  // namespace

std::size_t most_typical(const std::vector<JointFlight>& flights) {
    std::vector<double> second, third;
    for (const JointFlight& flight : flights)
        if (flight.own) {
            second.push_back(std::log(flight.own->moments[1]));
            third.push_back(std::log(flight.own->moments[2]));
        }
    if (second.empty()) return 0;
    const double middle_2 = median_in(second), middle_3 = median_in(third);
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < flights.size(); ++i) {
        if (!flights[i].own) continue;
        const double off = std::hypot(std::log(flights[i].own->moments[1]) - middle_2,
                                      std::log(flights[i].own->moments[2]) - middle_3);
        if (off < least) {
            least = off;
            best = i;
        }
    }
    return best;
}

void leave_outliers_out(std::vector<JointFlight>& flights, const FittedMotion& reference) {
    std::vector<std::size_t> with_own;
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (flights[i].own) with_own.push_back(i);
    constexpr std::size_t least_flights = 5;
    if (with_own.size() < least_flights) return;
    std::vector<double> farthest(flights.size(), 0.0);
    for (int k = 0; k < 5; ++k) {
        std::vector<double> values, distances;
        for (const std::size_t i : with_own)
            values.push_back(numbers_of(*flights[i].own, reference)[k]);
        const double middle = median_in(values);
        for (const double value : values) distances.push_back(std::abs(value - middle));
        constexpr double of_normal = 1.4826;
        const double scatter = of_normal * median_in(distances);
        for (std::size_t j = 0; j < with_own.size(); ++j) {
            const std::size_t i = with_own[j];
            const double sd = std::hypot(scatter, deviations_of(*flights[i].own)[k]);
            const double off = sd > 0.0 ? distances[j] / sd : 0.0;
            if (!(off > outlier_deviations) || off < farthest[i]) continue;
            farthest[i] = off;
            flights[i].left_out =
                fmt::format("its {} {} {:.2g} deviations from the median",
                            names_of_body[static_cast<std::size_t>(k)], k < 2 ? "is" : "are", off);
        }
    }
}

}  // namespace poinsot
