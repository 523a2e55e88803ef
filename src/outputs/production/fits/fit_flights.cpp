#include "production/fits/fit_flights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "error/error.h"
#include "measured/fit_start.h"
#include "measured/flight_fit.h"
#include "measured/flights.h"
#include "measured/table_faults.h"
#include "production/fits/fit_words.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

std::size_t n_between(const std::vector<MeasuredRow>& rows, double first_s, double last_s) {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [first_s, last_s](const MeasuredRow& row) {
            return row.time_s >= first_s && row.time_s <= last_s;
        }));
}

// How little a flight says about the body.
double uncertainty_of(const TableFlight& flight) {
    if (!flight.fit) return std::numeric_limits<double>::infinity();
    return std::sqrt(flight.fit->moments_sd.squaredNorm() + flight.fit->axes_sd_rad.squaredNorm());
}

void fit_into(TableFlight& flight, const FitKnown& known) {
    try {
        flight.fit = fit_motion(flight.measured.rows, known.moments_kg_m2, known.drag);
    } catch (const InputError& error) {
        flight.refusal = error.what();
        if (const std::string doubt = unit_doubt_of(flight.measured.rows); !doubt.empty())
            flight.refusal += "; " + doubt;
    }
}

TableFlight all_of(MeasuredMotion measured, const std::filesystem::path& file) {
    add_omega_by_differences(measured);
    TableFlight flight;
    flight.name = printable(file.string());
    flight.rate_rad_s = rate_of(measured.rows);
    flight.measured = std::move(measured);
    return flight;
}

}  // namespace

FitTable table_of_flight(MeasuredMotion measured, const std::filesystem::path& file,
                         const FitKnown& known) {
    FitTable table;
    table.file = file;
    table.n_rows = measured.rows.size();
    table.flights = {all_of(std::move(measured), file)};
    fit_into(table.flights.front(), known);
    return table;
}

FitTable fitted_table(MeasuredMotion measured, const std::filesystem::path& file,
                      const FitKnown& known) {
    FitTable table;
    table.file = file;
    table.n_rows = measured.rows.size();
    TableFlight whole = all_of(std::move(measured), file);
    const MeasuredMotion& all = whole.measured;
    // Where Euler's equations explain nothing, a fit would only take time.
    constexpr double most_unexplained = 0.5, most_share = 0.01, most_rad = 0.02;
    constexpr double most_of_flight = 2.0;
    bool is_whole = false;
    if (unexplained_share(all.rows) < most_unexplained) {
        fit_into(whole, known);
        is_whole =
            whole.fit &&
            whole.fit->residual < (whole.fit->attitude ? most_rad : most_share * whole.rate_rad_s);
    }
    if (!is_whole)
        for (const FreeFlight& found : flights_of(all.rows)) {
            TableFlight flight;
            flight.number = table.flights.size() + 1;
            flight.name = fmt::format("{}, flight {}", whole.name, flight.number);
            flight.measured = {found.rows, all.has_omega, all.has_attitude};
            flight.n_limited =
                n_between(all.rows, found.begin_s(), found.end_s()) - found.rows.size();
            flight.rate_rad_s = found.rate_rad_s;
            fit_into(flight, known);
            table.flights.push_back(std::move(flight));
        }
    constexpr std::size_t most_times = 3;
    const bool may_be_one =
        table.flights.empty() ||
        (table.flights.size() == 1 &&
         most_times * table.flights.front().measured.rows.size() > table.n_rows);
    if (may_be_one && !whole.fit && whole.refusal.empty()) fit_into(whole, known);
    if (may_be_one && !table.flights.empty() && whole.fit) {
        const auto& part = table.flights.front().fit;
        is_whole = !part || whole.fit->residual < most_of_flight * part->residual;
    }
    table.is_recording = !is_whole && !table.flights.empty();
    if (!table.is_recording)
        table.flights = {std::move(whole)};
    else if (whole.fit)
        table.why_parts = fmt::format("all rows together leave {:.2g} {}", whole.fit->residual,
                                      whole.fit->unit());
    else
        table.why_parts = "in the others, ω is not that of a free body";
    return table;
}

