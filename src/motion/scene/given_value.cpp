#include "scene/given_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scene/scene_error.h"
#include "text/nearest.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/units.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

// An example of a value in a common unit of the same quantity as this unit.
std::string_view measured_example(std::string_view unit) {
    if (unit == "m") return "24 cm";
    if (unit == "kg") return "800 g";
    if (unit == "rad/s") return "33 1/3 rpm";
    if (unit == "rad" || unit == "degrees") return "30 deg";
    if (unit == "kg m²") return "120 g cm²";
    if (unit == "s") return "5 min";
    if (unit == "kg/m³") return "2.7 g/cm³";
    if (unit == "N m") return "3 mN m";
    return "2 1/s";
}

// The text with a decimal point in place of a comma between two digits: "9,5 rad/s".
std::string with_decimal_point(std::string text) {
    const auto is_digit = [&text](std::size_t at) {
        return at < text.size() && text[at] >= '0' && text[at] <= '9';
    };
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos && comma > 0 && is_digit(comma - 1) && is_digit(comma + 1))
        text[comma] = '.';
    return text;
}

}  // namespace

void GivenValue::refuse(std::string_view is, std::string_view remedy) const {
    throw SceneError(value_.where, fmt::format("{} is {}; {}", name_, is, remedy));
}

void GivenValue::refuse_type(const TomlValue& value, const std::string& name) const {
    throw SceneError(value.where, fmt::format("{} is {}; it must be {}", name, name_of(value.type),
                                              key_.expectation()));
}

// Converts a string of a number with a unit to the key's unit.
double GivenValue::measured_number(const TomlValue& value, const std::string& name) const {
    const auto unit = unit_named(key_.type.unit);
    if (!unit) refuse_type(value, name);
    const std::string given = text(value, name);
    if (given.find_first_of("0123456789") == std::string::npos) refuse_type(value, name);
    if (const auto number = measured_in(given, *unit)) {
        if (std::isfinite(*number)) return *number;
        throw SceneError(value.where,
                         fmt::format("{} is \"{}\"; give a finite number", name, printable(given)));
    }
    const std::string with_point = with_decimal_point(given);
    const bool is_plain = number_of<double>(with_point).has_value();
    if (with_point != given && (is_plain || measured(with_point)))
        throw SceneError(
            value.where,
            fmt::format("{0} is \"{1}\"; numbers have a decimal point: write {2}{3}{2}", name,
                        printable(given), is_plain ? "" : "\"", printable(with_point)));
    const auto other = measured(given);
    throw SceneError(
        value.where,
        fmt::format("{} is \"{}\", {}; give {}, or a string with another unit of the "
                    "same kind, as in \"{}\"",
                    name, printable(given),
                    other ? fmt::format("which cannot be converted to {}", key_.type.unit)
                          : "which is not a number with a unit",
                    key_.expectation(), measured_example(key_.type.unit)));
}

double GivenValue::number(const TomlValue& value, const std::string& name) const {
    const double number = finite_number(value, name);
    const Bounds& bounds = key_.type.bounds;
    if (!bounds.hold(number)) {
        throw SceneError(value.where,
                         fmt::format("{} is {}; give a number{}", name, number, bounds.words()));
    }
    return number;
}

double GivenValue::finite_number(const TomlValue& value, const std::string& name) const {
    if (value.type == TomlValue::Type::text) return measured_number(value, name);
    if (value.type != TomlValue::Type::integer && value.type != TomlValue::Type::number) {
        refuse_type(value, name);
    }
    if (!std::isfinite(value.number)) {
        throw SceneError(value.where, fmt::format("{} is {}; give a finite number", name,
                                                  std::isnan(value.number) ? "nan" : "infinite"));
    }
    return value.number;
}

int GivenValue::integer() const {
    if (value_.type != TomlValue::Type::integer) refuse_type();
    const Bounds& bounds = key_.type.bounds;
    if (!bounds.hold(value_.number)) {
        refuse(fmt::format("{}", value_.integer), fmt::format("give an integer{}", bounds.words()));
    }
    return static_cast<int>(value_.integer);
}

bool GivenValue::boolean() const {
    if (value_.type != TomlValue::Type::boolean) refuse_type();
    return value_.boolean;
}

std::string GivenValue::text(const TomlValue& value, const std::string& name) const {
    if (value.type != TomlValue::Type::text) refuse_type(value, name);
    for (std::string_view rest = value.text; !rest.empty();) {
        const Utf8Character character = first_character(rest);
        const bool layout = character.code == '\n' || character.code == '\t';
        if (character.valid && is_control(character.code) && !layout) {
            throw SceneError(value.where,
                             fmt::format("{} contains the control character U+{:04X}; remove it",
                                         name, static_cast<std::uint32_t>(character.code)));
        }
        if (!character.valid) {
            throw SceneError(value.where, fmt::format("{} is not UTF-8; write it in UTF-8", name));
        }
        rest.remove_prefix(character.size);
    }
    return value.text;
}

std::string GivenValue::text() const {
    std::string given = text(value_, name_);
    const auto names = key_.type.names;
    if (names.empty() || std::find(names.begin(), names.end(), given) != names.end()) return given;
    throw SceneError(value_.where, fmt::format("{} is \"{}\"{}", name_, printable(given),
                                               choose_instead(given, names)));
}

void GivenValue::check_names(const std::vector<std::string>& given) const {
    const auto names = key_.type.names;
    for (std::size_t i = 0; i < given.size() && !names.empty(); ++i)
        if (std::find(names.begin(), names.end(), given[i]) == names.end())
            throw SceneError(value_.where,
                             fmt::format("{}[{}] is \"{}\"{}", name_, i, printable(given[i]),
                                         choose_instead(given[i], names)));
}

const std::vector<TomlValue>& GivenValue::items(const TomlValue& value,
                                                const std::string& name) const {
    if (value.type != TomlValue::Type::array) refuse_type(value, name);
    const std::size_t n = value.items.size();
    const ValueType::Size size = key_.type.size.value_or(ValueType::Size{});
    if (n < size.least || n > size.most) {
        throw SceneError(value.where,
                         fmt::format("{} has {} {}; it must be {}", name, n,
                                     n == 1 ? "entry" : "entries", key_.expectation()));
    }
    return value.items;
}

std::vector<double> GivenValue::numbers(const TomlValue& value, const std::string& name) const {
    std::vector<double> numbers;
    for (const TomlValue& item : items(value, name))
        numbers.push_back(number(item, fmt::format("{}[{}]", name, numbers.size())));
    return numbers;
}

Eigen::Matrix3d GivenValue::matrix() const {
    const auto& rows = items(value_, name_);
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i) {
        const std::vector<double> row =
            numbers(rows[static_cast<std::size_t>(i)], fmt::format("{}[{}]", name_, i));
        matrix.row(i) = Eigen::Map<const Eigen::RowVector3d>(row.data());
    }
    return matrix;
}

std::vector<std::string> GivenValue::texts() const {
    std::vector<std::string> texts;
    const bool from_command_line = value_.where.line == 0;
    if (from_command_line && value_.type == TomlValue::Type::text) {
        std::string_view rest = value_.text;
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            texts.emplace_back(rest.substr(0, comma));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
        check_names(texts);
        return texts;
    }
    if (value_.type != TomlValue::Type::array) refuse_type();
    for (const TomlValue& item : value_.items) {
        texts.push_back(text(item, fmt::format("{}[{}]", name_, texts.size())));
    }
    check_names(texts);
    return texts;
}

}  // namespace poinsot
