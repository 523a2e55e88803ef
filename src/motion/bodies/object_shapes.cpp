#include "bodies/object_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bodies/circle.h"

namespace poinsot {

namespace {

using Index = std::uint32_t;

// One sector, from facet first to facet last: the revolved profile and its two side walls.
TriangleMesh one_sector(std::span<const ProfilePoint> profile, int first, int last, int facets) {
    const double factor = equal_area_factor(facets);
    const auto n = static_cast<Index>(profile.size());
    TriangleMesh mesh;
    for (int i = first; i <= last; ++i) {
        for (const ProfilePoint& p : profile) {
            const Eigen::Vector2d at = p.radius_m * factor * on_unit_circle(i, facets);
            mesh.vertices.emplace_back(at.x(), at.y(), p.z_m);
        }
    }
    const auto n_steps = static_cast<Index>(last - first);
    for (Index step = 0; step < n_steps; ++step) {
        for (Index i = 0; i < n; ++i) {
            const Index a = step * n + i;
            const Index b = step * n + (i + 1) % n;
            mesh.triangles.push_back({a, a + n, b + n});
            mesh.triangles.push_back({a, b + n, b});
        }
    }
    // The walls are fans from a point off the axis: they then share only the edges on the axis
    // itself.
    const auto apex = static_cast<Index>(
        std::ranges::find_if(profile, [](const ProfilePoint& p) { return p.radius_m > 0.0; }) -
        profile.begin());
    for (Index i = 1; i + 1 < n; ++i) {
        const Index end = n_steps * n;
        const Index b = (apex + i) % n;
        const Index c = (apex + i + 1) % n;
        mesh.triangles.push_back({apex, b, c});
        mesh.triangles.push_back({end + apex, end + c, end + b});
    }
    // Points on the axis coincide in all facets: merge them.
    return welded(mesh);
}

// The boundary of an open surface, as edges in the direction of their triangles.
std::vector<std::array<Index, 2>> rim_of(const TriangleMesh& mesh) {
    std::vector<std::array<Index, 2>> edges;
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
    }
    std::vector<std::array<Index, 2>> sorted = edges;
    std::ranges::sort(sorted);
    std::erase_if(edges, [&](const std::array<Index, 2>& e) {
        return std::ranges::binary_search(sorted, std::array<Index, 2>{e[1], e[0]});
    });
    return edges;
}

// The triangles of which all corners have these coordinates ≥ 0.
TriangleMesh positive_part(TriangleMesh mesh, std::span<const Eigen::Index> coordinates) {
    std::erase_if(mesh.triangles, [&](const auto& t) {
        return std::ranges::any_of(t, [&](Index v) {
            return std::ranges::any_of(coordinates,
                                       [&](Eigen::Index i) { return mesh.vertices[v][i] < 0.0; });
        });
    });
    return mesh;
}

// The first octant of the unit sphere's mesh, closed by triangles to the centre.
TriangleMesh closed_octant(int quarter_facets) {
    TriangleMesh octant =
        positive_part(sphere_mesh(1.0, quarter_facets), std::array<Eigen::Index, 3>{0, 1, 2});
    const auto centre = static_cast<Index>(octant.vertices.size());
    octant.vertices.emplace_back(Eigen::Vector3d::Zero());
    for (const auto& edge : rim_of(octant)) octant.triangles.push_back({centre, edge[1], edge[0]});
    return welded(octant);
}

}  // namespace

TriangleMesh sectors(std::span<const ProfilePoint> profile, int n_sectors,
                     const std::function<bool(int)>& chosen, int facets) {
    std::vector<TriangleMesh> all;
    const int width = facets / n_sectors;
    for (int sector = 0; sector < n_sectors; ++sector) {
        if (!chosen(sector)) continue;
        all.push_back(one_sector(profile, sector * width, (sector + 1) * width, facets));
    }
    return joined(all);
}

TriangleMesh octants(const Eigen::Vector3d& half_axes_m, bool positive, int quarter_facets) {
    const TriangleMesh octant = closed_octant(quarter_facets);
    std::vector<TriangleMesh> all;
    for (const double x : {1.0, -1.0}) {
        for (const double y : {1.0, -1.0}) {
            for (const double z : {1.0, -1.0}) {
                if ((x * y * z > 0.0) != positive) continue;
                const Eigen::Vector3d scale = half_axes_m.cwiseProduct(Eigen::Vector3d(x, y, z));
                all.push_back(placed(octant, Eigen::Affine3d(Eigen::Scaling(scale))));
            }
        }
    }
    return joined(all);
}

