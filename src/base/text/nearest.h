// Tables of named rows, and the messages for an unknown name.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// The most similar of the known names; empty if none is similar.
std::string_view nearest_name(std::string_view given, std::span<const std::string_view> known);

// "; did you mean "render"?", or empty if no known name is similar.
std::string did_you_mean(std::string_view given, std::span<const std::string_view> known);

// The same, or all known names if none is similar: "; choose from: draft, lecture".
std::string choose_instead(std::string_view given, std::span<const std::string_view> known);

// "unknown quality "lectur"; did you mean "lecture"?"
std::string unknown(std::string_view what, std::string_view given,
                    std::span<const std::string_view> known);

// The names of a table's rows, in order.
template <class Table>
std::vector<std::string_view> names_of(const Table& table) {
    std::vector<std::string_view> names;
    names.reserve(std::size(table));
    for (const auto& row : table) names.emplace_back(row.name);
    return names;
}

// The row of this name, or null.
template <class Table>
const auto* find_row(const Table& table, std::string_view name) {
    const auto row = std::find_if(std::begin(table), std::end(table),
                                  [name](const auto& each) { return each.name == name; });
    return row == std::end(table) ? nullptr : &*row;
}

}  // namespace poinsot
