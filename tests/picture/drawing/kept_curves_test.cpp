// At any instant, every curve of a picture lies within the bound that the record states; otherwise
// it is refused, or drawn as the ring that it fills, with a note.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "construction/adaptive_curve.h"
#include "drawing/figures/elements/trail.h"
#include "drawing/stage/panel.h"
#include "error/error.h"
#include "mechanics/half_life.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::kept_curves_tests {
namespace {

using std::numbers::pi;

const Eigen::Vector3d moments{1.0, 2.0, 2.9};
const Eigen::Vector3d omega{1.5, 0.3, 0.75};

Scene generic(const std::string& panel) { return free_scene(moments, omega, panel); }

Scene burning(const std::string& panel) {
    Scene scene = free_scene({3.0, 2.0, 1.0}, {0.05, 0.02, 2.0}, panel);
    scene.torque = InternalFriction{
        friction_rate_of_half_life(scene.body.inertia, scene.start.omega_rad_s, 10.0)};
    scene.method = {.name = "dopri5", .step_s = {}, .tolerance = 1e-9, .order = {}};
    scene.film.duration_s = 30.0;
    scene.trail.polhode = "history";
    return scene;
}

// A stage as a quality draws it: with this number of samples per side, and curves within this many
// of them.
struct Drawn {
    Scene scene;
    Motion motion;
    std::optional<Motion> beside;
    Stage stage;

    Drawn(const Scene& scene_, double last_time_s, int samples, double curve_px,
          std::optional<double> first_shown_s = {})
        : scene(scene_),
          motion(problem_of(scene)),
          beside(other(scene, last_time_s)),
          stage(scene, theme_of(scene), motion,
                {.width_px = samples * scene.film.width_px,
                 .height_px = samples * scene.film.height_px,
                 .samples = samples,
                 .curve_px = curve_px,
                 .first_time_s = scene.film.start_s,
                 .last_time_s = last_time_s,
                 .first_shown_s = first_shown_s,
                 .fonts = installed_fonts()},
                beside ? &*beside : nullptr) {}

