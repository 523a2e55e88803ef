// poinsot compare REF NEW: compares two pictures, films or vector figures, or two folders of them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "output/frame_name.h"
#include "production/records/record.h"
#include "report/compare_file.h"
#include "report/compared_picture.h"
#include "report/github_report.h"
#include "report/html_report.h"
#include "report/json_report.h"
#include "report/junit.h"
#include "report/report_pictures.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

// The allowed differences, and the files to write.
struct CompareChoices {
    std::vector<std::string> pictures;  // two
    std::string profile;                // empty: depends on what rendered the baselines
    GivenLimits given;
    std::vector<std::string> ignore;
    bool antialiasing = false;        // of `given`, once the line is read
    std::string report, junit, diff;  // files to write, empty for none
    bool single_file = false, github = false;
    bool measures = false, json = false, quiet = false;
};

namespace fs = std::filesystem;

// Of the strip of --diff: frames keep their size up to this width.
constexpr int any_strip_width = 16384;

// The value of an option that is read by one of the functions of report/given_limits.h.
template <typename Read>
auto value_of(std::string_view option, Read read) {
    try {
        return read();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} {}", option, error.what()));
    }
}

std::optional<CompareLimits> profile_limits(const CompareChoices& choices) {
    return value_of("--profile", [&] { return limits_of_profile(choices.profile); });
}

// The limits of the command line; none if it sets none.
std::optional<CompareLimits> limits_of_line(const CompareChoices& choices) {
    const GivenLimits& given = choices.given;
    const bool own = given.decides() || given.antialiasing;
    const std::optional<CompareLimits> profile = profile_limits(choices);
    if (!own && !profile) return std::nullopt;
    return limits_of(given, profile, CompareLimits::exact());
}

// Whether both are folders. Throws for a file and a folder.
bool are_folders(const fs::path& expected, const fs::path& actual) {
    if (is_sequence_name(expected)) {
        [[maybe_unused]] const FrameStream readable{expected};  // throws if there is none
        return false;
    }
    const FileKind kind = kind_of_file(expected);
    const FileKind actual_kind =
        is_sequence_name(actual) ? FileKind::regular : kind_of_file(actual);
    if (kind == FileKind::missing)
        throw InputError(fmt::format(
            "{}: no such file or folder; give the reference first, then the new picture or folder",
            printable(expected.string())));
    const bool folder = kind == FileKind::folder;
    if (actual_kind != FileKind::missing && (actual_kind == FileKind::folder) != folder)
        throw InputError(
            fmt::format("{} and {}: one is a folder, the other is not; give two files or two "
                        "folders",
                        printable(expected.string()), printable(actual.string())));
    if (folder && actual_kind == FileKind::missing)
        throw InputError(fmt::format("{}: no such folder", printable(actual.string())));
    // A picture that a test should have made and did not is an outcome of the comparison.
    if (actual_kind == FileKind::missing && suffix_of(actual) != ".png")
        throw InputError(fmt::format("{}: no such file", printable(actual.string())));
    return folder;
}

bool is_png(const fs::path& file) { return suffix_of(file) == ".png" && !is_sequence_name(file); }

// As in folders: pictures without their suffix.
std::string name_of_file(const fs::path& file) {
    return (is_png(file) ? file.stem() : file.filename()).string();
}

