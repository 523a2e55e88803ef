#include "compare/compared_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compare/file_pair.h"
#include "compare/rendered_page.h"
#include "encoding/film_metadata.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "production/records/record.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// Compares two pictures in memory. Throws InputError.
void compare_pictures(const StoredPicture& expected, const StoredPicture& actual,
                      const Records& records, const CompareRequest& request,
                      const GivenLimits& given, ComparedPicture& result) {
    CompareExtras extras{.ssim = request.ssim, .flip = request.flip};
    const bool same_size = expected.image.width() == actual.image.width() &&
                           expected.image.height() == actual.image.height();
    const bool same_pixels =
        same_size && expected.image == actual.image && expected.deep == actual.deep;
    if (same_size && !same_pixels && !given.ignore.empty()) {
        try {
            IgnoredRegions regions(given.ignore, records);
            extras.ignored = regions.in(expected.image.width(), expected.image.height());
            result.found_regions = regions.found();
        } catch (const InputError& error) {
            result.outcome = Outcome::region;
            result.reason = error.what();
            return;
        }
    }
    result.measured = compare(expected, actual, result.limits, extras);
    result.outcome = outcome_of(result.measured.verdict);
    result.reason = result.measured.reason;
    add_ignored_pixels(result);
    if (same_size && !same_pixels && result.measured.n_pixels == 0) {
        result.outcome = Outcome::region;
        result.reason = nothing_left;
    }
    if (result.outcome != Outcome::same && request.seen)
        request.seen(result, {expected, actual, result.limits, extras.ignored, {}});
}

// A record in the metadata of a picture.
std::optional<Record> record_in(const PngInfo& info, const fs::path& file) {
    const auto text = info.texts.find(metadata_name);
    if (text == info.texts.end()) return std::nullopt;
    try {
        return parse_record(text->second, file.string());
    } catch (const InputError&) {
        return std::nullopt;
    }
}

// The header's width and height (PNG specification §11.2.2); empty for what is no regular file.
std::string stated_size_of(const fs::path& png) {
    constexpr std::size_t at = 16, n_bytes = 8;
    if (kind_of_file(png) != FileKind::regular) return "";
    const std::string beginning = read_beginning(png, at + n_bytes);
    return beginning.size() < at + n_bytes ? "" : beginning.substr(at);
}

// Whether two pictures have different sizes, which their headers say.
bool sizes_differ(ComparedPicture& result) {
    if (stated_size_of(result.expected) == stated_size_of(result.actual)) return false;
    const PngInfo a = read_png_info(result.expected), b = read_png_info(result.actual);
    if (a.width_px == b.width_px && a.height_px == b.height_px) return false;
    result.measured = size_difference(a.width_px, a.height_px, b.width_px, b.height_px);
    result.outcome = Outcome::size;
    result.reason = result.measured.reason;
    add_record_differences({record_in(a, result.expected), record_in(b, result.actual)}, result);
    return true;
}

void compare_pages(const CompareRequest& request, const GivenLimits& given, MachineShare& share,
                   ComparedPicture& result) {
    if (have_same_bytes(result.expected, result.actual)) return;
    RenderedPages pages;
    const fs::path expected_png = pages.picture_of(result.expected);
    const fs::path actual_png = pages.picture_of(result.actual);
    share.need(expected_png);
    share.need(actual_png);
    const StoredPicture expected = request.read(expected_png);
    const StoredPicture actual = request.read(actual_png);
    const Records records{find_record(result.expected), find_record(result.actual)};
    compare_pictures(expected, actual, records, request, given, result);
    add_record_differences(records, result);
}

// The kinds of files; a file is compared only with one of its kind.
enum class Kind { picture, page, film };
Kind kind_of_name(const fs::path& file) {
    if (is_film_name(file) || is_sequence_name(file)) return Kind::film;
    return is_vector_page_name(file) ? Kind::page : Kind::picture;
}

FileKind kind_of_compared(const fs::path& file) {
    if (!is_sequence_name(file)) return kind_of_file(file);
    return frames_there(file).empty() ? FileKind::missing : FileKind::regular;
}

}  // namespace

bool is_comparable(const fs::path& file) {
    return is_picture_name(file) || is_vector_page_name(file) || is_film_name(file);
}

void check_regions(const GivenLimits& given, const fs::path& picture) {
    const IgnoredRegions findable(given.ignore, {find_record(picture), {}});
}

std::string ComparedPicture::line() const {
    constexpr std::size_t most_changes = 5;
    std::string text;
    if (changes && changes->empty() && outcome == Outcome::pixels)
        text = "scene, settings and versions are the same; ";
    for (std::size_t i = 0; changes && i < std::min(changes->size(), most_changes); ++i)
        text += (*changes)[i] + "; ";
    if (changes && changes->size() > most_changes)
        text += fmt::format("and {} more changes; ", changes->size() - most_changes);
    return text + reason;
}

std::string_view name_of(Outcome outcome) {
    constexpr std::array<std::string_view, 14> names{
        "unreadable", "missing", "baseline", "renderer", "size",       "rate",          "length",
        "depth",      "colours", "region",   "pixels",   "unexpected", "within limits", "same"};
    return names.at(static_cast<std::size_t>(outcome));
}

std::optional<CompareLimits> limits_between(const Baseline& approved, std::string_view renderer,
                                            std::string_view mesa) {
    if (is_foreign(approved)) return CompareLimits::exact();
    if (approved.renderer == renderer && approved.mesa == mesa) return CompareLimits::exact();
    const auto is_llvmpipe = [](std::string_view name) { return name.starts_with("llvmpipe"); };
    if (!is_llvmpipe(approved.renderer) || !is_llvmpipe(renderer)) return std::nullopt;
    return CompareLimits{.differing_share = 1e-3, .level = 1, .over_level_share = 0.0};
}

