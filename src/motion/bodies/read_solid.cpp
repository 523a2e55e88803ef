// A mesh file's bytes → a checked solid.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "bodies/mesh_reader.h"
#include "error/error.h"
#include "text/printable.h"

namespace poinsot {

namespace {

[[noreturn]] void refuse(const std::string& name, std::string_view what) {
    throw InputError(fmt::format("{}: {}", printable(name), what));
}

struct MeshFormat {
    std::string_view extension;
    TriangleMesh (*read)(std::string_view bytes, std::string_view name);
};

constexpr std::array<MeshFormat, 2> formats{{{".obj", read_obj}, {".stl", read_stl}}};

const MeshFormat& format_of(const std::string& name) {
    std::string extension = std::filesystem::path(name).extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    for (const MeshFormat& format : formats)
        if (format.extension == extension) return format;
    refuse(name, "not a mesh that can be read; export it as .obj or .stl");
}

}  // namespace

void check_mesh_name(const std::string& name) { format_of(name); }

void check_mesh_size(std::uintmax_t n_bytes, const std::string& name) {
    if (n_bytes > largest_mesh_bytes)
        refuse(name, fmt::format("{} MiB, more than {}; simplify the mesh", n_bytes >> 20,
                                 largest_mesh_bytes >> 20));
}

SolidMesh read_solid(std::string_view bytes, const std::string& name) {
    const MeshFormat& format = format_of(name);
    check_mesh_size(bytes.size(), name);
    if (bytes.empty()) refuse(name, "the file is empty; export the surface of a solid");
    return checked_solid(format.read(bytes, name), name);
}

}  // namespace poinsot
