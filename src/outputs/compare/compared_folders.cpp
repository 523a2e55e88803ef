#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "compare/file_pair.h"
#include "compare/rendered_page.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "system/files/file_kind.h"
#include "system/in_parallel.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// Calls a function for every file of a folder and its subfolders, except hidden ones.
template <typename Take>
void for_each_file(const fs::path& folder, const Take& take) {
    std::error_code error;
    fs::recursive_directory_iterator at(folder, error);
    const fs::recursive_directory_iterator end;
    for (; !error && at != end; at.increment(error)) {
        const bool hidden = at->path().filename().string().starts_with('.');
        std::error_code ignored;
        if (at->is_directory(ignored)) {
            if (hidden) at.disable_recursion_pending();
        } else if (!hidden) {
            take(at->path());
        }
    }
    if (error)
        throw InputError(fmt::format("{}: {}; give a folder of pictures",
                                     printable(folder.string()), error.message()));
}

// The files of a folder that can be compared, by name.
std::map<std::string, fs::path> pictures_in(const fs::path& folder) {
    std::map<std::string, fs::path> found;
    for_each_file(folder, [&](const fs::path& path) {
        if (!is_comparable(path)) return;
        const fs::path name = path.lexically_relative(folder);
        if (!is_picture_name(path)) {
            found.emplace(name.generic_string(), path);
            return;
        }
        // turn.png and turn.PNG are two pictures.
        if (!found.emplace(fs::path(name).replace_extension().generic_string(), path).second)
            found.emplace(name.generic_string(), path);
    });
    return found;
}

}  // namespace

std::vector<fs::path> other_pictures_in(const fs::path& folder) {
    constexpr std::array<std::string_view, 6> suffixes{".jpg",  ".jpeg", ".webp",
                                                       ".tiff", ".tif",  ".bmp"};
    std::vector<fs::path> found;
    for_each_file(folder, [&](const fs::path& path) {
        const std::string suffix = suffix_of(path);
        if (std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end())
            found.push_back(path.lexically_relative(folder));
    });
    std::sort(found.begin(), found.end());
    return found;
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
        throw InputError(fmt::format(
            "{} and {}: neither contains a picture (.png), a film ({}) or a figure (.pdf, .svg); "
            "nothing to compare",
            printable(expected.string()), printable(actual.string()), film_suffixes()));
    const std::vector<std::pair<std::string, std::pair<fs::path, fs::path>>> pairs(names.begin(),
                                                                                   names.end());
    if (request.file) {
        std::vector<std::string> all;
        all.reserve(pairs.size());
        for (const auto& [name, paths] : pairs) all.push_back(name);
        request.file->check_used(all);
    }
    std::vector<ComparedPicture> results(pairs.size());
    std::mutex large_pairs;
    const int n_threads_each = std::max(
        1, request.n_threads / static_cast<int>(std::min<std::size_t>(pairs.size(), 1 << 16)));
    in_parallel(pairs.size(), request.n_threads, [&](std::size_t i) {
        const auto& [name, paths] = pairs[i];
        MachineShare share(n_threads_each, request.n_threads, large_pairs);
        try {
            results[i] = compare_pair({.name = name,
                                       .expected = paths.first,
                                       .actual = paths.second,
                                       .baselines = &baselines,
                                       .baseline_name = name},
                                      request, share);
        } catch (const NoRasteriser& error) {
            // Without the program that renders pages, the other files are still compared.
            results[i] = {.name = name,
                          .expected = paths.first,
                          .actual = paths.second,
                          .outcome = Outcome::unreadable,
                          .reason = error.what()};
        }
    });
    return results;
}

void sort_by_severity(std::vector<ComparedPicture>& pictures) {
    const auto rank = [](const ComparedPicture& p) {
        const Comparison& m = p.measured;
        const double difference = m.flip.value_or(m.mean_difference);
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
