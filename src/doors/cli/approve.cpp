// poinsot approve NAME…: approves pictures as new baselines, and records their origin and the
// reason; removes baselines.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/options.h"
#include "compare/approval.h"
#include "error/error.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

struct ApproveChoices {
    std::vector<std::string> names;
    std::string results, baselines;
    std::string why;
    bool any_renderer = false;
    bool foreign = false;
    bool all = false;
    bool remove = false;
    bool quiet = false;
};

int run(const ApproveChoices& choices) {
    const ApprovalTelling progress{
        .settled =
            [&choices](const std::string& name, std::string_view outcome) {
                if (!choices.quiet) fmt::print("{}: {}\n", printable(name), outcome);
            },
        .note =
            [&choices](const std::string& note) {
                if (!choices.quiet) say("note: " + note);
            }};
    if (choices.remove) {
        if (choices.baselines.empty())
            throw InputError("poinsot approve --remove: give the folder with --baselines");
        if (choices.all)
            throw InputError("poinsot approve --remove: name the baselines, not --all");
        remove_baselines(choices.baselines, choices.names, choices.why, progress);
        return 0;
    }
    if (choices.results.empty() || choices.baselines.empty())
        throw InputError(
            "poinsot approve: give both folders, the new pictures with --results and the baselines "
            "with --baselines");
    approve({.results = choices.results,
             .baselines = choices.baselines,
             .names = choices.names,
             .all = choices.all,
             .why = choices.why,
             .any_renderer = choices.any_renderer,
             .foreign = choices.foreign},
            progress);
    return 0;
}

CommandLine approve_line() {
    const auto choices = std::make_shared<ApproveChoices>();
    ApproveChoices& c = *choices;
    return {&c.names,
            {{.flags = "--results",
              .takes = "FOLDER",
              .help = "folder of the new pictures",
              .value = &c.results,
              .completes = "folder"},
             {.flags = "--baselines",
              .takes = "FOLDER",
              .help = "folder of the baselines and their manifest",
              .value = &c.baselines,
              .completes = "folder"},
             {.flags = "--why",
              .takes = "REASON",
              .help = "the reason for the change, kept in the manifest",
              .value = &c.why},
             {.flags = "--any-renderer",
              .help = "also accept pictures of another renderer or profile",
              .value = &c.any_renderer},
             {.flags = "--foreign",
              .help = "also accept files of other programs; the manifest says so",
              .value = &c.foreign},
             {.flags = "--all",
              .help = "approve everything that is new or has changed",
              .value = &c.all},
             {.flags = "--remove",
              .help = "instead remove these baselines, and their lines in the manifest; --results "
                      "is not needed",
              .value = &c.remove},
             quiet_option(c.quiet)},
            [choices] { return run(*choices); }};
}

}  // namespace

extern const Command approve_command{
    "approve",
    "NAME",
    0,
    1000000,
    "make new pictures the baselines of later comparisons",
    approve_line,
    {{{"poinsot approve generic --results results --baselines baselines --why \"thicker axes\"",
       "makes one picture a baseline"},
      {"poinsot approve --all --results results --baselines baselines --why \"new theme\"",
       "approves every new or changed picture"}}}};

}  // namespace poinsot
