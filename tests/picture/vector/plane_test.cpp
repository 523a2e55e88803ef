// The grid of a plane on paper.
#include "vector/passes/plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "vector/canvas.h"

namespace poinsot::vector {
namespace {

// Under a sphere that is seen from above, everything inside the sphere's outline is behind it.
struct Setting {
    Drawing drawing;

    Setting() {
        drawing.width_px = 1000;
        drawing.height_px = 750;
        View& view = drawing.views.emplace_back();
        view.width_px = 1000;
        view.height_px = 750;
        view.camera.orthographic = true;
        view.camera.eye = {2.5, -4.5, 3.2};
        view.camera.target = {0.0, 0.0, 0.0};
        view.ellipsoids.emplace_back().half_axes = 0.7 * Eigen::Matrix3d::Identity();
        view.planes.emplace_back().centre = {0.0, 0.0, -0.7};
    }

    // Points of the grid's lines inside the outline, and all; the lines' width.
    struct Found {
        int n_inside = 0, n_all = 0;
        double width_pt = 0.0;
    };
    Found found(Shading shading) const {
        SheetOfPaper paper;
        const View& view = drawing.views.front();
        const Canvas canvas(drawing, view, 0.24, shading, paper);
        draw_plane(canvas, view.planes.front());
        const Eigen::Vector2d middle = canvas.projection.place(Eigen::Vector3d::Zero());
        const double radius = 0.7 * canvas.projection.scale(1.0);
        Found found;
        for (const Item& item : paper.items) {
            const Stroke* stroke = std::get_if<Stroke>(&item);
            if (stroke == nullptr) continue;
            found.width_pt = stroke->width_pt;
            Eigen::Vector2d from = Eigen::Vector2d::Zero();
            for (const Step& step : stroke->path.steps) {
                for (int k = 0; k <= 20 && step.kind == Step::Kind::line; ++k) {
                    ++found.n_all;
                    const Eigen::Vector2d at = from + k / 20.0 * (step.to - from);
                    constexpr double margin_pt = 0.1;
                    if ((at - middle).norm() < radius - margin_pt) ++found.n_inside;
                }
                from = step.to;
            }
        }
        return found;
    }
};

TEST(Grid, WithoutFillsEndsAtTheOutlineOfTheBody) {
    const Setting setting;
    const auto filled = setting.found(Shading::tone), outlined = setting.found(Shading::none);
    EXPECT_GT(filled.n_inside, 50);
    EXPECT_EQ(outlined.n_inside, 0);
    EXPECT_GT(outlined.n_all, 500);
}

TEST(Grid, WithoutFillsIsAsThinAsAnyLine) {
    EXPECT_DOUBLE_EQ(Setting().found(Shading::none).width_pt, least_line_pt);
}

}  // namespace
}  // namespace poinsot::vector
