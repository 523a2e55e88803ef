// poinsot approve NAME…: takes pictures as the new baselines, with what they were made of and why.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "cli/command.h"
#include "error/error.h"
#include "image/pixel_hash.h"
#include "image/png.h"
#include "production/record.h"
#include "report/baselines.h"
#include "report/compared_picture.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// A picture that is to become a baseline.
struct Candidate {
    std::string name;
    fs::path file;
    Baseline baseline;
};

// "turn", from "turn" or "turn.png". It stays within its folder.
std::string picture_name(const std::string& argument) {
    fs::path path = fs::path(argument).lexically_normal();
    if (path.extension() == ".png") path.replace_extension();
    const bool leaves = path.empty() || path.is_absolute() || *path.begin() == "..";
    if (leaves)
        throw InputError(fmt::format("{}: not the name of a picture within the folder of results",
                                     printable(argument)));
    return path.generic_string();
}

// The names given, or all that are not as the baselines are.
std::vector<std::string> names_wanted(const Options& options) {
    std::vector<std::string> names;
    if (options.approve.all) {
        if (!options.arguments.empty())
            throw InputError("poinsot approve: give names or --all, not both");
        for (const ComparedPicture& picture :
             compare_folders(options.approve.baselines, options.approve.results,
                             {.differing_share = 0,
                             .level = 0,
                             .over_level_share = 0,
                             .measures_likeness = false}))
            if (!picture.actual.empty() && picture.outcome != Outcome::same)
                names.push_back(picture.name);
        return names;
    }
    if (options.arguments.empty())
        throw InputError("poinsot approve: name the pictures to take, or say --all");
    for (const std::string& argument : options.arguments) names.push_back(picture_name(argument));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Candidate candidate_for(const std::string& name, const ApproveChoices& choices, bool quiet) {
    Candidate candidate{name, fs::path(choices.results) / (name + ".png"), {}};
    const Record record = read_record(candidate.file);
    if (!record.portable && !choices.any_renderer)
        throw InputError(fmt::format(
            "{}: drawn for this processor alone; draw it with --portable, or say --any-renderer",
            printable(candidate.file.string())));
    const Verification verification = verify(candidate.file, record);
    if (verification.verified == Verified::no)
        throw InputError(fmt::format("{}: {}; draw it again", printable(candidate.file.string()),
                                     verification.sentence));
    if (verification.verified == Verified::cannot_be && !quiet)
        say(fmt::format("note: {}: {}", printable(candidate.file.string()), verification.sentence));
    candidate.baseline = {pixel_hash(read_stored_png(candidate.file)),
                          record.scene_hash,
                          record.renderer,
                          record.mesa,
                          record.version,
                          choices.why};
    return candidate;
}

// All baselines of a folder come from one renderer, or comparing with them would tell renderers
// apart instead of pictures.
void check_renderer(const Candidate& candidate, const BaselineManifest& manifest,
                    const ApproveChoices& choices) {
    if (choices.any_renderer) return;
    for (const auto& [name, baseline] : manifest) {
        const Baseline& now = candidate.baseline;
        if (baseline.renderer == now.renderer && baseline.mesa == now.mesa) continue;
        throw InputError(fmt::format(
            "{}: drawn by {}, Mesa {}, but the baseline {} by {}, Mesa {}; approve all of them "
            "with --any-renderer if the renderer is to change",
            printable(candidate.file.string()), printable(now.renderer), printable(now.mesa),
            printable(name), printable(baseline.renderer), printable(baseline.mesa)));
    }
}

void check_reason(const Candidate& candidate, const BaselineManifest& manifest) {
    if (!manifest.contains(candidate.name) || !candidate.baseline.why.empty()) return;
    throw InputError(fmt::format(
        "{}: another picture than the baseline; say with --why \"…\" why it is the right one now",
        printable(candidate.name)));
}

int run(const Options& options) {
    const ApproveChoices& choices = options.approve;
    if (choices.results.empty() || choices.baselines.empty())
        throw InputError(
            "poinsot approve: say with --results and --baselines from which folder to which");
    const auto say = [&options](const std::string& name, std::string_view what) {
        if (!options.quiet) fmt::print("{}: {}\n", printable(name), what);
    };
    BaselineWriter baselines(choices.baselines, [&options, &choices] {
        if (!options.quiet)
            poinsot::say(fmt::format("note: another approval is at work in {}; waiting for it",
                                     printable(choices.baselines)));
    });
    for (const std::string& name : baselines.finished())
        say(name, "taken by an approval that was interrupted; its line is written now");

    // Everything is checked before anything is changed.
    const BaselineManifest& manifest = baselines.manifest();
    std::vector<BaselineWriter::Change> changes;
    std::vector<std::string_view> outcomes;
    for (const std::string& name : names_wanted(options)) {
        Candidate candidate = candidate_for(name, choices, options.quiet);
        const auto before = manifest.find(name);
        if (before != manifest.end() && before->second.pixels == candidate.baseline.pixels) {
            if (baselines.pixels_of(name) == candidate.baseline.pixels) {
                say(name, "as it was");
                continue;
            }
            // The picture was lost or changed; its line stays.
            candidate.baseline = before->second;
            outcomes.emplace_back("put back; what was there was not what had been approved");
        } else {
            check_renderer(candidate, manifest, choices);
            check_reason(candidate, manifest);
            if (candidate.baseline.why.empty()) candidate.baseline.why = "first picture";
            outcomes.emplace_back(before == manifest.end() ? "new" : "changed");
        }
        changes.push_back({name, candidate.file, candidate.baseline});
    }
    baselines.take(changes);
    for (std::size_t i = 0; i < changes.size(); ++i) say(changes[i].name, outcomes[i]);
    return 0;
}

constexpr std::array<std::string_view, 6> options_taken{"results",      "baselines", "why",
                                                        "any-renderer", "all",       "quiet"};

}  // namespace

const Command approve_command{
    "approve",     "NAME", 0, 1000000, "take pictures as the new baselines, and record why",
    options_taken, run};

}  // namespace poinsot
