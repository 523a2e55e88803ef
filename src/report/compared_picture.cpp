#include "report/compared_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <tuple>

#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "production/provenance/record.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/in_parallel.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

Outcome outcome_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return Outcome::same;
        case Verdict::within_limits:
            return Outcome::within_limits;
        case Verdict::size_differs:
            return Outcome::size;
        case Verdict::depth_differs:
            return Outcome::depth;
        case Verdict::colours_differ:
            return Outcome::colours;
        case Verdict::pixels_differ:
            break;
    }
    return Outcome::pixels;
}

// The pictures of a folder by name.
std::map<std::string, fs::path> pictures_in(const fs::path& folder) {
    std::map<std::string, fs::path> found;
    std::error_code error;
    fs::recursive_directory_iterator at(folder, error);
    const fs::recursive_directory_iterator end;
    for (; !error && at != end; at.increment(error)) {
        const fs::path& path = at->path();
        const bool hidden = path.filename().string().starts_with('.');
        std::error_code ignored;
        if (at->is_directory(ignored)) {
            if (hidden) at.disable_recursion_pending();
        } else if (!hidden && suffix_of(path) == ".png") {
            const fs::path name = path.lexically_relative(folder);
            // turn.png and turn.PNG are two pictures.
            if (!found.emplace(fs::path(name).replace_extension().generic_string(), path).second)
                found.emplace(name.generic_string(), path);
        }
    }
    if (error)
        throw InputError(fmt::format("{}: {}; give a folder of pictures",
                                     printable(folder.string()), error.message()));
    return found;
}

std::optional<Record> record_of(const fs::path& picture) {
    try {
        return read_record(picture);
    } catch (const InputError&) {
        return std::nullopt;  // rendered by another program
    }
}

// Whether it has so many pixels that one pair of such pictures at a time is held in memory.
bool is_large(const fs::path& picture) {
    constexpr double many_pixels = 1 << 24;
    if (kind_of_file(picture) != FileKind::regular) return false;
    try {
        const PngInfo info = read_png_info(picture);
        return 1.0 * info.width_px * info.height_px > many_pixels;
    } catch (const Error&) {
        return false;  // reported when it is compared
    }
}

// Whether both are regular files of the same bytes; the reader of pictures reports files that
// cannot be read.
bool have_same_bytes(const fs::path& a, const fs::path& b) {
    if (kind_of_file(a) != FileKind::regular || kind_of_file(b) != FileKind::regular) return false;
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
    return read_bytes(a) == read_bytes(b);
}

}  // namespace

std::string_view name_of(Outcome outcome) {
    constexpr std::array<std::string_view, 11> names{
        "unreadable", "missing", "baseline",   "renderer",      "size", "depth",
        "colours",    "pixels",  "unexpected", "within limits", "same"};
    return names.at(static_cast<std::size_t>(outcome));
}

std::optional<CompareLimits> limits_between(const Baseline& approved, std::string_view renderer,
                                            std::string_view mesa) {
    if (approved.renderer == renderer && approved.mesa == mesa) return CompareLimits::exact();
    const auto is_llvmpipe = [](std::string_view name) { return name.starts_with("llvmpipe"); };
    if (!is_llvmpipe(approved.renderer) || !is_llvmpipe(renderer)) return std::nullopt;
    return CompareLimits{.differing_share = 1e-3, .level = 1, .over_level_share = 0.0};
}

