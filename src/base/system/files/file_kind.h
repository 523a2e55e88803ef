// The kind of a file, checked before opening: reading a pipe may never end, and a device has no
// size.
#pragma once

#include <filesystem>
#include <string_view>

#include "system/suffix.h"

namespace poinsot {

enum class FileKind {
    regular,      // a file with a size and an end
    missing,      // no file of this name
    folder,       //
    link_circle,  // a cycle of symbolic links
    name_too_long,
    unreachable,  // a parent folder has no permission
    special       // a pipe, a socket or a device
};

// Follows symbolic links.
FileKind kind_of_file(const std::filesystem::path& path) noexcept;

// A description for messages: "a pipe or a device, not a regular file". Precondition: not regular.
std::string_view in_words(FileKind kind);

}  // namespace poinsot
