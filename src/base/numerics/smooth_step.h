// A step without corners.
#pragma once

#include <algorithm>

namespace poinsot {

// 0 for u ≤ 0, 1 for u ≥ 1, and 3u² − 2u³ between them.
inline double smooth_step(double u) {
    const double v = std::clamp(u, 0.0, 1.0);
    return v * v * (3.0 - 2.0 * v);
}

}  // namespace poinsot
