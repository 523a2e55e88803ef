// Meshes, and pictures on their faces at points projected by a pinhole camera.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>

#include "painted_face.h"
#include "pictures.h"
#include "pinhole.h"

namespace poinsot::testing {
namespace {

MeshGeometry square(std::uint64_t id, double half_side, double z) {
    MeshGeometry mesh;
    mesh.id = id;
    const auto h = static_cast<float>(half_side);
    const auto at = static_cast<float>(z);
    for (const auto& [x, y] : {std::pair{-h, -h}, {h, -h}, {h, h}, {-h, -h}, {h, h}, {-h, h}}) {
        mesh.positions.emplace_back(x, y, at);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    return mesh;
}

TEST(MeshPicture, HidesItsFarPartsAndObjectsBehindIt) {
    Drawing drawing = flat_drawing(100, 100, 100.0);
    View& view = drawing.views[0];
    const MeshGeometry near_square = square(9401, 20.0, 5.0), far_square = square(9402, 30.0, -5.0);
    Mesh nearer;
    nearer.geometry = &near_square;
    nearer.colour = {1.0, 0.0, 0.0};
    Mesh farther;
    farther.geometry = &far_square;
    farther.colour = {0.0, 0.0, 1.0};
    view.meshes = {nearer, farther};
    const CurveGeometry line = curve_of(
        9403, 2, false, [](double t) { return Eigen::Vector3d(-45.0 + 90.0 * t, 0.0, 0.0); });
    Curve curve;
    curve.geometry = &line;
    curve.colour = {0.0, 1.0, 0.0};
    curve.width_px = 6.0;
    curve.hidden = HiddenStyle::absent;
    view.curves = {curve};
    const Image image = renderer().render(drawing);
    EXPECT_GT(image.at(50, 40).r, 2 * image.at(50, 40).b);
    EXPECT_GT(image.at(75, 40).b, 2 * image.at(75, 40).r);
    // The line is behind the near square and in front of the far one.
    EXPECT_GT(image.at(50, 50).r, 2 * image.at(50, 50).g);
    EXPECT_GT(image.at(75, 50).g, 2 * image.at(75, 50).b);
    EXPECT_EQ(image.at(50, 15).a, 0);
    EXPECT_EQ(image.at(50, 25).a, 255);
}

TEST(MeshPicture, IsLitOnTheVisibleSide) {
    // A square in the plane z = 0, lit from above and seen at 4 degrees, with its smooth normals
    // turned by 10 degrees away from the eye: the visible side is still the upper side. From below,
    // the visible side is the lower one, lit as if its normals pointed down.
    const auto picture = [](double eye_z, double tilt_rad, float side) {
        MeshGeometry geometry = square(9410, 30.0, 0.0);
        for (Eigen::Vector3f& normal : geometry.normals)
            normal = side * Eigen::Vector3f(0.0f, static_cast<float>(std::sin(tilt_rad)),
                                            static_cast<float>(std::cos(tilt_rad)));
        static std::uint64_t id = 9410;
        geometry.id = ++id;
        Drawing drawing = flat_drawing(100, 100, 100.0);
        View& view = drawing.views[0];
        view.camera.eye = {0.0, -10.0, eye_z};
        view.camera.up = Eigen::Vector3d::UnitZ();
        view.light.towards = Eigen::Vector3d::UnitZ();
        Mesh mesh;
        mesh.geometry = &geometry;
        view.meshes = {mesh};
        return renderer().render(drawing).at(50, 50).g;
    };
    const int above = picture(0.7, 0.0, 1.0f), below = picture(-0.7, 0.0, 1.0f);
    EXPECT_GT(above, below + 40);
    EXPECT_NEAR(picture(0.7, 0.17, 1.0f), above, 8);
    EXPECT_EQ(picture(-0.7, 0.0, -1.0f), below);
}

TEST(MeshPicture, HasSmoothEdges) {
    Drawing drawing = flat_drawing(100, 100, 100.0);
    const MeshGeometry geometry = square(9404, 30.0, 0.0);
    Mesh mesh;
    mesh.geometry = &geometry;
    mesh.placement.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
    drawing.views[0].meshes = {mesh};
    // Four samples per pixel give the position of an edge to an eighth of a pixel at worst.
    EXPECT_NEAR(covered_px(renderer().render(drawing)), 3600.0, 0.125 * 240.0 / 4.0);
}

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
