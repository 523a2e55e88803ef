// poinsot recover FILM: what an interrupted run has drawn, as a film that can be shown now.
#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "cli/command.h"
#include "error/error.h"
#include "output/frame_sink.h"
#include "production/chapters.h"
#include "production/record.h"
#include "scene/load_scene.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// The chapters beside a film that ends early, as render writes them beside a whole one.
void write_chapters_beside(const std::filesystem::path& path) {
    const Record record = read_record(path);
    // The record's scene is read as a file of its name in this folder would be.
    const Session session = session_of(
        parse_scene(record.scene_toml, record.scene_name + ".toml", {}, OutsideFiles::refused));
    if (session.scene.chapters.empty() || !record.frames) return;
    const FilmPlan film = film_plan(session);
    const auto [first, last] = *record.frames;
    OutputPlan plan;
    plan.path = path;
    plan.rate = film.rate;
    plan.first_frame = first;
    plan.n_frames = last - first + 1;
    plan.chapters = chapters_of(session.scene, film, first, last);
    write_chapters(plan, film);
}

int run(const Options& options) {
    const std::filesystem::path film = options.arguments.at(0);
    const std::int64_t n_frames = recover_film(film, told);
    try {
        write_chapters_beside(film);
    } catch (const InputError& error) {
        // The film is there; only what stands beside it needs the scene's files.
        if (!options.quiet)
            say(fmt::format("note: no {}: {}", printable(chapters_path(film).string()),
                            printable(error.what())));
    }
    if (!options.quiet)
        say(fmt::format("{}: the first {} frames", printable(film.string()), n_frames));
    return 0;
}

constexpr std::array<std::string_view, 1> options_taken{"quiet"};

}  // namespace

const Command recover_command{"recover",
                              "FILM",
                              1,
                              1,
                              "make a film of what an interrupted run has drawn; render goes on "
                              "from there instead",
                              options_taken,
                              run};

}  // namespace poinsot
