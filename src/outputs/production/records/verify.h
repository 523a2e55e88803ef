// Checks a file against its record.
#pragma once

#include <filesystem>
#include <string>

#include "production/records/record.h"

namespace poinsot {

// Whether a file's pixels or packets are those for which its record was written, and nothing was
// appended to it.
enum class Verified { yes, no, cannot_be };
struct Verification {
    Verified verified = Verified::cannot_be;
    std::string sentence;  // about the file, one line
};

// Reads the whole file. Throws InputError if it cannot be read.
Verification verify(const std::filesystem::path& file, const Record& record);

// Whether verification is nearly instantaneous.
bool is_quickly_verified(const std::filesystem::path& file, const Record& record);

}  // namespace poinsot
