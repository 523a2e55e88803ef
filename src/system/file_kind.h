// What a name on the disk means, asked before it is opened: reading a pipe may never end, and a
// device has no size.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace poinsot {

enum class FileKind {
    regular,      // a file that has a size and an end
    missing,      // nothing of that name
    folder,       //
    link_circle,  // symbolic links that lead back to themselves
    unreachable,  // a folder on the way to it may not be entered
    special       // a pipe, a socket or a device
};

// Symbolic links are followed.
FileKind kind_of_file(const std::filesystem::path& path) noexcept;

// What it is instead of a file, as the predicate of a message: "a pipe or a device, not a regular
// file". Precondition: not regular.
std::string_view in_words(FileKind kind);

// What a name ends in, as ".png", in small letters: a.PNG and a.png are files of one kind. Letters
// other than A to Z stay as they are.
std::string suffix_of(const std::filesystem::path& path);

}  // namespace poinsot
