// Units of measure as people write them: "cm", "deg/s", "g cm²", "rpm"; and numbers with them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// What a unit measures: powers of mass, length, time and angle. Angles count, so that a rate of
// turning is not any rate.
struct Dimension {
    std::array<int, 4> powers{};
    bool operator==(const Dimension&) const = default;
};

struct Unit {
    Dimension dimension;
    long double factor = 1.0L;  // SI units (kg, m, s, rad) in one of it
};

// A product of powers of named units: "kg m²", "kg*m^2", "rad/s", "N m", "1/s". Nothing if the text
// is none.
std::optional<Unit> unit_named(std::string_view text);

// A number before its unit: "24 cm", "33 1/3 rpm", "1/3 m", "800g".
struct Measured {
    double value = 0.0;  // in SI, rounded once
    Unit unit;
};
std::optional<Measured> measured(std::string_view text);

// The value of a measured text in another unit, rounded once; nothing if the text is none or
// measures something else.
std::optional<double> measured_in(std::string_view text, const Unit& wanted);

// The unit that numbers in an SI unit are shown in: of those wanted the one that measures the same,
// or the SI unit itself.
struct ShownUnit {
    std::string name;
    double per_SI = 1.0;  // the factor on a number in SI
};
ShownUnit unit_shown(std::span<const std::string> wanted, std::string_view si_unit);

}  // namespace poinsot
