#include "production/sampling/sample_table.h"

#include <fmt/compile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>

#include "error/error.h"
#include "system/interrupt.h"
#include "system/suffix.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Size of the output buffer.
constexpr std::size_t block_bytes = std::size_t{1} << 20;

// The shortest decimal that reads back as the same double.
void append_number(std::string& text, double value) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("{}"), value);
}

void write_csv(const SampleTable& table, const WriteBytes& write) {
    std::string text = fmt::format("{}\n", fmt::join(table.headings, ","));
    const std::size_t width = table.headings.size();
    for (std::size_t i = 0; i < table.values.size(); ++i) {
        append_number(text, table.values[i]);
        text += (i + 1) % width == 0 ? '\n' : ',';
        if (text.size() >= block_bytes) {
            write(text);
            text.clear();
        }
    }
    write(text);
}

void write_json_lines(const SampleTable& table, const WriteBytes& write) {
    std::vector<std::string> openings;
    for (const std::string& heading : table.headings)
        openings.push_back(
            fmt::format("{}{}:", openings.empty() ? "{" : ",", json_string(heading)));
    std::string text;
    const std::size_t width = table.headings.size();
    for (std::size_t i = 0; i < table.values.size(); ++i) {
        text += openings[i % width];
        // JSON has neither infinity nor NaN.
        if (std::isfinite(table.values[i])) {
            append_number(text, table.values[i]);
        } else {
            text += "null";
        }
        if ((i + 1) % width == 0) text += "}\n";
        if (text.size() >= block_bytes) {
            write(text);
            text.clear();
        }
    }
    write(text);
}

// NumPy's format 1.0: a Python expression that describes the data, padded so that the numbers start
// at a multiple of 64 bytes. Source: numpy.lib.format, "Format Version 1.0".
void write_npy(const SampleTable& table, const WriteBytes& write) {
    constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
    std::string described;
    for (const std::string& heading : table.headings)
        described += fmt::format("('{}', '{}f8'), ", heading, order);
    std::string header = fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}",
                                     described, table.n_rows());
    constexpr std::size_t before = 10;  // magic, version and header length
    header.append(63 - (before + header.size()) % 64, ' ');
    header += '\n';
    const auto length = static_cast<unsigned>(header.size());
    std::string opening = "\x93NUMPY";
    opening += '\x01';
    opening += '\0';
    opening += static_cast<char>(length & 0xFFU);
    opening += static_cast<char>(length >> 8U);
    write(opening + header);
    const auto bytes = std::as_bytes(std::span(table.values));
    write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// The column of a heading; throws InputError if the table has none.
std::size_t column_for_keyframes(const SampleTable& table, std::string_view heading) {
    const auto found = std::find(table.headings.begin(), table.headings.end(), heading);
    if (found == table.headings.end())
        throw InputError(fmt::format(
            "a .json file holds keyframes, which need {}; leave out --columns, or add time and "
            "space_from_body",
            heading));
    return static_cast<std::size_t>(found - table.headings.begin());
}

// The attitude as keyframes in the JSON that three.js's AnimationClip.parse reads: a track of
// quaternions x, y, z, w. The motion's quaternions do not change their sign between instants, so
// that programs that interpolate the components take the short way.
void write_keyframes(const SampleTable& table, const WriteBytes& write) {
    const std::size_t width = table.headings.size();
    const std::size_t time = column_for_keyframes(table, "time_s");
    std::array<std::size_t, 4> q{};
    constexpr std::array<std::string_view, 4> names{"q_x", "q_y", "q_z", "q_w"};
    for (std::size_t k = 0; k < 4; ++k) q[k] = column_for_keyframes(table, names[k]);
    const auto value = [&](std::size_t row, std::size_t column) {
        return table.values[row * width + column];
    };
    for (std::size_t row = 1; row < table.n_rows(); ++row)
        if (!(value(row, time) > value(row - 1, time)))
            throw InputError(fmt::format(
                "keyframes stand in order of time, but {:g} s comes after {:g} s; sort --times",
                value(row, time), value(row - 1, time)));
    std::string text = "{\"name\": \"motion\", \"duration\": ";
    append_number(text, table.n_rows() > 0 ? value(table.n_rows() - 1, time) : 0.0);
    text += ", \"tracks\": [{\"name\": \".quaternion\", \"type\": \"quaternion\", \"times\": [";
    const auto flush = [&](std::size_t least) {
        if (text.size() < least) return;
        write(text);
        text.clear();
    };
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        if (row > 0) text += ",";
        append_number(text, value(row, time));
        flush(block_bytes);
    }
    text += "], \"values\": [";
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (row + k > 0) text += ",";
            append_number(text, value(row, q[k]));
        }
        flush(block_bytes);
    }
    text += "]}]}\n";
    flush(0);
}

