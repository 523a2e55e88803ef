#include "bodies/files/mesh_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>
#include <system_error>

#include "bodies/mesh_reader.h"
#include "error/error.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_mesh(const fs::path& file, std::string_view what) {
    throw InputError(fmt::format("{}: {}", printable(file.string()), what));
}

}  // namespace

std::string bytes_of_mesh_file(const fs::path& file) {
    check_mesh_name(file.string());
    const FileKind kind = kind_of_file(file);
    if (kind == FileKind::missing) refuse_mesh(file, "no such file; name an .obj or .stl file");
    if (kind == FileKind::folder)
        refuse_mesh(file, "this is a folder; name an .obj or .stl file in it");
    if (kind != FileKind::regular) refuse_mesh(file, in_words(kind));
    std::error_code failed;
    const std::uintmax_t size = fs::file_size(file, failed);
    if (failed) refuse_mesh(file, "its size cannot be found; check its permissions");
    check_mesh_size(size, file.string());
    return read_beginning(file, largest_mesh_bytes);
}

}  // namespace poinsot
