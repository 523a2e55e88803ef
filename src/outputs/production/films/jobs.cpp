#include "production/films/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "encoding/film_part.h"
#include "encoding/film_parts.h"
#include "encoding/frame_log.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "production/films/child.h"
#include "production/films/job_choice.h"
#include "production/films/join.h"
#include "production/stills/output_place.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/files/processor.h"
#include "system/files/unfinished_folder.h"
#include "system/interrupt.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// The hidden folder of a film's parts. The first line of the marker says whose parts they are.
UnfinishedPlace parts_place(const fs::path& film) {
    return {
        .output = film,
        .folder = aside_path_of(film, ".parts"),
        .marker = "unfinished",
        .beginning = fmt::format("poinsot: unfinished parts of {}\n", film.filename().string())};
}

// A part in such a folder: "2-of-8.mp4", and while it is drawn ".2-of-8.mp4.part.frames".
struct LeftPart {
    std::int64_t number = 0, n_parts = 0;
    fs::path path;
};
std::vector<LeftPart> parts_left_of(const fs::path& film) {
    std::vector<LeftPart> parts;
    const auto folder = UnfinishedFolder::left(parts_place(film));
    if (!folder) return parts;
    for (const std::string& name : folder->names()) {
        LeftPart part;
        part.path = folder->file(name);
        const char* const begin = name.c_str() + (name.starts_with('.') ? 1 : 0);
        if (std::sscanf(begin, "%" SCNd64 "-of-%" SCNd64, &part.number, &part.n_parts) == 2)
            parts.push_back(std::move(part));
    }
    std::sort(parts.begin(), parts.end(), [](const LeftPart& a, const LeftPart& b) {
        return std::pair(a.n_parts, a.number) < std::pair(b.n_parts, b.number);
    });
    return parts;
}

bool has_bytes(const fs::path& path) {
    std::error_code none;
    const auto size = fs::file_size(path, none);
    return !none && size > 0;
}