namespace {

bool is_listed(const FilePair& pair) {
    return pair.baselines != nullptr && pair.baselines->manifest().contains(pair.baseline_name);
}

// Names the files that exist in `result`, and says what is wrong if one is missing. Returns whether
// there are two.
bool has_two_files(const FilePair& pair, ComparedPicture& result) {
    if (kind_of_compared(pair.expected) != FileKind::missing) result.expected = pair.expected;
    if (kind_of_compared(pair.actual) != FileKind::missing) result.actual = pair.actual;
    if (result.expected.empty() && is_listed(pair)) {
        result.outcome = Outcome::baseline;
        result.reason = fmt::format(
            "{} names this baseline, but the picture is missing; restore it, approve a new one, or "
            "remove its line with poinsot approve --remove",
            manifest_name);
    } else if (result.actual.empty()) {
        result.outcome = Outcome::missing;
        result.reason = "the baseline exists, but the new file is missing";
    } else if (result.expected.empty()) {
        result.outcome = Outcome::unexpected;
        result.reason = fmt::format("this {} has no baseline; approve it if it is right",
                                    is_picture_name(pair.actual) ? "picture" : "file");
    }
    return !result.expected.empty() && !result.actual.empty();
}

// Sets the limits of the pair. Returns false, with the reason, if its renderers have none.
bool find_limits(const FilePair& pair, const CompareRequest& request, const GivenLimits& given,
                 ComparedPicture& result) {
    std::optional<CompareLimits> by_renderer = CompareLimits::exact();
    if (!request.limits && !given.decides() && is_listed(pair)) {
        const Baseline& approved = pair.baselines->manifest().at(pair.baseline_name);
        if (const auto now = find_record(pair.actual))
            by_renderer = limits_between(approved, now->renderer, now->mesa);
        if (!by_renderer) {
            result.outcome = Outcome::renderer;
            result.reason = fmt::format(
                "drawn by another renderer than the baseline ({}, Mesa {}); draw it with the same "
                "renderer, or set with --profile how much may differ",
                printable(approved.renderer), printable(approved.mesa));
            return false;
        }
    }
    result.limits = limits_of(given, request.limits, *by_renderer);
    return true;
}

// Whether the baseline, whose pixels have this hash, is not the approved picture.
void report_fault(const FilePair& pair, const std::string& hash, ComparedPicture& result) {
    std::string fault = pair.baselines->fault(pair.baseline_name, hash);
    if (fault.empty()) return;
    result.outcome = Outcome::baseline;
    result.reason = std::move(fault);
}

// Throws InputError for a file that cannot be read.
void compare_png_files(const FilePair& pair, const CompareRequest& request,
                       const GivenLimits& given, MachineShare& share, ComparedPicture& result) {
    // With a manifest, the pixels of the baseline are checked whatever the sizes.
    const bool has_manifest = pair.baselines != nullptr && pair.baselines->has_manifest();
    if (!request.seen && !has_manifest && sizes_differ(result)) return;
    share.need(pair.expected);
    share.need(pair.actual);
    // Of byte-identical files one is read, to check that it is a complete PNG.
    const StoredPicture picture = request.read(pair.expected);
    if (have_same_bytes(pair.expected, pair.actual)) {
        result.measured = compare(picture, picture, CompareLimits::exact());
    } else {
        const StoredPicture other = request.read(pair.actual);
        const Records records{record_in(picture.info, pair.expected),
                              record_in(other.info, pair.actual)};
        compare_pictures(picture, other, records, request, given, result);
        add_record_differences(records, result);
    }
    if (has_manifest) report_fault(pair, pixels_sha256(picture), result);
}

// Throws InputError for two kinds of files, and for one that cannot be read.
void compare_contents(const FilePair& pair, const CompareRequest& request, const GivenLimits& given,
                      MachineShare& share, ComparedPicture& result) {
    const Kind kind = kind_of_name(pair.expected);
    if (kind != kind_of_name(pair.actual))
        throw InputError(fmt::format(
            "{} and {}: different kinds of files; give two pictures, two films, or two vector "
            "figures",
            printable(pair.expected.string()), printable(pair.actual.string())));
    if (kind == Kind::picture) return compare_png_files(pair, request, given, share, result);
    if (kind == Kind::page)
        compare_pages(request, given, share, result);
    else
        compare_two_films(request, given, share, result);
    // Those that were never approved need no line in the manifest.
    if (is_listed(pair)) report_fault(pair, pixel_hash_of_file(pair.expected), result);
}

}  // namespace

ComparedPicture compare_pair(const FilePair& pair, const CompareRequest& request,
                             MachineShare& share) {
    ComparedPicture result;
    result.name = pair.name;
    if (!has_two_files(pair, result)) return result;
    const GivenLimits given = request.given.over(
        request.file ? request.file->given_limits_of(pair.baseline_name) : GivenLimits{});
    for (const IgnoredRegion& region : given.ignore) result.ignored.push_back(region.text);
    if (!find_limits(pair, request, given, result)) return result;
    try {
        compare_contents(pair, request, given, share, result);
    } catch (const InputError& error) {
        result.outcome = Outcome::unreadable;
        result.reason = error.what();
    }
    return result;
}

ComparedPicture compare_files(const std::string& name, const fs::path& expected,
                              const fs::path& actual, const CompareRequest& request,
                              const Baselines* baselines, const std::string& baseline_name) {
    MachineShare whole(request.n_threads);
    return compare_pair({.name = name,
                         .expected = expected,
                         .actual = actual,
                         .baselines = baselines,
                         .baseline_name = baseline_name.empty() ? name : baseline_name},
                        request, whole);
}

}  // namespace poinsot
