// Reads a mesh file and returns a checked solid.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include "error/error.h"
#include "mesh/mesh_reader.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, std::string_view what) {
    throw InputError(fmt::format("{}: {}", printable(file.string()), what));
}

std::string bytes_of_file(const fs::path& file) {
    const FileKind kind = kind_of_file(file);
    if (kind == FileKind::missing) refuse(file, "no such file; name an .obj or .stl file");
    if (kind == FileKind::folder) refuse(file, "this is a folder; name an .obj or .stl file in it");
    if (kind != FileKind::regular) refuse(file, in_words(kind));
    std::error_code failed;
    const std::uintmax_t size = fs::file_size(file, failed);
    if (failed || size > largest_mesh_bytes) {
        refuse(file, failed ? "its size cannot be found; check its permissions"
                            : fmt::format("{} MiB, more than {}; simplify the mesh", size >> 20,
                                          largest_mesh_bytes >> 20));
    }

    std::string bytes = read_beginning(file, largest_mesh_bytes);
    if (bytes.empty()) refuse(file, "the file is empty; export the surface of a solid");
    return bytes;
}

struct MeshFormat {
    std::string_view extension;
    TriangleMesh (*read)(std::string_view bytes, std::string_view name);
};

constexpr std::array<MeshFormat, 2> formats{{{".obj", read_obj}, {".stl", read_stl}}};

}  // namespace

SolidMesh read_solid(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    const auto* const format = std::ranges::find(formats, extension, &MeshFormat::extension);
    if (format == formats.end()) {
        refuse(file, "not a mesh that can be read; export it as .obj or .stl");
    }
    return checked_solid(format->read(bytes_of_file(file), file.string()), file.string());
}

}  // namespace poinsot
