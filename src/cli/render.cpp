// poinsot render SCENE -o OUT: a film or a sequence.
#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <utility>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/scenes.h"
#include "error/error.h"
#include "production/film_job.h"

namespace poinsot {

namespace {

struct RenderChoices {
    std::vector<std::string> scenes;
    std::string output;
    SceneOptions scene;
    ContextOptions context;
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // inclusive
    bool certify = false;
    bool quiet = false;
};

// Prints how well the film keeps what its method promises; whether it does.
bool certified(const Session& session, const FilmPlan& film, const Telling& telling) {
    if (!can_certify(session)) {
        throw InputError(
            "--certify: only a torque-free body that turns rolls on a plane; leave it out");
    }
    const Certificate certificate = certify_film(session, film, telling);
    fmt::print("{}", text_of(certificate));
    return certificate.holds();
}

int render(const SceneJob& job, const RenderChoices& choices, Easel& easel) {
    Progress progress(choices.quiet);
    const Telling telling = progress.telling();
    const Session session =
        open_session(scene_request_of(job.scene, choices.scene), Purpose::pictures, telling);
    const FilmJob film(session, {job.output, choices.frames});
    // A film that is not what its method promises is refused before it is drawn.
    if (choices.certify && !certified(session, film.film(), telling)) return 1;
    film.make(easel, telling);
    return 0;
}

int run(const RenderChoices& choices) {
    Easel easel(context_choice_of(choices.context));
    return for_each_scene(jobs_of(choices.scenes, choices.output, OutputKind::film),
                          [&](const SceneJob& job) { return render(job, choices, easel); });
}

CommandLine line(std::any& room) {
    auto& c = room.emplace<RenderChoices>();
    return {&c.scenes,
            {output_option(c.output),
             set_option(c.scene),
             size_option(c.scene),
             fps_option(c.scene),
             theme_option(c.scene),
             quality_option(c.scene),
             {"--frames", "A-B: only these frames, from 0, both included",
              ReadText([&c](const std::string& text) { c.frames = parse_frames(text); })},
             quiet_option(c.quiet),
             backend_option(c.context),
             portable_option(c.context),
             {"--certify", "measure how well it is Poinsot's, over all frames", &c.certify},
             allow_outside_option(c.scene.allow_outside)},
            [&c] { return run(c); }};
}

}  // namespace

const Command render_command{
    "render",
    "SCENE",
    1,
    any_number,
    "make a film or a PNG sequence of each scene",
    line,
    {{{"poinsot render generic -o generic.mp4", "the film of a scene that came with the program"},
      {"poinsot render generic -o frames/####.png --frames 0-59",
       "two seconds as a PNG sequence"}}}};

}  // namespace poinsot
