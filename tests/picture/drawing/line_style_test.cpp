// Styles of hidden lines, gaps at crossings, and lower limits of line widths and text sizes on
// paper.
#include "drawing/style/line_style.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "drawing/style/theme.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// 85 mm at 300 dots per inch: 8 pt, 6 pt and half a point.
constexpr LeastSizes least{33.3, 25.0, 2.08};

// A scene's drawing of this size, with the objects that it refers to.
struct OnPaper {
    Motion motion;
    Stage stage;
    Drawing drawing;

    OnPaper(const Scene& scene, const LeastSizes& sizes)
        : motion(problem_of(scene)),
          stage(scene, theme_of(scene), motion,
                {.width_px = 1004,
                 .height_px = 565,
                 .line_scale = 1.04,
                 .least = sizes,
                 .last_time_s = 10.0,
                 .fonts = installed_fonts()}),
          drawing(stage.at(5.0)) {}
};

// Of the visible lines: a width of 0 means no line.
double thinnest_px(const Drawing& drawing) {
    double px = 1e9;
    const auto take = [&px](double width_px) {
        if (width_px > 0.0) px = std::min(px, width_px);
    };
    for (const View& view : drawing.views) {
        for (const Curve& curve : view.curves) take(curve.width_px);
        for (const Arrow& arrow : view.arrows) take(arrow.shaft_px);
        for (const Plane& plane : view.planes) take(plane.grid_px);
        for (const Dot& dot : view.dots) take(dot.rim_px);
        for (const Ellipsoid& ellipsoid : view.ellipsoids) {
            take(ellipsoid.ruling_px);
            take(ellipsoid.section_px);
            take(ellipsoid.contour_px);
        }
    }
    return px;
}

double smallest_letter_px(const Drawing& drawing) {
    double px = 1e9;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels)
            for (const MaskLetter& letter : label.mask->letters) px = std::min(px, letter.em_px);
    return px;
}

TEST(LineStyles, OnPaperLinesAndTextHaveTheirLeastSizes) {
    for (const char* panel : {"space", "body", "plan", "plot"}) {
        const Scene scene = free_scene({1.0, 1.8, 2.6}, {1.3, 0.9, 0.8}, panel);
        const OnPaper small(scene, {}), paper(scene, least);
        const Drawing& drawing = paper.drawing;
        EXPECT_LT(thinnest_px(small.drawing), least.line_px) << panel;
        EXPECT_GE(thinnest_px(drawing), least.line_px) << panel;
        EXPECT_GE(smallest_letter_px(drawing), least.script_px - 1e-9) << panel;
        for (const View& view : drawing.views)
            for (const Label& label : view.labels)
                EXPECT_GE(label.mask->source.em_px, least.type_px - 1e-9) << panel;
    }
}

TEST(LineStyles, TextIsEnlargedForItsScripts) {
    TextCache plain(installed_fonts(), 1, {20.0, 0.0, 0.0}),
        scripts(installed_fonts(), 1, {20.0, 18.0, 0.0});
    for (const char* text : {"I_1", "\\mathrm{kg}\\,\\mathrm{m}^2", "x^{a_b}"}) {
        const TextBlock before = plain.set(text, {.size_px = 10.0});
        EXPECT_DOUBLE_EQ(before.mask->source.em_px, 20.0);
        const TextBlock after = scripts.set(text, {.size_px = 10.0});
        double least_px = 1e9;
        for (const MaskLetter& letter : after.mask->letters)
            least_px = std::min(least_px, letter.em_px);
        EXPECT_NEAR(least_px, 18.0, 1e-9) << text;
    }
    EXPECT_DOUBLE_EQ(scripts.set("I", {.size_px = 10.0}).mask->source.em_px, 20.0);
    EXPECT_DOUBLE_EQ(scripts.set("I_1", {.size_px = 40.0}).mask->source.em_px, 40.0);
}

Scene styled(const char* panel, const std::string& hidden, const std::string& crossings = "") {
    Scene scene = free_scene({1.0, 1.8, 2.6}, {1.3, 0.9, 0.8}, panel);
    scene.hidden = hidden;
    scene.crossings = crossings;
    return scene;
}

// The first view, with the objects that it refers to.
struct Shown {
    StagedScene staged;
    Drawing drawing;
    const View& view;

    explicit Shown(const Scene& scene)
        : staged(scene, 10.0), drawing(staged.stage.at(5.0)), view(drawing.views.front()) {}
};

template <typename Shape>
bool may_be_hidden(const Shape& shape) {
    return shape.occlusion == Occlusion::by_solids;
}

