#include "measured/table_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot {

std::vector<MeasuredGap> gaps_of(std::span<const MeasuredRow> rows) {
    constexpr double most_steps = 3.0;
    if (rows.size() < 3) return {};
    std::vector<double> steps_s;
    steps_s.reserve(rows.size() - 1);
    for (std::size_t i = 1; i < rows.size(); ++i)
        steps_s.push_back(rows[i].time_s - rows[i - 1].time_s);
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    const double most_s = most_steps * *middle;
    std::vector<MeasuredGap> gaps;
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i].time_s - rows[i - 1].time_s > most_s)
            gaps.push_back({i - 1, rows[i - 1].time_s, rows[i].time_s});
    return gaps;
}

std::vector<std::span<const MeasuredRow>> stretches_of(std::span<const MeasuredRow> rows,
                                                       double first_s, double last_s) {
    std::vector<std::span<const MeasuredRow>> stretches;
    const auto add = [&](std::size_t begin, std::size_t end) {
        while (begin < end && rows[begin].time_s < first_s) ++begin;
        while (begin < end && rows[end - 1].time_s > last_s) --end;
        if (begin < end) stretches.push_back(rows.subspan(begin, end - begin));
    };
    std::size_t begin = 0;
    for (const MeasuredGap& gap : gaps_of(rows)) {
        add(begin, gap.before + 1);
        begin = gap.before + 1;
    }
    add(begin, rows.size());
    return stretches;
}

double resolution_of(std::span<const MeasuredRow> rows, int component) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double step =
            std::abs(rows[i].omega_body[component] - rows[i - 1].omega_body[component]);
        if (step > 0.0) least = std::min(least, step);
    }
    return least;
}

std::vector<Saturation> saturations_of(std::span<const MeasuredRow> rows) {
    constexpr std::size_t least_rows = 3;
    // A sensor's two limits are about equal; the smaller extreme of a component may be rest.
    constexpr double least_share = 0.5;
    // A rounded value also stays at a smooth maximum, but comes there by the smallest steps.
    constexpr double least_steps = 2.5;
    std::vector<Saturation> found;
    for (int k = 0; k < 3; ++k) {
        double least = 0.0, most = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double value = rows[i].omega_body[k];
            least = i == 0 ? value : std::min(least, value);
            most = i == 0 ? value : std::max(most, value);
        }
        if (!(least < most)) continue;
        const double largest = std::max(std::abs(least), std::abs(most));
        const double least_jump = least_steps * resolution_of(rows, k);
        for (const double limit : {most, least}) {
            // An upper limit is positive, a lower one negative.
            if (limit == most ? limit <= 0.0 : limit >= 0.0) continue;
            if (std::abs(limit) < least_share * largest) continue;
            const auto jumps_at = [&](std::size_t i) {
                return std::abs(rows[i].omega_body[k] - limit) > least_jump;
            };
            Saturation at{k, limit, 0, 0.0};
            for (std::size_t begin = 0; begin < rows.size(); ++begin) {
                std::size_t end = begin;
                while (end < rows.size() && rows[end].omega_body[k] == limit) ++end;
                const bool is_sudden =
                    (begin > 0 && jumps_at(begin - 1)) || (end < rows.size() && jumps_at(end));
                if (end - begin >= least_rows && is_sudden) {
                    if (at.n_rows == 0) at.from_s = rows[begin].time_s;
                    at.n_rows += end - begin;
                }
                begin = end;
            }
            if (at.n_rows > 0) found.push_back(at);
        }
    }
    return found;
}

std::string unit_doubt_of(std::span<const MeasuredRow> rows) {
    // Gyroscopes of phones end at 2000 °/s, 34.9 rad/s.
    constexpr double most_of_phone_rad_s = 36.0, most_turn_rad = 0.5;
    constexpr double degrees_in_radian = 57.3;
    if (rows.size() < 3) return "";
    double most_rad_s = 0.0;
    std::vector<double> turns_rad, steps_s;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        most_rad_s = std::max(most_rad_s, rows[i].omega_body.cwiseAbs().maxCoeff());
        if (i == 0) continue;
        steps_s.push_back(rows[i].time_s - rows[i - 1].time_s);
        turns_rad.push_back(rows[i].omega_body.cwiseAbs().maxCoeff() * steps_s.back());
    }
    const auto median_of = [](std::vector<double>& values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    const double step_s = median_of(steps_s), turn_rad = median_of(turns_rad);
    if (most_rad_s > most_of_phone_rad_s && turn_rad / degrees_in_radian < most_turn_rad)
        return fmt::format(
            "ω reaches {:.3g} rad/s, and the gyroscope of a phone {:.3g}: the values look like "
            "degrees a second; if they are, name the columns as in \"omega_x (deg/s)\"",
            most_rad_s, 34.9);
    // A clock that counts in whole units of its own; rows come every few milliseconds.
    constexpr double least_step_s = 1.0, least_rows_step_s = 1e-4;
    struct Unit {
        const char* name;
        const char* symbol;
        double in_s;
    };
    constexpr Unit units[] = {
        {"milliseconds", "ms", 1e-3}, {"microseconds", "us", 1e-6}, {"nanoseconds", "ns", 1e-9}};
    if (turn_rad > most_turn_rad && step_s >= least_step_s)
        for (const Unit& unit : units)
            if (turn_rad * unit.in_s < most_turn_rad && step_s * unit.in_s >= least_rows_step_s)
                return fmt::format(
                    "from row to row the body would turn by {:.3g} rad in {:.3g} s: the times look "
                    "like {}; if they are, name the column \"time ({})\"",
                    turn_rad, step_s, unit.name, unit.symbol);
    return "";
}

std::string in_words(const Saturation& saturation) {
    return fmt::format(
        "omega_{} stays at {:.6g} rad/s for {} rows from {:.6g} s on: the sensor's "
        "limit?",
        "xyz"[saturation.component], saturation.value_rad_s, saturation.n_rows, saturation.from_s);
}

std::string in_words(std::span<const MeasuredGap> gaps) {
    if (gaps.empty()) return "";
    const auto longest =
        *std::max_element(gaps.begin(), gaps.end(), [](const MeasuredGap& a, const MeasuredGap& b) {
            return a.to_s - a.from_s < b.to_s - b.from_s;
        });
    const std::string one =
        fmt::format("{:.3g} s from {:.6g} s on", longest.to_s - longest.from_s, longest.from_s);
    return gaps.size() == 1
               ? "no rows for " + one
               : fmt::format("no rows in {} stretches, the longest of {}", gaps.size(), one);
}

}  // namespace poinsot
