#include "system/files/seen_from.h"

namespace poinsot {

namespace fs = std::filesystem;

fs::path seen_from(const fs::path& folder, const fs::path& file) {
    // The current folder has the empty name, too.
    const fs::path from = folder.empty() ? fs::path(".") : folder;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file));
    const fs::path path = whole.lexically_relative(fs::weakly_canonical(fs::absolute(from)));
    return path.empty() ? whole : path;
}

}  // namespace poinsot
