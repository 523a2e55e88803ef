// The elementary solids, each as a real object in colours that make its rotation visible. The
// sources of their numbers are in the table in named_objects.cpp.
#include "bodies/circle.h"
#include "bodies/object_makers.h"
#include "bodies/object_shapes.h"
#include "bodies/solid_meshes.h"

namespace poinsot::object_makers {

namespace {

// The closed profile of a cylinder about the axis.
std::vector<ProfilePoint> cylinder_profile(double radius_m, double height_m) {
    const double h = 0.5 * height_m;
    return {{0.0, -h}, {radius_m, -h}, {radius_m, h}, {0.0, h}};
}

}  // namespace

std::vector<ObjectPart> box() {
    return {{"brick", box_mesh({0.065, 0.1025, 0.215}), {0.66, 0.32, 0.24}, 1900.0}};
}

std::vector<ObjectPart> cylinder() {
    constexpr double size_m = 0.03917;
    const std::vector<ProfilePoint> profile = cylinder_profile(0.5 * size_m, size_m);
    return of_mass({{"sectors", sectors(profile, 8, even_sector), {0.80, 0.80, 0.82}},
                    {"other sectors", sectors(profile, 8, odd_sector), {0.62, 0.63, 0.66}}},
                   1.0);
}

std::vector<ObjectPart> cone() {
    constexpr double radius_m = 0.05;
    constexpr double height_m = 0.15;
    constexpr double maple_kg_m3 = 705.0;
    const std::vector<ProfilePoint> profile{
        {0.0, -0.25 * height_m}, {radius_m, -0.25 * height_m}, {0.0, 0.75 * height_m}};
    return {{"sectors", sectors(profile, 8, even_sector), {0.80, 0.62, 0.40}, maple_kg_m3},
            {"other sectors", sectors(profile, 8, odd_sector), {0.66, 0.47, 0.28}, maple_kg_m3}};
}

std::vector<ObjectPart> ellipsoid() {
    const Eigen::Vector3d half_axes_m(513e3, 852e3, 1161e3);
    constexpr double density_kg_m3 = 1885.0;
    return {{"octants", octants(half_axes_m, true, 32), {0.84, 0.84, 0.86}, density_kg_m3},
            {"other octants", octants(half_axes_m, false, 32), {0.70, 0.68, 0.68}, density_kg_m3}};
}

std::vector<ObjectPart> sphere() {
    const Eigen::Vector3d half_axes_m = Eigen::Vector3d::Constant(0.5 * 0.05715);
    return of_mass({{"octants", octants(half_axes_m, true, 32), {0.93, 0.90, 0.82}},
                    {"other octants", octants(half_axes_m, false, 32), {0.75, 0.13, 0.13}}},
                   0.163);
}

// Four white bands on the red ring.
std::vector<ObjectPart> torus() {
    const std::vector<ProfilePoint> tube = tube_profile(0.3, 0.1, 40);
    return of_mass({{"ring",
                     sectors(tube, 16, [](int sector) { return sector % 4 != 0; }),
                     {0.85, 0.30, 0.10}},
                    {"bands",
                     sectors(tube, 16, [](int sector) { return sector % 4 == 0; }),
                     {0.94, 0.94, 0.92}}},
                   2.5);
}

}  // namespace poinsot::object_makers
