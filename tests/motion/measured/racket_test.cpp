// Real throws of one racket (racket/README.md): what fits of the single throws say about its
// moments, and how far they agree with each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "measured/fit.h"
#include "places.h"

namespace poinsot {

namespace {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::vector<FittedMotion> fitted_throws(const std::optional<DragModel>& drag = {}) {
    std::vector<FittedMotion> fits;
    const auto folder = source_folder() / "tests" / "motion" / "measured" / "racket";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".csv") continue;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        fits.push_back(fit_motion(read_measured(text, entry.path().string()).rows, {}, drag));
    }
    return fits;
}

// Pendulums gave I3/I1 = 0.067 ± 0.013 for this racket and I2/I1 = 0.91 within their much larger
// uncertainty; the phone's z axis is normal to the strings, its y axis along the handle. The
// scatter is 1.4826 times the median of the distances from the median, a standard deviation for
// normal errors; an honest deviation is about as large, and larger where a few throws lie far off.
TEST(Racket, SingleThrowsAgreeWithinTheirStatedDeviations) {
    const std::vector<FittedMotion> fits = fitted_throws();
    ASSERT_EQ(fits.size(), 57U);
    for (const int k : {1, 2}) {
        std::vector<double> ratios, stated, distances;
        for (const FittedMotion& fit : fits) ratios.push_back(fit.moments[k]);
        const double middle = median_of(ratios);
        for (const FittedMotion& fit : fits) {
            stated.push_back(fit.moments_sd[k]);
            distances.push_back(1.4826 * std::abs(fit.moments[k] - middle));
        }
        const double share = median_of(distances) / median_of(stated);
        EXPECT_GT(share, 0.5) << k;
        EXPECT_LT(share, 1.5) << k;
        EXPECT_NEAR(middle, k == 1 ? 0.91 : 0.067, k == 1 ? 0.05 : 0.013);
    }
    for (const FittedMotion& fit : fits) {
        EXPECT_GT(std::abs(fit.instrument_from_principal(2, 0)), 0.97);
        EXPECT_GT(std::abs(fit.instrument_from_principal(1, 2)), 0.97);
    }
}

// Slow throws turn once, so that drags which leave as little say other moments. All throws together
// give 0.933 and 0.070; the deviations of each speed are those from there.
TEST(Racket, ThrowsOfEachSpeedAgreeWithinTheirStatedDeviations) {
    struct Speed {
        double least_rad_s, most_rad_s;
        double squares = 0.0;
        int n = 0;
    };
    Speed speeds[] = {{0.0, 9.0}, {9.0, 10.5}, {10.5, 13.0}, {13.0, 40.0}};
    for (const FittedMotion& fit : fitted_throws())
        for (Speed& speed : speeds) {
            const double rate = fit.omega_rad_s.norm();
            if (rate < speed.least_rad_s || rate >= speed.most_rad_s) continue;
            speed.squares += std::pow((fit.moments[1] - 0.933) / fit.moments_sd[1], 2) +
                             std::pow((fit.moments[2] - 0.070) / fit.moments_sd[2], 2);
            speed.n += 2;
        }
    for (const Speed& speed : speeds) {
        ASSERT_GE(speed.n, 12) << speed.least_rad_s;
        const double rms = std::sqrt(speed.squares / speed.n);
        RecordProperty("from_" + std::to_string(speed.least_rad_s), std::to_string(rms));
        EXPECT_GT(rms, 0.6) << speed.least_rad_s;
        EXPECT_LT(rms, 1.35) << speed.least_rad_s;
    }
}

// What the fit leaves is the air and the instrument: the noise of the rows is 0.0026 rad/s.
TEST(Racket, MedianResidualIsBelow35Millirad) {
    std::vector<double> residuals;
    for (const FittedMotion& fit : fitted_throws()) residuals.push_back(fit.residual);
    EXPECT_LT(median_of(residuals), 0.035);
}

// A racket that falls faster and faster is slowed more and more: in each of the throws.
TEST(Racket, AirSlowsItMoreAsItFalls) {
    for (const FittedMotion& fit : fitted_throws(DragModel::growing)) {
        EXPECT_GT(fit.drag_rates[0], 0.0);
        EXPECT_GT(fit.drag_rates[1], 0.0);
    }
}

}  // namespace

}  // namespace poinsot