ComparedPicture compare_files(const std::string& name, const fs::path& expected,
                              const fs::path& actual, const CompareRequest& request,
                              const Baselines* baselines, const std::string& baseline_name) {
    ComparedPicture result;
    result.name = name;
    if (kind_of_file(expected) != FileKind::missing) result.expected = expected;
    if (kind_of_file(actual) != FileKind::missing) result.actual = actual;
    const bool is_listed = baselines != nullptr && baselines->manifest().contains(baseline_name);
    if (result.expected.empty() && is_listed) {
        result.outcome = Outcome::baseline;
        result.reason = fmt::format(
            "{} names this baseline, but the picture is missing; restore it, or approve a new one",
            manifest_name);
        return result;
    }
    if (result.actual.empty()) {
        result.outcome = Outcome::missing;
        result.reason = "the baseline exists, but the new picture is missing";
        return result;
    }
    if (result.expected.empty()) {
        result.outcome = Outcome::unexpected;
        result.reason = "this picture has no baseline; approve it if it is right";
        return result;
    }
    std::optional<CompareLimits> allowed = request.limits ? request.limits : CompareLimits::exact();
    if (!request.limits && is_listed) {
        const Baseline& approved = baselines->manifest().at(baseline_name);
        if (const auto now = record_of(actual))
            allowed = limits_between(approved, now->renderer, now->mesa);
        if (!allowed) {
            result.outcome = Outcome::renderer;
            result.reason = fmt::format(
                "drawn by another renderer than the baseline ({}, Mesa {}); draw it with the same "
                "renderer, or set with --profile how much may differ",
                printable(approved.renderer), printable(approved.mesa));
            return result;
        }
    }
    try {
        // Of two files of the same bytes one is read, to see that it is a whole PNG.
        const StoredPicture picture = request.read(expected);
        if (have_same_bytes(expected, actual)) {
            result.measured = compare(picture, picture, *allowed);
        } else {
            const StoredPicture other = request.read(actual);
            result.measured = compare(picture, other, *allowed);
            if (request.likeness && result.measured.n_differing > 0)
                result.measured.likeness = request.likeness(picture.image, other.image);
        }
        result.outcome = outcome_of(result.measured.verdict);
        result.reason = result.measured.reason;
        if (baselines == nullptr || !baselines->has_manifest()) return result;
        if (std::string fault = baselines->fault(baseline_name, pixels_sha256(picture));
            !fault.empty()) {
            result.outcome = Outcome::baseline;
            result.reason = std::move(fault);
        }
    } catch (const InputError& error) {
        result.outcome = Outcome::unreadable;
        result.reason = error.what();
    }
    return result;
}

std::vector<ComparedPicture> compare_folders(const fs::path& expected, const fs::path& actual,
                                             const CompareRequest& request) {
    const auto expected_files = pictures_in(expected);
    const auto actual_files = pictures_in(actual);
    std::map<std::string, std::pair<fs::path, fs::path>> names;
    for (const auto& [name, path] : expected_files) names[name].first = path;
    for (const auto& [name, path] : actual_files) names[name].second = path;
    const Baselines baselines(expected);
    for (const auto& [name, line] : baselines.manifest()) names[name];
    if (names.empty())
        throw InputError(fmt::format("{} and {}: neither contains a .png; nothing to compare",
                                     printable(expected.string()), printable(actual.string())));
    const std::vector<std::pair<std::string, std::pair<fs::path, fs::path>>> pairs(names.begin(),
                                                                                   names.end());
    std::vector<ComparedPicture> results(pairs.size());
    std::mutex large_pictures;
    in_parallel(pairs.size(), request.n_threads, [&](std::size_t i) {
        const auto& [name, paths] = pairs[i];
        std::unique_lock alone(large_pictures, std::defer_lock);
        if (is_large(paths.first) || is_large(paths.second)) alone.lock();
        results[i] = compare_files(name, paths.first, paths.second, request, &baselines, name);
    });
    return results;
}

void sort_by_severity(std::vector<ComparedPicture>& pictures) {
    const auto rank = [](const ComparedPicture& p) {
        const Comparison& m = p.measured;
        const double difference = m.likeness ? m.likeness->flip : m.mean_difference;
        return std::make_tuple(p.outcome, -difference, std::string_view(p.name));
    };
    std::stable_sort(pictures.begin(), pictures.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

bool all_pass(std::span<const ComparedPicture> pictures) {
    return std::all_of(pictures.begin(), pictures.end(),
                       [](const ComparedPicture& p) { return p.passes(); });
}

}  // namespace poinsot
