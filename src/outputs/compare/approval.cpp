#include "compare/approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "compare/baselines.h"
#include "compare/compared_picture.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "production/records/record.h"
#include "production/records/verify.h"
#include "system/files/file_kind.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// A picture that may become a baseline.
struct Candidate {
    std::string name;
    fs::path file;
    Baseline baseline;
};

// Returns the name "turn" for "turn", "turn.png" or "turn.PNG", within its folder. If turn.png and
// turn.PNG are in one folder, the second has its full name, as in compare_folders.
std::string picture_name(const std::string& argument, const fs::path& results) {
    fs::path path = fs::path(argument).lexically_normal();
    const bool leaves = path.empty() || path.is_absolute() || *path.begin() == "..";
    if (leaves)
        throw InputError(fmt::format("{}: not the name of a picture in the folder of results",
                                     printable(argument)));
    if (suffix_of(path) != ".png") return path.generic_string();
    const fs::path usual = fs::path(path).replace_extension(".png");
    if (path == usual || kind_of_file(results / usual) == FileKind::missing)
        path.replace_extension();
    return path.generic_string();
}

// The file of a picture with this name: turn.png, or turn.PNG if only that exists; of a film or a
// vector figure, the name itself.
fs::path file_of_picture(const fs::path& results, const std::string& name) {
    fs::path usual = results / (name + ".png");
    if (kind_of_file(usual) != FileKind::missing) return usual;
    fs::path whole = results / name;
    if (has_suffix_in_name(name)) return whole;
    if (suffix_of(whole) == ".png" && kind_of_file(whole) != FileKind::missing) return whole;
    std::error_code error;
    fs::directory_iterator at(usual.parent_path(), error);
    for (; !error && at != fs::directory_iterator(); at.increment(error))
        if (suffix_of(at->path()) == ".png" && at->path().stem() == whole.filename())
            return at->path();
    return usual;
}

// The given names, or all pictures that differ from the baselines.
std::vector<std::string> names_wanted(const ApprovalRequest& request) {
    std::vector<std::string> names;
    if (request.all) {
        if (!request.names.empty())
            throw InputError("poinsot approve: give names or --all, not both");
        const CompareRequest exactly{.limits = CompareLimits::exact()};
        for (const ComparedPicture& picture :
             compare_folders(request.baselines, request.results, exactly))
            if (!picture.actual.empty() && picture.outcome != Outcome::same)
                names.push_back(picture.name);
        return names;
    }
    if (request.names.empty())
        throw InputError("poinsot approve: no pictures; name them, or give --all");
    for (const std::string& argument : request.names)
        names.push_back(picture_name(argument, request.results));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Candidate candidate_for(const std::string& name, const ApprovalRequest& request,
                        const ApprovalTelling& progress) {
    Candidate candidate{name, file_of_picture(request.results, name), {}};
    if (kind_of_file(candidate.file) == FileKind::missing)
        throw InputError(fmt::format("{} does not exist", printable(candidate.file.string())));
    const bool is_picture = suffix_of(candidate.file) == ".png";
    const std::string pixels = is_picture ? pixels_sha256(read_stored_png(candidate.file))
                                          : pixel_hash_of_file(candidate.file);
    if (record_text(candidate.file).empty()) {
        if (!request.foreign)
            throw InputError(fmt::format(
                "{}: has no record of how it was made: another program drew it or removed the "
                "record; draw it with poinsot, or give --foreign to approve pictures of other "
                "programs",
                printable(candidate.file.string())));
        candidate.baseline = {.pixels = pixels,
                              .scene = "",
                              .renderer = std::string(foreign_renderer),
                              .mesa = "",
                              .version = "",
                              .why = request.why};
        return candidate;
    }
    const Record record = read_record(candidate.file);
    if (!record.portable && !request.any_renderer)
        throw InputError(
            fmt::format("{}: drawn without --portable, so it depends on the processor; draw it "
                        "with --portable, or give --any-renderer",
                        printable(candidate.file.string())));
    if (const std::string fault = fault_of_scene(record); !fault.empty())
        throw InputError(
            fmt::format("{}: {}; draw it again", printable(candidate.file.string()), fault));
    const Verification verification = verify(candidate.file, record);
    if (verification.verified == Verified::no)
        throw InputError(fmt::format("{}: {}; draw it again", printable(candidate.file.string()),
                                     verification.sentence));
    if (verification.verified == Verified::cannot_be)
        progress.note(
            fmt::format("{}: {}", printable(candidate.file.string()), verification.sentence));
    candidate.baseline = {pixels,      record.scene_hash, record.renderer,
                          record.mesa, record.version,    request.why};
    return candidate;
}

// Whether a renderer of ours drew it: neither another program's, nor vectors without pixels.
bool is_drawn(const Baseline& baseline) {
    return !is_foreign(baseline) && baseline.renderer != vectors_renderer;
}

// All baselines of a folder come from one renderer; otherwise comparisons would show differences
// between renderers instead of pictures.
void check_renderer(const Candidate& candidate, const BaselineManifest& manifest,
                    const ApprovalRequest& request) {
    if (request.any_renderer || !is_drawn(candidate.baseline)) return;
    for (const auto& [name, baseline] : manifest) {
        const Baseline& now = candidate.baseline;
        if (!is_drawn(baseline)) continue;
        if (baseline.renderer == now.renderer && baseline.mesa == now.mesa) continue;
        throw InputError(fmt::format(
            "{}: drawn by {}, Mesa {}, but the baseline {} by {}, Mesa {}; to change the renderer, "
            "approve all pictures with --any-renderer",
            printable(candidate.file.string()), printable(now.renderer), printable(now.mesa),
            printable(name), printable(baseline.renderer), printable(baseline.mesa)));
    }
}

// An existing picture is not replaced by another one without a reason, whether the manifest has a
// line for it or not.
void check_reason(const Candidate& candidate, const BaselineWriter& baselines) {
    if (!candidate.baseline.why.empty()) return;
    const std::string there = baselines.pixels_of(candidate.name);
    const bool replaces = !there.empty() && there != candidate.baseline.pixels;
    if (!replaces && !baselines.manifest().contains(candidate.name)) return;
    throw InputError(fmt::format(
        "{}: differs from the baseline; give the reason for the change with --why \"…\"",
        printable(candidate.name)));
}

}  // namespace

