// poinsot tradeoff SCENE: measures speed against accuracy for a scene, on this machine.
#include "lab/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cli/command.h"
#include "cli/requests.h"
#include "drawing/charts/chart.h"
#include "drawing/reach.h"
#include "image/png.h"
#include "production/output_place.h"
#include "production/picture.h"
#include "system/atomic_file.h"
#include "text/json_text.h"
#include "text/say.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

struct Tradeoff {
    MotionTrades motion;
    PictureTrades picture;
    FilmTrades film;
};

std::string machine_in_words() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    std::string model = "unknown processor";
    for (std::string line; std::getline(cpuinfo, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        model = line.substr(line.find(':') + 2);
        break;
    }
    return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
}

std::string how_measured(const Tradeoff& t) {
    return fmt::format(
        "processor time, medians of at least {} runs (motion), {} (picture), 3 (film) on {}",
        t.motion.n_runs, t.picture.n_runs, machine_in_words());
}

// The cheapest row of the motion within a displacement, or null.
const MotionTrade* cheapest_within(const MotionTrades& trades, double displacement_px,
                                   bool exact_too) {
    const MotionTrade* best = nullptr;
    for (const MotionTrade& row : trades.rows) {
        if (row.displacement_px > displacement_px || (!exact_too && row.method == "exact"))
            continue;
        if (best == nullptr || row.ns_a_frame < best->ns_a_frame) best = &row;
    }
    return best;
}

std::string advice(const Session& session, const Tradeoff& t) {
    const double accuracy_px = session.scene.accuracy_px;
    const MotionTrade* any = cheapest_within(t.motion, accuracy_px, true);
    const MotionTrade* stepped = cheapest_within(t.motion, accuracy_px, false);
    if (any == nullptr) {
        return fmt::format("No method reaches {} px here: give a shorter film or a smaller step.",
                           accuracy_px);
    }
    std::string text =
        fmt::format("Use {}{}{}", any->method, any->setting.empty() ? "" : " with ", any->setting);
    if (any->method == "exact" && stepped != nullptr) {
        text += fmt::format(", at {:.2g} of the cost of the cheapest stepper within {} px ({}, {})",
                            any->ns_a_frame / stepped->ns_a_frame, accuracy_px, stepped->method,
                            stepped->setting);
    }
    return text + fmt::format(
                      "; the motion is {:.2g} % of what drawing a frame costs at {}x{} and quality "
                      "{} ({:.3g} ms), so time is won in the picture and the encoder.",
                      any->ns_a_frame * 1e-6 / std::max(t.picture.film_ms, 1e-9) * 100.0,
                      session.scene.film.width_px, session.scene.film.height_px,
                      session.scene.film.quality, t.picture.film_ms);
}

std::string drift(double value) {
    return std::isfinite(value) ? fmt::format("{:.2e}", value) : "-";
}

// The rows that no other beats, or all of them.
void print_table(const Session& session, const Tradeoff& t, bool all) {
    fmt::print("motion: {} frames, against {}\n", t.motion.n_frames, t.motion.truth);
    fmt::print("  {:12} {:18} {:>11} {:>9} {:>10} {:>10} {:>10} {:>10}\n", "method", "setting",
               "ns/frame", "evals", "angle/rad", "T drift", "L drift", "px");
    for (const MotionTrade& r : t.motion.rows) {
        if (!all && !r.on_front) continue;
        fmt::print("{} {:12} {:18} {:11.0f} {:9.1f} {:10.2e} {:>10} {:>10} {:10.2e}\n",
                   r.on_front ? "*" : " ", r.method, r.setting, r.ns_a_frame, r.evaluations_a_frame,
                   r.attitude_rad, drift(r.energy), drift(r.momentum), r.displacement_px);
    }
    fmt::print("picture: {}×{}, against {}\n", t.picture.width_px, t.picture.height_px,
               t.picture.reference);
    fmt::print("  {:48} {:10} {:>9} {:>11} {:>8}\n", "setting", "quality", "ms/frame", "rms levels",
               "largest");
    for (const PictureTrade& r : t.picture.rows) {
        if (!all && !r.on_front) continue;
        fmt::print("{} {:48} {:10} {:9.2f} {:11.4f} {:8.0f}\n", r.on_front ? "*" : " ", r.setting,
                   r.quality, r.ms_a_frame, r.rms_levels, r.largest_levels);
    }
    fmt::print("film: {} frames of {}×{}, H.264\n", t.film.n_frames, t.film.width_px,
               t.film.height_px);
    fmt::print("  {:12} {:>9} {:>12} {:>9}\n", "quality", "ms/frame", "bytes/frame", "SSIM");
    for (const FilmTrade& r : t.film.rows) {
        if (!all && !r.on_front) continue;
        fmt::print("{} {:12} {:9.2f} {:12.0f} {:9.5f}\n", r.on_front ? "*" : " ", r.quality,
                   r.ms_a_frame, r.bytes_a_frame, r.ssim);
    }
    fmt::print("{}. {}.\n{}\n",
               all ? "*: on the Pareto front"
                   : "The Pareto front; --all prints every row, as the CSV and the JSON have it",
               how_measured(t), advice(session, t));
}

