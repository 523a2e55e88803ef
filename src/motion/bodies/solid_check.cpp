#include "bodies/solid_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "bodies/mass_properties.h"
#include "bodies/overlaps.h"
#include "error/error.h"
#include "text/printable.h"

namespace poinsot {

namespace {

using Index = std::uint32_t;

// A triangle's edge as one sortable number: lower vertex, higher vertex, direction. The two
// directions of an edge are thus neighbours after sorting. The readers' limits keep vertex numbers
// below 2^31.
using DirectedEdge = std::uint64_t;

DirectedEdge directed_edge(Index from, Index to) {
    return (std::uint64_t{std::min(from, to)} << 32) | (std::uint64_t{std::max(from, to)} << 1) |
           (from < to ? 0u : 1u);
}
bool same_edge(DirectedEdge a, DirectedEdge b) { return a >> 1 == b >> 1; }
Index low_vertex(DirectedEdge edge) { return static_cast<Index>(edge >> 32); }
Index high_vertex(DirectedEdge edge) { return static_cast<Index>((edge >> 1) & 0x7fffffffu); }

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) edges.push_back(directed_edge(t[i], t[(i + 1) % 3]));
    }
    std::ranges::sort(edges);
    return edges;
}

std::string point(const Eigen::Vector3d& p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

std::string plural(std::size_t n, std::string_view one, std::string_view more) {
    return fmt::format("{} {}", n, n == 1 ? one : more);
}

[[noreturn]] void refuse_open(const EdgeFaults& faults, std::string_view name) {
    std::vector<std::string> reasons;
    if (faults.n_open > 0) {
        reasons.push_back(plural(faults.n_open, "edge belongs to one triangle only",
                                 "edges belong to one triangle only"));
    }
    if (faults.n_crowded > 0) {
        reasons.push_back(plural(faults.n_crowded, "edge is shared by more than two triangles",
                                 "edges are shared by more than two triangles"));
    }
    if (faults.n_reversed > 0) {
        reasons.push_back(plural(faults.n_reversed, "edge runs the same way in both its triangles",
                                 "edges run the same way in both their triangles"));
    }
    throw InputError(fmt::format(
        "{}: the surface is not closed: {}, the first from {} to {}; a mesh that is not closed has "
        "no inside, so its inertia is meaningless; {} where the mesh was made and export it again",
        printable(name), fmt::join(reasons, ", "), point((*faults.first_m)[0]),
        point((*faults.first_m)[1]),
        faults.n_open > 0 ? "fill its holes"
                          : (faults.n_crowded > 0 ? "separate the parts that touch along an edge"
                                                  : "make its normals consistent")));
}

// The connected pieces of a surface, as the piece number of each triangle.
class Pieces {
 public:
    explicit Pieces(const TriangleMesh& mesh) : parent_(mesh.vertices.size()) {
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (const auto& t : mesh.triangles) {
            parent_[root(t[1])] = root(t[0]);
            parent_[root(t[2])] = root(t[0]);
        }
        std::vector<Index> number(parent_.size(), 0);
        for (const auto& t : mesh.triangles) {
            Index& n = number[root(t[0])];
            if (n == 0) n = ++n_pieces_;
            of_triangle_.push_back(n - 1);
        }
    }
    std::size_t count() const { return n_pieces_; }
    Index of_triangle(std::size_t t) const { return of_triangle_[t]; }
    std::span<const Index> of_triangles() const { return of_triangle_; }

 private:
    Index root(Index v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }

    std::vector<Index> parent_;
    std::vector<Index> of_triangle_;
    Index n_pieces_ = 0;
};

struct Piece {
    Eigen::AlignedBox3d box;
    double volume_m3 = 0.0;  // negative for an inside-out piece
    bool turned = false;
};

std::vector<Piece> measured(const TriangleMesh& mesh, const Pieces& pieces) {
    std::vector<Piece> result(pieces.count());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const Index v : mesh.triangles[t]) {
            result[pieces.of_triangle(t)].box.extend(mesh.vertices[v]);
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        Piece& piece = result[pieces.of_triangle(t)];
        const Eigen::Vector3d middle = piece.box.center();
        const auto& [a, b, c] = mesh.triangles[t];
        piece.volume_m3 += (mesh.vertices[a] - middle)
                               .dot((mesh.vertices[b] - middle).cross(mesh.vertices[c] - middle)) /
                           6.0;
    }
    return result;
}

// Marks the pieces to flip: every piece with negative volume, except one inside a larger, correctly
// oriented piece (then it is the wall of a cavity). Comparing with the few largest pieces is
// enough, and keeps a mesh of a million pieces fast.
void mark_inside_out(std::vector<Piece>& pieces) {
    constexpr std::size_t n_compared = 64;
    std::vector<const Piece*> outer;
    outer.reserve(pieces.size());
    for (const Piece& piece : pieces) outer.push_back(&piece);
    const auto larger = [](const Piece* a, const Piece* b) {
        return std::abs(a->volume_m3) > std::abs(b->volume_m3);
    };
    const std::size_t n = std::min(n_compared, outer.size());
    std::ranges::partial_sort(outer, outer.begin() + static_cast<std::ptrdiff_t>(n), larger);
    outer.resize(n);
    // In a mesh whose outer pieces are inside out, the cavities are reversed, too.
    const bool reversed = outer.front()->volume_m3 < 0.0;
    for (Piece& piece : pieces) {
        const bool negative = (piece.volume_m3 < 0.0) != reversed;
        const bool cavity = std::ranges::any_of(outer, [&](const Piece* other) {
            return other != &piece && larger(other, &piece) &&
                   (other->volume_m3 < 0.0) == reversed && other->box.contains(piece.box);
        });
        piece.turned = (negative && !cavity) != reversed;
    }
}

