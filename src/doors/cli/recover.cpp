// poinsot recover FILM: builds a film from the finished frames of an interrupted run.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "production/films/recovery.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct RecoverChoices {
    std::vector<std::string> films;
    bool quiet = false;
};

int run(const RecoverChoices& choices) {
    const std::string& film = choices.films.at(0);
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    const std::int64_t n_frames = recover(film, task);
    task.say(fmt::format("{}: the first {} frames", printable(film), n_frames));
    return 0;
}

CommandLine recover_line() {
    const auto choices = std::make_shared<RecoverChoices>();
    RecoverChoices& c = *choices;
    return {&c.films, {quiet_option(c.quiet)}, [choices] { return run(*choices); }};
}

}  // namespace

extern const Command recover_command{
    "recover",
    "FILM",
    1,
    1,
    "build a film from the finished frames of an interrupted run; to draw the other frames, run "
    "render again instead",
    recover_line,
    {{{"poinsot recover generic.mp4", "a film of the finished frames"},
      {"poinsot recover output/generic.mp4 --quiet", "the same without notes"}}}};

}  // namespace poinsot
