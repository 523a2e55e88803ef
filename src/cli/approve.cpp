// poinsot approve NAME…: approves pictures as new baselines, and records their origin and the
// reason; removes baselines.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/options.h"
#include "error/error.h"
#include "report/approval.h"
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

CommandLine approve_line(std::any& storage) {
    auto& c = storage.emplace<ApproveChoices>();
    return {
        &c.names,
        {{"--results", "folder of the new pictures", &c.results, "", "FOLDER", false, "folder"},
         {"--baselines", "folder of the baselines and their manifest", &c.baselines, "", "FOLDER",
          false, "folder"},
         {"--why", "the reason for the change, kept in the manifest", &c.why, "", "REASON"},
         {"--any-renderer", "also accept pictures of another renderer or profile", &c.any_renderer},
         {"--foreign", "also accept files of other programs; the manifest says so", &c.foreign},
         {"--all", "approve everything that is new or has changed", &c.all},
         {"--remove",
          "instead remove these baselines, and their lines in the manifest; --results is not "
          "needed",
          &c.remove},
         quiet_option(c.quiet)},
        [&c] { return run(c); }};
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
