#include "production/films/film_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "drawing/style/picture_quality.h"
#include "encoding/film_parts.h"
#include "encoding/frame_name.h"
#include "encoding/pipeline.h"
#include "error/error.h"
#include "image/alpha.h"
#include "image/png.h"
#include "production/films/chapters.h"
#include "production/films/subtitles.h"
#include "production/records/record.h"
#include "production/stills/output_place.h"
#include "system/files/file_kind.h"
#include "system/interrupt.h"
#include "text/languages.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// The first frame of a plan.
std::int64_t first_of(const OutputPlan& plan) {
    return plan.first_frame + (plan.part ? plan.part->n_before : 0);
}

// Whether the part exists already. Throws for a file that is not a part, or is another part of the
// same film: most likely one name was used for all parts, so it is not overwritten.
bool is_there(const OutputPlan& plan) {
    if (format_for(plan.path).join == nullptr || kind_of_file(plan.path) != FileKind::regular)
        return false;
    const std::string name = printable(plan.path.string());
    if (!looks_like_part(plan.path))
        throw InputError(
            fmt::format("{}: exists and is not a part of a film; remove it, or choose another name "
                        "for the part",
                        name));
    const PartFile there(plan.path);
    if (there.plan().metadata != plan.metadata) return false;
    if (there.part().n_parts == plan.part->n_parts && there.part().number != plan.part->number)
        throw InputError(
            fmt::format("{}: holds part {} of this film; give each part its own name: #### in a "
                        "name becomes the part's number",
                        name, there.part().number));
    return there.is_whole() && there.part() == *plan.part;
}

// Reports that the frames of an interrupted run are used. n_there: number of those frames.
void note_kept(const OutputPlan& plan, const FrameSink& sink, std::int64_t n_there, bool film,
               const Task& task) {
    if (n_there == 0) return;
    const std::string name = printable(plan.path.string());
    if (n_there == plan.n_frames && film)
        return task.say(
            fmt::format("note: an interrupted run had finished all frames of {}", name));
    if (n_there == plan.n_frames)
        return task.say(fmt::format(
            "note: all {} frames of {} exist and show this scene; remove them to draw them again",
            n_there, name));
    if (n_there == sink.n_frames_kept())
        return task.say(
            fmt::format("note: continuing with frame {} of {}, where an interrupted run ended",
                        first_of(plan) + n_there, name));
    task.say(fmt::format("note: continuing {}: {} of its {} frames exist, the others are drawn now",
                         name, n_there, plan.n_frames));
}

// Reports pictures of other frames, such as those of an earlier, longer run.
void note_others(const OutputPlan& plan, const Task& task) {
    std::vector<std::int64_t> others = frames_there(plan.path);
    std::erase_if(others, [&plan](std::int64_t frame) {
        return frame >= plan.first_frame && frame < plan.first_frame + plan.n_frames;
    });
    if (others.empty()) return;
    const auto name = [&plan](std::int64_t frame) {
        return printable(frame_name(plan.path, frame).filename().string());
    };
    task.say(fmt::format(
        "note: {} of another run in the same folder: {}{}; remove {} or name another output",
        others.size() == 1 ? "there is a frame" : fmt::format("there are {} frames", others.size()),
        name(others.front()), others.size() == 1 ? "" : fmt::format(" to {}", name(others.back())),
        others.size() == 1 ? "it" : "them"));
}

// Reports a transparent theme in a format without (full) transparency.
void note_transparency(const Session& session, const OutputFormat& format, const Task& task) {
    if (session.theme.background.alpha >= 1.0) return;
    const bool one_bit = format.name == "gif";
    if (format.alpha && !one_bit) return;
    task.say(fmt::format(
        "note: theme = \"{}\": {}; .webm, .mov and a .png sequence keep transparency",
        printable(session.scene.theme),
        one_bit ? "a pixel of a GIF is either transparent or opaque"
                : fmt::format(".{} has no transparency, so the background is white", format.name)));
}

// Rejects frames that are too large to be drawn as a whole; only stills are drawn in bands.
void check_size(const OutputPlan& plan) {
    if (std::max(plan.width_px, plan.height_px) <= largest_png_side_px) return;
    throw InputError(fmt::format(
        "film.size is {}x{}; a film frame has at most {} pixels per side, so make it smaller",
        plan.width_px, plan.height_px, largest_png_side_px));
}

