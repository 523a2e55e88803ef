#include "drawing/stage/type/labels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace poinsot {
namespace {

class Labels : public testing::Test {
 protected:
    Labels() {
        view.width_px = 800;
        view.height_px = 600;
        mask.id = 1;
        mask.width = 40;
        mask.height = 20;
        mask.coverage.assign(800, 255);
    }
    LabelRequest request(double x, double y, double dx, double dy) const {
        LabelRequest w;
        w.type.mask = &mask;
        w.anchor_px = {x, y};
        w.away = {dx, dy};
        w.gap_px = 5.0;
        return w;
    }
    Eigen::Vector2d centre(std::size_t i) const {
        return view.labels[i].top_left_px + Eigen::Vector2d(20.0, 10.0);
    }
    View view;
    GlyphMask mask;
};

LabelRules rules(double halo_px, const CurveGeometry* segment = nullptr) {
    LabelRules rules;
    rules.halo_px = halo_px;
    rules.margin_px = 0.0;
    rules.segment = segment;
    return rules;
}

TEST_F(Labels, AreOnTheRequestedSide) {
    place_labels({request(400, 300, 1, 0), request(100, 300, 0, -1)}, rules(2.0), view);
    EXPECT_GT(view.labels[0].top_left_px.x(), 400.0);
    EXPECT_LT(view.labels[1].top_left_px.y() + 20.0, 300.0);
}

TEST_F(Labels, DoNotOverlap) {
    place_labels({request(400, 300, 1, 0), request(404, 302, 1, 0.05), request(398, 301, 1, -0.05)},
                 rules(2.0), view);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i + 1; j < 3; ++j) {
            const Eigen::Vector2d apart = (centre(i) - centre(j)).cwiseAbs();
            EXPECT_TRUE(apart.x() > 36.0 || apart.y() > 14.0) << apart.transpose();
        }
    }
}

// Where a film's label fades, a still's is whole or absent, and a report says so.
TEST_F(Labels, OfStillsAreWholeOrAbsent) {
    LabelRules still = rules(2.0);
    still.is_still = true;
    int n_whole = 0, n_absent = 0, n_faded = 0;
    for (double presence = 0.05; presence < 1.0; presence += 0.1)
        for (const double x : {400.0, 799.0, 810.0, 825.0}) {  // the last two are outside
            LabelRequest one = request(x, 300, 1, 0);
            one.opacity = presence;
            view.labels.clear();
            place_labels({one}, rules(2.0), view);
            const double faded = view.labels.empty() ? 0.0 : view.labels[0].opacity;
            n_faded += faded > 0.0 && faded < 1.0;
            view.labels.clear();
            const auto absent = place_labels({one}, still, view);
            if (faded < 0.5) {
                EXPECT_TRUE(view.labels.empty());
                EXPECT_EQ(absent.size(), faded > 0.0 ? 1u : 0u);
                for (const UnplacedLabel& each : absent) EXPECT_FALSE(each.is_in_sight);
                ++n_absent;
            } else {
                ASSERT_EQ(view.labels.size(), 1u);
                EXPECT_EQ(view.labels[0].opacity, 1.0);
                EXPECT_TRUE(absent.empty());
                ++n_whole;
            }
        }
    EXPECT_GT(n_whole, 5);
    EXPECT_GT(n_absent, 5);
    EXPECT_GT(n_faded, 20);
    // Without room, a label is absent as a whole, too.
    view.labels.clear();
    LabelRules taken = still;
    for (double y = 0.0; y < 600.0; y += 25.0)
        taken.overlays.push_back({{400.0, y}, {400.0, 12.0}});
    const auto without_room = place_labels({request(400, 300, 1, 0)}, taken, view);
    EXPECT_TRUE(view.labels.empty());
    ASSERT_EQ(without_room.size(), 1u);
    EXPECT_TRUE(without_room[0].is_in_sight);
}

TEST_F(Labels, StayInsideTheView) {
    place_labels({request(799, 300, 1, 0), request(0, 0, -1, -1)}, rules(3.0), view);
    for (const Label& label : view.labels) {
        EXPECT_GE(label.top_left_px.x(), 3.0);
        EXPECT_GE(label.top_left_px.y(), 3.0);
        EXPECT_LE(label.top_left_px.x() + 40.0, 797.0);
    }
}