TriangleMesh elliptic_ring(const EllipticBar& bar, int facets) {
    constexpr int around = 24;
    const double factor = equal_area_factor(around);
    TriangleMesh mesh;
    for (int i = 0; i < facets; ++i) {
        const Eigen::Vector2d u = on_unit_circle(i, facets);
        const Eigen::Vector3d centre(0.0, bar.half_axis_y_m * u.x(), bar.half_axis_z_m * u.y());
        const Eigen::Vector3d outward =
            Eigen::Vector3d(0.0, u.x() / bar.half_axis_y_m, u.y() / bar.half_axis_z_m).normalized();
        for (int j = 0; j < around; ++j) {
            const Eigen::Vector2d w = factor * on_unit_circle(j, around);
            mesh.vertices.emplace_back(centre + bar.half_width_in_plane_m * w.x() * outward +
                                       bar.half_width_across_m * w.y() * Eigen::Vector3d::UnitX());
        }
    }
    for (int i = 0; i < facets; ++i) {
        for (int j = 0; j < around; ++j) {
            const auto at = [&](int ring, int point) {
                return static_cast<Index>(ring % facets * around + point % around);
            };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

TriangleMesh straight_bar(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m,
                          double half_width_across_m, double half_width_in_plane_m) {
    const Eigen::Vector3d along = (to_m - from_m).normalized();
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.linear().col(0) = half_width_across_m * Eigen::Vector3d::UnitX();
    placement.linear().col(1) = half_width_in_plane_m * along.cross(Eigen::Vector3d::UnitX());
    placement.linear().col(2) = to_m - from_m;
    placement.translation() = 0.5 * (from_m + to_m);
    return placed(cylinder_mesh(1.0, 1.0, 24), placement);
}

TriangleMesh rod_on_bar(double bar_radius_m, double rod_radius_m, double rod_length_m) {
    // The end that meets the bar is a disc of rings, which is bent onto the bar's surface below.
    constexpr int n_rings = 12;
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= n_rings; ++i) profile.push_back({rod_radius_m * i / n_rings, 0.0});
    profile.push_back({rod_radius_m, bar_radius_m + rod_length_m});
    profile.push_back({0.0, bar_radius_m + rod_length_m});
    TriangleMesh rod = revolved(profile, 64);
    for (Eigen::Vector3d& v : rod.vertices) {
        if (v.z() == 0.0) v.z() = std::sqrt(bar_radius_m * bar_radius_m - v.x() * v.x());
    }
    // Mirrors one quarter into the others, so that the facets are as symmetric as the rod.
    const TriangleMesh quarter = positive_part(std::move(rod), std::array<Eigen::Index, 2>{0, 1});
    std::vector<TriangleMesh> quarters;
    for (const double x : {1.0, -1.0}) {
        for (const double y : {1.0, -1.0}) {
            quarters.push_back(placed(quarter, Eigen::Affine3d(Eigen::Scaling(x, y, 1.0))));
        }
    }
    // Turns z into −y and y into z.
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.linear() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    return placed(welded(joined(quarters)), placement);
}

TriangleMesh octagonal_prism(double width_x_m, double width_y_m, double cut_m, double z_low_m,
                             double z_high_m) {
    const double x = 0.5 * width_x_m;
    const double y = 0.5 * width_y_m;
    const std::array<Eigen::Vector2d, 8> base{{{x, -y + cut_m},
                                               {x, y - cut_m},
                                               {x - cut_m, y},
                                               {-x + cut_m, y},
                                               {-x, y - cut_m},
                                               {-x, -y + cut_m},
                                               {-x + cut_m, -y},
                                               {x - cut_m, -y}}};
    return prism(base, z_low_m, z_high_m);
}

TriangleMesh cut_ellipsoid(const Eigen::Vector3d& half_axes_m, double cut_z_m, bool keep_below) {
    if (!keep_below) {
        return placed(cut_ellipsoid(half_axes_m, -cut_z_m, true),
                      Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, -1.0)));
    }
    // The unit sphere's profile from its lower pole to the plane, in equal angular steps.
    constexpr int n_steps = 40;
    const double cut_angle = std::acos(-cut_z_m / half_axes_m.z());
    std::vector<ProfilePoint> profile{{0.0, -1.0}};
    for (int i = 1; i <= n_steps; ++i) {
        const double angle = cut_angle * i / n_steps;
        profile.push_back({std::sin(angle), -std::cos(angle)});
    }
    profile.push_back({0.0, profile.back().z_m});
    return placed(revolved(profile, 96), Eigen::Affine3d(Eigen::Scaling(half_axes_m)));
}

}  // namespace poinsot
