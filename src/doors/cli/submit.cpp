// poinsot submit SCENE… -o OUT --parts N: renders films in parts on a Slurm cluster.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "cli/scenes.h"
#include "cli/sweep.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "production/cluster/slurm.h"
#include "production/cluster/submission.h"
#include "production/films/film_job.h"
#include "production/records/record.h"
#include "system/run_program.h"
#include "system/suffix.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct SubmitChoices {
    std::vector<std::string> scenes;
    std::string output;
    std::vector<std::string> sweeps;
    GivenOptions given;
    int n_parts = 0;
    std::vector<std::string> slurm;
    bool native = false, dry_run = false, quiet = false;
};

void check(const SubmitChoices& choices) {
    if (choices.output.empty())
        throw InputError("poinsot submit: no output; name the film with -o FILE");
    if (choices.n_parts < 1)
        throw InputError("poinsot submit: no number of parts; give it with --parts N, from 1");
    context_choice_of(choices.given);
}

// The --set of an override in a task, which runs in another folder: the path of a theme file in the
// current folder is made absolute.
std::string for_a_task(Override given) {
    std::error_code failed;
    const std::filesystem::path file = given.value;
    if (given.key == "theme" && suffix_of(file) == ".toml" && std::filesystem::exists(file, failed))
        given.value = std::filesystem::absolute(file).string();
    return given.assignment();
}

// The options of every render command of the submission.
std::vector<std::string> render_options(const SubmitChoices& choices) {
    std::vector<std::string> options;
    if (!choices.native) options.emplace_back("--portable");
    if (choices.given.context.backend != "auto")
        options.insert(options.end(), {"--backend", choices.given.context.backend});
    if (choices.given.allow_outside) options.emplace_back("--allow-outside");
    if (choices.given.frames)
        options.insert(options.end(), {"--frames", fmt::format("{}-{}", choices.given.frames->first,
                                                               choices.given.frames->second)});
    for (const Override& given : choices.given.overrides)
        options.insert(options.end(), {"--set", for_a_task(given)});
    return options;
}

// Reads each scene here, so that errors are found before any task is submitted.
std::vector<FilmToSubmit> films_of(const SubmitChoices& choices, const Task& task) {
    std::vector<FilmToSubmit> films;
    for (const SceneJob& job :
         jobs_of(choices.scenes, choices.output, OutputKind::film, choices.sweeps)) {
        const Session session =
            open_session(scene_request(job.scene, choices.given, job.overrides), task);
        FilmToSubmit& film = films.emplace_back();
        film.scene = scene_file(job.scene);
        film.scene_hash = scene_hash_of(session.scene);
        for (const Override& given : job.overrides)
            film.options.insert(film.options.end(), {"--set", for_a_task(given)});
        film.output = job.output;
        film.n_frames = FilmJob(session, {job.output, choices.given.frames}).n_frames();
        const std::filesystem::path folder = film.output.parent_path();
        if (!folder.empty() && !std::filesystem::is_directory(folder))
            throw EnvironmentError(fmt::format("{}: there is no folder {}; make it first",
                                               printable(film.output.string()),
                                               printable(folder.string())));
    }
    return films;
}

void print(const Submission& submission, const SlurmIds& ids) {
    for (const auto& [what, list] : {std::pair{"parts", &ids.parts}, {"joins", &ids.joins}})
        for (const std::string& id : *list) fmt::print("{} {}\n", what, id);
    fmt::print("folder {}\n", submission.folder.string());
}

int run(const SubmitChoices& choices) {
    check(choices);
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    const std::vector<FilmToSubmit> films = films_of(choices, task);
    const Submission submission = write_submission(submission_folder(choices.output), films,
                                                   render_options(choices), choices.n_parts);
    std::vector<std::string> options = site_options();
    for (const std::string& given : choices.slurm)
        for (const std::string& word : shell_words(given)) options.push_back(word);
    const std::vector<SlurmCall> calls =
        slurm_calls(submission, options, choices.dry_run ? 1001 : largest_array());
    const std::string folder = printable(submission.folder.string(), any_length);
    if (calls.empty()) {
        task.say(
            fmt::format("note: nothing to submit: all parts are done according to {}", folder));
        return 0;
    }
    if (choices.dry_run) {
        fmt::print("{}", in_shell(calls));
        task.say(fmt::format("wrote {}; submitted nothing", folder));
        return 0;
    }
    print(submission, submit(calls));
    task.say(fmt::format("watch with: poinsot status {}", shell_word(folder)));
    return 0;
}

CommandLine submit_line() {
    const auto choices = std::make_shared<SubmitChoices>();
    SubmitChoices& c = *choices;
    return {
        &c.scenes,
        joined({{output_option(c.output),
                 {.flags = "--parts",
                  .takes = "N",
                  .help = "number of parts of each film",
                  .value = &c.n_parts,
                  .wanted = "a number of parts"},
                 {.flags = "--slurm",
                  .takes = "OPTIONS",
                  .help = "options for sbatch, as \"--partition=short --time=10\"; repeatable",
                  .value = Repeated{&c.slurm}},
                 {.flags = "--dry-run",
                  .help = "write the folder with the scripts, but submit nothing",
                  .value = &c.dry_run},
                 {.flags = "--native",
                  .help = "draw without --portable: faster, but the bytes depend on the processor",
                  .value = &c.native},
                 set_option(c.given),
                 sweep_option(c.sweeps)},
                options_of(Verb::submit, c.given),
                {quiet_option(c.quiet), allow_outside_option(c.given.allow_outside)}}),
        [choices] { return run(*choices); }};
}

}  // namespace

extern const Command submit_command{
    "submit",
    "SCENE",
    1,
    any_number,
    "draw films in parts on a Slurm cluster, then join them",
    submit_line,
    {{{"poinsot submit generic -o film.mp4 --parts 8",
       "submits an array of eight parts, then the join"},
      {"poinsot submit generic -o film.mp4 --parts 8 --dry-run",
       "writes the scripts and prints the commands that submit them"}}}};

}  // namespace poinsot