void approve(const ApprovalRequest& request, const ApprovalTelling& progress) {
    BaselineWriter baselines(request.baselines, [&] {
        progress.note(fmt::format("waiting for another approval that is writing to {}",
                                  printable(request.baselines.string())));
    });
    for (const std::string& name : baselines.finished())
        progress.settled(name,
                         "finished for an interrupted approval: its line is now in the manifest");

    // All checks come before any change.
    const BaselineManifest& manifest = baselines.manifest();
    std::vector<BaselineWriter::Change> changes;
    std::vector<std::string_view> outcomes;
    for (const std::string& name : names_wanted(request)) {
        Candidate candidate = candidate_for(name, request, progress);
        const auto before = manifest.find(name);
        if (before != manifest.end() && before->second.pixels == candidate.baseline.pixels) {
            if (baselines.pixels_of(name) == candidate.baseline.pixels) {
                progress.settled(name, "unchanged");
                continue;
            }
            // The picture was lost or changed; its line is kept.
            candidate.baseline = before->second;
            outcomes.emplace_back("restored; the baseline did not match the manifest");
        } else {
            check_renderer(candidate, manifest, request);
            check_reason(candidate, baselines);
            if (candidate.baseline.why.empty()) candidate.baseline.why = "first picture";
            outcomes.emplace_back(before == manifest.end() ? "new" : "changed");
        }
        changes.push_back({name, candidate.file, candidate.baseline});
    }
    baselines.take(changes);
    for (std::size_t i = 0; i < changes.size(); ++i) progress.settled(changes[i].name, outcomes[i]);
}

void remove_baselines(const fs::path& baselines, const std::vector<std::string>& names,
                      const std::string& why, const ApprovalTelling& progress) {
    if (names.empty()) throw InputError("poinsot approve --remove: name the baselines");
    if (kind_of_file(baselines) != FileKind::folder)
        throw InputError(fmt::format("{}: no such folder", printable(baselines.string())));
    BaselineWriter writer(baselines, [&] {
        progress.note(fmt::format("waiting for another approval that is writing to {}",
                                  printable(baselines.string())));
    });
    std::vector<std::string> removed;
    for (const std::string& argument : names) {
        std::string name = picture_name(argument, baselines);
        if (!writer.manifest().contains(name) &&
            kind_of_file(writer.picture(name)) == FileKind::missing) {
            std::vector<std::string_view> known;
            for (const auto& [there, line] : writer.manifest()) known.emplace_back(there);
            throw InputError(fmt::format("{}: no baseline of that name in {}{}",
                                         printable(argument), printable(baselines.string()),
                                         did_you_mean(name, known)));
        }
        removed.push_back(std::move(name));
    }
    writer.take({}, removed);
    const std::string outcome = why.empty() ? "removed" : "removed: " + why;
    for (const std::string& name : removed) progress.settled(name, outcome);
}

}  // namespace poinsot
