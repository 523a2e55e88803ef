// Writers of mesh files, to test the readers with any mesh.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>
#include <string>

#include "bodies/triangle_mesh.h"

namespace poinsot::mesh_files {

inline std::string obj_text(const TriangleMesh& mesh) {
    std::string text = "# a comment\no solid\n";
    for (const Eigen::Vector3d& v : mesh.vertices) {
        fmt::format_to(std::back_inserter(text), "v {} {} {}\n", v.x(), v.y(), v.z());
    }
    text += "vn 0 0 1\ns off\n";
    for (const auto& t : mesh.triangles) {
        fmt::format_to(std::back_inserter(text), "f {}//1 {}//1 {}//1\n", t[0] + 1, t[1] + 1,
                       t[2] + 1);
    }
    return text;
}

inline std::string ascii_stl(const TriangleMesh& mesh) {
    std::string text = "solid a name\n";
    for (const auto& t : mesh.triangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const std::uint32_t v : t) {
            const Eigen::Vector3d& p = mesh.vertices[v];
            fmt::format_to(std::back_inserter(text), "      vertex {} {} {}\n", p.x(), p.y(),
                           p.z());
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid a name\n";
}

inline void append_little_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
}

inline std::string binary_stl(const TriangleMesh& mesh) {
    std::string bytes(80, ' ');
    append_little_endian(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) append_little_endian(bytes, 0);
        for (const std::uint32_t v : t) {
            for (const double x : mesh.vertices[v]) {
                append_little_endian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
            }
        }
        bytes += std::string(2, '\0');
    }
    return bytes;
}

}  // namespace poinsot::mesh_files