    static std::optional<Motion> other(const Scene& scene, double last_time_s) {
        if (!scene.beside) return std::nullopt;
        MotionProblem problem = problem_of(scene);
        problem.last_time_s = std::max(problem.last_time_s, last_time_s);
        problem.method = *scene.beside;
        return Motion(problem);
    }
};

double distance(const Eigen::Vector3d& point, const CurveGeometry& polyline, std::size_t i) {
    const auto& points = polyline.points;
    return distance_from_segment(point, points[i], points[(i + 1) % points.size()]);
}

// The greatest distance of the points from a polyline along which they run.
double farthest(const std::vector<Eigen::Vector3d>& points, const CurveGeometry& polyline) {
    const std::size_t n_segments = polyline.points.size() - (polyline.closed ? 0 : 1);
    std::size_t at = 0;
    double worst = 0.0;
    for (const Eigen::Vector3d& point : points) {
        while (at + 1 < n_segments &&
               distance(point, polyline, at + 1) <= distance(point, polyline, at))
            ++at;
        worst = std::max(worst, distance(point, polyline, at));
    }
    return worst;
}

struct Case {
    std::string name;
    Scene scene;
    double last_time_s = 10.0;
};

std::vector<Case> every_kind_of_curve() {
    std::vector<Case> cases;
    for (const char* panel : {"space", "plan", "body", "momentum", "plot"}) {
        cases.push_back({panel, generic(panel)});
        Scene ghost = generic(panel);
        ghost.beside = MethodChoice{.name = "rk4", .step_s = 0.1, .tolerance = {}, .order = {}};
        ghost.show = {"ellipsoid", "annulus", "polhode", "herpolhode", "ghost", "drift"};
        if (std::string(panel) != "plan")
            cases.push_back({std::string(panel) + " beside", std::move(ghost)});
        if (std::string(panel) != "plan")
            cases.push_back({std::string(panel) + " burning", burning(panel), 30.0});
    }
    for (const char* trail : {"history", "fading"}) {
        Scene scene = generic("space");
        scene.trail.polhode = scene.trail.herpolhode = trail;
        cases.push_back({std::string("space ") + trail, std::move(scene)});
    }
    Scene marked = generic("space");
    MarkSpec mark;
    mark.name = "m";
    mark.on = "ellipsoid";
    mark.at = {0.2, 1.0, 0.4};
    mark.trail = true;
    marked.marks = {mark};
    cases.push_back({"mark", std::move(marked)});
    Scene swept = generic("sweep");
    swept.construction.sweep = "axis";
    cases.push_back({"sweep", std::move(swept)});
    for (const char* panel : {"top", "potential", "plot"})
        cases.push_back(
            {std::string(panel) + " of a top",
             top_scene({.theta_rad = 0.8, .phi_dot_rad_s = 0.3, .omega3_rad_s = 6.0}, panel)});
    return cases;
}

// Against the same curve, two hundred times as finely.
TEST(KeptCurves, LieWithinTheBoundAtEveryQuality) {
    struct Setting {
        int samples;
        double curve_px;
    };
    int n_curves = 0;
    double worst_share = 0.0;
    for (const Case& each : every_kind_of_curve()) {
        for (const Setting& setting : {Setting{1, 0.05}, {2, 0.1}, {4, 0.04}}) {
            const Drawn drawn(each.scene, each.last_time_s, setting.samples, setting.curve_px);
            const Drawn fine(each.scene, each.last_time_s, setting.samples,
                             setting.curve_px / 200.0);
            const auto& curves = drawn.stage.store().curves();
            ASSERT_EQ(curves.size(), fine.stage.store().curves().size()) << each.name;
            EXPECT_LE(drawn.stage.curve_error_px(), setting.curve_px * 1.000001) << each.name;
            const double units_per_px = drawn.stage.panels().front().units_per_px;
            // The first two are the circle and the segment of unit size.
            for (std::size_t i = 2; i < curves.size(); ++i) {
                const CurveGeometry& curve = curves[i];
                if (curve.points.size() < 4) continue;
                const double off_px =
                    farthest(fine.stage.store().curves()[i].points, curve) / units_per_px;
                const double share = off_px / drawn.stage.curve_error_px();
                EXPECT_LE(share, 1.02) << each.name << " " << i;
                worst_share = std::max(worst_share, share);
                ++n_curves;
            }
        }
    }
    EXPECT_GT(n_curves, 200);
    RecordProperty("worst_share", std::to_string(worst_share));
}

// The path of L under friction, against the momentum of the motion itself.
TEST(KeptCurves, OfTheMomentumPanelFollowTheMotion) {
    constexpr double curve_px = 0.02;
    const Drawn drawn(burning("momentum"), 30.0, 1, curve_px);
    const auto& curves = drawn.stage.store().curves();
    std::vector<Eigen::Vector3d> exact;
    for (int k = 0; k <= 20'000; ++k) {
        const Eigen::Vector3d w = drawn.motion.at(30.0 * k / 20'000).omega_body;
        exact.push_back(Eigen::Vector3d(3.0, 2.0, 1.0).cwiseProduct(w).normalized());
    }
    double nearest = 1e9;
    for (std::size_t i = 2; i < curves.size(); ++i)
        if (curves[i].points.size() > 100) nearest = std::min(nearest, farthest(exact, curves[i]));
    EXPECT_LE(nearest / drawn.stage.panels().front().units_per_px, 1.01 * curve_px);
}

// The stage of a still: its history begins with the film, and one instant is shown.
Drawn still_of(const Scene& scene, double time_s) { return Drawn(scene, time_s, 1, 0.05, time_s); }

const Curve* curve_of_width(const Drawing& drawing, double width_px) {
    for (const Curve& curve : drawing.views.front().curves)
        if (std::abs(curve.width_px - width_px) < 1e-9) return &curve;
    return nullptr;
}

TEST(FarTimes, KeepTheirBoundOrAreRings) {
    for (const char* panel : {"space", "plan"}) {
        for (const double time_s : {1e2, 1e3, 1e4, 1e5, 1e9, 1e15}) {
            const Drawn still = still_of(generic(panel), time_s);
            EXPECT_LE(still.stage.curve_error_px(), 0.05 * 1.000001) << panel << time_s;
            if (time_s >= 1e5) {
                ASSERT_EQ(still.stage.notes().size(), 1u) << panel << time_s;
                EXPECT_NE(still.stage.notes().front().find("ring"), std::string::npos);
            }
            if (time_s <= 1e3) {
                EXPECT_TRUE(still.stage.notes().empty()) << panel << time_s;
            }
        }
    }
}

// The ring touches both circles of the annulus, and no point of it is farther from the line than
// half of the line's width. The curve itself leaves no larger gaps: its neighbouring turns, as far
// as the motion is sampled, are closer than that everywhere.
TEST(FarTimes, TheRingIsWhatTheHerpolhodeFills) {
    const Drawn still = still_of(generic("plan"), 1e9);
    const Drawing drawing = still.stage.at(1e9);
    const StageContext& context = still.stage.context();
    const Panel& panel = still.stage.panels().front();
    const Curve* ring = curve_of_width(drawing, 4.0 * context.theme.herpolhode_weight * panel.px);
    ASSERT_NE(ring, nullptr);
    const auto& points = ring->geometry->points;
    const Polhode::Annulus annulus = context.rolling->polhode.annulus();
    const double inner = annulus.inner / annulus.outer;
    double least = 1e9, most = 0.0;
    for (const Eigen::Vector3d& point : points) {
        least = std::min(least, point.norm());
        most = std::max(most, point.norm());
    }
    EXPECT_NEAR(least, inner, 1e-12);
    EXPECT_NEAR(most, 1.0, 1e-12);
    // Turn by turn the spiral moves outwards by half a line's width at most.
    const double half_width = 0.5 * ring->width_px * panel.units_per_px;
    std::vector<double> radii;  // where it crosses the x axis of its own plane
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i - 1].y() < 0.0 && points[i].y() >= 0.0)
            radii.push_back(std::hypot(points[i].x(), points[i].y()));
    ASSERT_GT(radii.size(), 20u);
    std::sort(radii.begin(), radii.end());
    for (std::size_t i = 1; i < radii.size(); ++i)
        EXPECT_LE(radii[i] - radii[i - 1], half_width * 1.01);

