#include "bodies/overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace poinsot {

namespace {

using Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;

// A few seconds on a slow machine.
constexpr std::int64_t most_tests = 100'000'000;

Box box_of(const TriangleMesh& mesh, std::size_t t) {
    Box box;
    for (const auto v : mesh.triangles[t]) box.extend(mesh.vertices[v]);
    return box;
}

// The point where a segment passes through a triangle. A segment that ends on the triangle or lies
// in its plane does not cross it. Source: Moeller & Trumbore, Fast, minimum storage ray-triangle
// intersection (1997).
std::optional<Vector3d> crossing(const Vector3d& from, const Vector3d& to, const Vector3d& a,
                                 const Vector3d& b, const Vector3d& c) {
    constexpr double inside = 1e-9;
    const Vector3d ab = b - a, ac = c - a, along = to - from;
    const Vector3d p = along.cross(ac);
    const double determinant = ab.dot(p);
    if (std::abs(determinant) <= 1e-12 * ab.norm() * p.norm()) return std::nullopt;
    const Vector3d offset = from - a;
    const double u = offset.dot(p) / determinant;
    const Vector3d q = offset.cross(ab);
    const double v = along.dot(q) / determinant;
    const double t = ac.dot(q) / determinant;
    if (u < inside || v < inside || u + v > 1.0 - inside || t < inside || t > 1.0 - inside)
        return std::nullopt;
    return from + t * along;
}

// The point where an edge of either triangle, or a line from a corner to its middle, passes through
// the other triangle. The lines to the middle find crossings where all edges of one triangle meet
// edges of the other, as with the diagonals of a cube's faces.
std::optional<Vector3d> crossing_of(const TriangleMesh& mesh, std::size_t s, std::size_t t) {
    for (const auto& [lines_of, through] : {std::pair{s, t}, {t, s}}) {
        const auto corner = [&mesh](std::size_t triangle, std::size_t i) -> const Vector3d& {
            return mesh.vertices[mesh.triangles[triangle][i % 3]];
        };
        const Vector3d middle =
            (corner(lines_of, 0) + corner(lines_of, 1) + corner(lines_of, 2)) / 3.0;
        for (std::size_t i = 0; i < 3; ++i)
            for (const Vector3d& end : {corner(lines_of, i + 1), middle})
                if (auto at = crossing(corner(lines_of, i), end, corner(through, 0),
                                       corner(through, 1), corner(through, 2)))
                    return at;
    }
    return std::nullopt;
}

bool share_a_vertex(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
    return std::any_of(a.begin(), a.end(), [&b](std::uint32_t v) {
        return std::find(b.begin(), b.end(), v) != b.end();
    });
}

// Sweep along x over the bounding boxes of the triangles.
void find_crossing(const TriangleMesh& mesh, std::int64_t& n_tests, Overlaps& found) {
    std::vector<Box> boxes;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) boxes.push_back(box_of(mesh, t));
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&boxes](std::size_t s, std::size_t t) {
        return boxes[s].min().x() < boxes[t].min().x();
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t s = order[i];
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const std::size_t t = order[k];
            if (boxes[t].min().x() > boxes[s].max().x()) break;
            if (--n_tests < 0) {
                found.all_looked_at = false;
                return;
            }
            if (!boxes[s].intersects(boxes[t]) ||
                share_a_vertex(mesh.triangles[s], mesh.triangles[t]))
                continue;
            if ((found.first_crossing_m = crossing_of(mesh, s, t))) return;
        }
    }
}

// Winding number of a piece around a point, by the crossings of a ray in general direction.
int winding_of(const TriangleMesh& mesh, std::span<const std::size_t> triangles,
               const Vector3d& point, double reach_m) {
    const Vector3d end = point + 2.0 * reach_m * Vector3d(0.8191, 0.4736, 0.3237);
    int winding = 0;
    for (const std::size_t t : triangles) {
        const auto& [i, j, k] = mesh.triangles[t];
        const Vector3d &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        if (crossing(point, end, a, b, c))
            winding += (b - a).cross(c - a).dot(end - point) > 0.0 ? 1 : -1;
    }
    return winding;
}

void count_nested(const TriangleMesh& mesh, std::span<const std::uint32_t> piece_of_triangle,
                  std::size_t n_pieces, std::int64_t& n_tests, Overlaps& found) {
    std::vector<std::vector<std::size_t>> triangles(n_pieces);
    std::vector<Box> boxes(n_pieces);
    std::vector<double> volumes(n_pieces, 0.0);
    Box whole;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t piece = piece_of_triangle[t];
        triangles[piece].push_back(t);
        boxes[piece].extend(box_of(mesh, t));
        whole.extend(box_of(mesh, t));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t piece = piece_of_triangle[t];
        const Vector3d middle = boxes[piece].center();
        const auto& [i, j, k] = mesh.triangles[t];
        volumes[piece] += (mesh.vertices[i] - middle)
                              .dot((mesh.vertices[j] - middle).cross(mesh.vertices[k] - middle));
    }
    for (std::size_t inner = 0; inner < n_pieces; ++inner) {
        const Vector3d point = mesh.vertices[mesh.triangles[triangles[inner].front()][0]];
        int depth = 0;
        for (std::size_t outer = 0; outer < n_pieces; ++outer) {
            if (--n_tests < 0) break;
            if (outer == inner || !boxes[outer].contains(boxes[inner])) continue;
            n_tests -= static_cast<std::int64_t>(triangles[outer].size());
            depth += winding_of(mesh, triangles[outer], point, whole.diagonal().norm());
        }
        if (n_tests < 0) {
            found.all_looked_at = false;
            return;
        }
        // A solid piece must begin in empty space, and a cavity inside a solid.
        found.n_nested += depth != (volumes[inner] < 0.0 ? 1 : 0);
    }
}

}  // namespace

Overlaps overlaps_of(const TriangleMesh& mesh, std::span<const std::uint32_t> piece_of_triangle,
                     std::size_t n_pieces) {
    Overlaps found;
    std::int64_t n_tests = most_tests;
    find_crossing(mesh, n_tests, found);
    if (n_pieces > 1 && n_tests >= 0)
        count_nested(mesh, piece_of_triangle, n_pieces, n_tests, found);
    return found;
}

}  // namespace poinsot
