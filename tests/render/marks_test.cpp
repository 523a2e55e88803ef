// Arrows, dots, cones, meshes and labels.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pictures.h"
#include "render/passes/label_pass.h"

namespace poinsot::testing {
namespace {

TEST(ArrowPicture, HasTheAreaOfShaftAndHead) {
    Drawing drawing = flat_drawing(200, 100, 100.0);
    Arrow arrow;
    arrow.tail = {-80.0, -10.0, 0.0};
    arrow.tip = {80.0, 20.0, 0.0};
    arrow.shaft_px = 5.0;
    arrow.head_px = 17.0;
    arrow.head_length_px = 24.0;
    drawing.views[0].arrows.push_back(arrow);
    const double length = std::hypot(160.0, 30.0);
    const double expected = (length - 24.0) * 5.0 + 0.5 * 17.0 * 24.0;
    EXPECT_NEAR(covered_px(renderer().render(drawing)), expected, 0.005 * expected);
}

TEST(ArrowPicture, IsADiscWhenItPointsAtTheEye) {
    Drawing drawing = flat_drawing(100, 100, 100.0);
    for (const double way : {-1.0, 1.0}) {
        Arrow arrow;
        arrow.tail = {0.3, 0.2, -30.0 * way};
        arrow.tip = {0.3, 0.2, 30.0 * way};
        arrow.head_px = 30.0;
        drawing.views[0].arrows = {arrow};
        EXPECT_NEAR(covered_px(renderer().render(drawing)), std::numbers::pi * 225.0, 2.5) << way;
    }
}

// As for ω and ρ: the longer arrow is below, and the shorter one, which is drawn later, on top,
// whatever the rounding of either.
TEST(ArrowPicture, LaterOfTwoOnOneLineIsOnTop) {
    const CurveGeometry none = circle(9302, 0.1, -0.8);
    Drawing drawing = lecture_drawing(320, 180, none, none);
    View& view = drawing.views[0];
    view.planes.clear();
    view.ellipsoids.clear();
    view.curves.clear();
    view.dots.clear();
    const Eigen::Vector3d direction = Eigen::Vector3d(0.7, -0.9, 0.4).normalized();
    const auto picture = [&](double bits, bool long_first) {
        Arrow omega, rho;
        omega.tip = (1.0 + bits) * 1.3 * direction;
        omega.colour = {0.6, 0.1, 0.4};
        rho.tip = (1.0 - bits) * direction;
        rho.colour = {0.1, 0.2, 0.6};
        view.arrows = long_first ? std::vector{omega, rho} : std::vector{rho, omega};
        return renderer().render(drawing);
    };
    const Image rho_on_top = picture(0.0, true);
    const Image omega_on_top = picture(0.0, false);
    EXPECT_GT(n_different(rho_on_top, omega_on_top), 50u);
    for (int n = 1; n <= 8; ++n) {
        for (const double bits : {n * 0x1p-52, n * -0x1p-52}) {
            EXPECT_EQ(n_different(picture(bits, true), rho_on_top), 0u) << bits;
            EXPECT_EQ(n_different(picture(bits, false), omega_on_top), 0u) << bits;
        }
    }
}

TEST(ArrowPicture, IsSolidOutsideTheEllipsoid) {
    Drawing drawing = flat_drawing(200, 100, 100.0);
    View& view = drawing.views[0];
    view.background.alpha = drawing.background.alpha = 1.0;
    view.background.top = view.background.bottom = {1.0, 1.0, 1.0};
    Ellipsoid sphere = plain_ellipsoid(30.0 * Eigen::Matrix3d::Identity());
    sphere.colour = {1.0, 1.0, 1.0};
    view.ellipsoids.push_back(sphere);
    const Image bare = renderer().render(drawing);
    Arrow arrow;
    arrow.tip = {80.0, 0.0, 0.0};
    arrow.colour = {0.0, 0.0, 0.0};
    arrow.shaft_px = 8.0;
    arrow.hidden_opacity = 0.3;
    view.arrows.push_back(arrow);
    const Image image = renderer().render(drawing);
    const auto kept = [&](int x) {
        return std::pow(static_cast<double>(image.at(x, 50).g) / bare.at(x, 50).g, 2.2);
    };
    EXPECT_NEAR(kept(110), 0.7, 0.05);
    EXPECT_LT(kept(150), 0.2);
}

TEST(DotPicture, HasTheRequestedPositionAndSize) {
    const CurveGeometry none = circle(9301, 0.1, -0.8);
    Drawing drawing = lecture_drawing(1920, 1080, none, none);
    View& view = drawing.views[0];
    view.planes.clear();
    view.ellipsoids.clear();
    view.curves.clear();
    view.arrows.clear();
    view.background.alpha = drawing.background.alpha = 0.0;
    // The point of contact with the plane z = -0.8, projected by the definition of the camera.
    view.dots[0].at = {0.21, -0.13, -0.8};
    view.dots[0].radius_px = 6.0;
    const Camera& camera = view.camera;
    const Eigen::Vector3d forward = (camera.target - camera.eye).normalized();
    const Eigen::Vector3d right = forward.cross(camera.up).normalized();
    const Eigen::Vector3d down = forward.cross(right);
    const Eigen::Vector3d from_eye = view.dots[0].at - camera.eye;
    const double focal = 540.0 / std::tan(0.5 * camera.vertical_field_rad) / forward.dot(from_eye);
    const Eigen::Vector2d expected(960.0 + focal * right.dot(from_eye),
                                   540.0 + focal * down.dot(from_eye));
    const Image image = renderer().render(drawing);
    EXPECT_LT((middle_of(image) - expected).norm(), 0.02);
    EXPECT_NEAR(covered_px(image), std::numbers::pi * 36.0, 0.3);
}

TEST(ConePicture, CoversItsProjection) {
    // Seen along its axis a cone is a disc; seen from the side, a triangle with half an ellipse.
    Drawing drawing = flat_drawing(120, 120, 120.0);
    Cone cone;
    cone.apex = {0.2, 0.1, 40.0};
    cone.axis = {0.0, 0.0, -1.0};
    cone.half_angle_rad = 0.5;
    cone.length = 60.0;
    cone.opacity = 1.0;
    cone.rim_px = 0.0;
    cone.n_rulings = 0;
    drawing.views[0].cones = {cone};
    const double radius = 60.0 * std::tan(0.5);
    EXPECT_NEAR(covered_px(renderer().render(drawing)), std::numbers::pi * radius * radius,
                0.005 * std::numbers::pi * radius * radius);
    drawing.views[0].cones[0].apex = {0.2, 30.0, 0.0};
    drawing.views[0].cones[0].axis = {0.0, -1.0, 0.0};
    EXPECT_NEAR(covered_px(renderer().render(drawing)), radius * 60.0, 0.02 * radius * 60.0);
}

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

GlyphMask block(std::uint64_t id, int width, int height) {
    GlyphMask mask;
    mask.id = id;
    mask.width = width;
    mask.height = height;
    mask.coverage.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
    return mask;
}

TEST(LabelPicture, DrawsItsMaskWithInkCorrectedForLinearLight) {
    GlyphMask mask = block(9501, 9, 5);
    for (std::size_t k = 0; k < mask.coverage.size(); ++k)
        mask.coverage[k] = static_cast<std::uint8_t>(k * 5);
    Drawing drawing = flat_drawing(40, 30, 30.0);
    Label label;
    label.mask = &mask;
    label.top_left_px = {11.0, 7.0};
    drawing.views[0].labels = {label};
    const Image image = renderer().render(drawing);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 11 && x < 20 && y >= 7 && y < 12;
            const double covered = inside ? 5.0 * ((y - 7) * 9 + x - 11) / 255.0 : 0.0;
            const double ink = covered * (1.8 - 0.8 * covered);
            EXPECT_NEAR(image.at(x, y).a, 255.0 * ink, 1.0) << x << "," << y;
        }
    }
}

