#include "production/slides/slide_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "production/films/film_job.h"
#include "production/films/jobs.h"
#include "production/records/record.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/files/own_files.h"
#include "system/files/seen_from.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// Reports loops that jump where they begin again, as far as arrows show it.
void note_jumps(const Session& session, const std::vector<Slide>& slides, const Task& task) {
    const FilmPlan film = film_plan(session);
    std::optional<Stage> stage;
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const Slide& slide = slides[i];
        const std::int64_t before = slide.first_loop_frame() - 1;
        if (slide.n_loop_frames == 0 || before < 0) continue;
        if (!stage) stage.emplace(stage_of(session, whole_film(film), setting_of(session.scene)));
        const std::vector<PlacedArrow> from = stage->arrows_at(film.moment_of(before)),
                                       to = stage->arrows_at(film.moment_of(slide.last_frame));
        double jump_px = 0.0;
        for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k)
            jump_px = std::max(jump_px, (from[k].tip_px - to[k].tip_px).norm());
        jump_px /= setting_of(session.scene).samples;
        constexpr double seen_px = 1.0;
        if (jump_px > seen_px)
            task.say(fmt::format(
                "note: {}stops[{}].loop_s: the tip of an arrow jumps by {:.0f} px where the loop "
                "begins again; set loop_s to a period of the motion",
                session.scene.where(fmt::format("stops[{}].loop_s", i)), i, jump_px));
    }
}

// The films that an interrupted run has finished: lines "SHA256 NAME".
constexpr const char* finished_name = "finished";

std::map<std::string, std::string> finished_in(const std::string& text) {
    std::map<std::string, std::string> hashes;
    std::istringstream lines(text);
    for (std::string hash, name; lines >> hash >> name;) hashes[name] = hash;
    return hashes;
}

}  // namespace

SlideOrigin origin_of(const Scene& scene, const fs::path& folder) {
    const bool has_file = kind_of_file(scene.file) == FileKind::regular;
    return {.scene_name = scene.name,
            .title = scene.title,
            .scene_file = has_file ? seen_from(folder, scene.file).string() : "",
            .scene_sha256 = scene_hash_of(scene)};
}

// The lock is beside the folder: the run that holds it may rename the folder.
SlidesAside::SlidesAside(const fs::path& output, const fs::path& place, std::string_view suffix,
                         const std::string& plan)
    : folder_(AtomicFile::lock(output, aside_path_of(place, ".held")),
              {.output = output,
               .folder = aside_path_of(place, suffix),
               .marker = slide_plan_name,
               .beginning = any_slide_plan_head},
              plan) {
    if (const fs::path list = file(finished_name); kind_of_file(list) == FileKind::regular)
        finished_ = finished_in(read_text(list));
    // All but films and their frames is quickly made again.
    folder_.keep_only([this](const std::string& name) {
        return name.front() == '.' || name == finished_name || finished_.contains(name);
    });
}

bool SlidesAside::has_finished(const std::string& name) const {
    const auto then = finished_.find(name);
    return then != finished_.end() && kind_of_file(file(name)) == FileKind::regular &&
           sha256_of_file(file(name)) == then->second;
}

void SlidesAside::set_finished(const std::string& name) {
    finished_[name] = sha256_of_file(file(name));
    std::string text;
    for (const auto& [each, hash] : finished_) text += fmt::format("{} {}\n", hash, each);
    write_whole(file(finished_name), text);
}

void SlidesAside::keep_only(const std::set<std::string>& files) const {
    folder_.keep_only([&files](const std::string& name) { return files.contains(name); });
}

void make_slide_films(const Session& session, const std::vector<Slide>& slides, SlidesAside& aside,
                      std::optional<int> n_jobs, LazyRenderer& renderer, const Task& task) {
    std::int64_t n_frames = 0, n_before = 0;
    for (const Slide& slide : slides)
        n_frames += slide.last_frame - slide.first_frame + 1 + slide.n_loop_frames;
    Task films = task;
    films.begin = [](const std::string&, std::int64_t) {};
    films.done = [&](std::int64_t n_done) { task.done(n_before + n_done); };
    films.finish = [](const std::string&) {};
    bool has_told_notes = false;
    films.say = [&](const std::string& line) {
        if (!has_told_notes && line.starts_with("note: ")) task.say(line);
    };
    task.begin(session.scene.name, n_frames);
    const auto make_film = [&](const std::string& name, std::int64_t first, std::int64_t last) {
        const FilmRequest one{.output = aside.file(name).string(),
                              .frames = std::pair(first, last),
                              .is_slide = true};
        if (aside.has_finished(name)) {
            // Perhaps without its captions.
            FilmJob(session, one).write_sidecars(one.output, films);
        } else {
            aside.remove(name);
            make_in_jobs(session, one, n_jobs, renderer, films);
            has_told_notes = true;
            aside.set_finished(name);
        }
        n_before += last - first + 1;
    };
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const Slide& slide = slides[i];
        make_film(slide_file(i, ".mp4"), slide.first_frame, slide.last_frame);
        if (slide.n_loop_frames > 0)
            make_film(slide_file(i, "-loop.mp4"), slide.first_loop_frame(), slide.last_frame);
    }
    note_jumps(session, slides, task);
}

}  // namespace poinsot
