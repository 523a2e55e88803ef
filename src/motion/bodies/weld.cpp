#include <algorithm>
#include <limits>
#include <numeric>

#include "bodies/triangle_mesh.h"

namespace poinsot {

namespace {

bool before(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

// For each vertex, the first vertex with the same position. Uses sorting, since chosen coordinates
// could make hashing slow.
std::vector<std::uint32_t> first_with_position(const std::vector<Eigen::Vector3d>& vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        if (before(vertices[a], vertices[b])) return true;
        return !before(vertices[b], vertices[a]) && a < b;
    });
    std::vector<std::uint32_t> first(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && !before(vertices[order[i - 1]], vertices[order[i]]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> first = first_with_position(mesh.vertices);
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    TriangleMesh result;
    result.triangles.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> kept{first[t[0]], first[t[1]], first[t[2]]};
        if (kept[0] == kept[1] || kept[1] == kept[2] || kept[2] == kept[0]) continue;
        result.triangles.push_back(kept);
    }

    // Renumber the remaining vertices in their old order.
    std::vector<std::uint32_t> number(mesh.vertices.size(), unused);
    for (const auto& t : result.triangles) {
        for (const std::uint32_t v : t) number[v] = 0;
    }
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == unused) continue;
        number[v] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[v]);
    }
    for (auto& t : result.triangles) {
        for (std::uint32_t& v : t) v = number[v];
    }
    return result;
}

}  // namespace poinsot
