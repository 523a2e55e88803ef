#include "production/slides/slide_deck.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "error/error.h"
#include "output/frame_name.h"
#include "production/jobs/film_job.h"
#include "production/jobs/still_job.h"
#include "production/parts/jobs.h"
#include "production/provenance/record.h"
#include "production/sidecars/subtitles.h"
#include "production/slides/slide_plan.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/interrupt.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

constexpr const char* plan_name = "slides.json";

// "01.mp4" for slide 0.
std::string file_of(std::size_t slide, std::string_view suffix) {
    return frame_name(fmt::format("##{}", suffix), static_cast<std::int64_t>(slide) + 1).string();
}

// The first line of the plan, which tells whose deck it is.
std::string plan_head(const Scene& scene) {
    return fmt::format("{{\n  \"slides_of\": {},\n", json_string(scene.name));
}

std::string row_of(const Session& session, const FilmPlan& film, const Slide& slide,
                   std::size_t index) {
    const auto or_null = [](bool is_there, const std::string& name) {
        return is_there ? json_string(name) : "null";
    };
    const double loop_s = static_cast<double>(slide.n_loop_frames) / film.rate.per_second();
    const auto has_captions = [&](std::int64_t first) {
        return !subtitles_of(session, film, first, slide.last_frame).empty();
    };
    const bool loops = slide.n_loop_frames > 0;
    return JsonObject()
        .add("number", index + 1)
        .add("is_stop", slide.is_stop)
        .add("title", slide.title)
        .add("note", slide.note)
        .add("film", file_of(index, ".mp4"))
        .json("loop", or_null(loops, file_of(index, "-loop.mp4")))
        .json("captions", or_null(has_captions(slide.first_frame), file_of(index, ".vtt")))
        .json("loop_captions",
              or_null(loops && has_captions(slide.first_loop_frame()), file_of(index, "-loop.vtt")))
        .add("png", file_of(index, ".png"))
        .add("pdf", file_of(index, ".pdf"))
        .add("begin_s", film.moment_of(slide.first_frame).film_s)
        .add("end_s", film.moment_of(slide.last_frame).film_s)
        .add("loop_s", loop_s)
        .add("motion_time_s", film.time_of(slide.last_frame))
        .add("first_frame", slide.first_frame)
        .add("last_frame", slide.last_frame)
        .line();
}

// The text of slides.json. It changes with everything that the films depend on, except for the
// machine.
std::string plan_of(const Session& session, const FilmPlan& film, const std::vector<Slide>& slides,
                    bool is_portable) {
    const Scene& scene = session.scene;
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < slides.size(); ++i)
        rows.push_back(row_of(session, film, slides[i], i));
    const std::string text =
        JsonObject()
            .add("title", scene.title)
            .add("language", scene.language)
            .json("size", json_numbers(scene.film.width_px, scene.film.height_px))
            .add("frames_per_second",
                 fmt::format("{}/{}", film.rate.numerator, film.rate.denominator))
            .add("n_frames", film.n_frames)
            .add("poinsot", POINSOT_VERSION)
            .add("profile", is_portable ? "portable" : "native")
            .add("scene_sha256", scene_hash_of(scene))
            .json("slides", json_lines(rows, 2))
            .lines();
    return plan_head(scene) + text.substr(std::string_view("{\n").size());
}

// Throws InputError for a folder that holds other files than a deck of the scene.
void check_folder(const fs::path& folder, const Scene& scene) {
    const std::string name = printable(folder.string());
    const FileKind kind = kind_of_file(folder);
    if (kind == FileKind::missing) return;
    if (kind != FileKind::folder)
        throw InputError(fmt::format("{}: exists and is not a folder; name a new folder", name));
    std::error_code error;
    if (fs::equivalent(folder, fs::current_path(error), error))
        throw InputError(fmt::format(
            "{}: is the current folder, and the slides get a folder of their own; name a new one",
            name));
    const fs::path plan = folder / plan_name;
    const std::string text = kind_of_file(plan) == FileKind::regular ? read_text(plan) : "";
    if (text.starts_with("{\n  \"slides_of\": ") && !text.starts_with(plan_head(scene)))
        throw InputError(fmt::format(
            "{}: holds the slides of another scene; name another folder, or remove it", name));
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        const bool is_of_deck =
            text.starts_with(plan_head(scene)) &&
            (file == plan_name || text.find(json_string(file)) != std::string::npos);
        if (!is_of_deck)
            throw InputError(
                fmt::format("{}: holds other files, such as {}; name a new or an empty folder",
                            name, printable(file)));
    }
}

// The hidden folder in which a deck is made. It is removed unless it holds frames from which
// another run can continue.
class DeckAside {
 public:
    DeckAside(const fs::path& folder, const std::string& plan)
        : folder_(folder), aside_(aside_path_of(folder)) {
        make();
        lock_.emplace(aside_ / plan_name, aside_ / "held");
        const fs::path file = aside_ / plan_name;
        const bool goes_on = kind_of_file(file) == FileKind::regular && read_text(file) == plan;
        if (goes_on) return;
        for (const fs::path& other : others()) fs::remove_all(other);
        write_whole(file, plan);
    }
    ~DeckAside() {
        lock_.reset();
        std::error_code ignored;
        const std::vector<fs::path> left = others();
        if (left.empty() || left == std::vector{aside_ / plan_name})
            fs::remove_all(aside_, ignored);
    }
    DeckAside(const DeckAside&) = delete;
    DeckAside& operator=(const DeckAside&) = delete;

