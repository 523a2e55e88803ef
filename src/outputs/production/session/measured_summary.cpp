#include "production/session/measured_summary.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "measured/departure.h"
#include "measured/table_faults.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

void add_faults(const MeasuredMotion& measured, std::vector<SummaryLine>& lines) {
    const std::vector<MeasuredGap> gaps = gaps_of(measured.rows);
    std::vector<std::string> spans;
    spans.reserve(gaps.size());
    for (const MeasuredGap& gap : gaps)
        spans.push_back(fmt::format("[{}, {}]", json_number(gap.from_s), json_number(gap.to_s)));
    lines.push_back({"measured_gaps_s", json_list(spans), gaps.empty() ? "" : "gaps in its table",
                     in_words(gaps)});
    std::vector<std::string> limits;
    std::string words;
    for (const Saturation& saturation : saturations_of(measured.rows)) {
        limits.push_back(JsonObject()
                             .add("component", fmt::format("omega_{}", "xyz"[saturation.component]))
                             .add("value_rad_s", saturation.value_rad_s)
                             .add("rows", saturation.n_rows)
                             .add("from_s", saturation.from_s)
                             .line());
        words += (words.empty() ? "" : "; ") + in_words(saturation);
    }
    lines.push_back({"measured_saturation", json_list(limits),
                     words.empty() ? "" : "saturation in its table", words});
}

}  // namespace

void add_measured(const Session& session, double first_s, double last_s,
                  std::vector<SummaryLine>& lines) {
    const MeasuredSpec& measured = session.scene.measured;
    const MeasuredMotion& table = measured.motion;
    Departure departure(session.motion);
    double sum = 0.0;
    Peak worst;
    for (const MeasuredRow& row : table.rows) {
        if (row.time_s < first_s || row.time_s > last_s) continue;
        departure.add(row, true, table.has_attitude);
        const double off = *departure.last().omega_rad_s;
        sum += off * off;
        worst.take(off, row.time_s);
    }
    const std::size_t n = departure.n_rows();
    lines.push_back(
        {"measured_file", json_string(measured.file), "measured motion",
         fmt::format("{}: {} of {} rows in the film{}", measured.file, n, table.rows.size(),
                     measured.has_derived_omega ? ", ω from differences of attitudes" : "")});
    lines.push_back({"measured_rows", fmt::format("{}", n), "", ""});
    if (n > 0) {
        const double rms = std::sqrt(sum / (3.0 * static_cast<double>(n)));
        lines.push_back({"measured_rms_rad_s", json_number(rms), "residual of the measured ω",
                         fmt::format("root mean square {:.3g} rad/s per component; largest "
                                     "{:.3g} rad/s, at {:.6g} s",
                                     rms, worst.value, worst.time_s)});
        lines.push_back({"measured_worst_rad_s", json_number(worst.value), "", ""});
        lines.push_back({"measured_worst_at_s", json_number(worst.time_s), "", ""});
        const auto add_share = [&lines](std::string key, std::string label, const Peak& peak,
                                        const std::optional<double>& last) {
            if (!last) return;
            lines.push_back({std::move(key), json_number(peak.value), std::move(label),
                             fmt::format("largest {:.3g} %, at {:.6g} s; at the last row {:+.3g} %",
                                         100.0 * peak.value, peak.time_s, 100.0 * *last)});
        };
        const auto add_angle = [&lines](std::string key, std::string label, const Peak& peak,
                                        const std::optional<double>& last) {
            if (!last) return;
            lines.push_back({std::move(key), json_number(peak.value), std::move(label),
                             fmt::format("largest {:.3g} rad, at {:.6g} s; at the last row {:.3g} "
                                         "rad",
                                         peak.value, peak.time_s, *last)});
        };
        const DepartureAt& last = departure.last();
        add_share("measured_energy_share", "drift of the measured T", departure.energy_share(),
                  last.energy_share);
        add_share("measured_momentum_share", "drift of the measured |L|",
                  departure.momentum_share(), last.momentum_share);
        add_angle("measured_attitude_rad", "error of the measured attitude",
                  departure.attitude_rad(), last.attitude_rad);
        add_angle("measured_momentum_tilt_rad", "tilt of the measured L",
                  departure.momentum_tilt_rad(), last.momentum_tilt_rad);
    }
    add_faults(table, lines);
}

}  // namespace poinsot
