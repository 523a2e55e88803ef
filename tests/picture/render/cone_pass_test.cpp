// Cones.
#include <gtest/gtest.h>

#include "pictures.h"

namespace poinsot::testing {
namespace {

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

}  // namespace
}  // namespace poinsot::testing
