// Mesh files become triangles: Wavefront OBJ and STL, binary or ASCII.
//
// Coordinates are taken as metres; the formats have no unit. Every count in a file is checked
// against the bytes that are there before memory is taken for it. All readers throw InputError:
// "file:line:column: what; what to do" for text, "file: byte n: …" for binary STL.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "mesh/solid_check.h"
#include "mesh/triangle_mesh.h"

namespace poinsot {

// Limits beyond which a mesh is refused.
constexpr std::size_t largest_mesh_bytes = std::size_t{256} << 20;
constexpr std::size_t most_mesh_triangles = 5'000'000;
constexpr std::size_t most_mesh_vertices = 5'000'000;
constexpr double largest_mesh_coordinate_m = 1e30;

// OBJ: v and f lines (v, v/vt, v//vn and v/vt/vn; negative indices count back from the last vertex
// read; a polygon is cut into a fan and so must be convex); all other lines are passed over.
// name is the file's, for the messages. Source: Wavefront, Advanced Visualizer manual, appendix B1.
TriangleMesh read_obj(std::string_view text, std::string_view name);

// STL, vertices of equal position welded. A file of exactly 84 + 50 n bytes, n as it says at byte
// 80, is binary; otherwise one that begins with "solid" is ASCII. The normals in the file are not
// used: the order of a facet's vertices tells its outside. Source: 3D Systems, StereoLithography
// Interface Specification (1989).
TriangleMesh read_stl(std::string_view bytes, std::string_view name);

// The solid in an .obj or .stl file, checked and put right as checked_solid says. Throws InputError
// also for a file that is missing, not a regular file, too large or of another kind.
SolidMesh read_solid(const std::filesystem::path& file);

}  // namespace poinsot