    fs::path file(const std::string& name) const { return aside_ / name; }

    // Gives the deck its name; an earlier deck of this name is removed.
    void commit() {
        lock_.reset();
        std::error_code error;
        const fs::path old = aside_path_of(folder_, ".old");
        fs::remove_all(old, error);
        if (kind_of_file(folder_) == FileKind::folder) fs::rename(folder_, old, error);
        if (!error) fs::rename(aside_, folder_, error);
        if (error) throw_write_error(folder_, error.value());
        fs::remove_all(old, error);
    }

 private:
    void make() const {
        std::error_code error;
        fs::create_directory(aside_, error);
        if (error) throw_write_error(folder_, error.value());
    }

    // All but the lock.
    std::vector<fs::path> others() const {
        std::vector<fs::path> files;
        std::error_code error;
        for (fs::directory_iterator at(aside_, error); !error && at != fs::directory_iterator();
             at.increment(error))
            if (at->path().filename() != "held" && at->path().filename() != ".held.part")
                files.push_back(at->path());
        return files;
    }

    fs::path folder_, aside_;
    std::optional<AtomicFile> lock_;
};

// Reports loops that jump where they begin again, as far as arrows show it.
void note_jumps(const Session& session, const FilmPlan& film, const std::vector<Slide>& slides,
                const ProgressSink& progress) {
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
            progress.say(fmt::format(
                "note: {}stops[{}].loop_s: the tip of an arrow jumps by {:.0f} px where the loop "
                "begins again; let it last a period of the motion",
                session.scene.where(fmt::format("stops[{}].loop_s", i)), i, jump_px));
    }
}

}  // namespace

void write_deck(const Session& session, const DeckRequest& request, LazyRenderer& renderer,
                const ProgressSink& progress) {
    const FilmPlan film = film_plan(session);
    const std::vector<Slide> slides = slides_of(session.scene, film, "--slides");
    // Stills for paper have the width and the type of a Beamer slide in 16:9.
    constexpr double beamer_width_mm = 160.0;
    SceneRequest on_paper = request.scene;
    on_paper.print = {};
    on_paper.print.dpi = session.scene.film.width_px * 25.4 / beamer_width_mm;
    on_paper.print.type_pt = 11.0;
    const Session paper = open_session(on_paper);
    fs::path folder =
        request.folder.filename().empty() ? request.folder.parent_path() : request.folder;
    if (fs::is_symlink(folder)) folder = fs::weakly_canonical(folder);
    check_folder(folder, session.scene);
    watch_for_interrupts();
    DeckAside aside(folder, plan_of(session, film, slides, renderer.is_portable()));

    // The films report as one.
    std::int64_t n_frames = 0, n_before = 0;
    for (const Slide& slide : slides)
        n_frames += slide.last_frame - slide.first_frame + 1 + slide.n_loop_frames;
    ProgressSink films = progress;
    films.begin = [](const std::string&, std::int64_t) {};
    films.done = [&](std::int64_t n_done) { progress.done(n_before + n_done); };
    films.finish = [](const std::string&) {};
    bool has_told_notes = false;
    films.say = [&](const std::string& line) {
        if (!has_told_notes && line.starts_with("note: ")) progress.say(line);
    };
    progress.begin(session.scene.name, n_frames);
    const auto make_film = [&](const std::string& name, std::int64_t first, std::int64_t last) {
        FilmRequest one{aside.file(name).string(), std::pair(first, last)};
        one.is_slide = true;
        // It was finished by an interrupted run.
        if (kind_of_file(one.output) != FileKind::regular)
            make_in_jobs(session, one, request.n_jobs, renderer, films);
        n_before += last - first + 1;
        has_told_notes = true;
    };
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const Slide& slide = slides[i];
        make_film(file_of(i, ".mp4"), slide.first_frame, slide.last_frame);
        if (slide.n_loop_frames > 0)
            make_film(file_of(i, "-loop.mp4"), slide.first_loop_frame(), slide.last_frame);
    }

    // The stills are frames of the film.
    StillWriter writer;
    const auto draw_still = [&](const Session& of, const PrintChoices& print, std::size_t i,
                                std::string_view suffix) {
        stop_if_interrupted();
        StillRequest still;
        still.output = aside.file(file_of(i, suffix)).string();
        still.frame = slides[i].last_frame;
        still.print = print;
        StillJob(Session(of), std::move(still)).draw(renderer, writer, {});
    };
    for (std::size_t i = 0; i < slides.size(); ++i) {
        draw_still(session, request.scene.print, i, ".png");
        draw_still(paper, on_paper.print, i, ".pdf");
    }
    writer.finish();
    note_jumps(session, film, slides, progress);
    aside.commit();
    progress.finish(fmt::format("{}, {} slide{}", folder.string(), slides.size(),
                                slides.size() == 1 ? "" : "s"));
}

}  // namespace poinsot
