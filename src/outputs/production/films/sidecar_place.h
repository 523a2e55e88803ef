// Files that are written beside a film without being named by the user.
#pragma once

#include <filesystem>
#include <string_view>

namespace poinsot {

// Throws InputError if a file beside a film exists and does not begin as poinsot's files of this
// kind, and as check_aside does. `contents`: such as "captions".
void check_sidecar(const std::filesystem::path& path, std::string_view beginning,
                   std::string_view contents);

}  // namespace poinsot
