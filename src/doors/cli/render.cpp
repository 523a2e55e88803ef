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
#include "encoding/frame_name.h"
#include "error/error.h"
#include "orders/film.h"
#include "system/files/file_kind.h"

namespace poinsot {

namespace {

struct RenderChoices {
    std::vector<std::string> scenes;
    std::vector<std::string> sweeps;
    GivenOptions given;
    FilmOrder film;
    bool quiet = false;
};

// Prints how accurately the film fulfils the claims of its method; returns whether it does.
bool certified(const Session& session, const FilmPlan& film, const Task& task) {
    if (!can_certify(session)) {
        throw InputError("--certify needs a torque-free body that rotates; leave --certify out");
    }
    const Certificate certificate = certify_film(session, film, task);
    fmt::print("{}", text_of(certificate));
    return certificate.holds();
}

int render(const SceneJob& job, const RenderChoices& choices, LazyRenderer& renderer) {
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    const SceneRequest scene = scene_request(job.scene, choices.given, job.overrides);
    FilmOrder film = choices.film;
    (film.slides.empty() ? film.output : film.slides) = job.output;
    std::optional<Session> session;
    const FilmCaller caller{
        .session = [&]() -> const Session& { return session.emplace(open_session(scene, task)); },
        .accepts = [&](const Session& opened,
                       const FilmPlan& plan) { return certified(opened, plan, task); }};
    return make_output(scene, film, caller, renderer, task) ? 0 : 1;
}

// Parts with the same name would replace each other: the first #### of a film's name is the part's
// number.
std::string output_of(const FilmOrder& film) {
    if (!film.slides.empty()) return film.slides;
    const std::filesystem::path output(film.output);
    if (!film.part || suffix_of(output) == ".png" || !has_frame_number(output)) return film.output;
    return frame_name(output, film.part->first).string();
}

int run(const RenderChoices& choices) {
    check_order(choices.film);
    LazyRenderer renderer(context_choice_of(choices.given));
    return for_each_scene(
        jobs_of(choices.scenes, output_of(choices.film), OutputKind::film, choices.sweeps),
        [&](const SceneJob& job) { return render(job, choices, renderer); });
}

CommandLine render_line() {
    const auto choices = std::make_shared<RenderChoices>();
    RenderChoices& c = *choices;
    return {
        &c.scenes,
        joined(
            {{output_option(c.film.output, "output file; default output/SCENE.mp4"),
              {.flags = "--slides",
               .takes = "FOLDER",
               .help = "write a film, a PNG and a PDF for each stop (without stops: for each "
                       "chapter), "
                       "index.html, which lists them, and slides.json into this folder",
               .value = ReadText{[&c](const std::string& text) {
                   c.film.slides = parse_text("--slides", text);
               }},
               .completes = "folder"},
              set_option(c.given),
              sweep_option(c.sweeps)},
             options_of(Verb::film | Verb::slides | Verb::page, c.given),
             {{.flags = "--part",
               .takes = "K/N",
               .help = "draw only part K of N, K from 1, for poinsot join; #### in a film's name "
                       "becomes K",
               .value =
                   ReadText{[&c](const std::string& text) { c.film.part = parse_part(text); }}},
              {.flags = "--jobs",
               .help = "number of processes that draw parts at the same time; the output is "
                       "byte-identical; default: chosen for this machine, see check --plan",
               .value = &c.film.n_jobs,
               .wanted = "a number of processes"},
              {.flags = "--certify",
               .help = "measure over all frames how well the motion fulfils Poinsot's construction",
               .value = &c.film.certify},
              quiet_option(c.quiet),
              allow_outside_option(c.given.allow_outside)}}),
        [choices] {
            choices->film.frames = choices->given.frames;
            return run(*choices);
        }};
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
