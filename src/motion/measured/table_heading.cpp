#include "measured/table_heading.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "text/units.h"

namespace poinsot {

namespace {

using Names = std::span<const std::string_view>;

std::string_view without_blanks(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

// Name and unit of "Gyroscope x (rad/s)": "gyroscope_x" and "rad/s".
TableHeading name_and_unit_of(std::string_view text) {
    TableHeading heading;
    // Brackets, also those of Japanese text.
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> brackets{
        {{"(", ")"}, {"[", "]"}, {"（", "）"}}};
    for (const auto& [opening, closing] : brackets) {
        const std::size_t open = text.ends_with(closing) ? text.rfind(opening) : std::string::npos;
        if (open == std::string::npos) continue;
        const std::size_t begin = open + opening.size();
        heading.unit = without_blanks(text.substr(begin, text.size() - closing.size() - begin));
        text = without_blanks(text.substr(0, open));
        break;
    }
    for (const char c : text) {
        const bool separates = c == ' ' || c == '.' || c == '-' || c == '_';
        if (!separates)
            heading.name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        else if (!heading.name.empty() && heading.name.back() != '_')
            heading.name += '_';
    }
    // The units at the end of a name, as this program's own tables have them.
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> endings{
        {{"_rad_s", "rad/s"},
         {"_deg_s", "deg/s"},
         {"_ms", "ms"},
         {"_us", "us"},
         {"_ns", "ns"},
         {"_s", "s"}}};
    for (const auto& [ending, unit] : endings)
        if (heading.unit.empty() && heading.name.ends_with(ending)) {
            heading.name.resize(heading.name.size() - ending.size());
            heading.unit = unit;
        }
    for (const std::string_view word : {"_axis", "_achse"})
        if (heading.name.ends_with(word)) heading.name.resize(heading.name.size() - word.size());
    return heading;
}

// The number of a component, if the name is one of these names with one of these components.
std::optional<int> component_of(std::string_view name, Names names, Names components) {
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (!name.ends_with(components[i])) continue;
        std::string_view before = name.substr(0, name.size() - components[i].size());
        if (before.ends_with('_')) before.remove_suffix(1);
        if (std::find(names.begin(), names.end(), before) != names.end())
            return static_cast<int>(i);
    }
    return std::nullopt;
}

bool is_one_of(std::string_view name, Names names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 13> names_of_time{
    "t",      "time",  "timestamp", "time_stamp", "zeit",     "zeitstempel", "temps",
    "tiempo", "tempo", "時間",      "時刻",       "経過時間", "loggingtime"};
// From the beginning of the recording, where another column has the time of day.
constexpr std::array<std::string_view, 4> names_of_elapsed{"seconds_elapsed", "elapsed",
                                                           "elapsed_time", "time_elapsed"};
// In milliseconds: Arduino's Science Journal, and its function millis().
constexpr std::array<std::string_view, 3> names_of_milliseconds{"relative_time", "millis",
                                                                "milliseconds"};
constexpr std::array<std::string_view, 32> names_of_omega{"omega_body",
                                                          "omega",
                                                          "ω",
                                                          "w",
                                                          "gyroscope",
                                                          "gyro",
                                                          "gyr",
                                                          "gyroscopesensor",
                                                          "angular_velocity",
                                                          "angularvelocity",
                                                          "angular_rate",
                                                          "rotation_rate",
                                                          "rotationrate",
                                                          "motionrotationrate",
                                                          "gyrorotation",
                                                          "gyroskop",
                                                          "kreisel",
                                                          "winkelgeschwindigkeit",
                                                          "drehrate",
                                                          "giroscope",
                                                          "vitesse_angulaire",
                                                          "vitesse_de_rotation",
                                                          "giroscopio",
                                                          "giróscopo",
                                                          "velocidad_angular",
                                                          "velocidad_de_rotación",
                                                          "velocità_angolare",
                                                          "velocita_angolare",
                                                          "ジャイロ",
                                                          "ジャイロスコープ",
                                                          "ジャイロセンサ",
                                                          "角速度"};
// Of Arduino's examples: gx; of Sensor Logger and MATLAB: x.
constexpr std::array<std::string_view, 1> short_name_of_omega{"g"};
constexpr std::array<std::string_view, 1> no_name{""};
constexpr std::array<std::string_view, 4> names_of_attitude{"q", "quat", "quaternion",
                                                            "space_from_body"};
constexpr std::array<std::string_view, 4> names_of_matrix{"r", "rotation", "matrix",
                                                          "space_from_body"};
constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
constexpr std::array<std::string_view, 3> numbers{"1", "2", "3"};
constexpr std::array<std::string_view, 4> of_quaternion{"w", "x", "y", "z"};
constexpr std::array<std::string_view, 9> of_matrix{"11", "12", "13", "21", "22",
                                                    "23", "31", "32", "33"};

// SI units in one of this unit; nothing if it is none, or of another kind than `si`.
std::optional<double> factor_of(std::string_view unit, std::string_view si) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> other_names{
        {{"dps", "deg/s"},
         {"deg/sec", "deg/s"},
         {"°/sec", "deg/s"},
         {"rad/sec", "rad/s"},
         {"sec", "s"}}};
    for (const auto& [other, name] : other_names)
        if (unit == other) unit = name;
    const std::optional<Unit> wanted = unit_named(si);
    if (!wanted) return std::nullopt;
    return measured_in("1 " + std::string(unit), *wanted);
}

void take_unit(TableHeading& heading) {
    const std::string_view si = heading.kind == ColumnKind::time    ? "s"
                                : heading.kind == ColumnKind::omega ? "rad/s"
                                                                    : "";
    if (si.empty() || heading.unit.empty()) return;
    const auto factor = factor_of(heading.unit, si);
    heading.is_unit_known = factor.has_value();
    heading.si_in_unit = factor.value_or(1.0);
}

}  // namespace

std::string_view unquoted_cell(std::string_view cell) {
    cell = without_blanks(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
        cell = cell.substr(1, cell.size() - 2);
    return without_blanks(cell);
}

TableHeading table_heading_of(std::string_view cell) {
    TableHeading heading = name_and_unit_of(unquoted_cell(cell));
    const std::string_view name = heading.name;
    const auto is = [&heading](ColumnKind kind, int component, int rank) {
        heading.kind = kind;
        heading.component = component;
        heading.rank = rank;
    };
    if (is_one_of(name, names_of_time)) {
        is(ColumnKind::time, 0, 0);
    } else if (is_one_of(name, names_of_elapsed)) {
        is(ColumnKind::time, 0, 1);
    } else if (is_one_of(name, names_of_milliseconds)) {
        is(ColumnKind::time, 0, 1);
        if (heading.unit.empty()) heading.unit = "ms";
    } else if (auto axis = component_of(name, names_of_omega, axes);
               axis || (axis = component_of(name, names_of_omega, numbers))) {
        is(ColumnKind::omega, *axis, sure_rank);
    } else if (const auto part = component_of(name, names_of_attitude, of_quaternion)) {
        is(ColumnKind::quaternion, *part, 0);
    } else if (const auto element = component_of(name, names_of_matrix, of_matrix)) {
        is(ColumnKind::matrix, *element, 0);
    } else if (const auto short_axis = component_of(name, short_name_of_omega, axes)) {
        is(ColumnKind::omega, *short_axis, 1);
    } else if (const auto bare_axis = component_of(name, no_name, axes)) {
        is(ColumnKind::omega, *bare_axis, 0);
    }
    take_unit(heading);
    // Such short names are also those of places and accelerations.
    if (heading.kind == ColumnKind::omega && heading.rank < sure_rank && !heading.is_unit_known)
        heading.kind = ColumnKind::other;
    return heading;
}

}  // namespace poinsot
