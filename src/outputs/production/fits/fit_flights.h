// The flights of the tables that `poinsot fit` and the workbench read, each with a fit of its own.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measured/fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

struct TableFlight {
    std::string name;           // "throws.csv, flight 3"
    std::size_t number = 1;     // in its table, from 1 on
    MeasuredMotion measured;    // its rows
    std::size_t n_limited = 0;  // rows at the limit of the sensor that were left out
    double rate_rad_s = 0.0;    // root mean square of |ω|
    std::optional<FittedMotion> fit;
    std::string refusal;  // why there is none
};

struct FitTable {
    std::filesystem::path file;
    bool is_recording = false;  // of which the flights are parts
    std::size_t n_rows = 0;
    std::string why_parts;  // of a recording: why its rows are not one flight
    std::vector<TableFlight> flights;
};

// Values known beforehand.
struct FitKnown {
    std::optional<Eigen::Vector3d> moments_kg_m2;
    std::optional<DragModel> drag;
};

// Finds the flights of a table and fits each. A table is one flight as a whole where this leaves a
// residual of its kind, less than 1 % of |ω|, than 0.02 rad of attitudes or than twice that of the
// one flight in it, and where no flight is found. Of rows without ω, the attitudes are fitted.
// `file`: for names and messages; it is not opened.
FitTable fitted_table(MeasuredMotion measured, const std::filesystem::path& file,
                      const FitKnown& known);

// All rows as one flight, however they fit.
FitTable table_of_flight(MeasuredMotion measured, const std::filesystem::path& file,
                         const FitKnown& known);

// The flight that says most about the body: the one with the smallest standard deviations of
// moments and axes. Without any fit, the first one; best_flight then throws InputError.
const TableFlight& best_of(const FitTable& table);
const TableFlight& best_flight(const FitTable& table);

// The notes of a flight's fit, the first of which says which rows of the table it leaves out, and
// why; and all words, as of a fit. Precondition: the flight has a fit.
std::vector<std::string> notes_of(const FitTable& table, const TableFlight& flight);
std::vector<std::string> words_of(const FitTable& table, const TableFlight& flight);

// Space from body at the first row: as fitted, else as measured, if the table has attitudes.
std::optional<Eigen::Quaterniond> attitude_of(const TableFlight& flight);

// The list of flights, a line each.
std::vector<std::string> flight_lines(const FitTable& table);
// [{"number": 1, …}, …]
std::string json_of_flights(const FitTable& table);

// Rows as a table that `fit` and scenes read; without ω where it is derived from the attitudes.
std::string table_text(const MeasuredMotion& measured);

}  // namespace poinsot
