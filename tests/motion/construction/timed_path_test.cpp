// Paths with their instants.
#include "construction/timed_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "construction/adaptive_curve.h"
#include "mechanics/motion.h"

namespace poinsot {
namespace {

// A quarter of the turn of a slow body may be centuries beyond the end of its film.
TEST(TimedPath, GoesOnForAFewStretchesAtMost) {
    const auto line = [](double t) { return Eigen::Vector3d(t, 0.0, 0.0); };
    for (const double feature_s : {1.0, 1e10, 1e300}) {
        const TimedPath path = sample_path(line, 5.0, 7.0, feature_s, 1e-3);
        EXPECT_LE(path.times_s.front(), 5.0) << feature_s;
        EXPECT_GE(path.times_s.back(), 7.0) << feature_s;
        EXPECT_LE(path.times_s.back(), 5.0 + 2.0 * longest_piece_spans) << feature_s;
    }
    EXPECT_EQ(sample_path(line, 5.0, 5.0, 1e10, 1e-3).index_at(5.0), 0.0);
}

// Rounding noise: halving brings it no nearer to its chord.
TEST(TimedPath, GivesUpWhereTheCurveIsLost) {
    int n_evaluations = 0;
    const auto noisy = [&n_evaluations](double t) {
        ++n_evaluations;
        const double noise = std::fmod(1e9 * std::sin(1e9 * t), 1.0);
        return Eigen::Vector3d(t, t > 0.25 ? noise : 0.0, 0.0);
    };
    const SampledCurve curve = sample_adaptively(noisy, {.tolerance = 1e-3});
    EXPECT_GT(curve.off, 0.1);
    EXPECT_LT(n_evaluations, 500);
}

}  // namespace
}  // namespace poinsot
