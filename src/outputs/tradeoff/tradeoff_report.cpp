#include "tradeoff/tradeoff_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

#include "text/json_text.h"

namespace poinsot {

namespace {

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

// The cheapest row of the motion within a given displacement, or null.
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
    const double accuracy_px = session.accuracy.asked_px;
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
                      "; the motion costs {:.2g} % of drawing a frame at {}x{} and quality {} "
                      "({:.3g} ms), so choose the picture and the encoder to save time.",
                      any->ns_a_frame * 1e-6 / std::max(t.picture.film_ms, 1e-9) * 100.0,
                      session.scene.film.width_px, session.scene.film.height_px,
                      session.scene.film.quality, t.picture.film_ms);
}

std::string drift(double value) {
    return std::isfinite(value) ? fmt::format("{:.2e}", value) : "-";
}

}  // namespace

std::string table_of(const Session& session, const Tradeoff& t, bool all) {
    std::string text;
    text += fmt::format("motion: {} frames, against {}\n", t.motion.n_frames, t.motion.truth);
    text += fmt::format("  {:12} {:18} {:>11} {:>9} {:>10} {:>10} {:>10} {:>10}\n", "method",
                        "setting", "ns/frame", "evals", "angle/rad", "T drift", "L drift", "px");
    for (const MotionTrade& r : t.motion.rows) {
        if (!all && !r.on_front) continue;
        text += fmt::format("{} {:12} {:18} {:11.0f} {:9.1f} {:10.2e} {:>10} {:>10} {:10.2e}\n",
                            r.on_front ? "*" : " ", r.method, r.setting, r.ns_a_frame,
                            r.evaluations_a_frame, r.attitude_rad, drift(r.energy),
                            drift(r.momentum), r.displacement_px);
    }
    text += fmt::format("picture: {}×{}, against {}\n", t.picture.width_px, t.picture.height_px,
                        t.picture.reference);
    text += fmt::format("  {:48} {:10} {:>9} {:>11} {:>8}\n", "setting", "quality", "ms/frame",
                        "rms levels", "largest");
    for (const PictureTrade& r : t.picture.rows) {
        if (!all && !r.on_front) continue;
        text += fmt::format("{} {:48} {:10} {:9.2f} {:11.4f} {:8.0f}\n", r.on_front ? "*" : " ",
                            r.setting, r.quality, r.ms_a_frame, r.rms_levels, r.largest_levels);
    }
    text += fmt::format("film: {} frames of {}×{}, H.264\n", t.film.n_frames, t.film.width_px,
                        t.film.height_px);
    text +=
        fmt::format("  {:12} {:>9} {:>12} {:>9}\n", "quality", "ms/frame", "bytes/frame", "SSIM");
    for (const FilmTrade& r : t.film.rows) {
        if (!all && !r.on_front) continue;
        text += fmt::format("{} {:12} {:9.2f} {:12.0f} {:9.5f}\n", r.on_front ? "*" : " ",
                            r.quality, r.ms_a_frame, r.bytes_a_frame, r.ssim);
    }
    text += fmt::format(
        "{}. {}.\n{}\n",
        all ? "*: on the Pareto front"
            : "The Pareto front; --all prints every row, which the CSV and the JSON contain",
        how_measured(t), advice(session, t));
    return text;
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
    std::vector<std::string> motion, picture, film;
    for (const MotionTrade& r : t.motion.rows) {
        JsonObject row;
        row.add("method", r.method).add("setting", r.setting).add("ns_a_frame", r.ns_a_frame);
        row.add("evaluations_a_frame", r.evaluations_a_frame).add("attitude_rad", r.attitude_rad);
        row.add("energy", r.energy).add("momentum", r.momentum);
        row.add("displacement_px", r.displacement_px).add("on_front", r.on_front);
        motion.push_back(row.line());
    }
    for (const PictureTrade& r : t.picture.rows) {
        JsonObject row;
        row.add("setting", r.setting).add("quality", r.quality).add("ms_a_frame", r.ms_a_frame);
        row.add("rms_levels", r.rms_levels).add("on_front", r.on_front);
        picture.push_back(row.line());
    }
    for (const FilmTrade& r : t.film.rows) {
        JsonObject row;
        row.add("quality", r.quality).add("ms_a_frame", r.ms_a_frame);
        row.add("bytes_a_frame", r.bytes_a_frame).add("ssim", r.ssim).add("on_front", r.on_front);
        film.push_back(row.line());
    }
    return JsonObject()
        .add("scene", session.scene.name)
        .add("measured", how_measured(t))
        .add("advice", advice(session, t))
        .json("motion", json_lines(motion, 2))
        .json("picture", json_lines(picture, 2))
        .json("film", json_lines(film, 2))
        .lines();
}

}  // namespace poinsot
