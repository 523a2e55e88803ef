// Checks whether a mesh is the surface of a solid: closed, consistently oriented, enclosing a
// volume.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bodies/triangle_mesh.h"

namespace poinsot {

// Edges that violate closedness: in a solid, every edge belongs to exactly two triangles, which run
// along it in opposite directions.
struct EdgeFaults {
    std::size_t n_open = 0;      // in one triangle: the edge of a hole
    std::size_t n_crowded = 0;   // in more than two triangles
    std::size_t n_reversed = 0;  // in two triangles with the same direction: one of them is flipped
    // The ends of the first faulty edge in m; open edges come first.
    std::optional<std::array<Eigen::Vector3d, 2>> first_m;

    bool none() const { return n_open + n_crowded + n_reversed == 0; }
};

// Counts the edge faults of a mesh. Precondition: equal positions are one vertex (see welded).
EdgeFaults edge_faults(const TriangleMesh& mesh);

// A mesh ready for mass properties, and the repairs that were made, as sentences.
struct SolidMesh {
    TriangleMesh mesh;
    std::vector<std::string> notes;
};

// Welds the mesh, removes triangles that have lost an edge, requires a closed surface, and flips
// the pieces that are inside out (pieces inside another one are cavities and stay). `name` is the
// file name for messages. Throws InputError if the surface is not closed, with the number and place
// of the faulty edges, and if it encloses no volume.
SolidMesh checked_solid(const TriangleMesh& mesh, std::string_view name);

}  // namespace poinsot
