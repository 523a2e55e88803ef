// Reads triangle meshes from Wavefront OBJ and from STL (binary or ASCII).
//
// Coordinates are taken as metres; the formats have no unit. Every count in a file is checked
// against the file's size before memory is allocated. All readers throw InputError:
// "file:line:column: what; what to do" for text, "file: byte n: …" for binary STL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "bodies/solid_check.h"
#include "bodies/triangle_mesh.h"

namespace poinsot {

// Larger meshes are rejected.
constexpr std::size_t largest_mesh_bytes = std::size_t{256} << 20;
constexpr std::size_t most_mesh_triangles = 5'000'000;
constexpr std::size_t most_mesh_vertices = 5'000'000;
constexpr double largest_mesh_coordinate_m = 1e30;

// Reads OBJ: v and f lines (v, v/vt, v//vn and v/vt/vn; negative indices count back from the last
// vertex read). Polygons are cut into fans, so they must be convex. Other lines are ignored. `name`
// is the file name for messages. Source: Wavefront, Advanced Visualizer manual, appendix B1.
TriangleMesh read_obj(std::string_view text, std::string_view name);

// Reads STL and welds vertices of equal position. A file of exactly 84 + 50 n bytes, n as stored at
// byte 80, is binary; otherwise a file that begins with "solid" is ASCII. The normals in the file
// are ignored: the order of a facet's vertices defines its outside. Source: 3D Systems,
// StereoLithography Interface Specification (1989).
TriangleMesh read_stl(std::string_view bytes, std::string_view name);

// Reads the solid in an .obj or .stl file, checked and repaired by checked_solid. Throws InputError
// also for bytes that are too many and for another type of file.
SolidMesh read_solid(std::string_view bytes, const std::string& name);

// The checks that are possible before the bytes are read. Throw InputError.
void check_mesh_name(const std::string& name);
void check_mesh_size(std::uintmax_t n_bytes, const std::string& name);

}  // namespace poinsot
