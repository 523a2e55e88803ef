// The matrices with which bodies of triangles are drawn put points where the projection does.
#include "render/view_scene.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/to_glm.h"

namespace poinsot::testing {
namespace {

View view_of(bool orthographic) {
    View view;
    view.x_px = 30, view.y_px = 10, view.width_px = 300, view.height_px = 200;
    view.camera.eye = {3.0, -4.0, 2.0};
    view.camera.target = {0.1, 0.2, -0.3};
    view.camera.orthographic = orthographic;
    return view;
}

glm::dvec3 seen(const ViewScene& scene, const Eigen::Vector3d& point, const glm::dvec2& shift_px) {
    const glm::dvec4 clip = scene.mesh_layer.projection(scene.projection, shift_px) *
                            scene.camera_from_view() * glm::dvec4(to_glm(point), 1.0);
    return glm::dvec3(clip) / clip.w;
}

class Matrices : public ::testing::TestWithParam<bool> {
 protected:
    Matrices() : view(view_of(GetParam())) {
        scene.prepare(drawing, view);
        // Beside the axis, so that the layer sees through one half of the view.
        scene.mesh_layer.left = 40, scene.mesh_layer.top = 25;
        scene.mesh_layer.width = 120, scene.mesh_layer.height = 90;
        scene.mesh_layer.nearest = 2.0, scene.mesh_layer.farthest = 9.0;
    }
    Drawing drawing;
    View view;
    ViewScene scene;
};

TEST_P(Matrices, PutAPointAtItsPixelWithRowsDownwards) {
    const MeshLayer& layer = scene.mesh_layer;
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(0.1, 0.2, -0.3), Eigen::Vector3d(-1.0, 0.4, 0.9),
          Eigen::Vector3d(0.7, 1.1, -1.2)}) {
        for (const glm::dvec2& shift_px : {glm::dvec2(0.0), glm::dvec2(0.375, -0.125)}) {
            const glm::dvec3 at = seen(scene, point, shift_px);
            const Eigen::Vector2d pixel = scene.projection.place(point);
            EXPECT_NEAR(layer.left + 0.5 * (1.0 + at.x) * layer.width, pixel.x() - shift_px.x,
                        1e-9);
            EXPECT_NEAR(layer.top + 0.5 * (1.0 + at.y) * layer.height, pixel.y() - shift_px.y,
                        1e-9);
        }
    }
}

TEST_P(Matrices, FillTheDepthBufferFromTheNearestToTheFarthest) {
    const Projection& p = scene.projection;
    const auto depth_at = [&](double depth) {
        return seen(scene, p.eye + depth * p.forward + 0.3 * p.right, glm::dvec2(0.0)).z;
    };
    EXPECT_NEAR(depth_at(2.0), -1.0, 1e-12);
    EXPECT_NEAR(depth_at(9.0), 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Matrices, ::testing::Bool());

}  // namespace
}  // namespace poinsot::testing