// Whether a curve is the outline of an arrow's head.
bool is_outline(const Curve& curve) { return curve.name.part == "hidden-head"; }

TEST(LineStyles, DashesMeanHiddenLinesOnly) {
    const Shown shown(styled("body", ""));
    const View& pale = shown.view;
    EXPECT_TRUE(std::any_of(pale.curves.begin(), pale.curves.end(), [](const Curve& curve) {
        return may_be_hidden(curve) && curve.dash_px > 0.0;
    }));
    for (const char* panel : {"space", "body"}) {
        const Shown broken(styled(panel, "dashed"));
        const View& dashed = broken.view;
        int n = 0;
        for (const Curve& curve : dashed.curves) {
            if (!may_be_hidden(curve) || is_outline(curve) || curve.name.part == "edge") continue;
            ++n;
            EXPECT_EQ(curve.dash_px, 0.0);
            EXPECT_EQ(curve.hidden, HiddenStyle::dashed);
            EXPECT_GE(curve.hidden_opacity, 0.7);
        }
        EXPECT_GT(n, 4);
    }
}

TEST(LineStyles, HiddenPartsOfArrowsAreDashed) {
    const Shown solid(styled("space", "")), broken(styled("space", "dashed"));
    const View &pale = solid.view, &dashed = broken.view;
    std::size_t n = 0;
    for (const Arrow& arrow : dashed.arrows) {
        if (!may_be_hidden(arrow)) continue;
        ++n;
        EXPECT_LT(arrow.hidden_opacity, 0.0);
        // A line from the tail to the head, which has an outline.
        const Eigen::Vector3d along = (arrow.tip - arrow.tail).normalized();
        const double head = arrow.head_length_px *
                            units_per_pixel(dashed, project(dashed, dashed.camera.target).depth);
        EXPECT_TRUE(std::any_of(dashed.curves.begin(), dashed.curves.end(), [&](const Curve& c) {
            const auto& points = c.geometry->points;
            return c.stands_for_hidden &&
                   (c.placement * points.front() - arrow.tail).norm() < 1e-12 &&
                   (c.placement * points.back() - (arrow.tip - head * along)).norm() < 1e-9;
        }));
        EXPECT_EQ(std::count_if(dashed.curves.begin(), dashed.curves.end(),
                                [&](const Curve& c) {
                                    return is_outline(c) && c.name.element == arrow.name.element &&
                                           c.name.number == arrow.name.number;
                                }),
                  1)
            << arrow.name.element << arrow.name.number;
    }
    EXPECT_GT(n, 2u);
    EXPECT_TRUE(std::none_of(pale.curves.begin(), pale.curves.end(),
                             [](const Curve& c) { return c.stands_for_hidden; }));
}

double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
}

