// A comparison as the command line and Python ask for it: of two files or two folders, with the
// files that show it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/compared_picture.h"

namespace poinsot {

// Files to be written; empty: none.
struct ComparisonOutputs {
    std::string title{};                 // of the report and the test results
    std::filesystem::path report{};      // .html
    std::filesystem::path junit{};       // test results
    std::filesystem::path difference{};  // .png, of two files
    bool single_file = false;            // the report embeds its pictures
};

struct ComparisonOrder {
    std::filesystem::path expected{}, actual{};
    bool are_folders = false;  // else files or sequences
    CompareRequest request{};  // without `file` and `seen`
    ComparisonOutputs outputs{};
};

struct ComparisonResult {
    std::vector<ComparedPicture> pictures;  // of folders, worst first
    bool wrote_difference = false;
};

// Whether both are folders. Throws InputError for a file and a folder, and for what does not exist.
bool are_folders(const std::filesystem::path& expected, const std::filesystem::path& actual);

// Throws InputError for outputs that would replace or join what is compared, or replace each other.
void check_outputs(const ComparisonOrder& order);

// Checks the outputs, compares, and writes them. The compare.toml and the manifest of the expected
// folder hold. Throws InputError and EnvironmentError.
ComparisonResult compare(const ComparisonOrder& order);

}  // namespace poinsot
