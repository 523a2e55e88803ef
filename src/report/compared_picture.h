// Two pictures, or two folders of them, compared in one pass: the outcomes that reports, test
// results and exit codes are made of.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/compare.h"
#include "report/baselines.h"

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

// Two files. One that does not exist is missing, or unexpected. The baselines, where given, say by
// their manifest what the expected picture of their name is, and, where no limits are given, what
// may differ by what drew it; else no pixel may.
ComparedPicture compare_files(const std::string& name, const std::filesystem::path& expected,
                              const std::filesystem::path& actual,
                              const std::optional<CompareLimits>& limits,
                              const Baselines* baselines = nullptr,
                              const std::string& baseline_name = "");

// Every .png in either folder and the folders below, hidden ones left out, by name, and what the
// manifest of the first names, where it has one. Throws InputError for a folder or a manifest that
// cannot be read, and where there is no picture at all.
std::vector<ComparedPicture> compare_folders(const std::filesystem::path& expected,
                                             const std::filesystem::path& actual,
                                             const std::optional<CompareLimits>& limits);

// Worst first: by outcome, then by perceived difference (FLIP), then by name.
void sort_by_severity(std::vector<ComparedPicture>& pictures);

bool all_pass(std::span<const ComparedPicture> pictures);

}  // namespace poinsot
