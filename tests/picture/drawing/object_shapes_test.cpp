// The faces of a body: the marked face, and pictures in the correct orientation.
#include "drawing/figures/elements/object_shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>

#include "scene/body_faces.h"
#include "scenes_by_hand.h"

namespace poinsot {
namespace {

// A box of 4 × 3 × 2 m along body axes.
Scene box_scene() {
    Scene scene = free_scene({13.0, 20.0, 25.0}, {0.1, 1.0, 0.1}, "object");
    scene.body.given = BodySpec::Given::solid;
    scene.body.shape = "box";
    scene.body.size_m = {4.0, 3.0, 2.0};
    return scene;
}

// The meshes of the object panel at t = 0, in body axes and metres.
std::vector<Mesh> meshes_of(const StagedScene& staged) {
    return staged.stage.at(0.0).views.at(0).meshes;
}

double area_of(const MeshGeometry& geometry) {
    double area = 0.0;
    for (std::size_t k = 0; k + 2 < geometry.positions.size(); k += 3) {
        const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
            return geometry.positions[k + i].cast<double>();
        };
        area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    }
    return area;
}

TEST(Faces, MarkedFaceIsExactlyOneWholeSide) {
    const double reach_m = 0.5 * std::sqrt(29.0);
    const std::array<double, 3> sides_m2{6.0, 8.0, 12.0};
    for (const std::string_view name : body_faces()) {
        Scene scene = box_scene();
        scene.object.marked_face = name;
        const StagedScene staged(scene, 10.0);
        const std::vector<Mesh> meshes = meshes_of(staged);
        ASSERT_EQ(meshes.size(), 2u) << name;
        const BodyFace face = body_face_named(name);
        const double half_m = std::array{2.0, 1.5, 1.0}[static_cast<std::size_t>(face.axis)];
        for (const Eigen::Vector3f& corner : meshes[1].geometry->positions)
            EXPECT_NEAR(corner[face.axis] * reach_m, face.sign * half_m, 1e-6) << name;
        const double side_m2 = sides_m2[static_cast<std::size_t>(face.axis)];
        EXPECT_NEAR(area_of(*meshes[1].geometry) * reach_m * reach_m, side_m2, 1e-5) << name;
        EXPECT_NEAR(area_of(*meshes[0].geometry) * reach_m * reach_m, 52.0 - side_m2, 1e-5) << name;
        EXPECT_NE(meshes[0].colour.r, meshes[1].colour.r);
    }
}

// A point of a face, its position in the picture, and the picture's axes, from differences.
struct Laid {
    Eigen::Vector3d right, down;  // of the face, per picture width and height
};
Laid laid(const MeshGeometry& geometry) {
    Eigen::Matrix<double, 2, 2> places;
    Eigen::Matrix<double, 3, 2> sides;
    for (int k = 0; k < 2; ++k) {
        const auto i = static_cast<std::size_t>(k + 1);
        places.col(k) = (geometry.places[i] - geometry.places[0]).cast<double>();
        sides.col(k) = (geometry.positions[i] - geometry.positions[0]).cast<double>();
    }
    const Eigen::Matrix<double, 3, 2> axes = sides * places.inverse();
    return {axes.col(0), axes.col(1)};
}

TEST(Faces, PicturesAreUnmirroredFromOutsideAndUpright) {
    for (const std::string_view name : body_faces())
        for (const std::string_view up : body_faces()) {
            const BodyFace face = body_face_named(name), towards = body_face_named(up);
            if (face.axis == towards.axis) continue;
            Scene scene = box_scene();
            scene.object.pictures.push_back(
                {std::string(name), "a.png", std::string(up), Image(4, 4)});
            const StagedScene staged(scene, 10.0);
            const std::vector<Mesh> meshes = meshes_of(staged);
            ASSERT_EQ(meshes.size(), 2u);
            const Laid picture = laid(*meshes[1].geometry);
            const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
            // Right × up points to the viewer.
            const Eigen::Vector3d to_us = picture.right.cross(-picture.down).normalized();
            EXPECT_LT((to_us - face.outward(axes)).norm(), 1e-6) << name << up;
            EXPECT_LT((-picture.down.normalized() - towards.outward(axes)).norm(), 1e-6)
                << name << up;
        }
}

// The top of a tall picture points along the face's longer side, that of a wide one along the
// shorter side.
TEST(Faces, PicturesAreStretchedLeast) {
    for (const auto& [image, upright] : {std::pair(Image(30, 40), Eigen::Vector3d(1, 0, 0)),
                                         std::pair(Image(40, 30), Eigen::Vector3d(0, 1, 0))}) {
        Scene scene = box_scene();
        scene.object.pictures.push_back({"+e3", "a.png", "", image});
        const StagedScene staged(scene, 10.0);
        const std::vector<Mesh> meshes = meshes_of(staged);
        const Laid picture = laid(*meshes.at(1).geometry);
        EXPECT_LT((-picture.down.normalized() - upright).norm(), 1e-6);
        EXPECT_NEAR(picture.down.norm() / picture.right.norm(),
                    static_cast<double>(image.height()) / image.width(), 1e-6);
    }
}

// A half-transparent pixel blends with the body's own colour in linear light.
TEST(Faces, TransparentPicturesShowTheBody) {
    Scene scene = box_scene();
    Image image(1, 1);
    image.set(0, 0, {255, 255, 255, 128});
    scene.object.pictures.push_back({"+e3", "a.png", "", image});
    const StagedScene staged(scene, 10.0);
    const std::vector<Mesh> meshes = meshes_of(staged);
    const auto light = [](double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    };
    const double part = 128.0 / 255.0;
    const double expected = part + (1.0 - part) * light(meshes[0].colour.g);
    EXPECT_NEAR(light(meshes.at(1).geometry->picture.rgb.at(1) / 255.0), expected, 0.005);
}

}  // namespace
}  // namespace poinsot
