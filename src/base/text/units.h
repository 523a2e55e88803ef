// Units of measure as users write them ("cm", "deg/s", "g cm²", "rpm"), and numbers with units.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// A physical dimension as powers of mass, length, time and angle. Angle counts as a dimension, so
// that an angular rate differs from other rates.
struct Dimension {
    std::array<int, 4> powers{};
    bool operator==(const Dimension&) const = default;
};

struct Unit {
    Dimension dimension;
    std::string
        text;  // as it was written; how much it is in SI is computed, exactly, where it is needed
};

// A product of powers of named units: "kg m²", "kg*m^2", "rad/s", "N m", "1/s". Empty if the text
// is not a unit, or has more than 16 names.
std::optional<Unit> unit_named(std::string_view text);

// The named units, for messages: "kg, g, mg, …".
std::string known_units();

// A number before its unit: "24 cm", "33 1/3 rpm", "1/3 m", "800g". The value is the double nearest
// to the written value; with π, nearest to within 1e-80 of the spacing of doubles.
struct Measured {
    double value = 0.0;  // in SI
    Unit unit;
};
std::optional<Measured> measured(std::string_view text);

// The value of a measured text in another unit, rounded once as in Measured; nothing if the text is
// none or measures something else.
std::optional<double> measured_in(std::string_view text, const Unit& wanted);

// The unit in which numbers of an SI unit are shown: the wanted unit of the same dimension; for a
// rate of rotation otherwise the wanted unit of angle a second ("deg" gives "deg/s"); or else the
// SI unit itself.
struct ShownUnit {
    std::string name;
    double per_SI = 1.0;  // shown number = number in SI · per_SI
};
ShownUnit unit_shown(std::span<const std::string> wanted, std::string_view si_unit);

// A unit's name as it is printed: "g*cm^2/s" is "g·cm²/s".
std::string printed_unit(std::string_view name);

}  // namespace poinsot
