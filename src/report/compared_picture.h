// Two pictures, or two folders of them, compared in one pass: the outcomes that reports, test
// results and exit codes are made of.
#pragma once

#include <filesystem>
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

// Two files. One that does not exist is missing, or unexpected. The baselines, where given, say by
// their manifest what the expected picture of their name is.
ComparedPicture compare_files(const std::string& name, const std::filesystem::path& expected,
                              const std::filesystem::path& actual, const CompareLimits& limits,
                              const Baselines* baselines = nullptr,
                              const std::string& baseline_name = "");

// Every .png in either folder and the folders below, hidden ones left out, by name, and what the
// manifest of the first names, where it has one. Throws InputError for a folder or a manifest that
// cannot be read, and where there is no picture at all.
std::vector<ComparedPicture> compare_folders(const std::filesystem::path& expected,
                                             const std::filesystem::path& actual,
                                             const CompareLimits& limits);

// Worst first: by outcome, then by perceived difference (FLIP), then by name.
void sort_by_severity(std::vector<ComparedPicture>& pictures);

bool all_pass(std::span<const ComparedPicture> pictures);

}  // namespace poinsot