// Nothing for a file that is damaged at its beginning.
std::optional<PartFile> part_if_readable(const fs::path& path) {
    try {
        return PartFile(path);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

bool is_whole_part(const fs::path& path) {
    const std::optional<PartFile> part = part_if_readable(path);
    return part && part->is_whole();
}

// The end of the names of a film's parts, as "-of-8.mp4".
std::string part_suffix(std::int64_t n_parts, const fs::path& film) {
    return fmt::format("-of-{}{}", n_parts, film.extension().string());
}

// Opens the folder of a film's parts, with the whole and the unfinished ones that an interrupted
// run has left. The lock is the log of a single process, so that only one run at a time works on
// the film.
UnfinishedFolder open_parts(const fs::path& film, const std::string& suffix) {
    // The film itself is opened when all of its parts are there.
    check_aside(film);
    const UnfinishedPlace place = parts_place(film);
    UnfinishedFolder folder(open_frame_log(film, true), place, place.beginning);
    // Parts of a run with another number of jobs cannot be continued; damaged ones are drawn again.
    folder.keep_only([&](const std::string& name) {
        return name.find(suffix) != std::string::npos &&
               (name.front() == '.' || is_whole_part(folder.file(name)));
    });
    return folder;
}

// Jobs share the processor: with as many threads as cores in each job, they would only wait for
// each other.
void take_a_share_of_the_cores(int n_jobs) {
    const int n_threads = n_drawing_threads(n_jobs, n_processors());
    // Without threads, llvmpipe draws on the calling thread.
    ::setenv("LP_NUM_THREADS", fmt::format("{}", n_threads > 1 ? n_threads : 0).c_str(), 0);
}

// Draws all parts in parallel.
void draw_parts(const Session& session, const FilmRequest& request, std::int64_t n_parts,
                const ContextChoice& context, const std::vector<std::string>& outputs,
                const Task& task) {
    Children children;
    for (std::int64_t number = 1; number <= n_parts; ++number) {
        FilmRequest part = request;
        part.output = outputs[static_cast<std::size_t>(number - 1)];
        part.part = {number, n_parts};
        children.start([&session, &context, part, n_parts](const Task& child_telling) {
            take_a_share_of_the_cores(static_cast<int>(n_parts));
            LazyRenderer renderer(context);
            FilmJob(session, part).make(renderer, child_telling);
        });
    }
    children.wait(task);
}

// The default number of jobs: that of an interrupted run, else the one that choose_jobs finds.
int n_jobs_for(const Session& session, std::int64_t n_frames, const fs::path& path,
               const LazyRenderer& renderer) {
    if (renderer.is_open() || has_bytes(frame_log_path(path))) return 1;
    const std::vector<LeftPart> left = parts_left_of(path);
    constexpr std::int64_t most = 4096;
    if (!left.empty() && left.front().n_parts >= 1 && left.front().n_parts <= most)
        return static_cast<int>(left.front().n_parts);
    return choose_jobs(work_of(session, n_frames, path), this_machine()).n_jobs;
}

// Appends the entries of a part to the film's log.
void append_all(const PartFile& part, FrameLog& log) {
    const std::vector<PartFile> one{part};
    JoinedEntries entries(one);
    for (std::int64_t k = 0; k < part.n_there(); ++k)
        log.append(entries.read(part.part().n_before + k));
}

void make_in_this_process(const FilmJob& film, const fs::path& path, LazyRenderer& renderer,
                          const Task& task) {
    film.make(renderer, task);
    // Parts of several processes are obsolete now.
    if (auto folder = UnfinishedFolder::left(parts_place(path))) folder->remove_all();
}

}  // namespace

void make_in_jobs(const Session& session, const FilmRequest& request, std::optional<int> n_asked,
                  LazyRenderer& renderer, const Task& task) {
    const FilmJob film(session, request);
    const OutputPlace place(request.output, session.scene, ".mp4");
    const fs::path& path = place.path();
    const OutputFormat& format = format_for(path);
    // Before anything is drawn: a folder of somebody else is refused.
    if (format.join != nullptr) UnfinishedFolder::left(parts_place(path));
    const int n_jobs = n_asked ? *n_asked : n_jobs_for(session, film.n_frames(), path, renderer);
    if (n_jobs == 1) return make_in_this_process(film, path, renderer, task);
    if (!format.has_parts)
        throw InputError(fmt::format("{}: this format has no parts for --jobs; leave --jobs out",
                                     printable(path.string())));
    film.check_sidecars(path);
    watch_for_interrupts();
    const std::int64_t n_parts =
        part_of_film(1, n_jobs, film.n_frames(), format.n_chunk_frames).n_parts;
    if (n_parts < n_jobs)
        task.say(fmt::format(
            "note: a part begins every {} frames, so {} frames make {} part{}, not {}",
            format.n_chunk_frames, film.n_frames(), n_parts, n_parts == 1 ? "" : "s", n_jobs));
    task.begin(session.scene.name, film.n_frames());
    if (format.join == nullptr) {
        // The pictures are written under their final names; the lock prevents a second run.
        const AtomicFile held(path, aside_path_of(path));
        const std::vector<std::string> outputs(static_cast<std::size_t>(n_parts), path.string());
        draw_parts(session, request, n_parts, renderer.choice(), outputs, task);
        film.write_sidecars(path, task);
    } else {
        const std::string suffix = part_suffix(n_parts, path);
        UnfinishedFolder aside = open_parts(path, suffix);
        std::vector<std::string> parts;
        parts.reserve(static_cast<std::size_t>(n_parts));
        for (std::int64_t number = 1; number <= n_parts; ++number)
            parts.push_back(aside.file(fmt::format("{}{}", number, suffix)).string());
        draw_parts(session, request, n_parts, renderer.choice(), parts, task);
        join(parts, path.string(), {});
        aside.remove_all();
    }
    task.finish(with_film_length(printable(path.string()), film.n_frames(), film.film().rate));
}

std::int64_t gather_parts_aside(const fs::path& film) {
    const std::vector<LeftPart> left = parts_left_of(film);
    if (left.empty() || has_bytes(frame_log_path(film))) return 0;
    // Fails if another run is still drawing.
    std::optional<AtomicFile> file = open_frame_log(film, true);
    std::optional<FrameLog> log;  // takes the file with the first part
    std::vector<std::string> gathered;
    std::int64_t n_before = 0;  // frames gathered
    std::int64_t n_left = 0;    // frames after a gap
    bool has_gap = false;
    for (const LeftPart& part : left) {
        if (part.n_parts != left.front().n_parts) continue;
        const std::optional<PartFile> readable = part_if_readable(part.path);
        if (!readable) continue;
        const PartFile& part_file = *readable;
        if (has_gap || part_file.part().n_before != n_before || part_file.n_there() == 0) {
            n_left += part_file.n_there();
            continue;
        }
        if (!log) {
            OutputPlan plan = part_file.plan();
            plan.path = film;
            plan.part.reset();
            plan.resume = true;
            log.emplace(std::move(*file), plan, part_file.settings(), 1);
        }
        append_all(part_file, *log);
        n_before += part_file.n_there();
        gathered.push_back(part.path.filename().string());
        has_gap = !part_file.is_whole();
    }
    if (!log) return 0;
    log.reset();
    auto folder = UnfinishedFolder::left(parts_place(film));
    if (folder && n_left == 0)
        folder->remove_all();
    else if (folder)
        for (const std::string& part : gathered) folder->remove(part);
    return n_left;
}

}  // namespace poinsot
