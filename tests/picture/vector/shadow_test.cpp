// The shadow of an ellipsoid on paper.
#include "vector/passes/shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "vector/canvas.h"

namespace poinsot::vector {
namespace {

// A sphere that touches the plane, seen from above.
struct ShadowSetting {
    Drawing drawing;
    SheetOfPaper paper;

    ShadowSetting() {
        drawing.width_px = 1000;
        drawing.height_px = 750;
        View& view = drawing.views.emplace_back();
        view.width_px = 1000;
        view.height_px = 750;
        view.camera.eye = {2.5, -4.5, 3.2};
        view.camera.target = {0.0, 0.0, -0.2};
        view.ellipsoids.emplace_back().half_axes = 0.7 * Eigen::Matrix3d::Identity();
        view.planes.emplace_back().centre = {0.0, 0.0, -0.7};
        view.planes.front().colour = {0.85, 0.85, 0.85};
        view.planes.front().grid_colour = {0.5, 0.5, 0.5};
    }
    const View& view() const { return drawing.views.front(); }
};

// The opacity of a gradient from a focus to the unit circle at a point of the paper.
double alpha_at(const RadialFade& fade, const Eigen::Vector2d& at) {
    const Eigen::Vector2d p = fade.paper_from_circle.inverse() * at, f = fade.focus;
    // The largest t with |p - (1 - t) f| = t.
    const double a = f.squaredNorm() - 1.0, b = (p - f).dot(f), c = (p - f).squaredNorm();
    const double t = (-b - std::sqrt(std::max(b * b - a * c, 0.0))) / a;
    if (t >= 1.0) return fade.stops.back().ink.alpha;
    for (std::size_t k = 1; k < fade.stops.size(); ++k) {
        const Stop &from = fade.stops[k - 1], &to = fade.stops[k];
        if (t > to.at || !(to.at > from.at)) continue;
        const double share = (t - from.at) / (to.at - from.at);
        return from.ink.alpha + share * (to.ink.alpha - from.ink.alpha);
    }
    return fade.stops.back().ink.alpha;
}

// No band on paper or on a projector: from point to point, a tenth of a millimetre apart, the grey
// changes by less than a viewer sees, and it is that of the light.
TEST(Shadow, HasNoSteps) {
    ShadowSetting setting;
    const Plane& plane = setting.view().planes.front();
    const Canvas canvas(setting.drawing, setting.view(), 0.24, Shading::tone, setting.paper);
    draw_shadow(canvas, plane, 0);
    ASSERT_GT(setting.paper.items.size(), 8u);
    const Eigen::Vector3d contact(0.0, 0.0, -0.7);
    double steepest = 0.0, farthest_off = 0.0, darkest = 255.0;
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(-0.6, 0.8, 0.0),
          Eigen::Vector3d(0.2, -0.98, 0.0)}) {
        double before = -1.0;
        for (double r = 0.2; r < 1.6; r += 0.002) {
            const Eigen::Vector3d point = contact + r * direction;
            const Eigen::Vector2d at = canvas.projection.place(point);
            double grey = plane.colour.g;
            for (const Item& item : setting.paper.items) {
                const Fill& fill = std::get<Fill>(item);
                const auto* fade = std::get_if<RadialFade>(&fill.paint);
                ASSERT_NE(fade, nullptr);
                const double alpha = alpha_at(*fade, at);
                grey = alpha * fade->stops.front().ink.colour.g + (1.0 - alpha) * grey;
            }
            const double exact = shadowed(canvas, plane, point, plane.colour).g;
            farthest_off = std::max(farthest_off, 255.0 * std::abs(grey - exact));
            if (before >= 0.0) steepest = std::max(steepest, 255.0 * std::abs(grey - before));
            before = grey;
            darkest = std::min(darkest, 255.0 * grey);
        }
    }
    EXPECT_LT(darkest, 170.0);
    EXPECT_LT(steepest, 2.0);
    EXPECT_LT(farthest_off,
              18.0);  // the outlines of the lamp's shadow are not quite ellipses: 17.1
}

}  // namespace
}  // namespace poinsot::vector