// A line for each picture that is not the same, worst first, and the count.
void print_lines(const std::vector<ComparedPicture>& pictures) {
    std::size_t n_same = 0, n_failed = 0;
    for (const ComparedPicture& p : pictures) {
        n_same += p.outcome == Outcome::same;
        n_failed += !p.passes();
        if (p.outcome == Outcome::same) continue;
        fmt::print("{}: {}: {}\n", name_of(p.outcome), printable(p.name),
                   printable(p.line(), most_of_a_message));
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

// A name that is ignored and that no picture shows may be a mistake.
void note_unused_regions(const std::vector<ComparedPicture>& pictures) {
    std::set<std::string> asked, found;
    for (const ComparedPicture& picture : pictures) {
        if (picture.outcome == Outcome::same || picture.outcome == Outcome::region ||
            picture.measured.n_pixels == 0)
            continue;
        asked.insert(picture.ignored.begin(), picture.ignored.end());
        found.insert(picture.found_regions.begin(), picture.found_regions.end());
    }
    for (const std::string& name : asked)
        if (name.find(',') == std::string::npos && !found.contains(name))
            say(fmt::format(
                "note: \"{}\" is ignored, but none of the pictures that differ shows it",
                printable(name)));
}

// JPEGs beside PNGs are easily taken for compared.
void note_other_pictures(const fs::path& expected, const fs::path& actual) {
    for (const fs::path& folder : {expected, actual}) {
        const std::vector<fs::path> others = other_pictures_in(folder);
        if (others.empty()) continue;
        constexpr std::size_t most_names = 3;
        std::string names;
        for (std::size_t i = 0; i < std::min(others.size(), most_names); ++i)
            names += (i == 0 ? "" : ", ") + printable(others[i].string());
        if (others.size() > most_names)
            names += fmt::format(" and {} more", others.size() - most_names);
        say(fmt::format("note: {}: not compared, because these pictures are not PNGs: {}",
                        printable(folder.string()), names));
    }
}

// Whether a path is a folder or lies inside of it.
bool is_within(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    const fs::path inner = fs::weakly_canonical(path, error),
                   outer = fs::weakly_canonical(folder, error);
    const auto [end, ignored] =
        std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
    return end == outer.end() || (std::next(end) == outer.end() && end->empty());
}

// Whether a file is, or would be, a picture of a sequence.
bool is_in_sequence(const fs::path& file, const fs::path& pattern) {
    std::error_code not_there;
    if (file.empty() || !is_sequence_name(pattern)) return false;
    const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
    const fs::path own_folder = file.has_parent_path() ? file.parent_path() : ".";
    if (is_frame_of(file, pattern) && fs::equivalent(own_folder, folder, not_there)) return true;
    const std::vector<std::int64_t> frames = frames_there(pattern);
    return std::any_of(frames.begin(), frames.end(), [&](std::int64_t frame) {
        return fs::equivalent(file, frame_name(pattern, frame), not_there);
    });
}

// An output must not replace a compared picture or another output, and the report's pictures must
// not be compared the next time.
void refuse_overwriting(const CompareChoices& choices, const fs::path& expected,
                        const fs::path& actual, bool folders) {
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
        if (is_in_sequence(path, expected) || is_in_sequence(path, actual))
            refuse(option, path, "is a picture of a sequence that is compared");
        std::error_code error;
        if (folders && !path.empty() && is_comparable(path) && fs::exists(path, error) &&
            (is_within(path, expected) || is_within(path, actual)))
            refuse(option, path, "is one of the pictures compared");
    }
    if (choices.report.empty() || choices.single_file) return;
    const fs::path pictures = ReportPictures::folder_of(choices.report);
    for (const fs::path& compared : {expected, actual}) {
        if (folders && is_within(pictures, compared))
            throw InputError(fmt::format(
                "--report {}: lies in a folder that is compared, so that the report's pictures "
                "would be compared the next time; choose another folder, or give --single-file",
                printable(choices.report)));
        if (!folders && is_within(compared, pictures))
            throw InputError(
                fmt::format("--report {}: the report's pictures belong into {}, where {} is; "
                            "choose another name",
                            printable(choices.report), printable(pictures.string()),
                            printable(compared.string())));
    }
}

// Appends to the file that GitHub Actions names for a job's summary.
void write_github_summary(const std::string& text) {
    const char* const path = std::getenv("GITHUB_STEP_SUMMARY");
    if (path == nullptr || *path == '\0') return;
    std::ofstream file(path, std::ios::app | std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw EnvironmentError(
            fmt::format("cannot write {}, which GITHUB_STEP_SUMMARY names", printable(path)));
}

// Equal pictures are shown beside each other, too, where that was asked for.
void show_same(const CompareChoices& choices, const fs::path& expected, const fs::path& actual,
               bool are_pictures) {
    if (are_pictures)
        write_png(choices.diff,
                  difference_picture(read_stored_png(expected), read_stored_png(actual)));
    else if (!choices.quiet)
        say(fmt::format("note: nothing differs, so {} is not written", printable(choices.diff)));
}

int run(const CompareChoices& choices) {
    const fs::path expected = choices.pictures.at(0), actual = choices.pictures.at(1);
    CompareRequest request{.limits = profile_limits(choices), .given = choices.given};
    for (const std::string& region : choices.ignore)
        request.given.ignore.push_back(value_of("--ignore", [&] { return parse_region(region); }));
    request.ssim = request.flip = choices.measures;
    const bool folders = are_folders(expected, actual);
    if (folders && !choices.diff.empty())
        throw InputError("--diff shows one pair of pictures; for folders use --report FILE.html");
    if (!choices.diff.empty() && suffix_of(choices.diff) != ".png")
        throw InputError(fmt::format("--diff {}: the picture is a PNG; end its name in .png",
                                     printable(choices.diff)));
    if (choices.single_file && choices.report.empty())
        throw InputError(
            "--single-file says how --report writes its page; give --report FILE.html");
    request.file = read_compare_file(folders ? expected : expected.parent_path());
    refuse_overwriting(choices, expected, actual, folders);

    std::optional<ReportPictures> shown;
    if (!choices.report.empty()) shown.emplace(choices.report, choices.single_file);
    if (shown || !choices.diff.empty())
        request.seen = [&](ComparedPicture& picture, const PicturePair& pair) {
            if (shown) shown->add(picture, pair);
            if (choices.diff.empty()) return;
            write_png(choices.diff,
                      pair.strip.empty()
                          ? difference_picture(pair.expected, pair.actual, pair.ignored)
                          : film_strip(pair.strip, any_strip_width));
        };

    std::vector<ComparedPicture> pictures;
    if (folders) {
        pictures = compare_folders(expected, actual, request);
        sort_by_severity(pictures);
    } else {
        const Baselines baselines(expected.parent_path());
        const bool is_picture = is_png(actual);
        pictures = {compare_files(name_of_file(actual), expected, actual, request,
                                  is_sequence_name(expected) ? nullptr : &baselines,
                                  name_of_file(expected))};
        if (pictures[0].outcome == Outcome::unreadable) throw InputError(pictures[0].reason);
        if (!choices.diff.empty() && pictures[0].outcome == Outcome::same)
            show_same(choices, expected, actual, is_picture);
    }

    const std::string title = fmt::format("{} compared with {}", printable(actual.string()),
                                          printable(expected.string()));
    if (!choices.report.empty()) {
        std::optional<ComparedFolders> approvable;
        if (folders) approvable = {expected.string(), actual.string()};
        write_whole(choices.report, html_report(title, pictures, *shown, approvable));
    }
    if (!choices.junit.empty()) write_whole(choices.junit, junit_xml(title, pictures));
    if (choices.json) {
        fmt::print("{}", json_report(pictures, limits_of_line(choices)));
    } else {
        print_lines(pictures);
    }
    if (choices.github) {
        if (!choices.json) fmt::print("{}", github_annotations(pictures));
        write_github_summary(github_summary(title, pictures));
    }
    if (!choices.quiet) {
        note_unused_regions(pictures);
        if (folders) note_other_pictures(expected, actual);
        if (choices.profile != "native") note_native(pictures);
    }
    return all_pass(pictures) ? 0 : 1;
}

Option option_of(const NumberLimit& limit, GivenLimits& given) {
    std::string option = fmt::format("--{}", limit.name);
    std::replace(option.begin(), option.end(), '_', '-');
    const auto read = [&given, &limit, option](const std::string& text) {
        double number = 0.0;
        if (limit.kind == LimitKind::level) number = parse_whole(option, text, limit.wanted);
        if (limit.kind == LimitKind::number) number = parse_number(option, text, limit.wanted);
        given.*limit.value = value_of(option, [&] {
            return limit.kind == LimitKind::share ? parse_share(text) : limit.checked(number);
        });
    };
    return {.flags = option,
            .takes = std::string(limit.takes),
            .help = std::string(limit.help),
            .value = ReadText{read}};
}

CommandLine compare_line() {
    const auto choices = std::make_shared<CompareChoices>();
    CompareChoices& c = *choices;
    std::vector<Option> options{{.flags = "--profile",
                                 .takes = "NAME",
                                 .help = "portable: no pixel may differ; native: pixels may differ "
                                         "by rounding; default: chosen by the renderer that the "
                                         "baselines' manifest names, portable without a manifest",
                                 .value = &c.profile,
                                 .completes = "portable|native"}};
    for (const NumberLimit& limit : number_limits()) options.push_back(option_of(limit, c.given));
    options.insert(
        options.end(),
        {{.flags = "--antialiasing",
          .help = "allow differences at edges that anti-aliasing explains: edges that move by less "
                  "than a pixel; not for textures, which are edges everywhere",
          .value = &c.antialiasing},
         {.flags = "--ignore",
          .takes = "REGION",
          .help = "do not compare a rectangle (left,top,width,height in pixels or %), or what the "
                  "pictures' records name: labels, clock, caption, title, or an element such as "
                  "polhode; repeatable",
          .value = Repeated{&c.ignore}},
         {.flags = "--measures",
          .help = "also measure SSIM and FLIP of pictures that differ and are not limited by them; "
                  "takes seconds per pair",
          .value = &c.measures},
         json_option(c.json),
         {.flags = "--report",
          .takes = "FILE.html",
          .help =
              "write a report that shows the pictures, with their files beside it in FILE_pictures",
          .value = &c.report,
          .completes = "file"},
         {.flags = "--single-file",
          .help = "embed small pictures in the report instead",
          .value = &c.single_file},
         {.flags = "--junit",
          .takes = "FILE.xml",
          .help = "write test results (JUnit)",
          .value = &c.junit,
          .completes = "file"},
         {.flags = "--github",
          .help = "print annotations for GitHub Actions (not with --json), and add to the job's "
                  "summary",
          .value = &c.github},
         {.flags = "--diff",
          .takes = "FILE.png",
          .help = "write expected | difference × 16 | actual; of films, a row for each of the "
                  "worst frames",
          .value = &c.diff,
          .completes = "file"},
         quiet_option(c.quiet)});
    return {&c.pictures, std::move(options), [choices] {
                if (choices->antialiasing) choices->given.antialiasing = true;
                return run(*choices);
            }};
}

}  // namespace

extern const Command compare_command{
    "compare",
    "REF NEW",
    2,
    2,
    "compare two pictures, films, vector figures or folders exactly, or within limits that you set",
    compare_line,
    {{{"poinsot compare expected.png new.png", "exit code 0: no pixel differs; 1: some do"},
      {"poinsot compare baselines/ results/ --report report.html --ignore clock --max-flip 0.01",
       "compares two folders without their clocks and writes a report that shows the pictures"}}},
    "two pictures or two folders"};

}  // namespace poinsot
