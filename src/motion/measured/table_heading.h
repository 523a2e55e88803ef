// The first line of a table of measurements: what each column is, from its heading.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot {

enum class ColumnKind { other, time, omega, quaternion, matrix };
inline constexpr std::size_t n_column_kinds = 5;

// The least rank of a name that is ω's alone: "gyroscope_x", not "x".
inline constexpr int sure_rank = 2;

struct TableHeading {
    ColumnKind kind = ColumnKind::other;
    int component = 0;  // of ω 0 to 2, of a quaternion w, x, y, z, of a matrix row by row
    // Of several columns of a kind, those with the highest rank are meant: "seconds_elapsed" before
    // "time", "gyroscope_x" before "x".
    int rank = 0;
    std::string name;           // in lower case, words joined by '_', without the unit
    std::string unit;           // as written; empty: none
    double si_in_unit = 1.0;    // s or rad/s in one unit
    bool is_unit_known = true;  // the unit is one of the kind's, or there is none
};

// What a heading says, in English, German, French, Spanish, Italian or Japanese, and in the words
// of phyphox, Sensor Logger, Physics Toolbox and of Arduino's Science Journal and libraries.
TableHeading table_heading_of(std::string_view cell);

// A cell without the blanks and quotes around it.
std::string_view unquoted_cell(std::string_view cell);

}  // namespace poinsot