// Throws EnvironmentError if the process may not take the memory that drawing and encoding need:
// the encoders' hundred libraries, five threads, and for each pixel the pictures between which they
// look for motion. Measured (2026-11-27): 165 MiB of address space, 55 MiB of memory and 140 bytes
// a pixel beyond what a still takes; with 16 samples a pixel, 390 bytes more.
void check_memory_for_film(const FilmSpec& film) {
    const int samples = picture_quality_named(film.quality).samples;
    const std::int64_t MiB =
        std::int64_t{film.width_px} * film.height_px * (130 + 30 * samples * samples) >> 20;
    MemoryNeed need = memory_of_drawing();
    need.address_MiB += 200 + MiB;
    need.data_MiB += 70 + MiB;
    need.n_threads += 5;
    check_memory("drawing this film", need);
}

}  // namespace

FilmJob::FilmJob(const Session& session, FilmRequest request)
    : session_(&session),
      request_(std::move(request)),
      film_(film_plan(session)),
      first_(request_.frames ? request_.frames->first : 0),
      last_(request_.frames ? request_.frames->second : film_.n_frames - 1) {
    if (last_ >= film_.n_frames)
        throw InputError(
            fmt::format("--frames {}-{}: the film has frames 0-{}; choose frames from these",
                        first_, last_, film_.n_frames - 1));
}

OutputPlan FilmJob::output_plan(const std::filesystem::path& path) const {
    const FilmSpec& film = session_->scene.film;
    OutputPlan plan;
    plan.path = path;
    plan.width_px = film.width_px;
    plan.height_px = film.height_px;
    plan.rate = film_.rate;
    plan.first_frame = first_;
    plan.n_frames = last_ - first_ + 1;
    plan.quality = film.quality;
    plan.language = three_letters_of(session_->scene.language);
    if (!request_.is_slide) plan.chapters = chapters_of(session_->scene, film_, first_, last_);
    plan.ends_alone = request_.is_slide;
    plan.subtitles = subtitles_of(*session_, film_, first_, last_);
    plan.resume = true;
    return plan;
}

// Makes the plan that of a part; false if the part has no frames because the film has too few.
bool FilmJob::take_part(OutputPlan& plan, const Task& task) const {
    const OutputFormat& format = format_for(plan.path);
    const auto [number, n_parts] = *request_.part;
    const std::string name = printable(plan.path.string());
    if (!format.has_parts)
        throw InputError(format.suffix == ".png"
                             ? fmt::format("{}: one picture has no parts; a sequence has #### in "
                                           "its name",
                                           name)
                             : fmt::format("{}: this format has no parts", name));
    FilmPart part = part_of_film(number, n_parts, plan.n_frames, format.n_chunk_frames);
    if (part.n_parts < n_parts)
        task.say(
            fmt::format("note: a part begins every {} frames, so {} frames make {} part{}, not {}",
                        format.n_chunk_frames, plan.n_frames, part.n_parts,
                        part.n_parts == 1 ? "" : "s", n_parts));
    if (part.n_frames == 0) {
        task.say(fmt::format("note: part {} has no frames; nothing to do", number));
        return false;
    }
    part.format = format.name;
    if (!plan.chapters.empty() && format.film) part.chapters = chapters_text_of(plan, film_);
    plan.n_frames = part.n_frames;
    plan.part = std::move(part);
    return true;
}

void FilmJob::draw(PictureMaker& pictures, const OutputPlan& plan, const Task& task) const {
    const OutputFormat& format = format_for(plan.path);
    at_scene_key(session_->scene, "film.fps", [&] { check_rate(format, plan.rate); });
    at_scene_key(session_->scene, "film.size", [&] { check_size(plan); });
    // Other errors of a format are due to the size.
    AsyncSink sink(at_scene_key(session_->scene, "film.size", [&] { return format.open(plan); }));
    std::int64_t n_done = 0;
    for (std::int64_t k = 0; k < plan.n_frames; ++k) n_done += sink.has_frame(k) ? 1 : 0;
    note_kept(plan, sink, n_done, format.film || format.join != nullptr, task);
    task.begin(session_->scene.name, plan.n_frames);
    const std::int64_t begin = first_of(plan);
    for (std::int64_t k = 0; k < plan.n_frames; ++k) {
        if (sink.has_frame(k)) continue;
        stop_if_interrupted();
        Image image = sink.spare();
        pictures.draw(film_.moment_of(begin + k), image);
        sink.write_moved(std::move(image));
        task.done(++n_done);
    }
    sink.finish();
}

