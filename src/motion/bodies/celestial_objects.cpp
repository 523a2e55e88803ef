// Celestial bodies. The sources of their numbers are in the table in named_objects.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bodies/object_makers.h"
#include "bodies/object_shapes.h"
#include "bodies/solid_meshes.h"

namespace poinsot::object_makers {

namespace {

// Half-axes of a spheroid with this equatorial radius and flattening.
Eigen::Vector3d spheroid(double equatorial_m, double flattening) {
    return {equatorial_m, equatorial_m, equatorial_m * (1.0 - flattening)};
}

// Craters and rubble on an ellipsoid. Their places follow a spiral over the sphere, their sizes
// repeat in threes: no map, but a surface that looks like rock from every side.
TriangleMesh cratered(const Eigen::Vector3d& half_axes_m, int n_craters, double first_rad) {
    constexpr double golden_rad = 2.399963229728653;
    TriangleMesh mesh = ellipsoid_mesh(Eigen::Vector3d::Ones(), 32);
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        const Eigen::Vector3d at = vertex.normalized();
        double height = 0.010 * std::sin(7.0 * at.x() + 2.0) * std::sin(8.0 * at.y()) +
                        0.008 * std::sin(13.0 * at.z() + 9.0 * at.x());
        for (int i = 0; i < n_craters; ++i) {
            const double z = 1.0 - (2.0 * i + 1.0) / n_craters;
            const double turn = first_rad + golden_rad * i;
            const double ring = std::sqrt(1.0 - z * z);
            const Eigen::Vector3d middle(ring * std::cos(turn), ring * std::sin(turn), z);
            const double radius_rad = 0.17 + 0.08 * (i * 7 % 3);
            const double depth = 0.22 * radius_rad;
            const double from_middle =
                std::acos(std::clamp(middle.dot(at), -1.0, 1.0)) / radius_rad;
            // A bowl with a raised rim.
            if (from_middle < 1.0) height -= depth * (1.0 - from_middle * from_middle);
            height += 0.3 * depth * std::exp(-std::pow((from_middle - 1.0) / 0.3, 2));
        }
        vertex = ((1.0 + height) * vertex).cwiseProduct(half_axes_m);
    }
    return mesh;
}

double volume_of(const Eigen::Vector3d& half_axes_m) {
    return 4.0 / 3.0 * std::numbers::pi * half_axes_m.prod();
}

}  // namespace

// Axis along z. The densities of mantle and core follow from the total mass and the polar moment C
// = 0.3307 M a². The dynamical flattening (C − A)/C is then 1/305.3 (observed: 1/305.46), and the
// rigid Earth's Euler period A/(C − A) is 304.3 sidereal days.
std::vector<ObjectPart> earth() {
    constexpr double mass_kg = 5.9722e24;
    constexpr double equatorial_m = 6378137.0;
    constexpr double polar_moment = 0.3307;
    constexpr double core_flattening = 1.0 / 393.0;
    const Eigen::Vector3d surface_m = spheroid(equatorial_m, 1.0 / 298.257223563);
    // 3480 km is the radius of the sphere of equal volume.
    const Eigen::Vector3d core_m =
        spheroid(3480e3 / std::cbrt(1.0 - core_flattening), core_flattening);

    // C = 2/5 (mantle density × V a² + excess density of the core × Vc ac²).
    const double volume = volume_of(surface_m);
    const double share = volume_of(core_m) / volume;
    const double squared_radii = core_m.x() * core_m.x() / (equatorial_m * equatorial_m);
    const double excess =
        mass_kg / volume * (1.0 - 2.5 * polar_moment) / (share * (1.0 - squared_radii));
    const double mantle = mass_kg / volume - share * excess;

    const auto shell = [&](bool positive) {
        return joined(std::array<TriangleMesh, 2>{octants(surface_m, positive, 32),
                                                  inside_out(octants(core_m, positive, 12))});
    };
    return {{"mantle octants", shell(true), {0.22, 0.42, 0.66}, mantle},
            {"other mantle octants", shell(false), {0.30, 0.52, 0.74}, mantle},
            {"core", ellipsoid_mesh(core_m, 12), {0.90, 0.55, 0.20}, mantle + excess}};
}

// Long axis along z. Two ellipsoids with the same ratio of widths, cut at the plane in which they
// meet. Their sizes make the whole 4.60 km long, 2.30 and 1.96 km wide, with moments in the ratio
// 3.24 : 3.08 : 1 (the radar model: 3.22 : 3.09 : 1).
std::vector<ObjectPart> toutatis() {
    constexpr double density_kg_m3 = 2500.0;
    constexpr double width_ratio = 0.85;
    const Eigen::Vector3d body_m(width_ratio * 1150.0, 1150.0, 1450.0);
    const Eigen::Vector3d head_m(width_ratio * 650.0, 650.0, 950.0);
    constexpr double head_z_m = 2200.0;

    // In the plane z both ellipsoids have the same half-widths: y²(1 − z²/c²) is equal for body and
    // head.
    double low = head_z_m - head_m.z();
    double high = body_m.z();
    const auto half_width_squared = [](const Eigen::Vector3d& half_axes, double z) {
        const double along = z / half_axes.z();
        return half_axes.y() * half_axes.y() * (1.0 - along * along);
    };
    for (int i = 0; i < 60; ++i) {
        const double z = 0.5 * (low + high);
        const bool body_is_wider =
            half_width_squared(body_m, z) > half_width_squared(head_m, z - head_z_m);
        (body_is_wider ? low : high) = z;
    }
    constexpr std::array<double, 3> rock{0.58, 0.54, 0.49}, pale_rock{0.64, 0.59, 0.52};
    const Eigen::Affine3d to_head(Eigen::Translation3d(0.0, 0.0, head_z_m));
    return centred(
        {{"body", cut_ellipsoid(body_m, low, true), rock, density_kg_m3, PartUse::mass_only},
         {"head", placed(cut_ellipsoid(head_m, low - head_z_m, false), to_head), pale_rock,
          density_kg_m3, PartUse::mass_only},
         {"surface of the body", cratered(body_m, 17, 0.4), rock, 1.0, PartUse::look_only},
         {"surface of the head", placed(cratered(head_m, 9, 1.9), to_head), pale_rock, 1.0,
          PartUse::look_only}});
}

}  // namespace poinsot::object_makers