std::string csv_of(const Tradeoff& t) {
    std::string csv = "table,name,setting,cost_ns_a_frame,error,error_is,on_front\n";
    for (const MotionTrade& r : t.motion.rows) {
        csv += fmt::format("motion,{},{},{},{},attitude_rad,{}\n", r.method, r.setting,
                           r.ns_a_frame, r.attitude_rad, r.on_front);
    }
    for (const PictureTrade& r : t.picture.rows) {
        csv += fmt::format("picture,{},\"{}\",{},{},rms_levels,{}\n", r.quality, r.setting,
                           r.ms_a_frame * 1e6, r.rms_levels, r.on_front);
    }
    for (const FilmTrade& r : t.film.rows) {
        csv += fmt::format("film,{},,{},{},one_minus_ssim,{}\n", r.quality, r.ms_a_frame * 1e6,
                           1.0 - r.ssim, r.on_front);
    }
    return csv;
}

std::string json_of(const Session& session, const Tradeoff& t) {
    std::string json = fmt::format("{{\n  \"scene\": {},\n  \"measured\": {},\n  \"advice\": {},\n",
                                   json_string(session.scene.name), json_string(how_measured(t)),
                                   json_string(advice(session, t)));
    const auto rows = [&json](const char* name, const auto& table, const auto& row_text,
                              bool last) {
        json += fmt::format("  \"{}\": [\n", name);
        for (std::size_t i = 0; i < table.size(); ++i) {
            json += "    " + row_text(table[i]) + (i + 1 < table.size() ? ",\n" : "\n");
        }
        json += last ? "  ]\n}\n" : "  ],\n";
    };
    rows(
        "motion", t.motion.rows,
        [](const MotionTrade& r) {
            return fmt::format(
                "{{\"method\": {}, \"setting\": {}, \"ns_a_frame\": {}, \"evaluations_a_frame\": "
                "{}, "
                "\"attitude_rad\": {}, \"energy\": {}, \"momentum\": {}, \"displacement_px\": {}, "
                "\"on_front\": {}}}",
                json_string(r.method), json_string(r.setting), json_number(r.ns_a_frame),
                json_number(r.evaluations_a_frame), json_number(r.attitude_rad),
                json_number(r.energy), json_number(r.momentum), json_number(r.displacement_px),
                r.on_front);
        },
        false);
    rows(
        "picture", t.picture.rows,
        [](const PictureTrade& r) {
            return fmt::format(
                "{{\"setting\": {}, \"quality\": {}, \"ms_a_frame\": {}, \"rms_levels\": {}, "
                "\"on_front\": {}}}",
                json_string(r.setting), json_string(r.quality), json_number(r.ms_a_frame),
                json_number(r.rms_levels), r.on_front);
        },
        false);
    rows(
        "film", t.film.rows,
        [](const FilmTrade& r) {
            return fmt::format(
                "{{\"quality\": {}, \"ms_a_frame\": {}, \"bytes_a_frame\": {}, \"ssim\": {}, "
                "\"on_front\": {}}}",
                json_string(r.quality), json_number(r.ms_a_frame), json_number(r.bytes_a_frame),
                json_number(r.ssim), r.on_front);
        },
        true);
    return json;
}

// The exact motion is its own truth here; it is drawn at the worst that accuracy_table finds.
constexpr double least_error = 1.1e-15;

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
    // A line for each number of samples, along it the tolerance of curves.
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

void write_chart(const Chart& chart, const Options& options, const fs::path& path) {
    const ChartSheet sheet(chart, theme_named("light"), 1600, 1000);
    const OffscreenContext context = make_context(context_choice_of(options));
    Renderer renderer(context);
    write_png(path, renderer.render(sheet.drawing()));
}

void write_text(const fs::path& path, const std::string& text) {
    AtomicFile file(path);
    file.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    file.commit();
}

int run(const Options& options) {
    const Session session = open_session(scene_request_of(options), Purpose::numbers);
    print_notes(session.scene, options.quiet);
    const FilmPlan film = film_plan(session);

    Tradeoff t;
    t.motion = trade_motion(session, film, pixels_per_radian(session.scene));
    t.picture = trade_picture(session, context_choice_of(options), film);
    t.film = trade_film(session, context_choice_of(options), film);

    std::string prefix = with_scene_name(options.output, session.scene.name).string();
    if (prefix.empty()) {
        std::error_code ignored;
        fs::create_directory("output", ignored);
        prefix = (fs::path("output") / (session.scene.name + "-tradeoff")).string();
    }
    write_text(prefix + ".csv", csv_of(t));
    write_text(prefix + ".json", json_of(session, t));
    write_chart(motion_chart(session, t), options, prefix + "-motion.png");
    write_chart(picture_chart(t), options, prefix + "-picture.png");
    write_chart(film_chart(t), options, prefix + "-film.png");

    if (options.json) {
        fmt::print("{}", json_of(session, t));
    } else {
        print_table(session, t, options.all_rows);
    }
    if (!options.quiet) {
        say(fmt::format("{0}.csv, {0}.json, {0}-motion.png, {0}-picture.png, {0}-film.png",
                        prefix));
    }
    return 0;
}

constexpr auto options_taken = std::to_array<std::string_view>(
    {"output", "set", "size", "json", "quiet", "all-rows", "backend", "allow-outside"});

}  // namespace

const Command tradeoff_command{
    "tradeoff", "SCENE", 1, 1, "measure speed against accuracy for a scene", options_taken, run};

}  // namespace poinsot
