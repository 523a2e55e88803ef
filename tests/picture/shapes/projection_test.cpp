#include "shapes/projection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace poinsot {
namespace {

View view_of(const Camera& camera) {
    View view;
    view.x_px = 100;
    view.y_px = 50;
    view.width_px = 800;
    view.height_px = 600;
    view.camera = camera;
    return view;
}

TEST(Projection, TargetIsTheMiddleOfTheView) {
    Camera camera;
    camera.eye = {3.0, -4.0, 2.0};
    camera.target = {0.1, 0.2, 0.3};
    const Projected middle = project(view_of(camera), camera.target);
    EXPECT_NEAR(middle.px.x(), 500.0, 1e-10);
    EXPECT_NEAR(middle.px.y(), 350.0, 1e-10);
    EXPECT_NEAR(middle.depth, (camera.eye - camera.target).norm(), 1e-14);
}

TEST(Projection, FieldOfViewReachesTheUpperEdge) {
    Camera camera;
    camera.eye = {0.0, -5.0, 0.0};
    camera.vertical_field_rad = 0.5;
    const View view = view_of(camera);
    const Projected top = project(view, {0.0, 0.0, 5.0 * std::tan(0.25)});
    EXPECT_NEAR(top.px.y(), 50.0, 1e-10);
    // +x is to the right of the camera, and up is −y of the picture.
    EXPECT_GT(project(view, {1.0, 0.0, 0.0}).px.x(), 500.0);
}

TEST(Projection, OrthographicScaleFollowsTheHeight) {
    Camera camera;
    camera.eye = {0.0, -5.0, 0.0};
    camera.orthographic = true;
    camera.height_units = 3.0;
    const View view = view_of(camera);
    EXPECT_NEAR(project(view, {0.0, 7.0, 1.5}).px.y(), 50.0, 1e-10);
    EXPECT_NEAR(units_per_pixel(view, 123.0), 3.0 / 600.0, 1e-18);
}

}  // namespace
}  // namespace poinsot
