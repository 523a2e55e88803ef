#include "bodies/solid_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bodies/circle.h"
#include "bodies/mass_properties.h"
#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

using std::numbers::pi;
using Index = std::uint32_t;

// Collects the circles of the profile's points in order, and the quadrilaterals between them.
class Revolution {
 public:
    explicit Revolution(int facets) : facets_(facets), factor_(equal_area_factor(facets)) {}

    Index circle(const ProfilePoint& p) {
        const auto first = static_cast<Index>(mesh.vertices.size());
        for (int i = 0; i < facets_; ++i) {
            const Eigen::Vector2d at = p.radius_m * factor_ * on_unit_circle(i, facets_);
            mesh.vertices.emplace_back(at.x(), at.y(), p.z_m);
        }
        return first;
    }
    Index pole(double z_m) {
        mesh.vertices.emplace_back(0.0, 0.0, z_m);
        return static_cast<Index>(mesh.vertices.size() - 1);
    }
    void band(Index low, Index high) {
        for (int i = 0; i < facets_; ++i) {
            const auto a = static_cast<Index>(i);
            const auto b = static_cast<Index>((i + 1) % facets_);
            mesh.triangles.push_back({low + a, low + b, high + b});
            mesh.triangles.push_back({low + a, high + b, high + a});
        }
    }
    // A fan of triangles between a pole and a circle above or below it.
    void fan(Index pole, Index circle, bool circle_above) {
        for (int i = 0; i < facets_; ++i) {
            const Index a = circle + static_cast<Index>(i);
            const Index b = circle + static_cast<Index>((i + 1) % facets_);
            if (circle_above) {
                mesh.triangles.push_back({pole, b, a});
            } else {
                mesh.triangles.push_back({pole, a, b});
            }
        }
    }

    TriangleMesh mesh;

 private:
    int facets_;
    double factor_;
};

// A point of one eighth of the unit sphere, from +x over +y to +z: point (i, j) with i + j ≤ n. The
// steps of angle along its three edges are equal, and every permutation of the axes maps the points
// onto each other.
Eigen::Vector3d on_octant(int i, int j, int n) {
    const auto component = [n](int k) { return on_unit_circle(k, 4 * n).y(); };
    return Eigen::Vector3d(component(i), component(j), component(n - i - j)).normalized();
}

// The unit sphere as eight octants, each mirrored from the first; welding merges their edges.
TriangleMesh unit_octasphere(int n) {
    TriangleMesh octant;
    const auto index = [n](int i, int j) {
        // Row i holds n + 1 - i points.
        return static_cast<Index>(i * (n + 1) - i * (i - 1) / 2 + j);
    };
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) octant.vertices.push_back(on_octant(i, j, n));
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
            octant.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
            if (i + j + 1 < n) {
                octant.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
            }
        }
    }
    std::vector<TriangleMesh> octants;
    for (const double x : {1.0, -1.0}) {
        for (const double y : {1.0, -1.0}) {
            for (const double z : {1.0, -1.0}) {
                octants.push_back(placed(octant, Eigen::Affine3d(Eigen::Scaling(x, y, z))));
            }
        }
    }
    return welded(joined(octants));
}

using Sizes = std::span<const double>;

struct SolidRow {
    std::string_view name;
    std::size_t n_sizes;
    TriangleMesh (*make)(Sizes size_m);
};

constexpr double seen_thickness = 0.01;

constexpr std::array<SolidRow, 12> mesh_rows{{
    {"box", 3,
     [](Sizes s) {
         return box_mesh({s[0], s[1], s[2]});
     }},
    {"ellipsoid", 3,
     [](Sizes s) {
         return ellipsoid_mesh({s[0], s[1], s[2]});
     }},
    {"cylinder", 2, [](Sizes s) { return cylinder_mesh(s[0], s[1]); }},
    {"cone", 2, [](Sizes s) { return cone_mesh(s[0], s[1]); }},
    {"sphere", 1, [](Sizes s) { return sphere_mesh(s[0]); }},
    {"torus", 2, [](Sizes s) { return torus_mesh(s[0], s[1]); }},
    {"rod", 2, [](Sizes s) { return cylinder_mesh(s[1], s[0]); }},
    {"disc", 1, [](Sizes s) { return cylinder_mesh(s[0], seen_thickness * s[0]); }},
    {"plate", 2,
     [](Sizes s) {
         return box_mesh({s[0], s[1], seen_thickness * std::max(s[0], s[1])});
     }},
    {"ring", 1, [](Sizes s) { return torus_mesh(s[0], 2.0 * seen_thickness * s[0]); }},
    {"shell", 1, [](Sizes s) { return sphere_mesh(s[0]); }},
    {"tube", 3, [](Sizes s) { return tube_mesh(s[0], s[1], s[2]); }},
}};

}  // namespace