void turn_round(TriangleMesh& mesh, const Pieces& pieces, const std::vector<Piece>& measured) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (measured[pieces.of_triangle(t)].turned) {
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        }
    }
}

// Rounding alone gives an empty surface a volume of a few epsilon of its bounding box.
bool encloses_volume(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    double moved_m3 = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        box.extend(mesh.vertices[a]).extend(mesh.vertices[b]).extend(mesh.vertices[c]);
    }
    const Eigen::Vector3d middle = box.center();
    for (const auto& [a, b, c] : mesh.triangles) {
        moved_m3 +=
            std::abs((mesh.vertices[a] - middle)
                         .dot((mesh.vertices[b] - middle).cross(mesh.vertices[c] - middle)));
    }
    const MassProperties properties = mass_properties(mesh);
    return properties.volume_m3 > 1e-12 * moved_m3 / 6.0 &&
           properties.inertia_unit_density.diagonal().minCoeff() > 0.0;
}

// Where the surface covers space twice, mass counts twice. This may be intended, so it is a note,
// not an error.
void note_overlaps(SolidMesh& solid, const Pieces& pieces, std::string_view name) {
    const Overlaps overlaps = overlaps_of(solid.mesh, pieces.of_triangles(), pieces.count());
    if (overlaps.first_crossing_m) {
        solid.notes.push_back(
            fmt::format("{}: the surface crosses itself, first near {}: the mass of overlapping "
                        "parts counts twice; unite the parts where the mesh was made",
                        printable(name), point(*overlaps.first_crossing_m)));
    }
    if (overlaps.n_nested > 0) {
        solid.notes.push_back(
            fmt::format("{}: {} within another: the mass of overlapping parts counts twice; "
                        "reverse the normals of the inner piece to make a cavity, or remove it",
                        printable(name), plural(overlaps.n_nested, "piece lies", "pieces lie")));
    }
    if (!overlaps.all_looked_at) {
        solid.notes.push_back(
            fmt::format("{}: the mesh is too large to check all of it for parts that cross or "
                        "contain each other",
                        printable(name)));
    }
}

}  // namespace

EdgeFaults edge_faults(const TriangleMesh& mesh) {
    EdgeFaults faults;
    bool first_is_open = false;
    const std::vector<DirectedEdge> edges = sorted_edges(mesh);
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && same_edge(edges[end], edges[i])) ++end;
        const std::size_t n = end - i;
        if (n == 1) {
            ++faults.n_open;
        } else if (n > 2) {
            ++faults.n_crowded;
        } else if (edges[i] == edges[i + 1]) {
            ++faults.n_reversed;
        }
        const bool faulty = n != 2 || edges[i] == edges[i + 1];
        if (faulty && (!faults.first_m || (n == 1 && !first_is_open))) {
            faults.first_m = {mesh.vertices[low_vertex(edges[i])],
                              mesh.vertices[high_vertex(edges[i])]};
            first_is_open = n == 1;
        }
        i = end;
    }
    return faults;
}

SolidMesh checked_solid(const TriangleMesh& mesh, std::string_view name) {
    SolidMesh solid{welded(mesh), {}};
    const std::size_t n_dropped = mesh.triangles.size() - solid.mesh.triangles.size();
    if (n_dropped > 0) {
        solid.notes.push_back(fmt::format("{}: {} without area removed", printable(name),
                                          plural(n_dropped, "triangle", "triangles")));
    }
    if (solid.mesh.triangles.empty()) {
        throw InputError(fmt::format("{}: no triangle has an area; export the surface of a solid",
                                     printable(name)));
    }
    if (const EdgeFaults faults = edge_faults(solid.mesh); !faults.none()) {
        refuse_open(faults, name);
    }

    const Pieces pieces(solid.mesh);
    std::vector<Piece> measures = measured(solid.mesh, pieces);
    mark_inside_out(measures);
    const auto n_turned =
        static_cast<std::size_t>(std::ranges::count(measures, true, &Piece::turned));
    if (n_turned == pieces.count()) {
        solid.notes.push_back(fmt::format(
            "{}: the surface was inside out; its normals are reversed", printable(name)));
    } else if (n_turned > 0) {
        solid.notes.push_back(
            fmt::format("{}: {} of {} separate pieces were inside out; their normals are reversed",
                        printable(name), n_turned, pieces.count()));
    }
    if (n_turned > 0) turn_round(solid.mesh, pieces, measures);
    note_overlaps(solid, pieces, name);
    if (!encloses_volume(solid.mesh)) {
        throw InputError(fmt::format(
            "{}: the surface is closed but encloses no volume, so the body has no mass; give the "
            "sheet a thickness",
            printable(name)));
    }
    return solid;
}

}  // namespace poinsot
