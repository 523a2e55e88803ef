#include "production/films/chapters.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "production/films/sidecar_place.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/seal.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

// The beginning of the file of any film.
constexpr const char* any_chapters_head = "{\n  \"film\": ";

// The first lines of the file, which identify it as the film's.
std::string chapters_head(const std::filesystem::path& film) {
    return fmt::format("{}{},\n", any_chapters_head, json_string(film.filename().string()));
}

}  // namespace

std::filesystem::path chapters_path(const std::filesystem::path& film) {
    std::string stem = film.stem().string();
    if (stem.find('#') != std::string::npos) {
        stem.erase(std::remove(stem.begin(), stem.end(), '#'), stem.end());
        stem.erase(stem.find_last_not_of("_-. ") + 1);
    }
    // Films with the same stem and different suffixes have separate files.
    if (suffix_of(film) != ".mp4" && !stem.empty()) stem += film.extension().string();
    return film.parent_path() / (stem.empty() ? "chapters.json" : stem + ".chapters.json");
}

void check_chapters_place(const std::filesystem::path& film) {
    check_sidecar(chapters_path(film), any_chapters_head, "chapters");
}

void remove_stale_chapters(const std::filesystem::path& film) {
    remove_stale_sidecar(chapters_path(film), chapters_head(film));
}

std::string chapters_text_of(const OutputPlan& plan, const FilmPlan& film) {
    const double per_second = plan.rate.per_second();
    std::vector<std::string> rows;
    rows.reserve(plan.chapters.size());
    for (const FilmChapter& chapter : plan.chapters) {
        const std::int64_t shown = plan.first_frame + chapter.first_frame;
        JsonObject row;
        row.add("title", chapter.title);
        row.add("at_s", static_cast<double>(chapter.first_frame) / per_second);
        row.add("end_s", static_cast<double>(chapter.end_frame) / per_second);
        row.add("first_frame", shown).add("last_frame", plan.first_frame + chapter.end_frame - 1);
        row.add("motion_time_s", film.time_of(shown));
        rows.push_back(row.line());
    }
    const std::string text = JsonObject()
                                 .add("frames_per_second", fmt::format("{}/{}", plan.rate.numerator,
                                                                       plan.rate.denominator))
                                 .add("n_frames", plan.n_frames)
                                 .add("loops", film.repeat_s > 0.0)
                                 .json("chapters", json_lines(rows, 2))
                                 .lines();
    // The head, with the opening brace and the film's name, is prepended when the file is written.
    return text.substr(std::string_view("{\n").size());
}

void write_chapters(const std::filesystem::path& film, const std::string& text) {
    check_chapters_place(film);
    write_whole(chapters_path(film), sealed(fmt::format("{}  \"sha256\": \"{}\",\n{}",
                                                        chapters_head(film), blank_seal, text)));
}

void write_chapters(const OutputPlan& plan, const FilmPlan& film) {
    write_chapters(plan.path, chapters_text_of(plan, film));
}

}  // namespace poinsot
