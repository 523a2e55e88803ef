// What the workbench needs beside the program, as functions of a WebAssembly module of its own,
// which pages that only show a scene do without: `poinsot fit`, for web/page/measure.js, and the
// parts of a presentation, for web/page/pptx.js.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measured/flights.h"
#include "production/fits/fit_flights.h"
#include "production/fits/fit_words.h"
#include "production/fits/fitted_scene.h"
#include "production/slides/pptx_parts.h"
#include "text/json_text.h"
#include "text/printable.h"
#include "web/module/answers.h"

namespace poinsot {
namespace {

std::optional<FitTable>& fit_table() {
    static std::optional<FitTable> it;
    return it;
}

void add_row(double time_s, const Eigen::Vector3d& omega) {
    numbers().insert(numbers().end(), {time_s, omega.x(), omega.y(), omega.z()});
}

}  // namespace
}  // namespace poinsot

using namespace poinsot;  // NOLINT(google-build-using-namespace)

// Reads a table, finds its flights and fits each. The rows are the numbers, four each: the time in
// s and ω in rad/s. The answer is JSON: "is_recording", "flights" as `poinsot fit --json` lists
// them, "best", the number of the one that says most about the body, or "refusal".
POINSOT_EXPORT(read_table)
int read_table(const char* text, std::uint32_t text_size, const char* name,
               std::uint32_t name_size) {
    return answered([&] {
        fit_table().reset();
        numbers().clear();
        const std::string file(text_at(name, name_size));
        MeasuredMotion measured = read_measured(text_at(text, text_size), file);
        add_omega_by_differences(measured);
        for (const MeasuredRow& row : measured.rows) add_row(row.time_s, row.omega_body);
        FitTable table = fitted_table(std::move(measured), file, {});
        JsonObject said;
        said.add("is_recording", table.is_recording).json("flights", json_of_flights(table));
        try {
            said.add("best", best_flight(table).number);
        } catch (const InputError& error) {
            said.add("refusal", error.what());
        }
        answer() = said.line();
        fit_table() = std::move(table);
    });
}

// A flight of the table that was read last. `scene_table`: the name that the scene gives its rows.
// The answer is JSON: "fit" as `poinsot fit --json` prints it, "words", the "scene" that `poinsot
// fit -o` writes and the "table" of the flight's rows, if they are not those that were read: of a
// recording, or with other times.
POINSOT_EXPORT(flight)
int flight(double number, const char* scene_table, std::uint32_t scene_table_size) {
    return answered([&] {
        if (!fit_table()) throw InputError("no table is read; read one first");
        const FitTable& table = *fit_table();
        const TableFlight& chosen = table.flights.at(static_cast<std::size_t>(number) - 1);
        if (!chosen.fit) throw InputError(chosen.name + ": " + chosen.refusal);
        JsonObject fit;
        if (table.is_recording)
            fit.json("flights", json_of_flights(table)).add("flight", chosen.number);
        add_fit(fit, *chosen.fit);
        const MeasuredMotion& measured = chosen.measured;
        FittedScene scene{.fit = *chosen.fit,
                          .from = chosen.name,
                          .words = words_of(table, chosen),
                          .last_time_s = measured.rows.back().time_s,
                          .attitude = {},
                          .table = std::string(text_at(scene_table, scene_table_size))};
        scene.attitude = attitude_of(chosen);
        std::vector<std::string> words;
        for (const std::string& line : scene.words) words.push_back(json_string(line));
        JsonObject said;
        said.json("fit", fit.line()).json("words", json_list(words)).add("scene", text_of(scene));
        const double zero_s = zero_of(scene);
        if (table.is_recording || zero_s != 0.0)
            said.add("table", table_text(counted_from(measured, zero_s)));
        answer() = said.line();
    });
}

// The flights of rows as `read_table` gives them, two numbers each: begin and end in s.
POINSOT_EXPORT(find_flights) int find_flights(const double* given, std::uint32_t n_rows) {
    return answered([&] {
        std::vector<MeasuredRow> rows(n_rows);
        for (MeasuredRow& row : rows) {
            row.time_s = given[0];
            row.omega_body = {given[1], given[2], given[3]};
            given += 4;
        }
        numbers().clear();
        for (const FreeFlight& found : flights_of(rows))
            numbers().insert(numbers().end(), {found.begin_s(), found.end_s()});
    });
}

// The parts of a presentation but its media. `texts`: its title, the scene's name, its language,
// width and height in pixels and, for each slide, the title, the note, the names of film, poster,
// loop (or "") and still, and the durations of film and loop in ms; each followed by a NUL. The
// answer is a list of names and contents in JSON.
POINSOT_EXPORT(presentation) int presentation(const char* texts, std::uint32_t texts_size) {
    return answered([&] {
        const std::vector<std::string> given = texts_at(texts, texts_size);
        PptxText text{.title = given.at(0),
                      .origin = {.scene_name = given.at(1),
                                 .title = given.at(0),
                                 .scene_sha256 = given.at(2)},
                      .language = given.at(3),
                      .width_px = std::stoi(given.at(4)),
                      .height_px = std::stoi(given.at(5)),
                      .slides = {}};
        for (std::size_t i = 6; i + 7 < given.size(); i += 8)
            text.slides.push_back({.title = given[i],
                                   .note = given[i + 1],
                                   .film = given[i + 2],
                                   .poster = given[i + 3],
                                   .loop = given[i + 4],
                                   .still = given[i + 5],
                                   .duration_ms = std::stoll(given[i + 6]),
                                   .loop_ms = std::stoll(given[i + 7])});
        std::vector<std::string> parts;
        for (const PptxPart& part : pptx_parts(text)) {
            parts.push_back(json_string(part.name));
            parts.push_back(json_string(part.xml));
        }
        answer() = json_list(parts);
    });
}