    // Turns of the motion that cross one circle, over the time in which the ring fills.
    const TimedCurve timed = herpolhode_trail(context, 0.05 * panel.units_per_px * annulus.outer,
                                              2.0 * half_width * annulus.outer);
    ASSERT_TRUE(timed.annulus);
    EXPECT_LT(timed.annulus->from_s, 1e5);
    const double middle = 0.5 * (annulus.inner + annulus.outer);
    // ω comes back with two components reversed after half a period: the same curve, turned about
    // L.
    const double period_s = 0.5 * *context.polhode_period_s;
    std::vector<double> angles;  // at which the curve crosses the middle circle, outwards
    const auto contact = [&](double t) -> Eigen::Vector3d {
        return context.rolling->picture_from_space *
               context.rolling->construction.contact_in_plane(
                   still.motion
                       .sample(t, {.attitude = false, .herpolhode = true, .euler_angles = false})
                       .herpolhode_space);
    };
    for (double t = 0.0; t < timed.annulus->from_s; t += period_s) {
        // Once in that time: a root of |contact| − middle, from the first crossing on by bisection.
        double from = t, to = t;
        for (int k = 1; k <= 64 && to == t; ++k) {
            const double a = t + period_s * (k - 1) / 64.0, b = t + period_s * k / 64.0;
            if (contact(a).norm() < middle && contact(b).norm() >= middle) from = a, to = b;
        }
        ASSERT_GT(to, t);
        for (int k = 0; k < 30; ++k) {
            const double half = 0.5 * (from + to);
            (contact(half).norm() < middle ? from : to) = half;
        }
        angles.push_back(std::atan2(contact(to).y(), contact(to).x()));
    }
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 2.0 * pi);
    double widest = 0.0;
    for (std::size_t i = 1; i < angles.size(); ++i)
        widest = std::max(widest, angles[i] - angles[i - 1]);
    EXPECT_LE(widest * annulus.outer, half_width * annulus.outer * 1.01);
}