TEST_F(Labels, MoveContinuously) {
    // A label does not jump while its direction makes a full turn and passes through zero.
    Eigen::Vector2d before;
    double largest = 0.0;
    constexpr int n = 4000;
    for (int k = 0; k <= n; ++k) {
        const double angle = 2.0 * 3.14159265358979 * k / n;
        view.labels.clear();
        place_labels(
            {request(400, 300, std::cos(angle), 0.3 * std::sin(angle)), request(430, 300, 1, 0)},
            rules(2.0), view);
        if (k > 0) largest = std::max(largest, (centre(0) - before).norm());
        before = centre(0);
    }
    EXPECT_LT(largest, 2.0);  // measured below 1 px per step of 2π/4000
}

// A view in pixels: one unit per pixel, x right, y up from the lower edge.
View view_in_pixels() {
    View view;
    view.width_px = 800;
    view.height_px = 600;
    view.camera.orthographic = true;
    view.camera.height_units = 600.0;
    view.camera.target = {400.0, 300.0, 0.0};
    view.camera.eye = {400.0, 300.0, 1000.0};
    view.camera.up = Eigen::Vector3d::UnitY();
    return view;
}

Arrow shaft_at(double from_x, double from_y, double to_x, double to_y) {
    Arrow arrow;
    arrow.tail = {from_x, 600.0 - from_y, 0.0};
    arrow.tip = {to_x, 600.0 - to_y, 0.0};
    arrow.shaft_px = 4.0;
    arrow.head_px = 16.0;
    arrow.head_length_px = 26.0;
    return arrow;
}

TEST_F(Labels, AvoidShaftsOfOtherArrows) {
    const CurveGeometry segment{1, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, false, {}};
    for (const int side : {1, -1}) {
        view = view_in_pixels();
        view.arrows = {shaft_at(395, 100, 400, 300), shaft_at(420, 100, 425, 500)};
        LabelRequest name = request(400, 300, 1, 0);
        name.at = Eigen::Vector3d(400.0, 300.0, 0.0);
        name.side = side;
        place_labels({name}, rules(2.0, &segment), view);
        // The shaft points down in the picture: clockwise from it is left.
        const double beyond = -side * (centre(0).x() - 422.5);
        EXPECT_GT(beyond, 20.0) << side;
        EXPECT_LT(beyond, 40.0) << side;
        // A label that was moved away has a leader, from the named point to its box.
        ASSERT_LE(view.curves.size(), 1u);
        for (const Curve& curve : view.curves) {
            EXPECT_EQ(curve.placement.translation(), *name.at);
            const Eigen::Vector3d end = curve.placement * Eigen::Vector3d::UnitX();
            EXPECT_NEAR(std::abs(end.x() - centre(0).x()), 20.0, 1e-9);
        }
    }
    // Its own shaft, one that crosses it, and one that ends elsewhere do not move it.
    view = view_in_pixels();
    LabelRequest name = request(400, 300, 1, 0);
    name.at = Eigen::Vector3d(400.0, 300.0, 0.0);
    name.side = 1;
    place_labels({name}, rules(2.0, &segment), view);
    const Eigen::Vector2d alone = centre(0);
    view.labels.clear();
    view.arrows = {shaft_at(395, 100, 400, 300), shaft_at(420, 400, 425, 500),
                   shaft_at(300, 250, 600, 350)};
    place_labels({name}, rules(2.0, &segment), view);
    EXPECT_EQ(centre(0), alone);
    EXPECT_TRUE(view.curves.empty());
}

TEST_F(Labels, MoveContinuouslyAsAShaftPassesOverThem) {
    Eigen::Vector2d before;
    double largest = 0.0;
    for (int k = 0; k <= 4000; ++k) {
        view = view_in_pixels();
        const double x = 300.0 + 0.06 * k;
        view.arrows = {shaft_at(395, 100, 400, 300),
                       shaft_at(x, 100, x + 0.02 * (k - 2000), 330.0 + 0.01 * k)};
        LabelRequest name = request(400, 300, 1, 0);
        name.at = Eigen::Vector3d(400.0, 300.0, 0.0);
        name.side = 1;
        place_labels({name}, rules(2.0), view);
        if (k > 0) largest = std::max(largest, (centre(0) - before).norm());
        before = centre(0);
    }
    // The shaft moves by 0.08 px per step and rotates.
    EXPECT_LT(largest, 0.3);
}

}  // namespace
}  // namespace poinsot
