// Tracks of keyframes: continuous velocities, values that do not overshoot, and correct integrals.
#include "scene/track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace poinsot {
namespace {

double velocity(const Track& track, double film_s) {
    constexpr double h = 1e-5;
    return (track.at(film_s + h) - track.at(film_s - h)) / (2.0 * h);
}

Track through(const std::vector<std::pair<double, double>>& keys) {
    Track track(keys.front().second);
    for (std::size_t i = 1; i < keys.size(); ++i)
        track.add(keys[i].first, keys[i].second,
                  easing_named(i + 1 < keys.size() ? "through" : "smooth"));
    return track;
}

TEST(Track, PassesKeysWithoutStopping) {
    const Track track = through({{0.0, 0.0}, {2.0, 30.0}, {3.0, 50.0}, {6.0, 80.0}, {8.0, 120.0}});
    EXPECT_EQ(track.at(2.0), 30.0);
    EXPECT_EQ(track.at(3.0), 50.0);
    EXPECT_EQ(track.at(6.0), 80.0);
    EXPECT_EQ(track.at(8.0), 120.0);
    EXPECT_NEAR(velocity(track, 0.0), 0.0, 1e-3);
    EXPECT_NEAR(velocity(track, 8.0), 0.0, 1e-3);
    for (const double key_s : {2.0, 3.0, 6.0}) {
        const double before = velocity(track, key_s - 1e-4);
        const double after = velocity(track, key_s + 1e-4);
        EXPECT_NEAR(before, after, 0.02) << key_s;  // the curvature times 2e-4
        EXPECT_GT(before, 5.0) << key_s;            // does not stop: 15 per second on average
    }
    // A track that stops, for comparison.
    Track halting(0.0);
    halting.add(2.0, 30.0, easing_named("smooth"));
    halting.add(3.0, 50.0, easing_named("smooth"));
    EXPECT_NEAR(velocity(halting, 2.0), 0.0, 1e-2);
}

// A uniform motion stays uniform between its first and last keys.
TEST(Track, KeepsUniformMotion) {
    const Track track = through({{0.0, 0.0}, {1.0, 3.0}, {2.0, 6.0}, {3.0, 9.0}, {4.0, 12.0}});
    for (double film_s = 1.0; film_s <= 3.0; film_s += 0.125)
        EXPECT_NEAR(track.at(film_s), 3.0 * film_s, 1e-12);
}

TEST(Track, StaysBetweenItsKeysAndIntegratesItsValues) {
    std::mt19937 random(16);
    std::uniform_real_distribution<double> value(-10.0, 10.0);
    std::uniform_real_distribution<double> step(0.2, 3.0);
    const std::vector<const char*> names{"through", "through", "smooth", "linear",
                                         "hold",    "in",      "out",    "smoother"};
    for (int round = 0; round < 200; ++round) {
        std::vector<double> at{0.0};
        std::vector<double> values{value(random)};
        Track track(values.back());
        for (int k = 0; k < 7; ++k) {
            at.push_back(at.back() + step(random));
            values.push_back(value(random));
            track.add(at.back(), values.back(), easing_named(names[random() % names.size()]));
        }
        double integral = 0.0;
        for (std::size_t k = 0; k + 1 < at.size(); ++k) {
            const double low = std::min(values[k], values[k + 1]);
            const double high = std::max(values[k], values[k + 1]);
            // Simpson's rule is exact for cubics, and nearly so for the quintic.
            constexpr int n = 256;
            const double h = (at[k + 1] - at[k]) / n;
            for (int i = 0; i < n; ++i) {
                const double a = track.at(at[k] + h * i);
                const double b = track.at(at[k] + h * (i + 0.5));
                const double c = i + 1 < n ? track.at(at[k] + h * (i + 1))
                                           : track.at(std::nextafter(at[k + 1], 0.0));
                integral += h / 6.0 * (a + 4.0 * b + c);
                EXPECT_GE(b, low - 1e-9);
                EXPECT_LE(b, high + 1e-9);
            }
            EXPECT_NEAR(track.integral(at[k + 1]), integral, 1e-7) << round << " " << k;
        }
    }
}

}  // namespace
}  // namespace poinsot
