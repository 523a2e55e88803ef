#include "production/chapters.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <span>
#include <string>

#include "system/atomic_file.h"
#include "system/file_kind.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

// The first frame that shows this second of the film or a later one.
std::int64_t frame_at(const FilmPlan& film, double film_s) {
    constexpr double rounding = 1e-9;
    std::int64_t before = -1;
    std::int64_t after = film.n_frames;
    while (after - before > 1) {
        const std::int64_t middle = before + (after - before) / 2;
        (film.moment_of(middle).film_s < film_s - rounding ? before : after) = middle;
    }
    return after;
}

// The first lines of the file, by which it is known for that of a film.
std::string head_of(const std::filesystem::path& film) {
    return fmt::format("{{\n  \"film\": {},\n", json_string(film.filename().string()));
}

}  // namespace

std::vector<FilmChapter> chapters_of(const Scene& scene, const FilmPlan& film, std::int64_t first,
                                     std::int64_t last) {
    std::vector<FilmChapter> chapters;
    for (std::size_t i = 0; i < scene.chapters.size(); ++i) {
        const bool is_last = i + 1 == scene.chapters.size();
        const std::int64_t begin = frame_at(film, scene.chapters[i].at_s);
        const std::int64_t end =
            is_last ? film.n_frames : frame_at(film, scene.chapters[i + 1].at_s);
        FilmChapter chapter;
        chapter.title = scene.chapters[i].title;
        chapter.first_frame = std::clamp(begin, first, last + 1) - first;
        chapter.end_frame = std::clamp(end, first, last + 1) - first;
        if (chapter.first_frame < chapter.end_frame) chapters.push_back(chapter);
    }
    return chapters;
}

std::filesystem::path chapters_path(const std::filesystem::path& film) {
    std::string stem = film.stem().string();
    if (stem.find('#') != std::string::npos) {
        stem.erase(std::remove(stem.begin(), stem.end(), '#'), stem.end());
        stem.erase(stem.find_last_not_of("_-. ") + 1);
    }
    // Films of one name in two formats each have theirs.
    if (suffix_of(film) != ".mp4" && !stem.empty()) stem += film.extension().string();
    return film.parent_path() / (stem.empty() ? "chapters.json" : stem + ".chapters.json");
}

void remove_stale_chapters(const OutputPlan& plan) {
    const std::filesystem::path path = chapters_path(plan.path);
    if (kind_of_file(path) != FileKind::regular) return;
    std::ifstream file(path, std::ios::binary);
    std::string beginning(head_of(plan.path).size(), '\0');
    file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    std::error_code ignored;
    if (file && beginning == head_of(plan.path)) std::filesystem::remove(path, ignored);
}

std::string chapters_text_of(const OutputPlan& plan, const FilmPlan& film) {
    const double per_second = plan.rate.per_second();
    std::string text = fmt::format(
        "  \"frames_per_second\": \"{}/{}\",\n  \"n_frames\": {},\n"
        "  \"loops\": {},\n  \"chapters\": [\n",
        plan.rate.numerator, plan.rate.denominator, plan.n_frames, film.loop_s > 0.0);
    for (std::size_t i = 0; i < plan.chapters.size(); ++i) {
        const FilmChapter& chapter = plan.chapters[i];
        const std::int64_t shown = plan.first_frame + chapter.first_frame;
        text += fmt::format(
            "    {{\"title\": {}, \"at_s\": {}, \"end_s\": {}, \"first_frame\": {}, "
            "\"last_frame\": {}, \"motion_time_s\": {}}}{}\n",
            json_string(chapter.title),
            json_number(static_cast<double>(chapter.first_frame) / per_second),
            json_number(static_cast<double>(chapter.end_frame) / per_second), shown,
            plan.first_frame + chapter.end_frame - 1, json_number(film.time_of(shown)),
            i + 1 < plan.chapters.size() ? "," : "");
    }
    return text + "  ]\n}\n";
}

void write_chapters(const std::filesystem::path& film, const std::string& text) {
    write_whole(chapters_path(film), head_of(film) + text);
}

void write_chapters(const OutputPlan& plan, const FilmPlan& film) {
    write_chapters(plan.path, chapters_text_of(plan, film));
}

}  // namespace poinsot