constexpr std::array<TableFormat, 4> formats{{
    {"csv", ".csv", "one line per instant, numbers separated by commas", write_csv},
    {"jsonl", ".jsonl", "one JSON object per line", write_json_lines},
    {"json", ".json", "the attitude as keyframes, which three.js and Blender read",
     write_keyframes},
    {"npy", ".npy", "a NumPy array whose fields are the columns", write_npy},
}};

Quantities wanted_of(const Motion& motion, std::span<const ChosenColumn> columns) {
    Quantities wanted{.attitude = false};
    for (const ChosenColumn& column : columns) {
        const Quantities& q = column.quantity->wanted;
        wanted.attitude = wanted.attitude || q.attitude;
        wanted.herpolhode = wanted.herpolhode || q.herpolhode;
        wanted.euler_angles = wanted.euler_angles || q.euler_angles;
    }
    wanted.euler_angles = wanted.euler_angles && motion.regime() == Regime::heavy_top;
    return wanted;
}

// Adjacent columns of one quantity, whose values are computed once.
struct Run {
    const Quantity* quantity = nullptr;
    std::vector<std::size_t> indices;
};

std::vector<Run> runs_of(std::span<const ChosenColumn> columns) {
    std::vector<Run> runs;
    for (const ChosenColumn& column : columns) {
        if (runs.empty() || runs.back().quantity != column.quantity)
            runs.push_back({column.quantity, {}});
        runs.back().indices.push_back(column.index);
    }
    return runs;
}

void append_row(const QuantitySource& source, const MotionSample& sample, std::span<const Run> runs,
                std::vector<double>& values) {
    std::array<double, 8> of_quantity{};
    for (const Run& run : runs) {
        run.quantity->values(source, sample, of_quantity.data());
        for (const std::size_t index : run.indices) {
            if (!std::isfinite(of_quantity[index]))
                throw InputError(
                    fmt::format("{} lies beyond the range of double-precision numbers; leave it "
                                "out, or choose other units",
                                run.quantity->name));
            values.push_back(of_quantity[index]);
        }
    }
}

// Calls take(row's number, row's values) for every instant.
template <typename Take>
void each_row(const Motion& motion, std::span<const ChosenColumn> columns,
              std::span<const double> times_s, std::string_view asked_by, Take take) {
    if (!columns.empty() && times_s.size() > most_sampled_values / columns.size())
        throw InputError(
            fmt::format("{}: {} instants of {} columns are more than the {} numbers that one table "
                        "holds; split them into several runs",
                        asked_by, times_s.size(), columns.size(), most_sampled_values));
    const Quantities wanted = wanted_of(motion, columns);
    const std::vector<Run> runs = runs_of(columns);
    QuantitySource source{motion.problem().inertia, nullptr, wanted.euler_angles};
    const bool certifies = std::any_of(columns.begin(), columns.end(), [](const auto& column) {
        return column.quantity->offered != nullptr;
    });
    std::optional<PoinsotConstruction> construction;
    if (certifies)
        source.construction =
            &construction.emplace(motion.problem().inertia, motion.problem().start);
    std::vector<double> row;
    constexpr std::size_t rows_between_looks = 4096;
    for (std::size_t k = 0; k < times_s.size(); ++k) {
        if (k % rows_between_looks == 0) stop_if_interrupted();
        row.clear();
        try {
            append_row(source, motion.sample(times_s[k], wanted), runs, row);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{} {}: {}", asked_by, times_s[k], error.what()));
        }
        take(k, row);
    }
}

std::vector<std::string> headings_of(std::span<const ChosenColumn> columns) {
    std::vector<std::string> headings;
    for (const ChosenColumn& column : columns) headings.push_back(column.heading);
    return headings;
}

}  // namespace

SampleTable sample_table(const Motion& motion, std::span<const ChosenColumn> columns,
                         std::span<const double> times_s, std::string_view asked_by) {
    SampleTable table{headings_of(columns), {}};
    each_row(motion, columns, times_s, asked_by, [&](std::size_t k, std::span<const double> row) {
        if (k == 0) table.values.reserve(times_s.size() * row.size());
        table.values.insert(table.values.end(), row.begin(), row.end());
    });
    return table;
}

SampleTable sample_columns(const Motion& motion, std::span<const ChosenColumn> columns,
                           std::span<const double> times_s, std::string_view asked_by) {
    const std::size_t n = times_s.size();
    SampleTable table{headings_of(columns), {}};
    each_row(motion, columns, times_s, asked_by, [&](std::size_t k, std::span<const double> row) {
        if (k == 0) table.values.resize(n * row.size());
        for (std::size_t i = 0; i < row.size(); ++i) table.values[i * n + k] = row[i];
    });
    return table;
}

std::span<const TableFormat> table_formats() { return formats; }

const TableFormat& table_format_for(const std::filesystem::path& path) {
    const std::string suffix = suffix_of(path);
    std::string known;
    for (const TableFormat& format : formats) {
        if (format.suffix == suffix) return format;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", format.suffix);
    }
    throw InputError(fmt::format("{}: no table format has this suffix; end the name with {}",
                                 printable(path.string()), known));
}

}  // namespace poinsot
