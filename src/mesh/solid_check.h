// Whether a mesh is the surface of a solid: closed, consistently oriented, enclosing a volume.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace poinsot {

// Edges that keep a surface from being closed: in a solid's every edge belongs to exactly two
// triangles, which run along it in opposite directions.
struct EdgeFaults {
    std::size_t n_open = 0;      // in one triangle: the rim of a hole
    std::size_t n_crowded = 0;   // in more than two
    std::size_t n_reversed = 0;  // in two that run the same way: one of them is turned over
    // The ends of the first faulty edge, open ones first, in m.
    std::optional<std::array<Eigen::Vector3d, 2>> first_m;

    bool none() const { return n_open + n_crowded + n_reversed == 0; }
};

// Counts the faults of a mesh whose equal positions are one vertex (see welded).
EdgeFaults edge_faults(const TriangleMesh& mesh);

// A mesh fit for mass properties, and what was changed on the way, in sentences.
struct SolidMesh {
    TriangleMesh mesh;
    std::vector<std::string> notes;
};

// Welds the mesh, drops triangles that have lost an edge, requires a closed surface, and turns
// round the pieces that are inside out (those within another piece are cavities and stay).
// name is the file's, for the messages. Throws InputError, naming how many edges are at fault and
// where, if the surface is not closed, and if it encloses no volume.
SolidMesh checked_solid(const TriangleMesh& mesh, std::string_view name);

}  // namespace poinsot
