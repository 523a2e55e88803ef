// The motion at many instants as a table of numbers, and the files that such a table becomes.
// Numbers only: nothing here draws.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/motion.h"

namespace poinsot {

// One column: its name, and its unit as the suffix that names carry here, empty for a pure number.
struct SampleColumn {
    std::string_view name;
    std::string_view unit;
};

struct SampledInstant;  // what a quantity's numbers are taken from

// Columns that are known together: a row of the table of what can be sampled.
struct SampleQuantity {
    std::string_view name;
    std::string_view summary;
    std::span<const SampleColumn> columns;
    Quantities wanted;               // of the motion
    bool (*offered)(const Motion&);  // null: of every motion
    std::string_view offered_by;     // which those are, for who asks another
    void (*values)(const SampledInstant& instant, double* values);  // one a column
};

std::span<const SampleQuantity> sample_quantities();

// A column of a table: a quantity's, and the name that it has there.
struct ChosenColumn {
    const SampleQuantity* quantity = nullptr;
    std::size_t index = 0;
    std::string heading;
};

// What `sample` prints unless told otherwise: instant, ω, attitude, herpolhode and, for a heavy
// top, its angles.
std::vector<ChosenColumn> default_columns(const Motion& motion);

// Columns by name: a quantity's ("omega_body": all of its columns) or a column's ("omega_body_1",
// with or without its unit). Headings carry the unit. Throws InputError for a name that is unknown,
// with the nearest, that stands there twice, or that this motion does not have.
std::vector<ChosenColumn> columns_named(const Motion& motion, std::span<const std::string> names);

// Rows of numbers, one an instant.
struct SampleTable {
    std::vector<std::string> headings;
    std::vector<double> values;  // row by row
    std::size_t n_rows() const { return headings.empty() ? 0 : values.size() / headings.size(); }
};

// The most numbers that one table may hold: 0.8 GB.
inline constexpr std::size_t most_sampled_values = 100'000'000;

// Evaluates the motion at every instant, whose order and repetitions stay. `asked_by` names where
// an instant was asked for ("--times") in the message of one that cannot be had. Throws
// InputError, also for more than most_sampled_values.
SampleTable sample_table(const Motion& motion, std::span<const ChosenColumn> columns,
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

// By the suffix, in letters of either case. Throws InputError, naming those there are.
const TableFormat& table_format_for(const std::filesystem::path& path);

// The whole file or none. Throws EnvironmentError.
void write_table(const SampleTable& table, const TableFormat& format,
                 const std::filesystem::path& path);

}  // namespace poinsot
