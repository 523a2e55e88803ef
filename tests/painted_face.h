// A face with a picture, for the tests of both renderers.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "shapes/views.h"

namespace poinsot::testing {

using Rgb = std::array<std::uint8_t, 3>;
inline constexpr std::array<Rgb, 4> quarters{
    {{200, 30, 40}, {30, 160, 60}, {40, 60, 190}, {230, 220, 90}}};

// A rectangle 2 × 1.2 about the origin across z, its picture upright when seen from +z.
inline MeshGeometry page(std::uint64_t id) {
    MeshGeometry mesh;
    mesh.id = id;
    for (const Eigen::Vector2f& place :
         {Eigen::Vector2f(0, 1), Eigen::Vector2f(1, 1), Eigen::Vector2f(1, 0),
          Eigen::Vector2f(0, 1), Eigen::Vector2f(1, 0), Eigen::Vector2f(0, 0)}) {
        mesh.positions.emplace_back(2.0f * place.x() - 1.0f, 0.6f - 1.2f * place.y(), 0.0f);
        mesh.normals.push_back(Eigen::Vector3f::UnitZ());
        mesh.places.push_back(place);
    }
    return mesh;
}

// Upper left, upper right, lower left, lower right.
inline SurfacePicture of_quarters(int side_px) {
    SurfacePicture picture{side_px, side_px, {}};
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x)
            for (const std::uint8_t level :
                 quarters[static_cast<std::size_t>((2 * y / side_px) * 2 + 2 * x / side_px)])
                picture.rgb.push_back(level);
    return picture;
}

inline Drawing drawing_of(const MeshGeometry& geometry, const Eigen::Affine3d& placement,
                          const Rgb& colour) {
    Drawing drawing;
    drawing.width_px = 480;
    drawing.height_px = 320;
    View& view = drawing.views.emplace_back();
    view.width_px = 480;
    view.height_px = 320;
    view.camera.eye = {1.5, -2.0, 4.0};
    view.camera.target = {0.1, 0.05, 0.0};
    view.camera.up = Eigen::Vector3d::UnitY();
    Mesh& mesh = view.meshes.emplace_back();
    mesh.geometry = &geometry;
    mesh.placement = placement;
    mesh.colour = {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0};
    return drawing;
}

}  // namespace poinsot::testing
