// Families of extreme heavy tops, generated from seeds, and the difference of the exact motion from
// the Taylor integration.
#pragma once

#include <random>
#include <span>
#include <string_view>

#include "mechanics/top/heavy_top.h"

namespace poinsot::tops {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high);

// A top of ordinary size, with either sign of Mgl, in any position.
HeavyTopProblem generic_top(Random& random);

struct Family {
    std::string_view name;
    HeavyTopProblem (*draw)(Random& random);
    double duration_s;
    bool amplifies;             // so strongly that long double's 64 bits do not suffice
    bool of_any_scale = false;  // the duration is in units of the time of the fastest turn
};

std::span<const Family> all();

// The largest differences from the oracle over tops first … last−1 of a family, each from its own
// seed, at four instants, before the start for every fourth one.
struct Residuals {
    double attitude = 0.0;  // largest component of the quaternion's difference
    double omega = 0.0;     // of ω's, relative to the larger of |ω| and √(|Mgl|/A)
};
Residuals measure(const Family& family, int first, int last);

// Bounds for every family.
inline constexpr Residuals bounds{1.1e-15, 1.1e-15};

}  // namespace poinsot::tops
