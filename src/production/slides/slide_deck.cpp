#include "production/slides/slide_deck.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
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

// The names of a slide's files; an empty name stands for a file that it does not have.
struct SlideFiles {
    std::string film, loop, captions, loop_captions, png, pdf;

    std::vector<std::string> all() const {
        std::vector<std::string> names;
        for (const std::string& name : {film, loop, captions, loop_captions, png, pdf})
            if (!name.empty()) names.push_back(name);
        return names;
    }
};

SlideFiles files_of(const Session& session, const FilmPlan& film, const Slide& slide,
                    std::size_t index) {
    const auto name_if = [index](bool is_there, std::string_view suffix) {
        return is_there ? file_of(index, suffix) : std::string();
    };
    const auto has_captions = [&](std::int64_t first) {
        return !subtitles_of(session, film, first, slide.last_frame).empty();
    };
    const bool loops = slide.n_loop_frames > 0;
    return {.film = file_of(index, ".mp4"),
            .loop = name_if(loops, "-loop.mp4"),
            .captions = name_if(has_captions(slide.first_frame), ".vtt"),
            .loop_captions = name_if(loops && has_captions(slide.first_loop_frame()), "-loop.vtt"),
            .png = file_of(index, ".png"),
            .pdf = file_of(index, ".pdf")};
}

std::string row_of(const Session& session, const FilmPlan& film, const Slide& slide,
                   std::size_t index) {
    const auto or_null = [](const std::string& name) {
        return name.empty() ? "null" : json_string(name);
    };
    const double loop_s = static_cast<double>(slide.n_loop_frames) / film.rate.per_second();
    const SlideFiles files = files_of(session, film, slide, index);
    return JsonObject()
        .add("number", index + 1)
        .add("is_stop", slide.is_stop)
        .add("title", slide.title)
        .add("note", slide.note)
        .add("film", files.film)
        .json("loop", or_null(files.loop))
        .json("captions", or_null(files.captions))
        .json("loop_captions", or_null(files.loop_captions))
        .add("png", files.png)
        .add("pdf", files.pdf)
        .add("begin_s", film.moment_of(slide.first_frame).film_s)
        .add("end_s", film.moment_of(slide.last_frame).film_s)
        .add("loop_s", loop_s)
        .add("motion_time_s", film.time_of(slide.last_frame))
        .add("first_frame", slide.first_frame)
        .add("last_frame", slide.last_frame)
        .line();
}

// The text of slides.json. It changes with everything that the films depend on, except for the
// machine and the renderer.
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

// Whether a file of a deck can have this name, as "01.mp4", "02-loop.vtt" or "slides.json".
bool is_deck_name(std::string_view name) {
    if (name == plan_name) return true;
    const std::size_t n_digits = std::min(name.find_first_not_of("0123456789"), name.size());
    if (n_digits < 2) return false;
    name.remove_prefix(n_digits);
    constexpr std::string_view loop = "-loop";
    if (name.starts_with(loop)) name.remove_prefix(loop.size());
    return name == ".mp4" || name == ".vtt" || name == ".png" || name == ".pdf";
}

bool is_deck_file(const fs::directory_entry& entry) {
    return fs::is_regular_file(entry.symlink_status()) &&
           is_deck_name(entry.path().filename().string());
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
            "{}: is the current folder; slides need a folder of their own, so name a new one",
            name));
    const fs::path plan = folder / plan_name;
    const std::string text = kind_of_file(plan) == FileKind::regular ? read_text(plan) : "";
    const bool is_own = text.starts_with(plan_head(scene));
    if (text.starts_with("{\n  \"slides_of\": ") && !is_own)
        throw InputError(fmt::format(
            "{}: holds the slides of another scene; name another folder, or remove this one",
            name));
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (!is_own || !is_deck_file(entry))
            throw InputError(
                fmt::format("{}: holds other files, such as {}; name a new or an empty folder",
                            name, printable(entry.path().filename().string())));
}

// The hidden folder in which a deck is made, with a lock beside it. It is removed unless it holds
// frames from which another run can continue.
class DeckAside {
 public:
    DeckAside(const fs::path& folder, const std::string& plan)
        : folder_(folder),
          aside_(made(folder)),
          lock_(aside_path_of(folder, ".held"), aside_path_of(folder, ".held")) {
        // Another run may have renamed it before it gave up the lock.
        made(folder);
        const fs::path file = aside_ / plan_name;
        if (kind_of_file(file) == FileKind::regular && read_text(file) == plan) return;
        for (const fs::path& other : contents()) fs::remove_all(other);
        write_whole(file, plan);
    }
    ~DeckAside() {
        const std::vector<fs::path> left = contents();
        std::error_code ignored;
        if (left.empty() || left == std::vector{aside_ / plan_name})
            fs::remove_all(aside_, ignored);
    }
    DeckAside(const DeckAside&) = delete;
    DeckAside& operator=(const DeckAside&) = delete;

    fs::path file(const std::string& name) const { return aside_ / name; }

    // Gives these files, the plan among them, to the folder. In an earlier deck each replaces the
    // file of its name, the plan last; files that only the earlier deck has are removed.
    void commit(const std::set<std::string>& files) const {
        for (const fs::path& other : contents())
            if (!files.contains(other.filename().string())) fs::remove_all(other);
        if (kind_of_file(folder_) == FileKind::missing) return move(aside_, folder_);
        for (const std::string& name : files)
            if (name != plan_name) move(aside_ / name, folder_ / name);
        move(aside_ / plan_name, folder_ / plan_name);
        std::vector<fs::path> old;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            if (is_deck_file(entry) && !files.contains(entry.path().filename().string()))
                old.push_back(entry.path());
        for (const fs::path& file : old) fs::remove(file);
    }

 private:
    static fs::path made(const fs::path& folder) {
        fs::path aside = aside_path_of(folder);
        std::error_code error;
        fs::create_directory(aside, error);
        if (error) throw_write_error(folder, error.value());
        return aside;
    }

    static void move(const fs::path& from, const fs::path& to) {
        std::error_code error;
        fs::rename(from, to, error);
        if (error) throw_write_error(to, error.value());
    }

    std::vector<fs::path> contents() const {
        std::vector<fs::path> files;
        std::error_code error;
        for (fs::directory_iterator at(aside_, error); !error && at != fs::directory_iterator();
             at.increment(error))
            files.push_back(at->path());
        return files;
    }

    fs::path folder_, aside_;
    AtomicFile lock_;
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
                "begins again; set loop_s to a period of the motion",
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
    fs::path folder = request.folder.lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();
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
        if (kind_of_file(one.output) == FileKind::regular) {
            // An interrupted run has finished this film, perhaps without its captions.
            FilmJob(session, one).write_sidecars(one.output, films);
        } else {
            make_in_jobs(session, one, request.n_jobs, renderer, films);
            has_told_notes = true;
        }
        n_before += last - first + 1;
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
    std::set<std::string> files{plan_name};
    for (std::size_t i = 0; i < slides.size(); ++i)
        for (std::string& name : files_of(session, film, slides[i], i).all())
            files.insert(std::move(name));
    aside.commit(files);
    progress.finish(fmt::format("{}, {} slide{}", folder.string(), slides.size(),
                                slides.size() == 1 ? "" : "s"));
}

}  // namespace poinsot