// The files beside a film are written last.
void FilmJob::check_beside(const OutputPlan& plan) const {
    const OutputFormat& format = format_for(plan.path);
    if (!plan.chapters.empty() && (format.film || format.name == "png-sequence"))
        check_chapters_place(plan.path);
    if (format.film && !plan.subtitles.empty()) check_subtitles_place(plan.path);
}

void FilmJob::check_sidecars(const std::filesystem::path& pattern) const {
    check_beside(output_plan(pattern));
}

void FilmJob::write_beside(OutputPlan plan, const Task& task) const {
    const OutputFormat& format = format_for(plan.path);
    if (plan.n_shown > 0) {
        plan.n_frames = plan.n_shown;
        if (!request_.is_slide)
            plan.chapters = chapters_of(session_->scene, film_, first_, first_ + plan.n_shown - 1);
    }
    if (!plan.chapters.empty() && (format.film || format.name == "png-sequence"))
        write_chapters(plan, film_);
    else
        remove_stale_chapters(plan.path);
    if (format.film)
        write_subtitles(plan.path, subtitles_of(*session_, film_, plan.first_frame,
                                                plan.first_frame + plan.n_frames - 1));
    if (format.name == "png-sequence") note_others(plan, task);
}

void FilmJob::write_sidecars(const std::filesystem::path& pattern, const Task& task) const {
    write_beside(output_plan(pattern), task);
}

void FilmJob::make(LazyRenderer& renderer, const Task& task) const {
    const Scene& scene = session_->scene;
    tell_notes(*session_, task);
    const OutputPlace place(
        request_.output, scene,
        request_.part ? fmt::format(".{}-of-{}.mp4", request_.part->first, request_.part->second)
                      : ".mp4");
    OutputPlan plan = output_plan(place.path());
    watch_for_interrupts();
    const OutputFormat& format = format_for(plan.path);
    if (request_.part && !take_part(plan, task)) return;
    if (!plan.part) check_beside(plan);
    note_transparency(*session_, format, task);
    if (request_.n_shown > 0 && request_.n_shown < plan.n_frames) {
        // Packets depend on the later frames of their chunk.
        const std::int64_t chunk = format.n_chunk_frames;
        plan.n_frames = std::min(plan.n_frames, (request_.n_shown + chunk - 1) / chunk * chunk);
        plan.n_shown = request_.n_shown;
    }
    // Whichever frames are drawn: each is the same in every run.
    PictureMaker pictures(*session_, renderer, whole_film(film_));
    if (format.film) check_memory_for_film(session_->scene.film);
    tell_stage_notes(pictures.stage(), task);
    Record record = record_of(*session_, pictures, renderer.is_portable());
    record.frames = {first_, last_};
    if (request_.is_slide) record.film_frames = film_.n_frames;
    plan.metadata = to_text(record);
    plan.seal = sealed_metadata;
    const std::string name = printable(plan.path.string());
    if (plan.part && is_there(plan))
        return task.say(fmt::format("note: part {} of {} exists already: {}", plan.part->number,
                                    plan.part->n_parts, name));
    if (plan.part && plan.part->n_before > 0 && format.alpha) {
        Image first;
        pictures.draw(film_.moment_of(first_), first);
        plan.has_alpha = !is_opaque(first);
    }
    draw(pictures, plan, task);
    if (!plan.part || plan.part->number == 1) {
        std::vector<FilmTime> samples;
        const std::int64_t n_samples = std::min<std::int64_t>(12, film_.n_frames);
        for (std::int64_t k = 0; k < n_samples; ++k)
            samples.push_back(film_.moment_of(first_ + (last_ - first_) * k / n_samples));
        tell_unnamed(pictures.stage(), samples, task);
    }
    if (!plan.part) write_beside(plan, task);
    task.finish(with_film_length(name, plan.n_frames, plan.rate));
    task.say(in_words(pictures.bound(), session_->accuracy.asked_px));
}

}  // namespace poinsot
