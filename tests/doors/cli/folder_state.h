// What lies in a folder, as text.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_run.h"

namespace poinsot::testing {

// Every entry below a folder with its kind and contents, links not followed.
inline std::string state_of(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::vector<std::string> lines;
    for (auto at = fs::recursive_directory_iterator(folder);
         at != fs::recursive_directory_iterator(); ++at) {
        const fs::file_status status = at->symlink_status();
        std::string line = at->path().string() + " " +
                           std::to_string(static_cast<int>(status.type())) + " " +
                           std::to_string(static_cast<int>(status.permissions()));
        if (fs::is_regular_file(status)) line += " " + text_of(at->path());
        if (fs::is_symlink(status)) line += " -> " + fs::read_symlink(at->path()).string();
        lines.push_back(line);
    }
    std::sort(lines.begin(), lines.end());
    std::string state;
    for (const std::string& line : lines) state += line + "\n";
    return state;
}

}  // namespace poinsot::testing
