// Files that are written beside a film without being named by the user.
#pragma once

#include <filesystem>
#include <string_view>

namespace poinsot {

// Throws as check_replaceable does unless nothing is beside a film, or a sealed text that begins
// so. `contents`: such as "captions".
void check_sidecar(const std::filesystem::path& path, std::string_view beginning,
                   std::string_view contents);

// Removes such a text, which an earlier film of the same name left.
void remove_stale_sidecar(const std::filesystem::path& path, std::string_view beginning);

}  // namespace poinsot
