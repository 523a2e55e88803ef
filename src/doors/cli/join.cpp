// poinsot join PART… -o OUT: joins the parts of a film.
#include "production/films/join.h"

#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "error/error.h"

namespace poinsot {

namespace {

struct JoinChoices {
    std::vector<std::string> parts;
    std::string output;
    bool quiet = false;
};

int run(const JoinChoices& choices) {
    if (choices.output.empty())
        throw InputError("poinsot join: no output; name the film with -o FILE");
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    task.say(join(choices.parts, choices.output, task));
    return 0;
}

CommandLine join_line() {
    const auto choices = std::make_shared<JoinChoices>();
    JoinChoices& c = *choices;
    return {&c.parts, {output_option(c.output), quiet_option(c.quiet)}, [choices] {
                return run(*choices);
            }};
}

}  // namespace

extern const Command join_command{
    "join",
    "PART",
    1,
    any_number,
    "join the parts of a film; the result is byte-identical to a single run",
    join_line,
    {{{"poinsot join part1.mp4 part2.mp4 -o film.mp4", "joins the parts, given in any order"},
      {"poinsot join 'f_####.png' -o 'f_####.png'",
       "checks that no frame of a sequence is missing"}}}};

}  // namespace poinsot
