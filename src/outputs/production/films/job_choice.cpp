#include "production/films/job_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/style/picture_quality.h"
#include "encoding/film_part.h"
#include "encoding/frame_sink.h"
#include "encoding/quality.h"
#include "scene/scene_error.h"
#include "system/files/file_kind.h"
#include "system/files/processor.h"

namespace poinsot {

namespace {

// CPU seconds per frame: a millisecond, plus the cost of its pixels from the table of qualities.
// Measured for the default scene as MP4, lecture (2026-11-22): 2.3 ms at 320×180, 5.8 at 640×360,
// 33 at 1920×1080; this gives 2.2, 5.7 and 43.
double frame_s(const FilmWork& film) {
    const QualityFigures& figures = quality_named(film.quality).figures;
    const double share = film.width_px * static_cast<double>(film.height_px) / (960.0 * 540.0);
    return 1e-3 * (1.0 + (figures.picture_ms + figures.film_ms) * share);
}

// Work below which another process saves no time: starting it takes 0.13 s of CPU, or 0.5 s if
// shaders have to be compiled.
constexpr double least_job_s = 0.5;

// Memory of one process: libraries, shaders and curves; and per pixel: layers, pictures in the
// queue and the encoder. Measured with one other process (Pss, lecture, 2026-11-22): 127 MiB at
// 320×180, 357 at 1920×1080, 1,089 at 3840×2160; 505 at 1920×1080 with 2×2 samples per pixel, 1,052
// with 4×4.
std::int64_t job_MiB(const FilmWork& film) {
    const int samples = picture_quality_named(film.quality).samples;
    return 120 + std::int64_t{film.width_px} * film.height_px *
                     (94 + std::int64_t{23} * samples * samples) / 1000000;
}

// The largest number of processes that fit into half of the memory.
std::int64_t most_in(const Machine& machine, std::int64_t each_MiB) {
    return machine.memory_MiB <= 0 ? 1
                                   : std::max<std::int64_t>(1, machine.memory_MiB / 2 / each_MiB);
}

}  // namespace

Machine this_machine() { return {n_processors(), memory_MiB()}; }

FilmWork work_of(const Session& session, std::int64_t n_frames,
                 const std::filesystem::path& output) {
    const FilmSpec& film = session.scene.film;
    at_scene_key(session.scene, "film.quality", [&film] { quality_named(film.quality); });
    return {n_frames, film.width_px, film.height_px, film.quality, output};
}

int n_drawing_threads(int n_jobs, int n_cores) {
    return std::max(1, n_cores / std::max(1, n_jobs));
}

JobChoice choose_jobs(const FilmWork& film, const Machine& machine) {
    const OutputFormat& format = format_for(film.output);
    JobChoice choice;
    const std::int64_t each_MiB = job_MiB(film);
    std::int64_t n_jobs = 1;
    const auto limit = [&](std::int64_t most, const std::string& why) {
        if (most >= n_jobs) return;
        n_jobs = most;
        choice.why = why;
    };
    const int cores = format.n_cores_a_job;
    if (cores == 0 || !format.has_parts) {
        choice.why = fmt::format("one process writes a .{}", format.name);
    } else if (kind_of_file(film.output) == FileKind::special || film.output == "-") {
        choice.why = "the output is a pipe or a device";
    } else {
        n_jobs = std::max(1, machine.n_cores / cores);
        choice.why = fmt::format("the machine has {} core{}{}", machine.n_cores,
                                 machine.n_cores == 1 ? "" : "s",
                                 cores == 1 ? "" : fmt::format(", and the encoder uses {}", cores));
        const std::int64_t n_chunks =
            part_of_film(1, film.n_frames, film.n_frames, format.n_chunk_frames).n_parts;
        limit(n_chunks, fmt::format("the film has {} part{} of {} frames", n_chunks,
                                    n_chunks == 1 ? "" : "s", format.n_chunk_frames));
        const double work_s = frame_s(film) * static_cast<double>(film.n_frames);
        limit(std::max<std::int64_t>(1,
                                     std::llround(std::floor(std::min(work_s / least_job_s, 1e6)))),
              fmt::format("drawing and encoding take about {:.2g} s of processor time; a further "
                          "process saves time only with {} s of work or more",
                          work_s, least_job_s));
        limit(most_in(machine, each_MiB),
              fmt::format("no more fit into half of the memory, {} MiB each", each_MiB));
    }
    choice.n_jobs = static_cast<int>(n_jobs);
    choice.n_threads = n_drawing_threads(choice.n_jobs, machine.n_cores);
    choice.memory_MiB = each_MiB * choice.n_jobs;
    return choice;
}

std::string in_words(const JobChoice& choice) {
    if (choice.n_jobs == 1) return fmt::format("one process, about {} MiB", choice.memory_MiB);
    return fmt::format(
        "{} processes, each drawing with {}, about {} MiB together", choice.n_jobs,
        choice.n_threads == 1 ? "one thread" : fmt::format("{} threads", choice.n_threads),
        choice.memory_MiB);
}

namespace {

// The positions at which a film may be divided into parts.
PlanLine parts_line(const FilmPlan& film) {
    const std::int64_t chunk = format_for("film.mp4").n_chunk_frames;
    const std::int64_t n_parts = (film.n_frames + chunk - 1) / chunk;
    return {
        "parts",
        n_parts <= 1 ? "one: the film is shorter than two parts"
                     : fmt::format("at most {}, a part begins every {} frames", n_parts, chunk),
        "the encoders of MP4 and WebM restart there; GIF and PNG can be divided at every frame"};
}

// The default of --jobs on this machine, with the reason.
PlanLine jobs_line(const Session& session, const FilmPlan& film) {
    const JobChoice choice =
        choose_jobs(work_of(session, film.n_frames, "film.mp4"), this_machine());
    return {"jobs", in_words(choice), choice.why};
}

}  // namespace

std::vector<PlanLine> plan_of_parts(const Session& session, const FilmPlan& film) {
    return {parts_line(film), jobs_line(session, film)};
}

}  // namespace poinsot
