// poinsot compare REF NEW: compares two pictures, or two folders of pictures.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/command.h"
#include "cli/options.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "production/provenance/record.h"
#include "report/compared_picture.h"
#include "report/html_report.h"
#include "report/json_report.h"
#include "report/junit.h"
#include "report/rendered_page.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "text/printable.h"
#include "text/rational.h"
#include "text/say.h"

namespace poinsot {

namespace {

// The allowed differences, and the files to write.
struct CompareChoices {
    std::vector<std::string> pictures;         // two
    std::string profile;                       // empty: depends on what rendered the baselines
    std::optional<std::string> max_differing;  // a share of the pixels
    std::optional<std::string> max_over;
    std::optional<int> over_levels;
    std::string report, junit, diff;  // files to write, empty for none
    bool measures = false, json = false, quiet = false;
};

namespace fs = std::filesystem;

// A share of the pixels: "0.001" or "0.1%".
double parse_share(std::string_view option, std::string_view text) {
    const bool percent = text.ends_with('%');
    const std::string_view digits = text.substr(0, text.size() - (percent ? 1 : 0));
    const auto value = rational_of(digits);
    const double share = value ? nearest_double(*value / (percent ? 100 : 1)) : -1.0;
    if (!(share >= 0 && share <= 1))
        throw InputError(fmt::format(
            "{} {}: not a share of the pixels; give a share from 0 to 1, or from 0% to 100%",
            option, printable(text)));
    return share;
}

// Within a portable profile no pixel may differ; otherwise the default limits separate a
// processor's rounding from a defect, unless the command line sets others. None if no limit was
// given.
std::optional<CompareLimits> limits_of(const CompareChoices& choices) {
    if (!choices.profile.empty() && choices.profile != "portable" && choices.profile != "native")
        throw InputError(fmt::format("--profile {}: unknown; choose portable or native",
                                     printable(choices.profile)));
    const bool own = choices.max_differing || choices.max_over || choices.over_levels;
    if (choices.profile.empty() && !own) return std::nullopt;
    if (choices.profile == "portable" && !own) return CompareLimits::exact();
    CompareLimits limits;
    if (choices.max_differing)
        limits.differing_share = parse_share("--max-differing", *choices.max_differing);
    if (choices.max_over) limits.over_level_share = parse_share("--max-over", *choices.max_over);
    if (choices.over_levels) {
        limits.level = *choices.over_levels;
        if (limits.level < 0 || limits.level > 255)
            throw InputError(fmt::format(
                "--over-levels {}: not a level; give a level from 0 to 255", *choices.over_levels));
    }
    return limits;
}

// Whether both are folders. Throws for a file and a folder.
bool are_folders(const fs::path& expected, const fs::path& actual) {
    const FileKind kind = kind_of_file(expected), actual_kind = kind_of_file(actual);
    if (kind == FileKind::missing)
        throw InputError(fmt::format(
            "{}: no such file or folder; give the reference first, then the new picture or folder",
            printable(expected.string())));
    const bool folder = kind == FileKind::folder;
    if (actual_kind != FileKind::missing && (actual_kind == FileKind::folder) != folder)
        throw InputError(
            fmt::format("{} and {}: one is a folder, the other is not; give two "
                        "pictures or two folders",
                        printable(expected.string()), printable(actual.string())));
    if (folder && actual_kind == FileKind::missing)
        throw InputError(fmt::format("{}: no such folder", printable(actual.string())));
    return folder;
}

// A line for each picture that is not the same, worst first, and the count.
void print_lines(const std::vector<ComparedPicture>& pictures) {
    std::size_t n_same = 0, n_failed = 0;
    for (const ComparedPicture& p : pictures) {
        n_same += p.outcome == Outcome::same;
        n_failed += !p.passes();
        if (p.outcome == Outcome::same) continue;
        const auto& likeness = p.measured.likeness;
        fmt::print("{}: {}: {}{}\n", name_of(p.outcome), printable(p.name),
                   printable(p.reason, most_of_a_message),
                   likeness
                       ? fmt::format("; FLIP {:.3g}, SSIM {:.5f}", likeness->flip, likeness->ssim)
                       : "");
    }
    fmt::print("{} compared, {} failed, {} the same\n", pictures.size(), n_failed, n_same);
}

std::optional<Record> record_of(const fs::path& picture) {
    try {
        return read_record(picture);
    } catch (const InputError&) {
        return std::nullopt;  // drawn by another program
    }
}

// Whether another processor's rounding may be all that there is between two pictures: one scene at
// one instant, drawn natively by one of them at least, and no more different than rounding makes
// them.
bool may_be_rounding(const ComparedPicture& picture) {
    const Comparison& m = picture.measured;
    const CompareLimits native;
    const double most = native.differing_share * static_cast<double>(m.n_pixels);
    if (picture.outcome != Outcome::pixels || m.largest_difference > native.level ||
        static_cast<double>(m.n_differing) > most)
        return false;
    const std::optional<Record> expected = record_of(picture.expected);
    const std::optional<Record> actual = record_of(picture.actual);
    return expected && actual && !(expected->portable && actual->portable) &&
           expected->scene_hash == actual->scene_hash && expected->time_s == actual->time_s &&
           expected->frames == actual->frames;
}

// Where that may be all, nothing is wrong with the pictures.
void note_native(const std::vector<ComparedPicture>& pictures) {
    const auto n_native = std::count_if(pictures.begin(), pictures.end(), may_be_rounding);
    if (n_native > 0)
        say(fmt::format(
            "note: {} by no more than the rounding of two processors; draw both pictures with "
            "--portable, or compare with --profile native",
            n_native == 1 ? "1 pair differs" : fmt::format("{} pairs differ", n_native)));
}

// An output must not replace a compared picture or another output.
void refuse_overwriting(const CompareChoices& choices, const fs::path& expected,
                        const fs::path& actual, const std::vector<ComparedPicture>& pictures) {
    const std::array<std::pair<std::string_view, fs::path>, 3> outputs{
        {{"--diff", choices.diff}, {"--report", choices.report}, {"--junit", choices.junit}}};
    const auto same = [](const fs::path& a, const fs::path& b) {
        std::error_code not_there;
        return !a.empty() && !b.empty() &&
               (a.lexically_normal() == b.lexically_normal() || fs::equivalent(a, b, not_there));
    };
    const auto refuse = [](std::string_view option, const fs::path& path, std::string_view is) {
        throw InputError(
            fmt::format("{} {}: {}; choose another name", option, printable(path.string()), is));
    };
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [option, path] = outputs[i];
        for (std::size_t k = 0; k < i; ++k)
            if (same(path, outputs[k].second))
                refuse(option, path, fmt::format("is also the output of {}", outputs[k].first));
        if (same(path, expected) || same(path, actual))
            refuse(option, path, "is one of the files compared");
        for (const ComparedPicture& picture : pictures)
            if (same(path, picture.expected) || same(path, picture.actual))
                refuse(option, path, "is one of the pictures compared");
    }
}

int run(const CompareChoices& choices) {
    const fs::path expected = choices.pictures.at(0), actual = choices.pictures.at(1);
    CompareRequest request{.limits = limits_of(choices)};
    if (choices.measures) request.likeness = likeness_of;
    const bool folders = are_folders(expected, actual);
    if (folders && !choices.diff.empty())
        throw InputError("--diff shows one pair of pictures; for folders use --report FILE.html");
    if (!choices.diff.empty() && suffix_of(choices.diff) != ".png")
        throw InputError(fmt::format("--diff {}: the picture is a PNG; end its name in .png",
                                     printable(choices.diff)));

    std::vector<ComparedPicture> pictures;
    std::optional<RenderedPages> pages;
    if (is_page_name(expected) && is_page_name(actual)) {
        pages.emplace();
        const fs::path first = pages->picture_of(expected), second = pages->picture_of(actual);
        pictures = {compare_files(actual.filename().string(), first, second, request)};
        if (pictures[0].outcome == Outcome::unreadable) throw InputError(pictures[0].reason);
    } else if (folders) {
        pictures = compare_folders(expected, actual, request);
        sort_by_severity(pictures);
    } else {
        const Baselines baselines(expected.parent_path());
        pictures = {compare_files(actual.filename().replace_extension().string(), expected, actual,
                                  request, &baselines, expected.stem().string())};
        if (pictures[0].outcome == Outcome::unreadable) throw InputError(pictures[0].reason);
    }

    refuse_overwriting(choices, expected, actual, pictures);
    const std::string title = fmt::format("{} compared with {}", printable(actual.string()),
                                          printable(expected.string()));
    if (!choices.diff.empty() && !pictures[0].actual.empty())
        write_png(choices.diff, difference_picture(read_stored_png(pictures[0].expected),
                                                   read_stored_png(pictures[0].actual)));
    if (!choices.report.empty()) write_whole(choices.report, html_report(title, pictures));
    if (!choices.junit.empty()) write_whole(choices.junit, junit_xml(title, pictures));
    if (choices.json) {
        fmt::print("{}", json_report(pictures, request.limits, choices.measures));
    } else {
        print_lines(pictures);
    }
    if (choices.profile != "native" && !choices.quiet) note_native(pictures);
    return all_pass(pictures) ? 0 : 1;
}

CommandLine compare_line(std::any& storage) {
    auto& c = storage.emplace<CompareChoices>();
    return {
        &c.pictures,
        {{"--profile",
          "portable: no pixel may differ; native: pixels may differ by rounding; default: chosen "
          "by the renderer that the baselines' manifest names, portable without a manifest",
          &c.profile, "", "NAME", false, "portable|native"},
         {"--max-differing", "share of the pixels that may differ, as 0.001 or 0.1%",
          &c.max_differing, "", "SHARE"},
         {"--max-over", "share of the pixels that may differ by more than --over-levels",
          &c.max_over, "", "SHARE"},
         {"--over-levels", "threshold of --max-over in levels of 255; default 2", &c.over_levels,
          "a level of 0 to 255"},
         {"--measures",
          "also measure SSIM and FLIP of pictures that differ, for --json, --report and the order "
          "of the results; takes seconds per pair",
          &c.measures},
         json_option(c.json),
         {"--report",
          "FILE.html: write a report that shows the pictures",
          &c.report,
          "",
          {},
          false,
          "file"},
         {"--junit", "FILE.xml: write test results (JUnit)", &c.junit, "", {}, false, "file"},
         {"--diff",
          "FILE.png: write expected | difference × 16 | actual",
          &c.diff,
          "",
          {},
          false,
          "file"},
         quiet_option(c.quiet)},
        [&c] { return run(c); }};
}

}  // namespace

extern const Command compare_command{
    "compare",
    "REF NEW",
    2,
    2,
    "compare two pictures, vector figures or folders exactly, or within limits that you set",
    compare_line,
    {{{"poinsot compare expected.png new.png", "exit code 0: no pixel differs; 1: some do"},
      {"poinsot compare baselines/ results/ --report report.html",
       "compares two folders and writes a report that shows the pictures"}}},
    "two pictures or two folders"};

}  // namespace poinsot
