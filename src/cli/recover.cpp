// poinsot recover FILM: what an interrupted run has drawn, as a film that can be shown now.
#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "cli/command.h"
#include "cli/record.h"
#include "error/nearest.h"
#include "output/film_part.h"

namespace poinsot {

namespace {

// The record of a film that ends early says how far it goes.
std::string retold(const std::string& metadata, std::int64_t n_frames) {
    if (metadata.empty()) return metadata;
    Record record = parse_record(metadata, "the unfinished film");
    if (record.frames) record.frames->second = record.frames->first + n_frames - 1;
    return to_text(record);
}

int run(const Options& options) {
    const std::filesystem::path film = options.arguments.at(0);
    const std::int64_t n_frames = recover_film(film, retold);
    if (!options.quiet)
        fmt::print(stderr, "{}: the first {} frames\n", printable(film.string()), n_frames);
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
