#include "production/fits/fit_flights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "error/error.h"
#include "measured/flight_fit.h"
#include "measured/flights.h"
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

}  // namespace

FitTable fitted_table(MeasuredMotion measured, const std::filesystem::path& file,
                      const FitKnown& known) {
    FitTable table;
    table.file = file;
    add_omega_by_differences(measured);
    const std::vector<FreeFlight> flights = flights_of(measured.rows);
    constexpr double least_share = 0.8;
    const bool is_one =
        flights.empty() ||
        (flights.size() == 1 && static_cast<double>(flights.front().rows.size()) >=
                                    least_share * static_cast<double>(measured.rows.size()));
    const std::string name = printable(file.string());
    if (is_one) {
        TableFlight flight;
        flight.name = name;
        flight.rate_rad_s = rate_of(measured.rows);
        try {
            flight.fit = fit_motion(measured.rows, known.moments_kg_m2, known.drag);
        } catch (const InputError& error) {
            flight.refusal = error.what();
        }
        flight.measured = std::move(measured);
        table.flights.push_back(std::move(flight));
        return table;
    }
    table.is_recording = true;
    for (const FreeFlight& found : flights) {
        TableFlight flight;
        flight.number = table.flights.size() + 1;
        flight.name = fmt::format("{}, flight {}", name, flight.number);
        flight.measured = {found.rows, measured.has_omega, measured.has_attitude};
        flight.n_limited =
            n_between(measured.rows, found.begin_s(), found.end_s()) - found.rows.size();
        flight.rate_rad_s = found.rate_rad_s;
        try {
            flight.fit = fit_motion(found.rows, known.moments_kg_m2, known.drag);
        } catch (const InputError& error) {
            flight.refusal = error.what();
        }
        table.flights.push_back(std::move(flight));
    }
    return table;
}

const TableFlight& best_flight(const FitTable& table) {
    const auto best = std::min_element(table.flights.begin(), table.flights.end(),
                                       [](const TableFlight& a, const TableFlight& b) {
                                           return uncertainty_of(a) < uncertainty_of(b);
                                       });
    if (!best->fit) throw InputError(fmt::format("{}: {}", best->name, best->refusal));
    return *best;
}

std::vector<std::string> flight_lines(const FitTable& table) {
    std::vector<std::string> lines;
    for (const TableFlight& flight : table.flights) {
        const auto& rows = flight.measured.rows;
        std::string line =
            fmt::format("{:3}  {:.2f} to {:.2f} s, |ω| = {:.1f} rad/s", flight.number,
                        rows.front().time_s, rows.back().time_s, flight.rate_rad_s);
        if (flight.fit) {
            line += fmt::format(", residual {:.3g} rad/s", flight.fit->residual_rad_s);
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
            one.add("residual_rad_s", fit.residual_rad_s)
                .json("moments", json_numbers(fit.moments[0], fit.moments[1], fit.moments[2]))
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
    std::string text = "time_s,omega_x_rad_s,omega_y_rad_s,omega_z_rad_s";
    text += measured.has_attitude ? ",q_w,q_x,q_y,q_z\n" : "\n";
    for (const MeasuredRow& row : measured.rows) {
        const Eigen::Vector3d& w = row.omega_body;
        text += fmt::format("{},{},{},{}", row.time_s, w[0], w[1], w[2]);
        const Eigen::Quaterniond& q = row.space_from_body;
        text += measured.has_attitude ? fmt::format(",{},{},{},{}\n", q.w(), q.x(), q.y(), q.z())
                                      : "\n";
    }
    return text;
}

}  // namespace poinsot
