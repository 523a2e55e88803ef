// poinsot render SCENE -o OUT: renders a film or a sequence.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "cli/scenes.h"
#include "cli/sweep.h"
#include "error/error.h"
#include "output/frame_name.h"
#include "output/frame_sink.h"
#include "production/jobs/film_job.h"
#include "production/pages/page_job.h"
#include "production/parts/jobs.h"
#include "production/slides/pptx_deck.h"
#include "production/slides/slide_deck.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct RenderChoices {
    std::vector<std::string> scenes;
    std::string output;
    std::string slides;  // folder; empty: no slides
    std::vector<std::string> sweeps;
    SceneOptions scene;
    ContextOptions context;
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // inclusive
    std::optional<std::pair<std::int64_t, std::int64_t>> part;    // K of N, from 1
    std::optional<int> n_jobs;
    bool certify = false;
    bool quiet = false;
};

// Prints how accurately the film fulfils the claims of its method; returns whether it does.
bool certified(const Session& session, const FilmPlan& film, const ProgressSink& progress) {
    if (!can_certify(session)) {
        throw InputError("--certify needs a torque-free body that rotates; leave --certify out");
    }
    const Certificate certificate = certify_film(session, film, progress);
    fmt::print("{}", text_of(certificate));
    return certificate.holds();
}

int render(const SceneJob& job, const RenderChoices& choices, LazyRenderer& renderer) {
    ProgressBar bar(choices.quiet);
    const ProgressSink progress = bar.sink();
    const SceneRequest scene = scene_request_of(job.scene, choices.scene, job.overrides);
    if (!choices.slides.empty()) {
        const Session session = open_session(scene, progress);
        if (choices.certify && !certified(session, film_plan(session), progress)) return 1;
        write_deck(session, {scene, job.output, choices.n_jobs}, renderer, progress);
        return 0;
    }
    if (is_page_name(job.output)) {
        write_page(scene, job.output, renderer, progress);
        return 0;
    }
    const Session session = open_session(scene, progress);
    if (is_slides_name(job.output)) {
        if (choices.certify && !certified(session, film_plan(session), progress)) return 1;
        write_pptx(session, {job.output, choices.n_jobs}, renderer, progress);
        return 0;
    }
    FilmRequest request{job.output, choices.frames};
    request.part = choices.part;
    const FilmJob film(session, request);
    // A film that is less accurate than its method claims is refused before it is rendered.
    if (choices.certify && !certified(session, film.film(), progress)) return 1;
    if (choices.part)
        film.make(renderer, progress);
    else
        make_in_jobs(session, request, choices.n_jobs, renderer, progress);
    return 0;
}

// Parts with the same name would replace each other: the first #### of a film's name is the part's
// number.
std::string output_of(const RenderChoices& choices) {
    const std::filesystem::path output(choices.output);
    if (!choices.part || suffix_of(output) == ".png" || !has_frame_number(output))
        return choices.output;
    return frame_name(output, choices.part->first).string();
}

// Options that choose or divide frames, which a page does not have.
void check_page(const RenderChoices& choices) {
    if (!is_page_name(choices.output)) return;
    const std::pair<bool, std::string_view> options[] = {{choices.frames.has_value(), "--frames"},
                                                         {choices.part.has_value(), "--part"},
                                                         {choices.n_jobs.has_value(), "--jobs"},
                                                         {choices.certify, "--certify"}};
    for (const auto& [is_given, option] : options)
        if (is_given)
            throw InputError(
                fmt::format("{}: a page has no frames, it shows every instant; leave {} out",
                            printable(choices.output), option));
}

// Options that name another output or choose frames.
void check_slides(const RenderChoices& choices) {
    const bool is_folder = !choices.slides.empty();
    if (!is_folder && !is_slides_name(choices.output)) return;
    const std::pair<bool, std::string_view> options[] = {
        {is_folder && !choices.output.empty(), "-o"},
        {choices.frames.has_value(), "--frames"},
        {choices.part.has_value(), "--part"}};
    for (const auto& [is_given, option] : options)
        if (is_given)
            throw InputError(
                is_folder
                    ? fmt::format("--slides writes a film for each stop into its folder; leave {} "
                                  "out",
                                  option)
                    : fmt::format("{}: a presentation has a film for each stop; leave {} out",
                                  printable(choices.output), option));
}

void check(const RenderChoices& choices) {
    check_slides(choices);
    if (choices.slides.empty()) check_page(choices);
    constexpr int most = 4096;
    if (choices.n_jobs && (*choices.n_jobs < 1 || *choices.n_jobs > most))
        throw InputError(fmt::format("--jobs {}: not a number of processes; give 1 to {}",
                                     *choices.n_jobs, most));
    if (choices.n_jobs && *choices.n_jobs > 1 && choices.part)
        throw InputError(
            "one process draws a --part; leave --jobs out, or draw all parts here with --jobs "
            "alone");
}

int run(const RenderChoices& choices) {
    check(choices);
    LazyRenderer renderer(context_choice_of(choices.context));
    const std::string output = choices.slides.empty() ? output_of(choices) : choices.slides;
    return for_each_scene(jobs_of(choices.scenes, output, OutputKind::film, choices.sweeps),
                          [&](const SceneJob& job) { return render(job, choices, renderer); });
}

CommandLine render_line() {
    const auto choices = std::make_shared<RenderChoices>();
    RenderChoices& c = *choices;
    return {
        &c.scenes,
        {output_option(c.output, "output file; default output/SCENE.mp4"),
         {.flags = "--slides",
          .takes = "FOLDER",
          .help = "write a film, a PNG and a PDF for each stop (without stops: for each chapter) "
                  "and slides.json into this folder",
          .value =
              ReadText{[&c](const std::string& text) { c.slides = parse_text("--slides", text); }},
          .completes = "folder"},
         set_option(c.scene),
         sweep_option(c.sweeps),
         size_option(c.scene),
         fps_option(c.scene),
         theme_option(c.scene),
         quality_option(c.scene),
         {.flags = "--frames",
          .takes = "A-B",
          .help = "draw only frames A to B, counted from 0",
          .value = ReadText{[&c](const std::string& text) { c.frames = parse_frames(text); }}},
         {.flags = "--part",
          .takes = "K/N",
          .help =
              "draw only part K of N, K from 1, for poinsot join; #### in a film's name becomes K",
          .value = ReadText{[&c](const std::string& text) { c.part = parse_part(text); }}},
         {.flags = "--jobs",
          .help = "number of processes that draw parts at the same time; the output is "
                  "byte-identical; default: chosen for this machine, see check --plan",
          .value = &c.n_jobs,
          .wanted = "a number of processes"},
         quiet_option(c.quiet),
         backend_option(c.context),
         portable_option(c.context),
         {.flags = "--certify",
          .help = "measure over all frames how well the motion fulfils Poinsot's construction",
          .value = &c.certify},
         allow_outside_option(c.scene.allow_outside)},
        [choices] { return run(*choices); }};
}

}  // namespace

extern const Command render_command{
    "render",
    "SCENE",
    1,
    any_number,
    "write a film (.mp4, .webm, .mov, .gif), a PNG sequence (#### in the name), a page (.html) or "
    "slides (.pptx) of each scene",
    render_line,
    {{{"poinsot render generic -o generic.mp4", "a film of a scene that comes with the program"},
      {"poinsot render generic -o frame_####.png --frames 0-59",
       "two seconds as a PNG sequence"}}}};

}  // namespace poinsot
