// Where a closed surface covers space twice: triangles that cross, and pieces within one another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh/triangle_mesh.h"

namespace poinsot {

// What is found of a mesh, looked for within a bound of work.
struct Overlaps {
    std::optional<Eigen::Vector3d> first_crossing_m;  // where an edge passes through a triangle
    std::size_t n_nested = 0;  // pieces whose matter lies in that of another, or cavities outside
    bool all_looked_at = true;
};

// Precondition: the mesh is closed and welded; piece_of_triangle numbers its connected pieces, the
// outer ones turned outwards and cavities inwards.
Overlaps overlaps_of(const TriangleMesh& mesh, std::span<const std::uint32_t> piece_of_triangle,
                     std::size_t n_pieces);

}  // namespace poinsot
