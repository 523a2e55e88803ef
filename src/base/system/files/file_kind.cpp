#include "system/files/file_kind.h"

#include <system_error>

namespace poinsot {

namespace fs = std::filesystem;

FileKind kind_of_file(const fs::path& path) noexcept {
    std::error_code failed;
    switch (fs::status(path, failed).type()) {
        case fs::file_type::regular:
            return FileKind::regular;
        case fs::file_type::directory:
            return FileKind::folder;
        case fs::file_type::not_found:
            return FileKind::missing;
        case fs::file_type::none:
            return failed == std::errc::too_many_symbolic_link_levels ? FileKind::link_circle
                   : failed == std::errc::filename_too_long           ? FileKind::name_too_long
                                                                      : FileKind::unreachable;
        default:
            return FileKind::special;
    }
}

std::string_view in_words(FileKind kind) {
    switch (kind) {
        case FileKind::regular:
            return "a regular file";
        case FileKind::missing:
            return "no such file";
        case FileKind::folder:
            return "this is a folder";
        case FileKind::link_circle:
            return "a symbolic link that leads back to itself; remove it";
        case FileKind::name_too_long:
            return "the name is too long; a name has at most 255 bytes";
        case FileKind::unreachable:
            return "cannot be reached; check the permissions of the folders above it";
        case FileKind::special:
            break;
    }
    return "a pipe or a device, not a regular file; name a file on the disk";
}

}  // namespace poinsot
