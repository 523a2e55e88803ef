#include "orders/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "compare/compare_file.h"
#include "compare/html_report.h"
#include "compare/junit.h"
#include "compare/report_pictures.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace fs = std::filesystem;

namespace {

// Of the strip of --diff: frames keep their size up to this width.
constexpr int any_strip_width = 16384;

bool is_png(const fs::path& file) { return suffix_of(file) == ".png" && !is_sequence_name(file); }

// As in folders: pictures without their suffix.
std::string name_of_file(const fs::path& file) {
    return (is_png(file) ? file.stem() : file.filename()).string();
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
void refuse_overwriting(const ComparisonOrder& order) {
    const fs::path &expected = order.expected, &actual = order.actual;
    const ComparisonOutputs& outputs = order.outputs;
    const bool folders = order.are_folders;
    const std::array<std::pair<std::string_view, fs::path>, 3> files{
        {{"--diff", outputs.difference}, {"--report", outputs.report}, {"--junit", outputs.junit}}};
    const auto same = [](const fs::path& a, const fs::path& b) {
        std::error_code not_there;
        return !a.empty() && !b.empty() &&
               (a.lexically_normal() == b.lexically_normal() || fs::equivalent(a, b, not_there));
    };
    const auto refuse = [](std::string_view option, const fs::path& path, std::string_view is) {
        throw InputError(
            fmt::format("{} {}: {}; choose another name", option, printable(path.string()), is));
    };
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto& [option, path] = files[i];
        for (std::size_t k = 0; k < i; ++k)
            if (same(path, files[k].second))
                refuse(option, path, fmt::format("is also the output of {}", files[k].first));
        if (same(path, expected) || same(path, actual))
            refuse(option, path, "is one of the files compared");
        if (is_in_sequence(path, expected) || is_in_sequence(path, actual))
            refuse(option, path, "is a picture of a sequence that is compared");
        std::error_code error;
        if (folders && !path.empty() && is_comparable(path) && fs::exists(path, error) &&
            (is_within(path, expected) || is_within(path, actual)))
            refuse(option, path, "is one of the pictures compared");
    }
    if (outputs.report.empty() || outputs.single_file) return;
    const fs::path pictures = ReportPictures::folder_of(outputs.report);
    for (const fs::path& compared : {expected, actual}) {
        if (folders && is_within(pictures, compared))
            throw InputError(fmt::format(
                "--report {}: lies in a folder that is compared, so that the report's pictures "
                "would be compared the next time; choose another folder, or give --single-file",
                printable(outputs.report.string())));
        if (!folders && is_within(compared, pictures))
            throw InputError(
                fmt::format("--report {}: the report's pictures belong into {}, where {} is; "
                            "choose another name",
                            printable(outputs.report.string()), printable(pictures.string()),
                            printable(compared.string())));
    }
}

}  // namespace

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

void check_outputs(const ComparisonOrder& order) {
    const ComparisonOutputs& outputs = order.outputs;
    if (order.are_folders && !outputs.difference.empty())
        throw InputError("--diff shows one pair of pictures; for folders use --report FILE.html");
    if (!outputs.difference.empty() && suffix_of(outputs.difference) != ".png")
        throw InputError(fmt::format("--diff {}: the picture is a PNG; end its name in .png",
                                     printable(outputs.difference.string())));
    if (outputs.single_file && outputs.report.empty())
        throw InputError(
            "--single-file says how --report writes its page; give --report FILE.html");
    refuse_overwriting(order);
}

ComparisonResult compare(const ComparisonOrder& order) {
    const fs::path &expected = order.expected, &actual = order.actual;
    const ComparisonOutputs& outputs = order.outputs;
    CompareRequest request = order.request;
    request.file = read_compare_file(order.are_folders ? expected : expected.parent_path());
    check_outputs(order);

    ComparisonResult result;
    std::optional<ReportPictures> shown;
    if (!outputs.report.empty()) shown.emplace(outputs.report, outputs.single_file);
    if (shown || !outputs.difference.empty())
        request.seen = [&](ComparedPicture& picture, const PicturePair& pair) {
            if (shown) shown->add(picture, pair);
            if (outputs.difference.empty()) return;
            write_png(outputs.difference,
                      pair.strip.empty()
                          ? difference_picture(pair.expected, pair.actual, pair.ignored)
                          : film_strip(pair.strip, any_strip_width));
            result.wrote_difference = true;
        };

    std::vector<ComparedPicture>& pictures = result.pictures;
    if (order.are_folders) {
        pictures = compare_folders(expected, actual, request);
        sort_by_severity(pictures);
    } else {
        const Baselines baselines(expected.parent_path());
        pictures = {compare_files(name_of_file(actual), expected, actual, request,
                                  is_sequence_name(expected) ? nullptr : &baselines,
                                  name_of_file(expected))};
        if (pictures[0].outcome == Outcome::unreadable) throw InputError(pictures[0].reason);
        // Equal pictures are shown beside each other, too.
        if (!outputs.difference.empty() && pictures[0].outcome == Outcome::same && is_png(actual)) {
            write_png(outputs.difference,
                      difference_picture(read_stored_png(expected), read_stored_png(actual)));
            result.wrote_difference = true;
        }
    }

    if (shown) {
        std::optional<ComparedFolders> approvable;
        if (order.are_folders) approvable = {expected.string(), actual.string()};
        write_whole(outputs.report, html_report(outputs.title, pictures, *shown, approvable));
    }
    if (!outputs.junit.empty()) write_whole(outputs.junit, junit_xml(outputs.title, pictures));
    return result;
}

}  // namespace poinsot
