// Ticks at equal lengths of polhode and herpolhode.
#include "drawing/figures/elements/direction_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot::direction_marks_tests {
namespace {

// The middles of the ticks on a curve.
std::vector<Eigen::Vector3d> ticks_on(const View& view, std::string_view element) {
    std::vector<Eigen::Vector3d> at;
    for (const Curve& curve : view.curves)
        if (curve.name.element == element && curve.geometry->points.size() == 2 &&
            curve.name.part.empty())
            at.push_back(curve.placement.translation());
    return at;
}

Eigen::Vector3d contact_of(const View& view) {
    for (const Dot& dot : view.dots)
        if (dot.name.element == "contact") return dot.at;
    throw std::logic_error("no contact");
}

double distance_to_nearest(const std::vector<Eigen::Vector3d>& ticks, const Eigen::Vector3d& at) {
    double least = 1e300;
    for (const Eigen::Vector3d& tick : ticks) least = std::min(least, (tick - at).norm());
    return least;
}

Scene ticked(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega, const std::string& kind,
             bool ticks) {
    Scene scene = free_scene(moments, omega, "space");
    scene.show = {"plane", "ellipsoid", "polhode", "herpolhode", "contact"};
    scene.trail.polhode = scene.trail.herpolhode = kind;
    scene.trail.ticks = ticks;
    return scene;
}

// The ellipsoid rolls without slipping: what the contact has run along one curve it has run along
// the other, so that each tick of the polhode comes to lie on one of the herpolhode, also after
// turns of the polhode and where the motion runs against the order of its points.
TEST(Ticks, OfBothCurvesMeetAtTheContact) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0.3, 1.0);
    for (int k = 0; k < 24; ++k) {
        // In braces, arguments are evaluated in their order, by every compiler.
        const Eigen::Vector3d moments{any(random) + 0.6, any(random) + 0.6, any(random) + 0.6};
        const Eigen::Vector3d omega{k % 2 == 0 ? any(random) : -any(random), any(random),
                                    any(random)};
        const bool grows = k % 3 == 0;
        const StagedScene staged(ticked(moments, omega, grows ? "history" : "whole", true), 60.0);
        // At the end of its first turn, a growing polhode has ticks before the contact, too.
        const double last_s =
            grows ? std::min(60.0, *staged.motion.free_constants().polhode_period_s) : 60.0;
        int n_near = 0;
        double farthest_px = 0.0;
        for (int i = 20; i < 360; ++i) {
            const View view = staged.stage.at(last_s * i / 400.0).views.front();
            const Eigen::Vector3d contact = contact_of(view);
            const std::vector<Eigen::Vector3d> fixed = ticks_on(view, "herpolhode");
            const double off = distance_to_nearest(ticks_on(view, "polhode"), contact);
            if (!(off < 0.02) || fixed.empty()) continue;
            // The contact may have passed the newest tick on one of two growing curves alone.
            if (grows && off < 0.001) continue;
            double least = 1e300;
            for (const Eigen::Vector3d& tick : fixed)
                least = std::min(least, std::abs((tick - contact).norm() - off));
            const double unit = units_per_pixel(view, project(view, contact).depth);
            farthest_px = std::max(farthest_px, least / unit);
            ++n_near;
        }
        EXPECT_GT(n_near, 20) << "body " << k;
        EXPECT_LT(farthest_px, 0.5) << "body " << k;  // after a minute; measured 0.35 in one, 0.07
    }
}

TEST(Ticks, AreDrawnWhereTheSceneWantsThem) {
    for (const bool wanted : {true, false}) {
        const StagedScene staged(ticked({4.0, 3.0, 1.5}, {1.2, 0.8, 2.4}, "whole", wanted), 10.0);
        const View view = staged.stage.at(3.0).views.front();
        for (const std::string_view curve : {"polhode", "herpolhode"})
            EXPECT_EQ(ticks_on(view, curve).size() > 10, wanted) << curve;
    }
}

}  // namespace
}  // namespace poinsot::direction_marks_tests
