// The momentum panel: curves on the sphere and the ellipsoid.
#include <gtest/gtest.h>

#include <vector>

#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(MomentumPanel, CurvesLieOnSphereAndEnergyEllipsoid) {
    for (const FreeCase& one : extremes) {
        const StagedScene staged(free_scene(one.moments, one.omega, "momentum"), 10.0);
        for (const double t : {0.0, 3.7}) {
            const Drawing drawing = staged.stage.at(t);
            const View& view = view_of(drawing);
            const Eigen::Vector3d half_axes = view.ellipsoids[1].half_axes.diagonal();
            std::vector<Eigen::Vector3d> points{view.arrows.back().tip};
            for (const Curve& curve : view.curves) {
                if (curve.geometry == staged.stage.store().unit_segment()) continue;  // a leader
                for (const Eigen::Vector3d& point : drawn_points(curve)) points.push_back(point);
            }
            for (const Eigen::Vector3d& point : points) {
                EXPECT_NEAR(point.norm(), 1.0, 4e-15) << one.name;  // measured 4e-16
                // 2T/L² of the point: the relative error of the moments' ratio does not matter,
                // since all terms are positive.
                EXPECT_NEAR(point.cwiseQuotient(half_axes).norm(), 1.0, 2e-14) << one.name;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot::panels_tests
