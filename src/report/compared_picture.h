// Two pictures, or two folders of them, compared in one pass: the outcomes that reports, test
// results and exit codes are made of.
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
#include "system/processor.h"

namespace poinsot {

// In order of severity.
enum class Outcome {
    unreadable,  // one of the two is no whole PNG
    missing,     // expected, but not there
    baseline,    // what is there to compare with is not what was approved
    renderer,    // drawn by another kind of renderer than the baseline
    size,        // there, in another size
    depth,       // with another number of bits a component
    colours,     // with samples that mean other colours
    pixels,      // more pixels differ than may
    unexpected,  // there, but nothing says what it should look like
    within_limits,
    same
};

// "missing", "within limits".
std::string_view name_of(Outcome outcome);

struct ComparedPicture {
    std::string name;                        // path within the folder, without ".png"
    std::filesystem::path expected, actual;  // files; empty for one that is not there
    Outcome outcome = Outcome::same;
    std::string reason;   // one line; empty when the pictures are the same
    Comparison measured;  // of pictures that both could be read

    bool passes() const { return outcome == Outcome::same || outcome == Outcome::within_limits; }
};

// What may differ between a baseline and a picture by this renderer (GL_RENDERER) and version of
// Mesa, when nobody says: no pixel where one version of one renderer drew both; between two
// versions of llvmpipe 0.1 % of the pixels by a level, as Mesa 22 and 26 were found to round apart
// by less; none can be told between others.
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

// Two files. One that does not exist is missing, or unexpected. The baselines, where given, say by
// their manifest what the expected picture of their name is, and, where no limits are given, what
// may differ by what drew it; else no pixel may.
ComparedPicture compare_files(const std::string& name, const std::filesystem::path& expected,
                              const std::filesystem::path& actual, const CompareRequest& request,
                              const Baselines* baselines = nullptr,
                              const std::string& baseline_name = "");

// Every .png in either folder and the folders below, hidden ones left out, by name, and what the
// manifest of the first names, where it has one; in order of their names, whatever number of
// threads compares them. Throws InputError for a folder or a manifest that cannot be read, and
// where there is no picture at all.
std::vector<ComparedPicture> compare_folders(const std::filesystem::path& expected,
                                             const std::filesystem::path& actual,
                                             const CompareRequest& request);

// Worst first: by outcome, then by perceived difference (FLIP) where it was measured, by the mean
// difference where not, then by name.
void sort_by_severity(std::vector<ComparedPicture>& pictures);

bool all_pass(std::span<const ComparedPicture> pictures);

}  // namespace poinsot