TEST(LabelPicture, HasAHaloThatFadesWithDistance) {
    const GlyphMask mask = block(9502, 1, 1);
    const std::vector<std::uint8_t> texels = with_halo(mask, 4.0, 5);
    const auto halo = [&](int x, int y) {
        return texels[2 * static_cast<std::size_t>(y * 11 + x) + 1];
    };
    EXPECT_EQ(halo(5, 5), 255);
    EXPECT_EQ(halo(7, 5), 255);
    EXPECT_GT(halo(8, 5), halo(9, 5));
    EXPECT_EQ(halo(10, 5), 0);
    EXPECT_EQ(halo(5, 1), halo(9, 5));
}

TEST(LabelPicture, DrawsMoreMasksThanTheTextureHolds) {
    // 300 masks of 100×100 px fill three textures of 1024² px; each mask is still drawn completely.
    std::vector<GlyphMask> masks;
    for (std::uint64_t k = 0; k < 300; ++k) masks.push_back(block(9600 + k, 100, 100));
    Drawing drawing = flat_drawing(128, 128, 128.0);
    for (const GlyphMask& mask : masks) {
        Label label;
        label.mask = &mask;
        label.top_left_px = {10.0, 12.0};
        drawing.views[0].labels = {label};
        ASSERT_NEAR(covered_px(renderer().render(drawing)), 10000.0, 1.0);
    }
    drawing.views[0].labels.clear();
    for (const GlyphMask& mask : masks) {
        Label label;
        label.mask = &mask;
        label.top_left_px = {10.0, 12.0};
        drawing.views[0].labels.push_back(label);
    }
    EXPECT_NEAR(covered_px(renderer().render(drawing)), 10000.0, 1.0);
}

