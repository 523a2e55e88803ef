#include "text/units.h"

#include <charconv>
#include <cmath>

namespace poinsot {

namespace {

constexpr long double pi = 3.14159265358979323846264338327950288L;

struct NamedUnit {
    std::string_view name;
    std::array<int, 4> powers;  // kg, m, s, rad
    long double factor;
};

constexpr std::array<int, 4> mass{1, 0, 0, 0};
constexpr std::array<int, 4> length{0, 1, 0, 0};
constexpr std::array<int, 4> time{0, 0, 1, 0};
constexpr std::array<int, 4> angle{0, 0, 0, 1};
constexpr std::array<int, 4> turning{0, 0, -1, 1};

constexpr NamedUnit units[] = {
    {"kg", mass, 1.0L},
    {"g", mass, 1e-3L},
    {"mg", mass, 1e-6L},
    {"t", mass, 1e3L},
    {"lb", mass, 0.45359237L},
    {"oz", mass, 0.028349523125L},
    {"m", length, 1.0L},
    {"cm", length, 1e-2L},
    {"mm", length, 1e-3L},
    {"km", length, 1e3L},
    {"\u00b5m", length, 1e-6L},
    {"um", length, 1e-6L},
    {"nm", length, 1e-9L},
    {"in", length, 0.0254L},
    {"ft", length, 0.3048L},
    {"s", time, 1.0L},
    {"ms", time, 1e-3L},
    {"\u00b5s", time, 1e-6L},
    {"us", time, 1e-6L},
    {"ns", time, 1e-9L},
    {"min", time, 60.0L},
    {"h", time, 3600.0L},
    {"d", time, 86400.0L},
    {"yr", time, 31557600.0L},
    {"rad", angle, 1.0L},
    {"mrad", angle, 1e-3L},
    {"deg", angle, pi / 180.0L},
    {"degree", angle, pi / 180.0L},
    {"degrees", angle, pi / 180.0L},
    {"\u00b0", angle, pi / 180.0L},
    {"turn", angle, 2.0L * pi},
    {"turns", angle, 2.0L * pi},
    {"rev", angle, 2.0L * pi},
    {"rpm", turning, 2.0L * pi / 60.0L},
    {"N", {1, 1, -2, 0}, 1.0L},
    {"mN", {1, 1, -2, 0}, 1e-3L},
    {"kN", {1, 1, -2, 0}, 1e3L},
    {"J", {1, 2, -2, 0}, 1.0L},
    {"mJ", {1, 2, -2, 0}, 1e-3L},
    {"\u00b5J", {1, 2, -2, 0}, 1e-6L},
    {"kJ", {1, 2, -2, 0}, 1e3L},
    {"Nm", {1, 2, -2, 0}, 1.0L},
    {"px", {0, 0, 0, 0}, 0.0L},  // no unit of ours, so that it is not taken for one
};

// Superscripts that follow a name: "²" is 2, "⁻¹" is −1.
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

// A power behind a name, 1 where there is none: "^2", "2", "²", "^-1", "⁻¹".
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

// The longest name that the text begins with, which no letter may follow.
const NamedUnit* take_name(std::string_view& rest) {
    const NamedUnit* found = nullptr;
    for (const NamedUnit& unit : units)
        if (rest.starts_with(unit.name) &&
            (found == nullptr || unit.name.size() > found->name.size()))
            found = &unit;
    if (found == nullptr || found->factor == 0.0L) return nullptr;
    const std::string_view after = rest.substr(found->name.size());
    const bool goes_on = !after.empty() && ((after.front() >= 'a' && after.front() <= 'z') ||
                                            (after.front() >= 'A' && after.front() <= 'Z'));
    if (goes_on) return nullptr;
    rest = after;
    return found;
}

// A number in decimals; from_chars knows no locale.
std::optional<long double> take_decimal(std::string_view& rest) {
    long double number{};
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return number;
}

// "24", "1/3", "33 1/3": a number, a quotient of whole ones, or both.
std::optional<long double> take_number(std::string_view& rest) {
    const bool negative = rest.starts_with('-');
    if (negative || rest.starts_with('+')) rest.remove_prefix(1);
    if (rest.empty() || rest.front() == '-' || rest.front() == '+') return std::nullopt;
    auto number = take_decimal(rest);
    if (!number) return std::nullopt;
    const auto take_denominator = [&rest]() -> std::optional<long double> {
        std::string_view after = rest;
        if (!take(after, "/")) return std::nullopt;
        const auto below = take_decimal(after);
        if (!below || *below <= 0.0L) return std::nullopt;
        rest = after;
        return below;
    };
    if (const auto below = take_denominator()) {
        *number /= *below;
    } else {
        std::string_view fraction = rest;
        skip_spaces(fraction);
        if (fraction.size() < rest.size() && !fraction.empty() && fraction.front() >= '0' &&
            fraction.front() <= '9') {
            // "7 1/s" has none: what follows is its unit.
            std::swap(rest, fraction);
            const auto above = take_decimal(rest);
            const auto under = above ? take_denominator() : std::nullopt;
            if (under) {
                *number += *above / *under;
            } else {
                rest = fraction;
            }
        }
    }
    return negative ? -*number : *number;
}

struct MeasuredExactly {
    long double value;
    Unit unit;
};

std::optional<MeasuredExactly> measured_exactly(std::string_view text) {
    skip_spaces(text);
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    const auto unit = unit_named(text);
    if (!unit) return std::nullopt;
    return MeasuredExactly{*number * unit->factor, *unit};
}

}  // namespace

std::optional<Unit> unit_named(std::string_view text) {
    Unit unit;
    skip_spaces(text);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    bool any = take(text, "1/");
    int sign = any ? -1 : 1;
    while (!text.empty()) {
        skip_spaces(text);
        if (take(text, "/")) {
            if (!any || sign < 0) return std::nullopt;
            sign = -1;
        } else if (take(text, "*") || take(text, "\u00b7") || take(text, "\u22c5")) {
            if (!any) return std::nullopt;
        }
        skip_spaces(text);
        // What stands in brackets below the line: "kg/(m s)".
        const bool bracket = take(text, "(");
        if (bracket) {
            const std::size_t close = text.find(')');
            if (close == std::string_view::npos) return std::nullopt;
            const auto inner = unit_named(text.substr(0, close));
            if (!inner) return std::nullopt;
            text.remove_prefix(close + 1);
            for (std::size_t i = 0; i < 4; ++i)
                unit.dimension.powers[i] += sign * inner->dimension.powers[i];
            unit.factor *= sign > 0 ? inner->factor : 1.0L / inner->factor;
        } else {
            const NamedUnit* named = take_name(text);
            if (named == nullptr) return std::nullopt;
            const int power = take_power(text);
            if (power == 0) return std::nullopt;
            for (std::size_t i = 0; i < 4; ++i)
                unit.dimension.powers[i] += sign * power * named->powers[i];
            for (int k = 0; k < std::abs(power); ++k)
                unit.factor =
                    sign * power > 0 ? unit.factor * named->factor : unit.factor / named->factor;
        }
        any = true;
    }
    if (!any) return std::nullopt;
    return unit;
}

ShownUnit unit_shown(std::span<const std::string> wanted, std::string_view si_unit) {
    const auto plain = unit_named(si_unit);
    if (plain) {
        for (const std::string& name : wanted) {
            const auto unit = unit_named(name);
            if (unit && unit->dimension == plain->dimension)
                return {name, static_cast<double>(plain->factor / unit->factor)};
        }
    }
    return {std::string(si_unit), 1.0};
}

std::optional<Measured> measured(std::string_view text) {
    const auto exactly = measured_exactly(text);
    if (!exactly) return std::nullopt;
    return Measured{static_cast<double>(exactly->value), exactly->unit};
}

std::optional<double> measured_in(std::string_view text, const Unit& wanted) {
    const auto exactly = measured_exactly(text);
    if (!exactly || exactly->unit.dimension != wanted.dimension) return std::nullopt;
    return static_cast<double>(exactly->value / wanted.factor);
}

}  // namespace poinsot
