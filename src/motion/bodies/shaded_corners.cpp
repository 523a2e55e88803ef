#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bodies/triangle_mesh.h"

namespace poinsot {

namespace {

// Corner 3t+i is vertex i of triangle t.
struct Corner {
    std::uint32_t vertex, next, previous;
    double angle_rad;  // of the triangle, at the vertex
};

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    // The form with atan2 is accurate for small angles and for angles near π.
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::vector<Eigen::Vector3d> normals_of_triangles(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3d> normals;
    normals.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d& a = mesh.vertices[t[0]];
        const Eigen::Vector3d n = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        // A degenerate triangle has no normal; any unit vector will do, since it covers no pixel.
        normals.emplace_back(n.norm() > 0.0 ? n.stableNormalized() : Eigen::Vector3d::UnitZ());
    }
    return normals;
}

std::vector<Corner> corners_of(const TriangleMesh& mesh) {
    std::vector<Corner> corners;
    corners.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d& at = mesh.vertices[t[i]];
            const std::uint32_t next = t[(i + 1) % 3];
            const std::uint32_t previous = t[(i + 2) % 3];
            corners.push_back(
                {t[i], next, previous,
                 angle_between(mesh.vertices[next] - at, mesh.vertices[previous] - at)});
        }
    }
    return corners;
}

// Corners grouped by vertex: those of vertex v are order[first[v]] … order[first[v + 1] - 1].
struct Fans {
    std::vector<std::uint32_t> first, order;
};

Fans fans_of(const std::vector<Corner>& corners, std::size_t n_vertices) {
    Fans fans;
    fans.first.assign(n_vertices + 1, 0);
    for (const Corner& c : corners) ++fans.first[c.vertex + 1];
    std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
    fans.order.resize(corners.size());
    std::vector<std::uint32_t> place(fans.first.begin(), fans.first.end() - 1);
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
        fans.order[place[corners[c].vertex]++] = c;
    }
    return fans;
}

// Sets of corners of one vertex that are connected by smooth edges.
class SmoothSets {
 public:
    explicit SmoothSets(std::size_t n) : parent_(n) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

 private:
    std::vector<std::uint32_t> parent_;
};

class Shading {
 public:
    Shading(const TriangleMesh& mesh, double crease_angle_rad)
        : normals_(normals_of_triangles(mesh)),
          corners_(corners_of(mesh)),
          sets_(corners_.size()),
          crease_angle_rad_(crease_angle_rad) {
        const Fans fans = fans_of(corners_, mesh.vertices.size());
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            join_fan({fans.order.begin() + fans.first[v], fans.order.begin() + fans.first[v + 1]});
        }
    }

    // The normals of all corners.
    std::vector<Eigen::Vector3d> corner_normals() {
        std::vector<Eigen::Vector3d> sums(corners_.size(), Eigen::Vector3d::Zero());
        for (std::uint32_t c = 0; c < corners_.size(); ++c) {
            sums[sets_.root(c)] += corners_[c].angle_rad * normals_[c / 3];
        }
        std::vector<Eigen::Vector3d> chosen;
        chosen.reserve(corners_.size());
        for (std::uint32_t c = 0; c < corners_.size(); ++c) {
            const Eigen::Vector3d& sum = sums[sets_.root(c)];
            const bool leans = angle_between(sum, normals_[c / 3]) > crease_angle_rad_;
            chosen.emplace_back(leans || !(sum.norm() > 0.0) ? normals_[c / 3] : sum.normalized());
        }
        return chosen;
    }

 private:
    // Connects the corners of one vertex across its smooth edges: an edge that leaves the vertex in
    // one triangle returns to it in the neighbouring one.
    void join_fan(std::vector<std::uint32_t> fan) {
        std::vector<std::uint32_t> returning = fan;
        std::ranges::sort(fan, {}, [this](std::uint32_t c) { return corners_[c].next; });
        std::ranges::sort(returning, {}, [this](std::uint32_t c) { return corners_[c].previous; });
        auto other = returning.begin();
        for (const std::uint32_t c : fan) {
            const std::uint32_t next = corners_[c].next;
            while (other != returning.end() && corners_[*other].previous < next) ++other;
            if (other == returning.end()) break;
            if (corners_[*other].previous != next) continue;
            if (angle_between(normals_[c / 3], normals_[*other / 3]) < crease_angle_rad_) {
                sets_.join(c, *other);
            }
        }
    }

    std::vector<Eigen::Vector3d> normals_;
    std::vector<Corner> corners_;
    SmoothSets sets_;
    double crease_angle_rad_;
};

}  // namespace

ShadedCorners shaded_corners(const TriangleMesh& mesh, double crease_angle_rad) {
    ShadedCorners shaded;
    shaded.positions.reserve(3 * mesh.triangles.size());
    shaded.normals.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) {
            shaded.positions.emplace_back(mesh.vertices[v].cast<float>());
        }
    }
    for (const Eigen::Vector3d& n : Shading(mesh, crease_angle_rad).corner_normals()) {
        shaded.normals.emplace_back(n.cast<float>());
    }
    return shaded;
}

}  // namespace poinsot