// The outline of a head is inside the head from every side: in the convex hull of the tip and the
// base. It is no smaller than that by more than its width.
TEST(LineStyles, OutlinesOfHeadsAreInsideTheHeads) {
    for (const double azimuth_deg : {0.0, 70.0, 160.0, 250.0}) {
        Scene scene = styled("space", "dashed");
        scene.camera.azimuth_deg = azimuth_deg;
        const Shown shown(scene);
        const View& view = shown.view;
        const double unit = units_per_pixel(view, project(view, view.camera.target).depth);
        int n = 0;
        for (const Arrow& arrow : view.arrows) {
            // The part of an arrow before a plane has no head.
            if (arrow.head_px <= arrow.shaft_px) continue;
            const auto outline =
                std::find_if(view.curves.begin(), view.curves.end(), [&](const Curve& curve) {
                    return is_outline(curve) && curve.name.element == arrow.name.element &&
                           curve.name.number == arrow.name.number;
                });
            if (outline == view.curves.end()) continue;
            ++n;
            const Eigen::Vector3d axis = (arrow.tip - arrow.tail).normalized();
            const Eigen::Vector3d across = axis.unitOrthogonal();
            std::vector<Eigen::Vector2d> head{project(view, arrow.tip).px};
            for (int k = 0; k < 360; ++k)
                head.push_back(
                    project(view, arrow.tip - arrow.head_length_px * unit * axis +
                                      0.5 * arrow.head_px * unit *
                                          (Eigen::AngleAxisd(k * std::numbers::pi / 180.0, axis) *
                                           across))
                        .px);
            Eigen::Vector2d low(1e9, 1e9), high = -low, low_of_line = low, high_of_line = high;
            for (const Eigen::Vector2d& p : head) {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            for (const Eigen::Vector3d& point : outline->geometry->points) {
                const Eigen::Vector2d p = project(view, outline->placement * point).px;
                low_of_line = low_of_line.cwiseMin(p);
                high_of_line = high_of_line.cwiseMax(p);
                // Some triangle of three points of the head contains it: the tip and two of the
                // base, or three of the base.
                bool inside = false;
                for (std::size_t k = 1; k <= 360 && !inside; ++k) {
                    const Eigen::Vector2d& a = head[k];
                    const Eigen::Vector2d& b = head[k % 360 + 1];
                    for (const Eigen::Vector2d& c : {head[0], head[(k + 179) % 360 + 1]}) {
                        const double u = side_of(a, b, p), v = side_of(b, c, p),
                                     w = side_of(c, a, p);
                        inside = inside || (u >= -0.05 && v >= -0.05 && w >= -0.05) ||
                                 (u <= 0.05 && v <= 0.05 && w <= 0.05);
                    }
                }
                EXPECT_TRUE(inside) << azimuth_deg << " " << arrow.name.element;
            }
            const double most_px = 6.0 * outline->width_px;
            EXPECT_LT((high - high_of_line).maxCoeff(), most_px) << arrow.name.element;
            EXPECT_LT((low_of_line - low).maxCoeff(), most_px) << arrow.name.element;
        }
        EXPECT_GT(n, 2);
    }
}

Scene with_broken_omega(const char* line, const std::string& hidden = "") {
    Scene scene = styled("space", hidden);
    scene.show = {"ellipsoid", "omega", "momentum"};
    scene.style.looks["omega"].line = line;
    return scene;
}

std::vector<Arrow> arrows_of(const View& view, const Colour& colour) {
    std::vector<Arrow> found;
    for (const Arrow& arrow : view.arrows)
        if (arrow.colour == colour) found.push_back(arrow);
    return found;
}

// Dashes and gaps have the same length, from the tail to the head, which is unchanged.
TEST(LineStyles, DashedShaftIsSplitIntoDashes) {
    const Colour& omega = theme_named("light").omega;
    const Shown solid(with_broken_omega("solid"));
    const std::vector<Arrow> one = arrows_of(solid.view, omega);
    ASSERT_EQ(one.size(), 1u);
    const Arrow& whole = one.front();
    const Eigen::Vector3d along = (whole.tip - whole.tail).normalized();
    for (const auto& [line, fewest] : {std::pair{"dashed", 3u}, {"dotted", 10u}}) {
        const Shown shown(with_broken_omega(line));
        const std::vector<Arrow> dashes = arrows_of(shown.view, omega);
        ASSERT_GE(dashes.size(), fewest);
        EXPECT_EQ(dashes.front().tail, whole.tail);
        EXPECT_EQ(dashes.back().tip, whole.tip);
        EXPECT_EQ(dashes.back().head_px, whole.head_px);
        EXPECT_EQ(dashes.back().head_length_px, whole.head_length_px);
        const double dash = (dashes[0].tip - dashes[0].tail).norm();
        for (std::size_t k = 0; k + 1 < dashes.size(); ++k) {
            EXPECT_EQ(dashes[k].dash_px, 0.0);
            EXPECT_EQ(dashes[k].shaft_px, whole.shaft_px);
            EXPECT_LE(dashes[k].head_px, whole.shaft_px);
            EXPECT_NEAR((dashes[k].tip - dashes[k].tail).dot(along), dash, 1e-12);
            EXPECT_NEAR((dashes[k + 1].tail - dashes[k].tip).dot(along), dash, 1e-12);
        }
    }
}

TEST(LineStyles, WithDashedHiddenLinesNoShaftIsDashed) {
    const Colour& omega = theme_named("light").omega;
    const Shown solid(with_broken_omega("solid", "dashed")),
        shown(with_broken_omega("dashed", "dashed"));
    const std::vector<Arrow> whole = arrows_of(solid.view, omega);
    const std::vector<Arrow> thin = arrows_of(shown.view, omega);
    ASSERT_EQ(thin.size(), 1u);
    EXPECT_LT(thin.front().shaft_px, whole.front().shaft_px);
}

TEST(LineStyles, OmittedLinesAreAbsent) {
    const Shown shown(styled("space", "omitted"));
    const View& view = shown.view;
    for (const Curve& curve : view.curves)
        if (may_be_hidden(curve)) {
            EXPECT_EQ(curve.hidden, HiddenStyle::absent);
        }
    for (const Arrow& arrow : view.arrows)
        if (may_be_hidden(arrow)) {
            EXPECT_LT(arrow.hidden_opacity, 0.0);
        }
}

TEST(LineStyles, PrincipalSectionsLieOnTheEllipsoid) {
    const Shown solid(styled("space", "")), broken(styled("space", "dashed"));
    const View& view = broken.view;
    ASSERT_EQ(view.ellipsoids.size(), 1u);
    const Ellipsoid& ellipsoid = view.ellipsoids[0];
    EXPECT_EQ(ellipsoid.section_px, 0.0);
    const Eigen::Matrix3d to_sphere = ellipsoid.half_axes.inverse();
    std::vector<Eigen::Matrix3d> sections;
    for (const Curve& curve : view.curves) {
        if (curve.on_surface != 0 || !curve.geometry->closed) continue;
        if (curve.width_px != solid.view.ellipsoids[0].section_px) continue;
        // Gaps divide a section into parts.
        const Eigen::Matrix3d axes = curve.placement.linear();
        if (std::find(sections.begin(), sections.end(), axes) == sections.end())
            sections.push_back(axes);
        for (std::size_t k = 0; k < curve.geometry->points.size(); k += 50)
            EXPECT_NEAR(
                (to_sphere * (curve.placement * curve.geometry->points[k] - ellipsoid.centre))
                    .norm(),
                1.0, 1e-12);
    }
    EXPECT_EQ(sections.size(), 3u);
}

TEST(LineStyles, InPrintHiddenLinesAreDashedAndArrowsAreNot) {
    Scene scene = styled("space", "");
    scene.theme = "print";
    const Shown printed(scene);
    int n_dashed = 0;
    for (const Curve& curve : printed.view.curves) {
        EXPECT_FALSE(is_outline(curve) || curve.stands_for_hidden);
        if (curve.occlusion == Occlusion::by_solids && curve.hidden == HiddenStyle::dashed)
            ++n_dashed;
    }
    EXPECT_GT(n_dashed, 4);
    for (const Arrow& arrow : printed.view.arrows) EXPECT_GE(arrow.hidden_opacity, 0.0);
    // A scene's own word holds for both.
    scene.hidden = "dashed";
    const Shown broken(scene);
    for (const Arrow& arrow : broken.view.arrows) EXPECT_LT(arrow.hidden_opacity, 0.0);
    scene.hidden_arrows = "pale";
    const Shown pale(scene);
    for (const Arrow& arrow : pale.view.arrows) EXPECT_GE(arrow.hidden_opacity, 0.0);
}

// A line from x = -1 to 1 at this height, and an opaque arrow along y at z = 0 over its middle,
// seen from above.
struct Crossed {
    CurveGeometry line;
    View view;
    LineStyleRules rules;

    Crossed(double height, const char* crossings) {
        constexpr int n = 400;
        for (int k = 0; k <= n; ++k) line.points.emplace_back(2.0 * k / n - 1.0, 0.0, height);
        rules.crossings = crossings;
        view.width_px = view.height_px = 400;
        view.camera.eye = {0.0, 0.0, 8.0};
        view.camera.up = {0.0, 1.0, 0.0};
        view.ellipsoids.emplace_back().centre = {0.0, 0.0, -9.0};
        view.curves.emplace_back().geometry = &line;
        view.curves.back().width_px = 2.0;
        Arrow& arrow = view.arrows.emplace_back();
        arrow.tail = {0.0, -1.0, 0.0};
        arrow.tip = {0.0, 1.0, 0.0};
        arrow.shaft_px = 8.0;
        arrow.head_px = 16.0;
        arrow.head_length_px = 26.0;
        apply_line_style(rules, view);
    }
    double pixels_per_point() const {
        return (project(view, line.points[1]).px - project(view, line.points[0]).px).norm();
    }
};

TEST(LineStyles, AnArrowInterruptsWhatIsBehindIt) {
    const Crossed behind(-1.0, "gap");
    ASSERT_EQ(behind.view.curves.size(), 2u);
    const double gap_px =
        (behind.view.curves[1].first - behind.view.curves[0].last) * behind.pixels_per_point();
    EXPECT_GT(gap_px, 8.0 + 2.0);  // the shaft and some ground on both sides
    EXPECT_NEAR(0.5 * (behind.view.curves[1].first + behind.view.curves[0].last), 200.0, 0.3);
    EXPECT_EQ(Crossed(1.0, "gap").view.curves.size(), 1u);
    EXPECT_EQ(Crossed(-1.0, "through").view.curves.size(), 1u);
}

// Arrows over a wide line, and the hole that they leave in it, px.
struct WideCrossed : Crossed {
    static constexpr double width_px = 8.0;

    // The tips of arrows at z = 0 that run through the mirror images of their tips.
    explicit WideCrossed(const std::vector<std::pair<Eigen::Vector3d, double>>& arrows)
        : Crossed(-1.0, "through") {
        Arrow arrow = view.arrows.front();
        view.arrows.clear();
        for (const auto& [tip, aside] : arrows) {
            const Eigen::Vector3d middle(aside, 0.0, 0.0);
            arrow.tail = middle - tip;
            arrow.tip = middle + tip;
            view.arrows.push_back(arrow);
        }
        view.curves.front().width_px = width_px;
        rules.crossings = "gap";
    }
    double hole_px() {
        apply_line_style(rules, view);
        double left = 0.0;
        for (const Curve& part : view.curves) left += std::min(part.last, 400.0) - part.first;
        return (400.0 - left) * pixels_per_point();
    }
};

TEST(LineStyles, AFlatCrossingLeavesAHoleOfThreeWidths) {
    // 0.98 rad to 0.17 rad between the lines.
    for (const double rise : {1.5, 0.6, 0.3, 0.17}) {
        WideCrossed crossed({{{1.0, rise, 0.0}, 0.0}});
        const double hole_px = crossed.hole_px();
        EXPECT_GT(hole_px, 8.0) << rise;
        EXPECT_LE(hole_px, 3.0 * WideCrossed::width_px + 1e-6) << rise;
    }
}

TEST(LineStyles, CrossingsInARowLeaveNoLongHole) {
    // Twelve pixels apart: together they would leave 80 px.
    std::vector<std::pair<Eigen::Vector3d, double>> arrows;
    for (int k = 0; k < 6; ++k) arrows.emplace_back(Eigen::Vector3d(0.0, 1.0, 0.0), 0.12 * k);
    WideCrossed crossed(arrows);
    apply_line_style(crossed.rules, crossed.view);
    ASSERT_GT(crossed.view.curves.size(), 1u);
    for (std::size_t k = 1; k < crossed.view.curves.size(); ++k)
        EXPECT_LE((crossed.view.curves[k].first - crossed.view.curves[k - 1].last) *
                      crossed.pixels_per_point(),
                  3.0 * WideCrossed::width_px + 1e-6);
}

TEST(LineStyles, AtTheContactPointEveryLineIsWhole) {
    for (const double away_px : {0.0, 20.0, 60.0}) {
        WideCrossed crossed({{{0.2, 1.0, 0.0}, 0.0}});
        Dot& contact = crossed.view.dots.emplace_back();
        contact.at = crossed.line.points[200] +
                     Eigen::Vector3d(away_px / crossed.pixels_per_point() * 2.0 / 400.0, 0.0, 0.0);
        contact.name = {"contact"};
        EXPECT_EQ(crossed.hole_px() > 0.0, away_px > 50.0) << away_px;
    }
}

// Both parts of a fading trail fade as the whole does.
TEST(LineStyles, AFadingTrailKeepsItsFadingAcrossAGap) {
    Crossed crossed(-1.0, "gap");
    View view = crossed.view;
    view.curves = {view.curves.front()};
    Curve& trail = view.curves.front();
    trail.first = 0.0;
    trail.last = 390.0;
    trail.fade_points = 380.0;
    trail.fade_end = 0.0;
    apply_line_style(crossed.rules, view);
    ASSERT_EQ(view.curves.size(), 2u);
    for (const Curve& part : view.curves) {
        EXPECT_EQ(part.fade_points, 380.0);
        EXPECT_EQ(std::max(part.fade_end, part.last), 390.0);
    }
}

// Every gap is at a crossing of two lines, and only the rear line has gaps.
TEST(LineStyles, LinesPassingUnderOthersHaveGaps) {
    const Shown whole_lines(styled("space", "", "through")), gaps(styled("space", "", "gap"));
    const View &through = whole_lines.view, &gap = gaps.view;
    EXPECT_GT(gap.curves.size(), through.curves.size());
    // The visible part of each curve, in points: most of the curve.
    double whole = 0.0, left = 0.0;
    const auto length = [](const Curve& curve) {
        const double n = static_cast<double>(curve.geometry->points.size());
        return (std::clamp(curve.last, 0.0, n) - std::clamp(curve.first, 0.0, n)) / n;
    };
    const auto is_path = [](const Curve& curve) {
        return curve.name.element == "polhode" || curve.name.element == "herpolhode";
    };
    for (const Curve& curve : through.curves) whole += is_path(curve) ? length(curve) : 0.0;
    for (const Curve& curve : gap.curves) left += is_path(curve) ? length(curve) : 0.0;
    EXPECT_LT(left, whole);
    EXPECT_GT(left, 0.8 * whole);
}

}  // namespace
}  // namespace poinsot
