#include "production/parts/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "error/error.h"
#include "output/film_part.h"
#include "output/frame_log.h"
#include "production/output_place.h"
#include "production/parts/child.h"
#include "production/parts/join.h"
#include "system/atomic_file.h"
#include "system/file_kind.h"
#include "system/interrupt.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// Where parts of a film wait for each other: a hidden folder beside it, which goes with the last of
// them. Held by one run at a time.
class PartsAside {
 public:
    PartsAside(const fs::path& film, std::int64_t n_parts)
        : folder_(aside_path_of(film, ".parts")),
          suffix_(fmt::format("-of-{}{}", n_parts, film.extension().string())) {
        std::error_code error;
        fs::create_directory(folder_, error);
        if (error) throw_write_error(film, error.value());
        lock_.emplace(film, folder_ / "held");
        remove_others();
    }
    ~PartsAside() {
        lock_.reset();
        std::error_code not_empty;
        fs::remove(folder_, not_empty);
    }
    PartsAside(const PartsAside&) = delete;
    PartsAside& operator=(const PartsAside&) = delete;

    std::string part(std::int64_t number) const {
        return (folder_ / fmt::format("{}{}", number, suffix_)).string();
    }

    void clear() {
        lock_.reset();
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

 private:
    // What a run of another number of jobs has left cannot be gone on with.
    void remove_others() const {
        std::vector<fs::path> others;
        for (const auto& entry : fs::directory_iterator(folder_))
            if (const std::string name = entry.path().filename().string();
                name != "held" && name.find(suffix_) == std::string::npos)
                others.push_back(entry.path());
        for (const fs::path& other : others) {
            std::error_code ignored;
            fs::remove(other, ignored);
        }
    }

    fs::path folder_;
    std::string suffix_;
    std::optional<AtomicFile> lock_;
};

// Jobs share the processor; each drawing with as many threads as there are cores would only make
// them wait for each other.
void take_a_share_of_the_cores(std::int64_t n_jobs) {
    const std::int64_t n_cores = std::max(1u, std::thread::hardware_concurrency());
    const std::int64_t n_threads = n_cores / n_jobs;
    // llvmpipe draws on the calling thread where it has no threads of its own.
    ::setenv("LP_NUM_THREADS", fmt::format("{}", n_threads > 1 ? n_threads : 0).c_str(), 0);
}

// Draws all parts side by side.
void draw_parts(const Session& session, const FilmRequest& request, std::int64_t n_parts,
                const ContextChoice& context, const std::vector<std::string>& outputs,
                const Telling& telling) {
    Children children;
    for (std::int64_t number = 1; number <= n_parts; ++number) {
        FilmRequest part = request;
        part.output = outputs[static_cast<std::size_t>(number - 1)];
        part.part = {number, n_parts};
        children.start([&session, &context, part, n_parts](const Telling& child_telling) {
            take_a_share_of_the_cores(n_parts);
            Easel easel(context);
            FilmJob(session, part).make(easel, child_telling);
        });
    }
    children.wait(telling);
}

}  // namespace

void make_in_jobs(const Session& session, const FilmRequest& request, int n_jobs,
                  const ContextChoice& context, const Telling& telling) {
    const FilmJob film(session, request);
    const OutputPlace place(request.output, session.scene, ".mp4");
    const fs::path& path = place.path();
    const OutputFormat& format = format_for(path);
    if (!format.has_parts)
        throw InputError(fmt::format("{}: has no parts that --jobs could share out; leave it out",
                                     printable(path.string())));
    watch_for_interrupts();
    const std::int64_t n_parts =
        part_of_film(1, n_jobs, film.n_frames(), format.n_chunk_frames).n_parts;
    if (n_parts < n_jobs)
        telling.say(fmt::format("note: {} frames are {} of {}, so {} are drawn", film.n_frames(),
                                n_parts == 1 ? "one part" : "parts", format.n_chunk_frames,
                                n_parts));
    telling.begin(session.scene.name, film.n_frames());
    if (format.join == nullptr) {
        // Pictures go to their own names at once.
        const std::vector<std::string> outputs(static_cast<std::size_t>(n_parts), path.string());
        draw_parts(session, request, n_parts, context, outputs, telling);
        film.end_sequence(path, telling);
    } else {
        PartsAside aside(path, n_parts);
        std::vector<std::string> parts;
        for (std::int64_t number = 1; number <= n_parts; ++number)
            parts.push_back(aside.part(number));
        draw_parts(session, request, n_parts, context, parts, telling);
        join(parts, path.string(), {});
        aside.clear();
    }
    telling.finish(printable(path.string()));
}

}  // namespace poinsot
