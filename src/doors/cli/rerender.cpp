// poinsot rerender FILE -o OUT: renders a picture or film again from a file's record.
#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "error/error.h"
#include "production/films/redraw.h"

namespace poinsot {

namespace {

struct RerenderChoices {
    std::vector<std::string> files;
    std::string output;
    GivenOptions given;
    bool quiet = false;
};

int run(const RerenderChoices& choices) {
    if (choices.output.empty())
        throw InputError("poinsot rerender: no output; name the new file with -o FILE");
    ProgressBar bar(choices.quiet);
    redraw({.file = choices.files.at(0),
            .output = choices.output,
            .backend = context_choice_of(choices.given).backend,
            .outside = outside_files(choices.given.allow_outside)},
           bar.task());
    return 0;
}

CommandLine rerender_line() {
    const auto choices = std::make_shared<RerenderChoices>();
    RerenderChoices& c = *choices;
    return {&c.files,
            joined({{output_option(c.output)},
                    options_of(Verb::rerender, c.given),
                    {quiet_option(c.quiet), allow_outside_option(c.given.allow_outside)}}),
            [choices] { return run(*choices); }};
}

}  // namespace

extern const Command rerender_command{
    "rerender",
    "FILE",
    1,
    1,
    "draw a picture or film again from its own record",
    rerender_line,
    {{{"poinsot rerender generic.png -o again.png", "draws the same picture from its record"},
      {"poinsot rerender generic.mp4 -o again.mp4 --quiet", "draws the same film"}}}};

}  // namespace poinsot
