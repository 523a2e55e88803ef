// The unit in which a film's time is shown: days for an asteroid, milliseconds for a coin,
// nanoseconds for a molecule.
#pragma once

#include <string_view>

namespace poinsot {

struct TimeUnit {
    std::string_view name = "s";
    double seconds = 1.0;
};

// The unit in which this span is a few to some tens of units.
constexpr TimeUnit time_unit_of(double span_s) {
    constexpr double year_s = 365.25 * 86400.0;  // Julian
    if (span_s >= 3e9 * year_s) return {"Gyr", 1e9 * year_s};
    if (span_s >= 3e6 * year_s) return {"Myr", 1e6 * year_s};
    if (span_s >= 3e3 * year_s) return {"kyr", 1e3 * year_s};
    if (span_s >= 3.0 * year_s) return {"yr", year_s};
    if (span_s >= 3.0 * 86400.0) return {"d", 86400.0};
    if (span_s >= 3.0 * 3600.0) return {"h", 3600.0};
    if (span_s >= 0.05 || !(span_s > 0.0)) return {};
    if (span_s >= 5e-5) return {"ms", 1e-3};
    if (span_s >= 5e-8) return {"\u00b5s", 1e-6};
    if (span_s >= 5e-11) return {"ns", 1e-9};
    return {"ps", 1e-12};
}

}  // namespace poinsot
