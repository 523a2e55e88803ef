// Finds where a closed surface covers space twice: crossing triangles, and pieces inside one
// another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "bodies/triangle_mesh.h"

namespace poinsot {

// The overlaps found in a mesh; the search is limited in work.
struct Overlaps {
    std::optional<Eigen::Vector3d> first_crossing_m;  // where an edge passes through a triangle
    std::size_t n_nested = 0;  // solid pieces inside another solid, or cavities outside of one
    bool all_looked_at = true;
};

// Searches for overlaps. Precondition: the mesh is closed and welded; piece_of_triangle numbers its
// connected pieces; outer pieces face outwards and cavities inwards.
Overlaps overlaps_of(const TriangleMesh& mesh, std::span<const std::uint32_t> piece_of_triangle,
                     std::size_t n_pieces);

}  // namespace poinsot
