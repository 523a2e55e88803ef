// Compares two pictures, or two folders of pictures, in one pass; reports, test results and exit
// codes follow from the outcomes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/compare.h"
#include "image/png.h"
#include "report/baselines.h"
#include "system/files/processor.h"

namespace poinsot {

// In order of severity.
enum class Outcome {
    unreadable,  // one of the two is not a complete PNG
    missing,     // expected, but does not exist
    baseline,    // the baseline is not the approved picture
    renderer,    // rendered by another kind of renderer than the baseline
    size,        // exists, in another size
    depth,       // with another number of bits per component
    colours,     // with samples in another colour space
    pixels,      // more pixels differ than allowed
    unexpected,  // exists, but has no baseline
    within_limits,
    same
};

// "missing", "within limits".
std::string_view name_of(Outcome outcome);

struct ComparedPicture {
    std::string name;                        // path within the folder, without ".png"
    std::filesystem::path expected, actual;  // files; empty if missing
    Outcome outcome = Outcome::same;
    std::string reason;   // one line; empty if the pictures are equal
    Comparison measured;  // of pictures that could both be read

    bool passes() const { return outcome == Outcome::same || outcome == Outcome::within_limits; }
};

// Returns the default limits between a baseline and a picture by this renderer (GL_RENDERER) and
// version of Mesa: no pixel may differ with the same renderer and version; between two versions of
// llvmpipe 0.1 % of the pixels may differ by a level, because Mesa 22 and 26 round differently in
// fewer; none are known for other pairs.
std::optional<CompareLimits> limits_between(const Baseline& approved, std::string_view renderer,
                                            std::string_view mesa);

// What is compared, and how much of it.
struct CompareRequest {
    // None: what drew the baseline decides, else no pixel may differ.
    std::optional<CompareLimits> limits{};
    // Measures pairs whose pixels differ; none: they are not measured.
    std::function<Likeness(const Image&, const Image&)> likeness{};
    std::function<StoredPicture(const std::filesystem::path&)> read = read_stored_png;
    int n_threads = n_processors();  // of a folder; likeness and read are called by all of them
};

// Compares two files. A file that does not exist is "missing" or "unexpected". If baselines are
// given, their manifest names the expected picture and, if no limits are given, determines the
// limits from the renderer; otherwise no pixel may differ.
ComparedPicture compare_files(const std::string& name, const std::filesystem::path& expected,
                              const std::filesystem::path& actual, const CompareRequest& request,
                              const Baselines* baselines = nullptr,
                              const std::string& baseline_name = "");

// Compares every .png in the two folders and their subfolders, except hidden ones, and every
// picture that the manifest of the first folder names. The result is in the order of the names, for
// any number of threads. Throws InputError for a folder or a manifest that cannot be read, and if
// there are no pictures.
std::vector<ComparedPicture> compare_folders(const std::filesystem::path& expected,
                                             const std::filesystem::path& actual,
                                             const CompareRequest& request);

// Worst first: by outcome, then by perceived difference (FLIP) where it was measured, by the mean
// difference where not, then by name.
void sort_by_severity(std::vector<ComparedPicture>& pictures);

bool all_pass(std::span<const ComparedPicture> pictures);

}  // namespace poinsot
