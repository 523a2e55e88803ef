#include "scene/given_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scene/scene_error.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "text/units.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

// A number with a unit that people use where the key has this one.
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

}  // namespace

void GivenValue::refuse(std::string_view is, std::string_view remedy) const {
    throw SceneError(value_.where, fmt::format("{} is {}; {}", name_, is, remedy));
}

void GivenValue::refuse_type(const TomlValue& value, const std::string& name) const {
    throw SceneError(value.where, fmt::format("{} is {}; it must be {}", name, name_of(value.type),
                                              key_.expectation()));
}

// A number with its unit, as a string, in the key's own unit.
double GivenValue::measured_number(const TomlValue& value, const std::string& name) const {
    const auto unit = unit_named(key_.unit);
    if (!unit) refuse_type(value, name);
    const std::string given = text(value, name);
    if (given.find_first_of("0123456789") == std::string::npos) refuse_type(value, name);
    if (const auto number = measured_in(given, *unit)) {
        if (std::isfinite(*number)) return *number;
        throw SceneError(value.where,
                         fmt::format("{} is \"{}\"; give a finite number", name, printable(given)));
    }
    const auto other = measured(given);
    throw SceneError(value.where,
                     fmt::format("{} is \"{}\", {}; give {}, or a string with another unit of the "
                                 "same kind, as in \"{}\"",
                                 name, printable(given),
                                 other ? fmt::format("which cannot be converted to {}", key_.unit)
                                       : "which is not a number with a unit",
                                 key_.expectation(), measured_example(key_.unit)));
}

double GivenValue::number(const TomlValue& value, const std::string& name) const {
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

double GivenValue::positive(const TomlValue& value, const std::string& name) const {
    const double given = number(value, name);
    if (!(given > 0.0)) {
        throw SceneError(value.where,
                         fmt::format("{} is {}; give a number greater than 0", name, given));
    }
    return given;
}

double GivenValue::number_between(double least, double most) const {
    const double given = number();
    if (given < least || given > most) {
        refuse(fmt::format("{}", given), fmt::format("give a number from {} to {}", least, most));
    }
    return given;
}

int GivenValue::integer_between(int least, int most) const {
    if (value_.type != TomlValue::Type::integer) refuse_type();
    if (value_.integer < least || value_.integer > most) {
        refuse(fmt::format("{}", value_.integer),
               fmt::format("give an integer from {} to {}", least, most));
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

std::string GivenValue::one_of(std::span<const std::string_view> names) const {
    std::string given = text();
    if (std::find(names.begin(), names.end(), given) != names.end()) return given;
    throw SceneError(value_.where, fmt::format("{} is \"{}\"{}", name_, printable(given),
                                               choose_instead(given, names)));
}

const std::vector<TomlValue>& GivenValue::items(const TomlValue& value, const std::string& name,
                                                std::size_t n) const {
    if (value.type != TomlValue::Type::array) refuse_type(value, name);
    if (value.items.size() != n) {
        throw SceneError(
            value.where,
            fmt::format("{} has {} {}; it must be {}", name, value.items.size(),
                        value.items.size() == 1 ? "entry" : "entries", key_.expectation()));
    }
    return value.items;
}

std::vector<double> GivenValue::positive_numbers() const {
    if (value_.type != TomlValue::Type::array) refuse_type();
    std::vector<double> numbers;
    for (const TomlValue& item : value_.items) {
        numbers.push_back(positive(item, fmt::format("{}[{}]", name_, numbers.size())));
    }
    return numbers;
}

Eigen::Vector3d GivenValue::vector(const TomlValue& value, const std::string& name) const {
    const auto& entries = items(value, name, 3);
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i) {
        vector[i] = number(entries[static_cast<std::size_t>(i)], fmt::format("{}[{}]", name, i));
    }
    return vector;
}

Eigen::Vector3d GivenValue::positive_vector() const {
    const auto& entries = items(value_, name_, 3);
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i) {
        vector[i] = positive(entries[static_cast<std::size_t>(i)], fmt::format("{}[{}]", name_, i));
    }
    return vector;
}

Eigen::Vector4d GivenValue::four_numbers() const {
    const auto& entries = items(value_, name_, 4);
    Eigen::Vector4d four;
    for (int i = 0; i < 4; ++i) {
        four[i] = number(entries[static_cast<std::size_t>(i)], fmt::format("{}[{}]", name_, i));
    }
    return four;
}

Eigen::Matrix3d GivenValue::matrix() const {
    const auto& rows = items(value_, name_, 3);
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i) {
        matrix.row(i) = vector(rows[static_cast<std::size_t>(i)], fmt::format("{}[{}]", name_, i));
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
        return texts;
    }
    if (value_.type != TomlValue::Type::array) refuse_type();
    for (const TomlValue& item : value_.items) {
        texts.push_back(text(item, fmt::format("{}[{}]", name_, texts.size())));
    }
    return texts;
}

}  // namespace poinsot
