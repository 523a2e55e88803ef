// The potential panel: the moving point and the turning points.
#include <gtest/gtest.h>

#include <algorithm>

#include "mechanics/top/heavy_top.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(PotentialPanel, MovingPointReachesTheEnergyAtTheTurningPoints) {
    const StagedScene staged(top_scene({0.7, 0.0, -0.6, 5.0}, "potential"), 10.0);
    // θ̇(0) = 0: the start is a turning point, where V = E.
    const Drawing start = staged.stage.at(0.0);
    const auto& dots = view_of(start).dots;
    ASSERT_EQ(dots.size(), 3u);
    EXPECT_LT(std::min((dots[2].at - dots[0].at).norm(), (dots[2].at - dots[1].at).norm()), 1e-6);
    // Between the turning points V is less than E.
    const double period = staged.motion.heavy_top()->nutation().period_s;
    const Drawing middle = staged.stage.at(0.25 * period);
    EXPECT_LT(view_of(middle).dots[2].at.y(), dots[0].at.y() - 10.0);
}

}  // namespace
}  // namespace poinsot::panels_tests
