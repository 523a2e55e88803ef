#include "text/units.h"

#include <cstdlib>

#include "text/rational.h"

namespace poinsot {

namespace {

struct NamedUnit {
    std::string_view name;
    std::array<int, 4> powers;  // kg, m, s, rad
    std::string_view factor;    // a decimal or a quotient of two
    int power_of_pi = 0;
};

constexpr std::array<int, 4> mass{1, 0, 0, 0};
constexpr std::array<int, 4> length{0, 1, 0, 0};
constexpr std::array<int, 4> time{0, 0, 1, 0};
constexpr std::array<int, 4> angle{0, 0, 0, 1};
constexpr std::array<int, 4> turning{0, 0, -1, 1};

constexpr NamedUnit units[] = {
    {"kg", mass, "1"},
    {"g", mass, "1e-3"},
    {"mg", mass, "1e-6"},
    {"t", mass, "1e3"},
    {"lb", mass, "0.45359237"},
    {"oz", mass, "0.028349523125"},
    {"m", length, "1"},
    {"cm", length, "1e-2"},
    {"mm", length, "1e-3"},
    {"km", length, "1e3"},
    {"\u00b5m", length, "1e-6"},
    {"um", length, "1e-6"},
    {"nm", length, "1e-9"},
    {"in", length, "0.0254"},
    {"ft", length, "0.3048"},
    {"s", time, "1"},
    {"ms", time, "1e-3"},
    {"\u00b5s", time, "1e-6"},
    {"us", time, "1e-6"},
    {"ns", time, "1e-9"},
    {"min", time, "60"},
    {"h", time, "3600"},
    {"d", time, "86400"},
    {"yr", time, "31557600"},
    {"rad", angle, "1"},
    {"mrad", angle, "1e-3"},
    {"deg", angle, "1/180", 1},
    {"degree", angle, "1/180", 1},
    {"degrees", angle, "1/180", 1},
    {"\u00b0", angle, "1/180", 1},
    {"Grad", angle, "1/180", 1},  // German
    {"turn", angle, "2", 1},
    {"turns", angle, "2", 1},
    {"rev", angle, "2", 1},
    {"rpm", turning, "1/30", 1},
    {"r/min", turning, "1/30", 1},
    {"U/min", turning, "1/30", 1},   // German
    {"tr/min", turning, "1/30", 1},  // French
    {"N", {1, 1, -2, 0}, "1"},
    {"mN", {1, 1, -2, 0}, "1e-3"},
    {"kN", {1, 1, -2, 0}, "1e3"},
    {"J", {1, 2, -2, 0}, "1"},
    {"mJ", {1, 2, -2, 0}, "1e-3"},
    {"\u00b5J", {1, 2, -2, 0}, "1e-6"},
    {"kJ", {1, 2, -2, 0}, "1e3"},
    {"Nm", {1, 2, -2, 0}, "1"},
    {"px", {0, 0, 0, 0}, ""},  // no unit of ours, so that it is not taken for one
};

// Superscripts after a name: "²" is 2, "⁻¹" is −1.
constexpr std::array<std::string_view, 10> superscripts{"\u2070", "\u00b9", "\u00b2", "\u00b3",
                                                        "\u2074", "\u2075", "\u2076", "\u2077",
                                                        "\u2078", "\u2079"};

void skip_spaces(std::string_view& rest) {
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
}

bool take(std::string_view& rest, std::string_view token) {
    if (!rest.starts_with(token)) return false;
    rest.remove_prefix(token.size());
    return true;
}

// The power after a name, or 1 if there is none: "^2", "2", "²", "^-1", "⁻¹".
int take_power(std::string_view& rest) {
    const bool caret = take(rest, "^") || take(rest, "**");
    const bool negative = take(rest, "\u207b") || (caret && take(rest, "-"));
    for (std::size_t digit = 0; digit < superscripts.size(); ++digit)
        if (take(rest, superscripts[digit]))
            return negative ? -static_cast<int>(digit) : static_cast<int>(digit);
    if (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
        const int power = rest.front() - '0';
        rest.remove_prefix(1);
        return negative ? -power : power;
    }
    return caret || negative ? 0 : 1;
}

// The longest name at the beginning of the text that is not followed by a letter.
const NamedUnit* take_name(std::string_view& rest) {
    const NamedUnit* found = nullptr;
    for (const NamedUnit& unit : units)
        if (rest.starts_with(unit.name) &&
            (found == nullptr || unit.name.size() > found->name.size()))
            found = &unit;
    if (found == nullptr || found->factor.empty()) return nullptr;
    const std::string_view after = rest.substr(found->name.size());
    const bool goes_on = !after.empty() && ((after.front() >= 'a' && after.front() <= 'z') ||
                                            (after.front() >= 'A' && after.front() <= 'Z'));
    if (goes_on) return nullptr;
    rest = after;
    return found;
}

// "/3" after a number.
std::optional<Rational> take_denominator(std::string_view& rest) {
    std::string_view after = rest;
    if (!take(after, "/")) return std::nullopt;
    auto below = take_decimal(after);
    if (!below || *below <= 0) return std::nullopt;
    rest = after;
    return below;
}

// "24", "1/3", "33 1/3": a number, a quotient of whole ones, or both.
std::optional<Rational> take_number(std::string_view& rest) {
    const bool negative = rest.starts_with('-');
    if (negative || rest.starts_with('+')) rest.remove_prefix(1);
    if (rest.empty() || rest.front() == '-' || rest.front() == '+') return std::nullopt;
    auto number = take_decimal(rest);
    if (!number) return std::nullopt;
    if (const auto below = take_denominator(rest)) {
        number = *number / *below;
    } else {
        std::string_view fraction = rest;
        skip_spaces(fraction);
        if (fraction.size() < rest.size() && !fraction.empty() && fraction.front() >= '0' &&
            fraction.front() <= '9') {
            // "7 1/s" has no fraction: "1/s" is its unit.
            std::swap(rest, fraction);
            const auto above = take_decimal(rest);
            const auto under = above ? take_denominator(rest) : std::nullopt;
            if (under) {
                number = *number + *above / *under;
            } else {
                rest = fraction;
            }
        }
    }
    return negative ? -*number : *number;
}

// One of it is factor · π^power_of_pi SI units (kg, m, s, rad).
struct ExactUnit {
    Dimension dimension;
    Rational factor = 1;
    int power_of_pi = 0;
};

ExactUnit unit_of(const NamedUnit& named) {
    std::string_view factor = named.factor;
    return {{named.powers}, *take_number(factor), named.power_of_pi};
}

// unit becomes unit · other^power.
void multiply(ExactUnit& unit, const ExactUnit& other, int power) {
    for (std::size_t i = 0; i < 4; ++i)
        unit.dimension.powers[i] += power * other.dimension.powers[i];
    for (int k = 0; k < std::abs(power); ++k)
        unit.factor = power > 0 ? unit.factor * other.factor : unit.factor / other.factor;
    unit.power_of_pi += power * other.power_of_pi;
}

// The double nearest to number · π^power.
double with_pi(Rational number, int power) {
    // To 90 digits: wrong only for a product that lies closer than 1e-80 of its size to the middle
    // of two doubles.
    if (power != 0) {
        const Rational pi = *rational_of(
            "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862"
            "803482");
        for (int k = 0; k < std::abs(power); ++k) number = power > 0 ? number * pi : number / pi;
    }
    return nearest_double(number);
}

std::optional<ExactUnit> exact_unit(std::string_view text) {
    ExactUnit unit;
    skip_spaces(text);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    bool any = take(text, "1/");
    int sign = any ? -1 : 1;
    // Products of any length would take any time.
    constexpr int most_names = 16;
    for (int n_names = 0; !text.empty(); ++n_names) {
        if (n_names == most_names) return std::nullopt;
        skip_spaces(text);
        if (take(text, "/")) {
            if (!any || sign < 0) return std::nullopt;
            sign = -1;
        } else if (take(text, "*") || take(text, "\u00b7") || take(text, "\u22c5")) {
            if (!any) return std::nullopt;
        }
        skip_spaces(text);
        // A denominator in brackets: "kg/(m s)".
        const bool bracket = take(text, "(");
        if (bracket) {
            const std::size_t close = text.find(')');
            if (close == std::string_view::npos) return std::nullopt;
            const auto inner = exact_unit(text.substr(0, close));
            if (!inner) return std::nullopt;
            text.remove_prefix(close + 1);
            multiply(unit, *inner, sign);
        } else {
            const NamedUnit* named = take_name(text);
            if (named == nullptr) return std::nullopt;
            const int power = take_power(text);
            if (power == 0) return std::nullopt;
            multiply(unit, unit_of(*named), sign * power);
        }
        any = true;
    }
    if (!any) return std::nullopt;
    return unit;
}

struct MeasuredExactly {
    Rational value;  // in the unit
    ExactUnit unit;
    std::string_view written;  // the unit
};

std::optional<MeasuredExactly> measured_exactly(std::string_view text) {
    skip_spaces(text);
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    const auto unit = exact_unit(text);
    if (!unit) return std::nullopt;
    return MeasuredExactly{*number, *unit, text};
}

}  // namespace

std::string known_units() {
    std::string names;
    for (const NamedUnit& unit : units)
        if (!unit.factor.empty()) names += (names.empty() ? "" : ", ") + std::string(unit.name);
    return names;
}

std::optional<Unit> unit_named(std::string_view text) {
    const auto exactly = exact_unit(text);
    if (!exactly) return std::nullopt;
    return Unit{exactly->dimension, std::string(text)};
}

ShownUnit unit_shown(std::span<const std::string> wanted, std::string_view si_unit) {
    const auto plain = exact_unit(si_unit);
    if (!plain) return {std::string(si_unit), 1.0};
    const auto shown_in = [&plain](const std::string& name) -> std::optional<ShownUnit> {
        const auto unit = exact_unit(name);
        if (!unit || unit->dimension != plain->dimension) return std::nullopt;
        return ShownUnit{
            name, with_pi(plain->factor / unit->factor, plain->power_of_pi - unit->power_of_pi)};
    };
    for (const std::string& name : wanted)
        if (auto shown = shown_in(name)) return *shown;
    for (const std::string& name : wanted) {
        const auto unit = exact_unit(name);
        if (!unit || unit->dimension.powers != angle) continue;
        if (auto shown = shown_in(name + "/s")) return *shown;
    }
    return {std::string(si_unit), 1.0};
}

std::string printed_unit(std::string_view name) {
    std::string printed;
    std::string_view rest = name;
    if (take(rest, "1/")) printed = "1/";
    while (!rest.empty()) {
        if (take(rest, "**") || take(rest, "^")) continue;
        if (take(rest, "*")) {
            printed += "\u00b7";
        } else if (take(rest, "-")) {
            printed += "\u207b";
        } else if (rest.front() >= '0' && rest.front() <= '9') {
            printed += superscripts.at(static_cast<std::size_t>(rest.front() - '0'));
            rest.remove_prefix(1);
        } else {
            printed += rest.front();
            rest.remove_prefix(1);
        }
    }
    return printed;
}

std::optional<Measured> measured(std::string_view text) {
    const auto exactly = measured_exactly(text);
    if (!exactly) return std::nullopt;
    const ExactUnit& unit = exactly->unit;
    return Measured{with_pi(exactly->value * unit.factor, unit.power_of_pi),
                    {unit.dimension, std::string(exactly->written)}};
}

std::optional<double> measured_in(std::string_view text, const Unit& wanted) {
    const auto exactly = measured_exactly(text);
    if (!exactly || exactly->unit.dimension != wanted.dimension) return std::nullopt;
    const ExactUnit in = wanted.text.empty() ? ExactUnit{} : *exact_unit(wanted.text);
    return with_pi(exactly->value * exactly->unit.factor / in.factor,
                   exactly->unit.power_of_pi - in.power_of_pi);
}

}  // namespace poinsot
