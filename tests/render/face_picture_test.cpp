// Pictures on faces, at points projected by a pinhole camera.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdlib>

#include "../painted_face.h"
#include "../pinhole.h"
#include "pictures.h"

namespace poinsot::testing {
namespace {

// A picture's quarters appear at the face's quarters, each lit like a face of its colour.
TEST(FacePicture, HasPositionAndShadingOfItsFace) {
    Eigen::Affine3d turned = Eigen::Affine3d::Identity();
    turned.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.2, 1.0, 0.3).normalized()));
    turned.translate(Eigen::Vector3d(0.1, -0.1, 0.2));
    // Larger and smaller than the pixels on screen: averaged, and magnified.
    std::uint64_t id = 9700;
    for (const int side_px : {8, 64, 2048}) {
        MeshGeometry face = page(++id);
        face.picture = of_quarters(side_px);
        const Drawing drawing = drawing_of(face, turned, {90, 90, 90});
        const Image seen = renderer().render(drawing);
        for (std::size_t k = 0; k < quarters.size(); ++k) {
            MeshGeometry plain = page(++id);
            plain.places.clear();
            const Image expected = renderer().render(drawing_of(plain, turned, quarters[k]));
            for (const double u : {0.2, 0.25, 0.3})
                for (const double v : {0.2, 0.25, 0.3}) {
                    const double right = u + 0.5 * static_cast<double>(k % 2);
                    const double down = v + 0.5 * static_cast<double>(k / 2);
                    const Eigen::Vector3d point =
                        turned * Eigen::Vector3d(2.0 * right - 1.0, 0.6 - 1.2 * down, 0.0);
                    const Eigen::Vector2d at = Pinhole(drawing.views[0]).place(point);
                    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
                    const Rgba8 a = seen.at(x, y), b = expected.at(x, y);
                    EXPECT_LE(std::abs(a.r - b.r), 1) << side_px << " quarter " << k;
                    EXPECT_LE(std::abs(a.g - b.g), 1) << side_px << " quarter " << k;
                    EXPECT_LE(std::abs(a.b - b.b), 1) << side_px << " quarter " << k;
                }
        }
    }
}

// An object in front of a face covers its picture, in either order of drawing.
TEST(FacePicture, IsHiddenByObjectsInFrontOfIt) {
    MeshGeometry face = page(9790), before = page(9791);
    face.picture = of_quarters(64);
    before.places.clear();
    Drawing drawing =
        drawing_of(before, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5)), {9, 9, 9});
    const Image alone = renderer().render(drawing);
    Mesh behind = drawing.views[0].meshes[0];
    behind.geometry = &face;
    // The front face covers the picture entirely.
    behind.placement = Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.3) * Eigen::Scaling(0.4));
    drawing.views[0].meshes.push_back(behind);
    EXPECT_EQ(n_different(renderer().render(drawing), alone), 0u);
    std::swap(drawing.views[0].meshes[0], drawing.views[0].meshes[1]);
    EXPECT_EQ(n_different(renderer().render(drawing), alone), 0u);
}

}  // namespace
}  // namespace poinsot::testing
