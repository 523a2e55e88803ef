// The motion at many instants as a table of numbers, and the file formats of such tables. Nothing
// here draws.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "construction/quantities.h"

namespace poinsot {

// A column of a table: a component of a quantity, and its heading.
struct ChosenColumn {
    const Quantity* quantity = nullptr;
    std::size_t index = 0;
    std::string heading;
};

// The default columns of `sample`: instant, ω, attitude, herpolhode and, for a heavy top, its
// angles.
std::vector<ChosenColumn> default_columns(const Motion& motion);

// Columns by name: a quantity ("omega_body" or its symbol: all of its components) or a component
// ("omega_body_1", with or without its unit). Headings include the unit. Throws InputError for a
// name that is unknown, with the nearest one, that occurs twice, or that this motion does not have.
std::vector<ChosenColumn> columns_named(const Motion& motion, std::span<const std::string> names);

// Rows of numbers, one per instant.
struct SampleTable {
    std::vector<std::string> headings;
    std::vector<double> values;  // row by row
    std::size_t n_rows() const { return headings.empty() ? 0 : values.size() / headings.size(); }
};

// Largest number of values in a table: 0.8 GB.
inline constexpr std::size_t most_sampled_values = 100'000'000;

// Evaluates the motion at every instant, in the given order and with repetitions. `asked_by` is the
// source of an instant ("--times") for the messages about invalid ones. Throws InputError, also for
// more than most_sampled_values.
SampleTable sample_table(const Motion& motion, std::span<const ChosenColumn> columns,
                         std::span<const double> times_s, std::string_view asked_by);

// The same, with the values column by column.
SampleTable sample_columns(const Motion& motion, std::span<const ChosenColumn> columns,
                           std::span<const double> times_s, std::string_view asked_by);

// A file format of tables.
using WriteBytes = std::function<void(std::string_view bytes)>;
struct TableFormat {
    std::string_view name;
    std::string_view suffix;
    std::string_view summary;
    void (*write)(const SampleTable& table, const WriteBytes& write);
};

// CSV is the first.
std::span<const TableFormat> table_formats();

// The format of a suffix, which is case-insensitive. Throws InputError with the list of formats.
const TableFormat& table_format_for(const std::filesystem::path& path);

}  // namespace poinsot