TriangleMesh box_mesh(const Eigen::Vector3d& edges_m) {
    const Eigen::Vector3d h = 0.5 * edges_m;
    const std::array<Eigen::Vector2d, 4> base{
        {{-h.x(), -h.y()}, {h.x(), -h.y()}, {h.x(), h.y()}, {-h.x(), h.y()}}};
    return prism(base, -h.z(), h.z());
}

TriangleMesh ellipsoid_mesh(const Eigen::Vector3d& half_axes_m, int quarter_facets) {
    const TriangleMesh sphere = unit_octasphere(quarter_facets);
    const double equal_volume = std::cbrt(4.0 / 3.0 * pi / mass_properties(sphere).volume_m3);
    return placed(sphere,
                  Eigen::Affine3d(Eigen::Scaling(Eigen::Vector3d(equal_volume * half_axes_m))));
}

TriangleMesh sphere_mesh(double radius_m, int quarter_facets) {
    return ellipsoid_mesh(Eigen::Vector3d::Constant(radius_m), quarter_facets);
}

TriangleMesh cylinder_mesh(double radius_m, double height_m, int facets) {
    const double h = 0.5 * height_m;
    return revolved(
        std::array<ProfilePoint, 4>{{{0.0, -h}, {radius_m, -h}, {radius_m, h}, {0.0, h}}}, facets);
}

TriangleMesh tube_mesh(double inner_radius_m, double outer_radius_m, double height_m, int facets) {
    const double h = 0.5 * height_m;
    return revolved_ring(
        std::array<ProfilePoint, 4>{
            {{inner_radius_m, -h}, {outer_radius_m, -h}, {outer_radius_m, h}, {inner_radius_m, h}}},
        facets);
}

TriangleMesh cone_mesh(double base_radius_m, double height_m, int facets) {
    const double base = -0.25 * height_m;
    return revolved(
        std::array<ProfilePoint, 3>{{{0.0, base}, {base_radius_m, base}, {0.0, 0.75 * height_m}}},
        facets);
}

TriangleMesh torus_mesh(double centre_line_radius_m, double tube_radius_m, int facets,
                        int tube_facets) {
    return revolved_ring(tube_profile(centre_line_radius_m, tube_radius_m, tube_facets), facets);
}

TriangleMesh solid_mesh(std::string_view shape, std::span<const double> size_m) {
    const SolidRow* row = find_row(mesh_rows, shape);
    if (row == nullptr) throw InputError(unknown("shape", shape, names_of(mesh_rows)));
    if (size_m.size() != row->n_sizes) {
        throw InputError(fmt::format("size_m of a {} has {} values, not {}; give {}", shape,
                                     row->n_sizes, size_m.size(), row->n_sizes));
    }
    return row->make(size_m);
}

TriangleMesh revolved(std::span<const ProfilePoint> profile, int facets) {
    Revolution solid(facets);
    const Index bottom = solid.pole(profile.front().z_m);
    Index last = solid.circle(profile[1]);
    solid.fan(bottom, last, true);
    for (const ProfilePoint& p : profile.subspan(2, profile.size() - 3)) {
        const Index circle = solid.circle(p);
        solid.band(last, circle);
        last = circle;
    }
    solid.fan(solid.pole(profile.back().z_m), last, false);
    return std::move(solid.mesh);
}

TriangleMesh revolved_ring(std::span<const ProfilePoint> profile, int facets) {
    Revolution ring(facets);
    const Index first = ring.circle(profile.front());
    Index last = first;
    for (const ProfilePoint& p : profile.subspan(1)) {
        const Index circle = ring.circle(p);
        ring.band(last, circle);
        last = circle;
    }
    ring.band(last, first);
    return std::move(ring.mesh);
}

TriangleMesh prism(std::span<const Eigen::Vector2d> base_m, double z_low_m, double z_high_m) {
    TriangleMesh mesh;
    for (const double z : {z_low_m, z_high_m}) {
        for (const Eigen::Vector2d& p : base_m) mesh.vertices.emplace_back(p.x(), p.y(), z);
    }
    const auto n = static_cast<Index>(base_m.size());
    for (Index i = 0; i < n; ++i) {
        const Index j = (i + 1) % n;
        mesh.triangles.push_back({i, j, n + j});
        mesh.triangles.push_back({i, n + j, n + i});
    }
    for (Index i = 1; i + 1 < n; ++i) {
        mesh.triangles.push_back({0, i + 1, i});
        mesh.triangles.push_back({n, n + i, n + i + 1});
    }
    return mesh;
}

TriangleMesh placed(TriangleMesh mesh, const Eigen::Affine3d& placement) {
    for (Eigen::Vector3d& v : mesh.vertices) v = placement * v;
    return placement.linear().determinant() < 0.0 ? inside_out(std::move(mesh)) : mesh;
}

TriangleMesh joined(std::span<const TriangleMesh> meshes) {
    TriangleMesh all;
    for (const TriangleMesh& mesh : meshes) {
        const auto first = static_cast<Index>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const auto& t : mesh.triangles) {
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    return all;
}

TriangleMesh inside_out(TriangleMesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

}  // namespace poinsot
