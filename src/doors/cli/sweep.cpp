#include "cli/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "error/error.h"
#include "scene/scene_keys.h"
#include "text/label_text.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/rational.h"

namespace poinsot {

namespace {

constexpr std::size_t most_runs = 100000;

// Splits at separators outside brackets and quotes.
std::vector<std::string> pieces_of(std::string_view text, char separator) {
    std::vector<std::string> pieces(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == separator && depth == 0) {
            pieces.emplace_back();
            continue;
        }
        pieces.back() += c;
    }
    return pieces;
}

// The values of from:to:n; empty for any other text.
std::vector<std::string> range_of(std::string_view text) {
    const std::vector<std::string> pieces = pieces_of(text, ':');
    if (pieces.size() != 3) return {};
    const auto from = rational_of(pieces[0]), to = rational_of(pieces[1]);
    const auto n = number_of<std::int64_t>(pieces[2]);
    if (!from || !to || !n) return {};
    if (!std::isfinite(nearest_double(*from)) || !std::isfinite(nearest_double(*to))) return {};
    if (*n < 2 || *n > static_cast<std::int64_t>(most_runs))
        throw InputError(fmt::format(
            "--sweep: {} has {} values; give 2 to {} values in from:to:n, both ends included",
            printable(text), *n, most_runs));
    const Progression numbers(*from, (*to - *from) / (*n - 1));
    std::vector<std::string> values;
    for (std::int64_t i = 0; i < *n; ++i) values.push_back(fmt::format("{}", numbers.at(i)));
    return values;
}

void replace_all(std::string& text, const std::string& what, std::string with) {
    // In a value, '/' is not a folder and '#' not a number.
    std::replace_if(
        with.begin(), with.end(), [](char c) { return c == '/' || c == '#'; }, '_');
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
        text.replace(at, what.size(), with);
}

std::string with_values(std::string output, const SweepPoint& point) {
    for (const auto& [key, value] : point) replace_all(output, "{" + key + "}", value);
    if (point.size() == 1) replace_all(output, "{key}", point.front().second);
    return output;
}

// Symbols of quantities, by the last part of their key.
constexpr std::pair<std::string_view, std::string_view> symbols_of_keys[] = {
    {"omega_rad_s", "\\omega"},
    {"omega3_rad_s", "\\omega_3"},
    {"moments_kg_m2", "I"},
    {"theta_rad", "\\theta"},
    {"theta_dot_rad_s", "\\dot{\\theta}"},
    {"phi_dot_rad_s", "\\dot{\\varphi}"},
    {"mgl_N_m", "Mgl"},
    {"mass_kg", "m"},
    {"energy_J", "T"},
    {"momentum_kg_m2_s", "L"}};

// "$\omega_2 = 0.057$~rad/s" for start.omega_rad_s[1] and 0.057; if the quantity has no symbol, the
// key has another index, or the value is no plain decimal: the last part of the key and the value
// as they are.
std::string formula_of(std::string_view key, const std::string& value) {
    const std::size_t dot = key.rfind('.');
    std::string_view name = key.substr(dot + 1);
    std::string plain = as_caption(fmt::format("{} = {}", name, value));
    if (dot != std::string_view::npos && key.substr(0, dot).find('[') != std::string_view::npos)
        return as_caption(fmt::format("{} = {}", key, value));
    std::string subscript;
    if (const std::size_t bracket = name.find('['); bracket != std::string_view::npos) {
        const auto index = number_of<int>(name.substr(bracket + 1, name.size() - bracket - 2));
        if (!index || name.back() != ']') return plain;
        subscript = fmt::format("_{}", *index + 1);
        name = name.substr(0, bracket);
        key.remove_suffix(key.size() - key.rfind('['));
    }
    const auto* symbol = std::find_if(std::begin(symbols_of_keys), std::end(symbols_of_keys),
                                      [name](const auto& row) { return row.first == name; });
    const SceneKey* row = find_scene_key(key);
    const bool is_decimal = value.find_first_not_of("+-.0123456789") == std::string::npos;
    if (symbol == std::end(symbols_of_keys) || row == nullptr || !is_decimal) return plain;
    std::string unit(row->type.unit);
    std::replace(unit.begin(), unit.end(), ' ', '~');
    return fmt::format("${}{} = {}$~{}", symbol->second, subscript, value, unit);
}

}  // namespace

