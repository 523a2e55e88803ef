// poinsot render SCENE -o OUT: a film or a sequence.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "cli/command.h"
#include "cli/jobs.h"
#include "cli/progress.h"
#include "cli/requests.h"
#include "cli/scenes.h"
#include "error/error.h"
#include "output/frame_name.h"
#include "output/pipeline.h"
#include "production/chapters.h"
#include "production/output_place.h"
#include "production/picture.h"
#include "production/record.h"
#include "production/session.h"
#include "system/interrupt.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// What an interrupted run has left is gone on from, and the user is told.
void note_kept(const OutputPlan& plan, std::int64_t n_kept, bool film, bool quiet) {
    if (quiet || n_kept == 0) return;
    if (n_kept == plan.n_frames && film) {
        say(fmt::format("note: an interrupted run has drawn all frames of {}",
                        printable(plan.path.string())));
        return;
    }
    if (n_kept == plan.n_frames) {
        say(fmt::format(
            "note: all {} frames of {} are there, of this very scene; remove them to have "
            "them drawn again",
            n_kept, printable(plan.path.string())));
        return;
    }
    say(fmt::format("note: going on with frame {} of {}, where an interrupted run ended",
                    plan.first_frame + n_kept, printable(plan.path.string())));
}

// A shorter run over a longer one, or one of other frames, leaves pictures that are not its own.
void note_others(const OutputPlan& plan) {
    std::vector<std::int64_t> others = frames_there(plan.path);
    std::erase_if(others, [&plan](std::int64_t frame) {
        return frame >= plan.first_frame && frame < plan.first_frame + plan.n_frames;
    });
    if (others.empty()) return;
    const auto name = [&plan](std::int64_t frame) {
        return printable(frame_name(plan.path, frame).filename().string());
    };
    fmt::print(
        stderr, "note: {} of another run beside these: {}{}; remove {} or name another output\n",
        others.size() == 1 ? "there is a frame" : fmt::format("there are {} frames", others.size()),
        name(others.front()), others.size() == 1 ? "" : fmt::format(" to {}", name(others.back())),
        others.size() == 1 ? "it" : "them");
}

}  // namespace

int make_film(const Session& session, const Options& options, Easel& easel, std::int64_t n_shown) {
    print_notes(session.scene, options.quiet);
    const FilmPlan film = film_plan(session);

    // The frames wanted, checked against the film before anything is opened.
    std::int64_t first = 0;
    std::int64_t last = film.n_frames - 1;
    if (options.frames) {
        first = options.frames->first;
        last = options.frames->second;
        if (last >= film.n_frames) {
            throw InputError(
                fmt::format("--frames {}-{}: the film has frames 0-{}; ask for a part of those",
                            first, last, film.n_frames - 1));
        }
    }

    OutputPlan plan;
    const OutputPlace place(options.output, session.scene, ".mp4");
    plan.path = place.path();
    plan.width_px = session.scene.film.width_px;
    plan.height_px = session.scene.film.height_px;
    plan.rate = film.rate;
    plan.first_frame = first;
    plan.n_frames = last - first + 1;
    plan.quality = session.scene.film.quality;
    plan.chapters = chapters_of(session.scene, film, first, last);

    // A film that is not what its method promises is refused before it is drawn.
    if (options.certify) {
        if (!can_certify(session)) {
            throw InputError(
                "--certify: only a torque-free body that turns rolls on a plane; leave it out");
        }
        const Certificate certificate = certify_film(session, film, options.quiet);
        fmt::print("{}", text_of(certificate));
        if (!certificate.holds()) return 1;
    }

    watch_for_interrupts();
    const OutputFormat& format = format_for(plan.path);
    if (n_shown > 0 && n_shown < plan.n_frames) {
        // Packets know of the frames that follow in their chunk.
        const std::int64_t chunk = format.n_chunk_frames;
        plan.n_frames = std::min(plan.n_frames, (n_shown + chunk - 1) / chunk * chunk);
        plan.n_shown = n_shown;
    }
    PictureMaker pictures(session, easel,
                          {.first_time_s = film.time_of(0), .last_time_s = film.time_of(last)});
    print_type_notes(pictures.stage(), options.quiet);
    Record record = record_of(session, pictures, options.portable);
    record.frames = {first, last};
    plan.metadata = to_text(record);
    plan.tell = told;
    plan.resume = true;
    AsyncSink sink(format.open(plan));
    note_kept(plan, sink.n_frames_kept(), format.film, options.quiet);
    Progress progress(session.scene.name, plan.n_frames, options.quiet);
    // The first picture is drawn whole, the second keeps what stands still, the third has it.
    constexpr std::int64_t n_to_compile = 3;
    const std::int64_t first_drawn = first + sink.n_frames_kept();
    for (std::int64_t frame = first_drawn; frame < first + plan.n_frames; ++frame) {
        stop_if_interrupted();
        Image image = sink.spare();
        pictures.draw(film.moment_of(frame), image);
        sink.write_moved(std::move(image));
        if (frame == first_drawn + n_to_compile - 1) easel.context().shaders_are_compiled();
        progress.at(frame - first + 1);
    }
    sink.finish();
    if (plan.n_shown > 0) {
        plan.n_frames = plan.n_shown;
        plan.chapters = chapters_of(session.scene, film, first, first + plan.n_shown - 1);
    }
    if (!plan.chapters.empty() && (format.film || format.name == "png-sequence")) {
        write_chapters(plan, film);
    } else {
        remove_stale_chapters(plan);
    }
    if (!options.quiet && format.name == "png-sequence") note_others(plan);
    progress.finish(printable(plan.path.string()));
    if (!options.quiet) {
        say(in_words(pictures.bound(), session.scene.accuracy_px));
    }
    return 0;
}

namespace {

int run(const Options& options) {
    Easel easel(context_choice_of(options), options.print);
    return for_each_scene(options, [&easel](const Options& own) {
        return make_film(open_session(scene_request_of(own)), own, easel);
    });
}

constexpr auto options_taken =
    std::to_array<std::string_view>({"output", "set", "size", "fps", "theme", "quality", "frames",
                                     "quiet", "backend", "portable", "certify", "allow-outside"});

}  // namespace

const Command render_command{
    "render",      "SCENE", 1, any_number, "make a film or a PNG sequence of each scene",
    options_taken, run};

}  // namespace poinsot
