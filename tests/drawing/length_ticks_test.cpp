// Ticks at equal lengths along polhode and herpolhode.
#include "drawing/figures/elements/length_ticks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes_by_hand.h"

namespace poinsot {
namespace {

Scene ticked(bool ticks) {
    Scene scene = free_scene({1.0, 1.8, 2.6}, {1.3, 0.9, 0.8}, "space");
    scene.show = {"plane", "ellipsoid", "polhode", "herpolhode", "contact"};
    scene.trail.ticks = ticks;
    return scene;
}

// The middles of the ticks of one path.
std::vector<Eigen::Vector3d> middles(const View& view, std::string_view element) {
    std::vector<Eigen::Vector3d> found;
    for (const Curve& curve : view.curves)
        if (curve.name.element == element && curve.geometry->points.size() == 2)
            found.emplace_back(curve.placement * Eigen::Vector3d(0.5, 0.0, 0.0));
    return found;
}

double nearest(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& to) {
    double best = 1e9;
    for (const Eigen::Vector3d& point : points) best = std::min(best, (point - to).norm());
    return best;
}

TEST(LengthTicks, AreAbsentByDefault) {
    const StagedScene plain(ticked(false), 10.0);
    const Drawing drawing = plain.stage.at(6.0);
    EXPECT_TRUE(middles(drawing.views.front(), "polhode").empty());
    EXPECT_TRUE(middles(drawing.views.front(), "herpolhode").empty());
}

// Rolling without slipping: the newest tick of the herpolhode is as far behind the contact as a
// tick of the polhode, or as far as the polhode's nearest tick ahead leaves of the spacing.
TEST(LengthTicks, MeetAtTheContact) {
    const StagedScene staged(ticked(true), 10.0);
    int n_met = 0, n_midway = 0;
    for (int k = 10; k <= 250; ++k) {
        const Drawing drawing = staged.stage.at(0.04 * k);
        const View& view = drawing.views.front();
        ASSERT_EQ(view.dots.size(), 1u);
        const Eigen::Vector3d contact = view.dots.front().at;
        const std::vector<Eigen::Vector3d> body = middles(view, "polhode");
        const std::vector<Eigen::Vector3d> plane = middles(view, "herpolhode");
        ASSERT_FALSE(body.empty() || plane.empty());
        double spacing = 0.0;
        for (std::size_t i = 1; i < body.size(); ++i)
            spacing = std::max(spacing, (body[i] - body[i - 1]).norm());
        const double on_body = nearest(body, contact);
        const double on_plane = (plane.back() - contact).norm();
        // Distances along chords, not along the curves.
        const double off =
            std::min(std::abs(on_plane - on_body), std::abs(on_plane - (spacing - on_body)));
        EXPECT_LT(off, 0.08 * spacing) << k;
        n_met += on_body < 0.1 * spacing ? 1 : 0;
        n_midway += on_body > 0.2 * spacing && on_body < 0.3 * spacing ? 1 : 0;
    }
    EXPECT_GT(n_met, 10);
    EXPECT_GT(n_midway, 10);
}

// The ticks of the polhode divide it into equal lengths, also where its end meets its beginning.
TEST(LengthTicks, DivideTheClosedPolhodeEvenly) {
    const StagedScene staged(ticked(true), 10.0);
    const Drawing drawing = staged.stage.at(3.0);
    const std::vector<Eigen::Vector3d> ticks = middles(drawing.views.front(), "polhode");
    ASSERT_GT(ticks.size(), 10u);
    double shortest = 1e9, longest = 0.0;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        const double apart = (ticks[(k + 1) % ticks.size()] - ticks[k]).norm();
        shortest = std::min(shortest, apart);
        longest = std::max(longest, apart);
    }
    // Chords of equal arcs: shorter where the curve bends.
    EXPECT_LT(longest, 0.17);
    EXPECT_GT(shortest, 0.93 * longest);
}

}  // namespace
}  // namespace poinsot