Option sweep_option(std::vector<std::string>& sweeps) {
    return {.flags = "--sweep",
            .takes = "KEY=VALUES",
            .help =
                "KEY=a,b,c or KEY=from:to:n: one run for each value; several --sweep give all "
                "combinations",
            .value = Repeated{&sweeps}};
}

Sweep parse_sweep(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size())
        throw InputError(
            fmt::format("--sweep {}: write KEY=a,b,c or KEY=from:to:n, as "
                        "start.omega_rad_s[1]=0:2:5",
                        printable(text)));
    Sweep sweep{std::string(text.substr(0, equals)), range_of(text.substr(equals + 1))};
    if (sweep.values.empty()) sweep.values = pieces_of(text.substr(equals + 1), ',');
    for (const std::string& value : sweep.values)
        if (value.empty())
            throw InputError(fmt::format(
                "--sweep {}: a value is empty; give a value after each comma", printable(text)));
    return sweep;
}

std::vector<SweepPoint> points_of(const std::vector<std::string>& sweeps) {
    std::vector<SweepPoint> points(1);
    for (const std::string& text : sweeps) {
        const Sweep sweep = parse_sweep(text);
        if (std::any_of(points[0].begin(), points[0].end(),
                        [&](const auto& swept) { return swept.first == sweep.key; }))
            throw InputError(fmt::format(
                "--sweep {}: the key is swept twice; give all its values in one --sweep",
                printable(sweep.key)));
        if (sweep.values.size() > most_runs / points.size())
            throw InputError(
                fmt::format("--sweep: more than {} runs; give fewer values", most_runs));
        std::vector<SweepPoint> more;
        for (const SweepPoint& point : points) {
            for (const std::string& value : sweep.values) {
                more.push_back(point);
                more.back().emplace_back(sweep.key, value);
            }
        }
        points = std::move(more);
    }
    return points;
}

std::vector<Override> overrides_of(const SweepPoint& point) {
    std::vector<Override> overrides;
    for (const auto& [key, value] : point) overrides.push_back({key, value, "--sweep"});
    return overrides;
}

std::string in_words(const SweepPoint& point) {
    std::string text;
    for (const auto& [key, value] : point)
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, value);
    return text;
}

std::string caption_of(const SweepPoint& point) {
    SweepPoint named = point;
    for (auto& [key, value] : named) key.erase(0, key.rfind('.') + 1);
    return in_words(named);
}

std::string formula_of(const SweepPoint& point) {
    std::string text;
    for (const auto& [key, value] : point) {
        if (!text.empty()) text += ", ";
        text += formula_of(key, value);
    }
    return text;
}

std::pair<int, int> parse_sheet(std::string_view text) {
    constexpr int most = 1000;
    const std::size_t cross = text.find('x');
    std::optional<int> columns, rows;
    if (cross != std::string_view::npos) {
        columns = number_of<int>(text.substr(0, cross));
        rows = number_of<int>(text.substr(cross + 1));
    }
    if (!columns || !rows || *columns < 1 || *rows < 1 || *columns > most || *rows > most)
        throw InputError(fmt::format(
            "--sheet {}: not a sheet; write CxR, as 4x3 for four columns and three rows",
            printable(text)));
    return {*columns, *rows};
}

std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind, const std::vector<std::string>& sweeps) {
    if (sweeps.empty()) return jobs_of(scenes, output, kind);
    std::vector<SceneJob> wanted;
    const std::vector<SweepPoint> points = points_of(sweeps);
    for (const std::string& scene : scenes) {
        for (const SweepPoint& point : points) {
            SceneJob& job = wanted.emplace_back();
            job.scene = scene;
            job.output = with_values(output, point);
            job.overrides = overrides_of(point);
        }
    }
    return named_jobs(std::move(wanted), output, kind);
}

}  // namespace poinsot
