// compare.toml: the limits of pictures, by name, in a file beside the baselines.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/given_limits.h"
#include "scene/scene.h"

namespace poinsot {

inline constexpr const char* compare_file_name = "compare.toml";

// The limits of all pictures, and of those whose names match a glob: * stands for any characters, ?
// for one. A later entry overrides an earlier one.
struct CompareFile {
    struct Entry {
        std::string glob;
        SourceLocation where;  // of the glob
        GivenLimits given;
    };
    std::string name;  // of the file, for messages
    GivenLimits all;
    std::vector<Entry> entries;

    GivenLimits given_limits_of(std::string_view picture) const;
    // Throws InputError for an entry that matches none of the pictures, with its place.
    void check_used(const std::vector<std::string>& pictures) const;
};

// Whether a glob matches all of a name.
bool matches_glob(std::string_view name, std::string_view glob);

// Reads the file's text. Throws InputError `FILE:LINE:COLUMN: …` for an unknown key or a wrong
// value.
CompareFile parse_compare_file(std::string_view text, const std::string& name);

// Reads the file of a folder of baselines; empty if there is none. Throws InputError,
// EnvironmentError.
std::optional<CompareFile> read_compare_file(const std::filesystem::path& folder);

}  // namespace poinsot
