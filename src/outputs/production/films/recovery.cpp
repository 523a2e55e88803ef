#include "production/films/recovery.h"

#include <fmt/format.h>

#include <utility>

#include "encoding/frame_name.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "production/films/chapters.h"
#include "production/films/jobs.h"
#include "production/films/subtitles.h"
#include "production/session/session.h"
#include "text/printable.h"

namespace poinsot {

void write_what_lies_beside(const std::filesystem::path& path, const Record& record,
                            const Task& task) {
    const Scene scene = scene_of(record, OutsideFiles::refused);
    if ((scene.chapters.empty() && scene.captions.empty()) || !record.frames) {
        remove_stale_chapters(path);
        if (!has_frame_number(path)) write_subtitles(path, {});
        return;
    }
    const Session session = session_of(scene, {}, task);
    const FilmPlan film = film_plan(session);
    const auto [first, last] = *record.frames;
    OutputPlan plan;
    plan.path = path;
    plan.rate = film.rate;
    plan.first_frame = first;
    plan.n_frames = last - first + 1;
    plan.chapters = chapters_of(session.scene, film, first, last);
    if (plan.chapters.empty())
        remove_stale_chapters(path);
    else
        write_chapters(plan, film);
    if (!has_frame_number(path)) write_subtitles(path, subtitles_of(session, film, first, last));
}

std::int64_t recover(const std::filesystem::path& film, const Task& task) {
    // Parts of several processes are converted to the state of a single process first.
    const std::int64_t n_left = format_for(film).recover != nullptr ? gather_parts_aside(film) : 0;
    const std::int64_t n_frames = recover_film(film, sealed_metadata);
    if (n_left > 0)
        task.say(fmt::format(
            "note: {} later frames follow a gap and are kept; render draws the missing frames",
            n_left));
    try {
        write_what_lies_beside(film, read_record(film), task);
    } catch (const InputError& error) {
        // The film itself is complete; only the files beside it need the scene's files.
        task.say(fmt::format("note: {} was not written: {}",
                             printable(chapters_path(film).string()), printable(error.what())));
    }
    return n_frames;
}

}  // namespace poinsot
