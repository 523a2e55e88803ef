// poinsot compare REF NEW: compares two pictures, films or vector figures, or two folders of them.
#include "orders/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "compare/compared_picture.h"
#include "compare/github_report.h"
#include "compare/json_report.h"
#include "error/error.h"
#include "production/records/record.h"
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

int run(const CompareChoices& choices) {
    const fs::path expected = choices.pictures.at(0), actual = choices.pictures.at(1);
    CompareRequest request{.limits = profile_limits(choices), .given = choices.given};
    for (const std::string& region : choices.ignore)
        request.given.ignore.push_back(value_of("--ignore", [&] { return parse_region(region); }));
    request.ssim = request.flip = choices.measures;
    const ComparisonOrder order{
        .expected = expected,
        .actual = actual,
        .are_folders = are_folders(expected, actual),
        .request = std::move(request),
        .outputs = {.title = fmt::format("{} compared with {}", printable(actual.string()),
                                         printable(expected.string())),
                    .report = choices.report,
                    .junit = choices.junit,
                    .difference = choices.diff,
                    .single_file = choices.single_file}};
    const ComparisonResult result = compare(order);
    const std::vector<ComparedPicture>& pictures = result.pictures;
    const bool all_same = std::all_of(pictures.begin(), pictures.end(),
                                      [](const auto& p) { return p.outcome == Outcome::same; });
    if (!choices.diff.empty() && !result.wrote_difference && all_same && !choices.quiet)
        say(fmt::format("note: nothing differs, so {} is not written", printable(choices.diff)));
    if (choices.json) {
        fmt::print("{}", json_report(pictures, limits_of_line(choices)));
    } else {
        print_lines(pictures);
    }
    if (choices.github) {
        if (!choices.json) fmt::print("{}", github_annotations(pictures));
        write_github_summary(github_summary(order.outputs.title, pictures));
    }
    if (!choices.quiet) {
        note_unused_regions(pictures);
        if (order.are_folders) note_other_pictures(expected, actual);
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