std::vector<std::string> notes_of(const FitTable& table, const TableFlight& flight) {
    std::vector<std::string> notes = notes_of(*flight.fit, flight.measured);
    if (!table.is_recording) return notes;
    const auto& rows = flight.measured.rows;
    const std::string of_flights =
        table.flights.size() == 1
            ? ""
            : fmt::format(", flight {} of {}", flight.number, table.flights.size());
    notes.insert(notes.begin(),
                 fmt::format("{} of {} rows are fitted, from {:.6g} to {:.6g} s{}: {}", rows.size(),
                             table.n_rows, rows.front().time_s, rows.back().time_s, of_flights,
                             table.why_parts));
    return notes;
}

std::vector<std::string> words_of(const FitTable& table, const TableFlight& flight) {
    std::vector<std::string> lines = result_lines(*flight.fit);
    for (const std::string& note : notes_of(table, flight))
        lines.push_back(fmt::format("note: {}", note));
    return lines;
}

const TableFlight& best_of(const FitTable& table) {
    return *std::min_element(table.flights.begin(), table.flights.end(),
                             [](const TableFlight& a, const TableFlight& b) {
                                 return uncertainty_of(a) < uncertainty_of(b);
                             });
}

const TableFlight& best_flight(const FitTable& table) {
    const TableFlight& best = best_of(table);
    if (!best.fit) throw InputError(fmt::format("{}: {}", best.name, best.refusal));
    return best;
}

std::optional<Eigen::Quaterniond> attitude_of(const TableFlight& flight) {
    if (flight.fit && flight.fit->attitude) return flight.fit->attitude;
    if (!flight.measured.has_attitude) return std::nullopt;
    return flight.measured.rows.front().space_from_body;
}

std::vector<std::string> flight_lines(const FitTable& table) {
    std::vector<std::string> lines;
    for (const TableFlight& flight : table.flights) {
        const auto& rows = flight.measured.rows;
        std::string line =
            fmt::format("{:3}  {:.2f} to {:.2f} s, |ω| = {:.1f} rad/s", flight.number,
                        rows.front().time_s, rows.back().time_s, flight.rate_rad_s);
        if (flight.fit) {
            line += fmt::format(", residual {:.3g} {}", flight.fit->residual, flight.fit->unit());
            if (!flight.fit->I1_kg_m2)
                line += fmt::format(", I2/I1 = {}, I3/I1 = {}",
                                    with_sd(flight.fit->moments[1], flight.fit->moments_sd[1]),
                                    with_sd(flight.fit->moments[2], flight.fit->moments_sd[2]));
        } else {
            line += fmt::format(": {}", flight.refusal);
        }
        if (flight.n_limited > 0)
            line +=
                fmt::format("; {} rows at the limit of the sensor are left out", flight.n_limited);
        lines.push_back(line);
    }
    return lines;
}

std::string json_of_flights(const FitTable& table) {
    std::vector<std::string> list;
    for (const TableFlight& flight : table.flights) {
        JsonObject one;
        one.add("number", flight.number)
            .add("begin_s", flight.measured.rows.front().time_s)
            .add("end_s", flight.measured.rows.back().time_s)
            .add("rate_rad_s", flight.rate_rad_s);
        if (flight.fit) {
            const FittedMotion& fit = *flight.fit;
            add_residual(one, fit);
            one.json("moments", json_numbers(fit.moments[0], fit.moments[1], fit.moments[2]))
                .json("moments_sd",
                      json_numbers(fit.moments_sd[0], fit.moments_sd[1], fit.moments_sd[2]));
        } else {
            one.add("refusal", flight.refusal);
        }
        list.push_back(one.line());
    }
    return json_lines(list, 2);
}

std::string table_text(const MeasuredMotion& measured) {
    std::string text = "time_s";
    if (measured.has_omega) text += ",omega_x_rad_s,omega_y_rad_s,omega_z_rad_s";
    text += measured.has_attitude ? ",q_w,q_x,q_y,q_z\n" : "\n";
    for (const MeasuredRow& row : measured.rows) {
        const Eigen::Vector3d& w = row.omega_body;
        text += fmt::format("{}", row.time_s);
        if (measured.has_omega) text += fmt::format(",{},{},{}", w[0], w[1], w[2]);
        const Eigen::Quaterniond& q = row.space_from_body;
        text += measured.has_attitude ? fmt::format(",{},{},{},{}\n", q.w(), q.x(), q.y(), q.z())
                                      : "\n";
    }
    return text;
}

}  // namespace poinsot
