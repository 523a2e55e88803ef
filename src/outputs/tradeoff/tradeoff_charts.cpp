#include <fmt/format.h>

#include <algorithm>

#include "tradeoff/tradeoff_report.h"

namespace poinsot {

namespace {

// The exact motion is the reference itself; it is drawn at the largest error in accuracy_table.
constexpr double least_error = 1.1e-15;

}  // namespace

Chart motion_chart(const Session& session, const Tradeoff& t) {
    Chart chart;
    chart.title =
        fmt::format("{}: work and precision of the methods",
                    session.scene.title.empty() ? session.scene.name : session.scene.title);
    chart.x_label = "processor time a frame / ns";
    chart.y_label = "worst error of the attitude / rad";
    for (const MotionTrade& row : t.motion.rows) {
        if (chart.series.empty() || chart.series.back().name != row.method) {
            chart.series.push_back({row.method, {}});
        }
        chart.series.back().points.push_back(
            {row.ns_a_frame, std::max(row.attitude_rad, least_error), row.on_front, ""});
    }
    return chart;
}

Chart picture_chart(const Tradeoff& t) {
    Chart chart;
    chart.title = "Settings of the picture against its error";
    chart.x_label = "processor time a frame / ms";
    chart.y_label = "error of the picture / levels";
    // One line per number of samples, along which the tolerance of curves varies.
    int samples = 0;
    for (const PictureTrade& row : t.picture.rows) {
        if (row.samples != samples) {
            samples = row.samples;
            chart.series.push_back(
                {samples == 1 ? "analytic edges alone" : fmt::format("{0} × {0} samples", samples),
                 {}});
        }
        const std::string name = row.quality.empty() ? "" : "\\textbf{" + row.quality + "}";
        chart.series.back().points.push_back({row.ms_a_frame, row.rms_levels, row.on_front, name});
    }
    return chart;
}

Chart film_chart(const Tradeoff& t) {
    Chart chart;
    chart.title = "Encoder settings against the likeness of the film";
    chart.x_label = "processor time a frame / ms";
    chart.y_label = "one less the structural similarity";
    for (const FilmTrade& row : t.film.rows) {
        chart.series.push_back({"\\textbf{" + row.quality + "}",
                                {{row.ms_a_frame, row.unlikeness, row.on_front, ""}}});
    }
    return chart;
}

}  // namespace poinsot
