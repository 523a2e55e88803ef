// The unit in which a film's time is told: days for an asteroid, milliseconds for a coin.
#pragma once

#include <string_view>

namespace poinsot {

struct TimeUnit {
    std::string_view name = "s";
    double seconds = 1.0;
};

// The unit in which a span of this many seconds is some tens of units, or a few.
constexpr TimeUnit time_unit_of(double span_s) {
    if (span_s >= 3.0 * 86400.0) return {"d", 86400.0};
    if (span_s >= 3.0 * 3600.0) return {"h", 3600.0};
    if (span_s < 0.05) return {"ms", 1e-3};
    return {};
}

}  // namespace poinsot
