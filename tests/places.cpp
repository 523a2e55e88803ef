#include "places.h"

#include <algorithm>

namespace poinsot {

std::filesystem::path source_folder() { return POINSOT_SOURCE_DIR; }

std::vector<std::filesystem::path> supplied_scenes() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "scenes"))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace poinsot
