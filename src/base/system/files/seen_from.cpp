#include "system/files/seen_from.h"

#include <system_error>

namespace poinsot {

namespace fs = std::filesystem;

fs::path seen_from(const fs::path& folder, const fs::path& file) {
    // The current folder has the empty name, too.
    const fs::path from = folder.empty() ? fs::path(".") : folder;
    // Of a name that the system refuses, the refusal comes from who opens it.
    const auto whole_path = [](const fs::path& path) {
        std::error_code error;
        const fs::path found = fs::weakly_canonical(fs::absolute(path), error);
        return error ? fs::absolute(path).lexically_normal() : found;
    };
    const fs::path whole = whole_path(file);
    const fs::path path = whole.lexically_relative(whole_path(from));
    return path.empty() ? whole : path;
}

}  // namespace poinsot