// In a film the curve is drawn until it has filled the ring, and the ring from then on.
TEST(FarTimes, AFilmGoesOverFromTheCurveToTheRing) {
    Scene scene = generic("space");
    const Drawn film(scene, 1e6, 1, 0.05);
    ASSERT_EQ(film.stage.notes().size(), 1u);
    const double width_px =
        4.0 * film.stage.context().theme.herpolhode_weight * film.stage.panels().front().px;
    const auto geometry_at = [&](double time_s) {
        const Drawing drawing = film.stage.at(time_s);
        for (const Curve& curve : drawing.views.front().curves)
            if (curve.on_plane >= 0 && std::abs(curve.width_px - width_px) < 1e-9)
                return curve.geometry;
        return static_cast<const CurveGeometry*>(nullptr);
    };
    EXPECT_NE(geometry_at(10.0), nullptr);
    EXPECT_NE(geometry_at(1e6), nullptr);
    EXPECT_EQ(geometry_at(10.0), geometry_at(1000.0));
    EXPECT_NE(geometry_at(10.0), geometry_at(1e6));
    EXPECT_EQ(geometry_at(5e5), geometry_at(1e6));
}

// Paths that close, come to rest, or are shown in a short stretch are drawn as curves at any time.
TEST(FarTimes, OfCirclesLoopsAndShortTrailsAreCurves) {
    Scene circle = free_scene({2.0, 2.0, 1.0}, {0.3, 0.0, 1.0}, "space");
    Scene fading = generic("space");
    fading.trail.herpolhode = "fading";
    Scene separatrix = free_scene({1.0, 2.0, 2.25}, {1.5, 1.0, 2.0}, "space");
    Scene turning = generic("space");
    turning.camera.motion = "co-precessing";
    for (const Scene& scene : {circle, fading, separatrix, turning}) {
        const Drawn still = still_of(scene, 1e9);
        EXPECT_LE(still.stage.curve_error_px(), 0.05 * 1.000001);
        EXPECT_TRUE(still.stage.notes().empty());
        const Drawing drawing = still.stage.at(1e9);
        const auto& curves = drawing.views.front().curves;
        EXPECT_TRUE(std::any_of(curves.begin(), curves.end(), [](const Curve& curve) {
            return curve.on_plane >= 0 && curve.geometry->points.size() > 50;
        }));
    }
    // The contact point lies on the circle that is drawn, a billion seconds after its first turn.
    const Drawn still = still_of(circle, 1e9);
    const Drawing drawing = still.stage.at(1e9);
    const double off = [&] {
        const ConstructionPicture& picture = *still.stage.context().rolling;
        const Eigen::Vector3d contact = picture.picture_from_space *
                                        picture.construction.contact_space(still.motion.at(1e9)) *
                                        picture.picture_per_rho;
        double nearest = 1e9;
        for (const Curve& curve : drawing.views.front().curves) {
            if (curve.on_plane < 0 || curve.geometry->points.size() < 50) continue;
            for (std::size_t i = 0; i + 1 < curve.geometry->points.size(); ++i)
                nearest = std::min(nearest, distance(contact, *curve.geometry, i));
        }
        return nearest;
    }();
    EXPECT_LE(off / still.stage.panels().front().units_per_px, 0.05 * 1.1);
}

// Other curves are never drawn with a larger bound than requested: charts and the tracks of tops,
// marks and other methods are refused with a remedy.
TEST(FarTimes, OfOtherCurvesAreRefused) {
    Scene marked = generic("space");
    MarkSpec mark;
    mark.on = "ellipsoid";
    mark.at = {0.2, 1.0, 0.4};
    mark.trail = true;
    marked.marks = {mark};
    const std::vector<Scene> scenes{
        generic("plot"), marked,
        top_scene({.theta_rad = 0.8, .phi_dot_rad_s = 0.3, .omega3_rad_s = 6.0}, "top")};
    for (const Scene& scene : scenes) {
        try {
            still_of(scene, 1e9);
            ADD_FAILURE() << scene.panels.front().kind;
        } catch (const InputError& error) {
            const std::string what = error.what();
            EXPECT_NE(what.find("cannot be drawn within accuracy_px = 0.1"), std::string::npos);
            EXPECT_NE(what.find("set film.start_s nearer"), std::string::npos) << what;
        }
        // As the sentence says.
        Scene near = scene;
        near.film.start_s = 1e9 - 10.0;
        EXPECT_NO_THROW(still_of(near, 1e9)) << scene.panels.front().kind;
    }
}

// At 1e15 s doubles are an eighth of a second apart, too far for a polyline.
TEST(FarTimes, TooCoarseForACurveAreRefused) {
    Scene fading = generic("space");
    fading.trail.herpolhode = "fading";
    EXPECT_THROW(still_of(fading, 1e15), InputError);
}

}  // namespace
}  // namespace poinsot::kept_curves_tests