TEST(LabelPicture, EqualsASeparatelyDrawnPicture) {
    // The texture previously held full masks at the positions of these labels and all around them.
    std::vector<GlyphMask> masks, letters;
    for (std::uint64_t k = 0; k < 61; ++k) masks.push_back(block(10'000 + k, 200, 60));
    for (std::uint64_t k = 0; k < 60; ++k)
        letters.push_back(block(10'100 + k, 11, 7 + static_cast<int>(k % 9)));
    const auto drawing_of = [](const GlyphMask& mask, double halo_px, double shift_px) {
        Drawing drawing = flat_drawing(40, 40, 40.0);
        Label label;
        label.mask = &mask;
        label.top_left_px = {11.0 + shift_px, 9.0 - 0.7 * shift_px};
        label.halo_px = halo_px;
        drawing.views[0].labels = {label};
        return drawing;
    };
    Renderer film(context());
    for (const GlyphMask& mask : masks) film.render(drawing_of(mask, 2.0, 0.3));
    for (std::size_t k = 0; k < letters.size(); ++k) {
        const Drawing drawing =
            drawing_of(letters[k], k % 3 == 0 ? 1.7 : 0.0, 0.0137 * static_cast<double>(k));
        Renderer alone(context());
        ASSERT_EQ(n_different(alone.render(drawing), film.render(drawing)), 0u) << k;
    }
}

TEST(LabelPicture, DrawsACaptionOf12000PixelsToItsEnd) {
    // A caption of a poster; its last seven columns are ink.
    constexpr int width = 12000;
    GlyphMask mask = block(9950, width, 3);
    for (std::size_t k = 0; k < mask.coverage.size(); ++k)
        mask.coverage[k] = k % width >= width - 7 ? 255 : 0;
    Drawing drawing = flat_drawing(40, 30, 30.0);
    Label label;
    label.mask = &mask;
    label.top_left_px = {20.0 - width, 7.0};
    drawing.views[0].labels = {label};
    const Image image = renderer().render(drawing);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_EQ(image.at(x, y).a, x >= 13 && x < 20 && y >= 7 && y < 10 ? 255 : 0)
                << x << "," << y;
}

}  // namespace
}  // namespace poinsot::testing
