// The names of curves and surfaces: which are shown, what they say, and how they move.
#include "drawing/stage/thing_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <string>

#include "drawing/stage/type/labels.h"
#include "scene/scene.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"
#include "text/languages.h"

namespace poinsot::thing_names_tests {
namespace {

Scene rolling_scene() {
    Scene scene = free_scene({4.0, 3.0, 1.5}, {1.2, 0.8, 2.4}, "space");
    scene.names.reset();
    scene.film.width_px = 1920;
    scene.film.height_px = 1080;
    return scene;
}

// The labels of things in a drawing, by name.
std::map<std::string, Label> names_in(const Drawing& drawing) {
    std::map<std::string, Label> found;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels)
            for (const std::string_view name : named_things)
                if (label.name.element == name && label.mask->source.is_formula == false)
                    found[std::string(name)] = label;
    return found;
}

std::map<std::string, Label> names_of(const Scene& scene, double time_s = 5.0) {
    static std::deque<StagedScene> staged;  // labels refer to their stage
    return names_in(staged.emplace_back(scene, time_s, 0.0, true).stage.at(time_s));
}

// How often each name can be read at 20 instants of ten seconds.
std::map<std::string, int> times_read(const Scene& scene) {
    const StagedScene staged(scene, 10.0);
    std::map<std::string, int> times;
    for (int k = 0; k < 20; ++k)
        for (const auto& [name, label] : names_in(staged.stage.at(0.5 * (k + 1))))
            times[name] += label.opacity > 0.5;
    return times;
}

TEST(ThingNames, AreShownByDefault) {
    const auto times = times_read(rolling_scene());
    for (const char* name : {"polhode", "herpolhode", "inertia-ellipsoid", "invariable-plane"}) {
        ASSERT_TRUE(times.contains(name)) << name;
        EXPECT_GE(times.at(name), 10) << name;
    }
    EXPECT_EQ(times.size(), 4u);
}

// Under drag, L turns in space, and the plane with it.
TEST(ThingNames, OfAPlaneThatTurnsIsTheTangentPlane) {
    Scene scene = rolling_scene();
    const auto name_of_plane = [&scene] {
        return names_of(scene).at("invariable-plane").mask->source.text;
    };
    EXPECT_EQ(name_of_plane(), "invariable plane");
    scene.torque = Drag{{0.02, 0.05, 0.1}, {0.0, 0.0, 0.0}, 0.0};
    scene.method = {.name = "dopri5", .step_s = {}, .tolerance = 1e-9, .order = {}};
    EXPECT_EQ(name_of_plane(), "tangent plane");
    scene.language = "de";
    EXPECT_EQ(name_of_plane(), "Tangentialebene");
}

TEST(ThingNames, AreThoseThatTheSceneWants) {
    Scene scene = rolling_scene();
    scene.names = {"polhode"};
    EXPECT_EQ(names_of(scene).size(), 1u);
    scene.names.emplace();
    EXPECT_TRUE(names_of(scene).empty());
    scene.names.reset();
    scene.unlabelled = {"herpolhode"};
    EXPECT_EQ(names_of(scene).count("herpolhode"), 0u);
    EXPECT_EQ(times_read(scene).size(), 3u);
    scene.unlabelled.clear();
    scene.labels = false;
    EXPECT_TRUE(names_of(scene).empty());
}

TEST(ThingNames, NameConesAndSeparatrices) {
    Scene cones = free_scene({2.0, 2.0, 0.8}, {0.8, 0.0, 2.0}, "space");
    cones.names.reset();
    cones.film.width_px = 1920;
    cones.film.height_px = 1080;
    const auto times = times_read(cones);
    EXPECT_GE(times.at("body-cone"), 5);
    EXPECT_GE(times.at("space-cone"), 5);
    Scene body = rolling_scene();
    body.panels[0].kind = "body";
    EXPECT_TRUE(names_of(body).contains("separatrix"));
}

TEST(ThingNames, AreInTheLanguageOfTheSceneOrAsTheSceneSays) {
    Scene scene = rolling_scene();
    scene.language = "de";
    EXPECT_EQ(names_of(scene).at("inertia-ellipsoid").mask->source.text, "Trägheitsellipsoid");
    scene.symbols.things["inertia-ellipsoid"] = "Poinsots Ellipsoid";
    EXPECT_EQ(names_of(scene).at("inertia-ellipsoid").mask->source.text, "Poinsots Ellipsoid");
    scene.symbols.things["inertia-ellipsoid"] = "";
    EXPECT_EQ(names_of(scene).count("inertia-ellipsoid"), 0u);
    // Every thing has a name of its own in every language.
    for (const std::string_view language : languages()) {
        scene = rolling_scene();
        scene.language = language;
        std::set<std::string> texts;
        const StagedScene staged(scene, 10.0);
        StageStore store(staged.stage.context());
        for (const ThingName& name : set_thing_names(staged.stage.panels().front(), store))
            texts.insert(name.type.mask->source.text);
        EXPECT_EQ(texts.size(), named_things.size() + 3) << language;  // and those of all names
    }
}

TEST(ThingNames, AreMovedByHand) {
    Scene scene = rolling_scene();
    const auto before = names_of(scene, 10.0);
    scene.label_offsets_pt["inertia-ellipsoid"] = {-20.0, 10.0};
    const auto after = names_of(scene, 10.0);
    // A screen is 540 points high.
    const Eigen::Vector2d moved =
        after.at("inertia-ellipsoid").top_left_px - before.at("inertia-ellipsoid").top_left_px;
    EXPECT_LT((moved - Eigen::Vector2d(-40.0, 20.0)).norm(), 1e-9);
    EXPECT_EQ(after.at("herpolhode").top_left_px, before.at("herpolhode").top_left_px);
    // And so are labels of vectors.
    const auto label_of = [](const Drawing& drawing, std::string_view element, int number) {
        for (const Label& label : drawing.views[0].labels)
            if (label.name.element == element && label.name.number == number)
                return label.top_left_px;
        return Eigen::Vector2d(-1e9, -1e9);
    };
    const StagedScene plain(rolling_scene(), 10.0);
    scene.label_offsets_pt = {{"e1", {6.0, 3.0}}};
    const StagedScene staged(scene, 10.0);
    const Drawing was = plain.stage.at(5.0), is = staged.stage.at(5.0);
    EXPECT_LT(
        (label_of(is, "axes", 1) - label_of(was, "axes", 1) - Eigen::Vector2d(12.0, 6.0)).norm(),
        1e-9);
    EXPECT_EQ(label_of(is, "axes", 2), label_of(was, "axes", 2));
}

// Where a name can be read it moves at most a little faster than what it names: it does not jump.
TEST(ThingNames, MoveSmoothly) {
    const StagedScene staged(rolling_scene(), 10.0);
    std::map<std::string, Label> before;
    double largest_px = 0.0;
    int n_seen = 0;
    constexpr int n_frames = 600;
    for (int k = 0; k < n_frames; ++k) {
        const Drawing drawing = staged.stage.at(10.0 * k / n_frames);
        auto now = names_in(drawing);
        for (const auto& [name, label] : now) {
            const auto was = before.find(name);
            if (was == before.end() || std::min(was->second.opacity, label.opacity) < 0.5) continue;
            ++n_seen;
            largest_px = std::max(largest_px, (label.top_left_px - was->second.top_left_px).norm());
        }
        before = std::move(now);
    }
    EXPECT_GT(n_seen, 2.5 * n_frames);
    // The outermost point of the polhode moves by up to 20 px.
    EXPECT_LT(largest_px, 30.0);
    RecordProperty("largest_px", static_cast<int>(largest_px));
}

// In a film a name fades with its curve; a still has it or says that it is absent.
TEST(ThingNames, OfStillsAreWholeOrReportedAsAbsent) {
    const Scene scene = rolling_scene();
    const StagedScene film(scene, 10.0);
    int n_faded = 0, n_hidden = 0;
    for (int k = 0; k <= 25; ++k) {
        const double time_s = 0.4 * k;
        for (const auto& [name, label] : names_in(film.stage.at(time_s)))
            n_faded += label.opacity < 0.99;
        const StagedScene still(scene, time_s, 0.0, true);
        const Drawing drawing = still.stage.at(time_s);
        const auto names = names_in(drawing);
        std::map<std::string_view, bool> in_sight;
        for (const UnnamedThing& thing : drawing.unnamed) in_sight[thing.name] = thing.is_in_sight;
        for (const View& view : drawing.views)
            for (const Label& label : view.labels) EXPECT_EQ(label.opacity, 1.0) << time_s;
        for (const char* name : {"polhode", "herpolhode", "inertia-ellipsoid", "invariable-plane"})
            EXPECT_NE(names.contains(name), in_sight.contains(name)) << name << " " << time_s;
        for (const auto& [name, seen] : in_sight) n_hidden += seen ? 0 : 1;
        // At the start both curves are points.
        if (k == 0) {
            EXPECT_FALSE(in_sight.at("polhode"));
            EXPECT_FALSE(in_sight.at("herpolhode"));
        }
    }
    EXPECT_GT(n_faded, 3);
    EXPECT_GT(n_hidden, 3);
}

// The line of a name ends at its thing, and touches no other label, which it would seem to name.
TEST(ThingNames, HaveLeadersThatTouchNoOtherLabel) {
    Scene scene = free_scene({0.052, 0.043, 0.011}, {2.0, 9.0, 4.0}, "space");
    scene.names.reset();
    scene.film.width_px = 1016;  // 86 mm at 300 dpi
    scene.film.height_px = 571;
    int n_leaders = 0;
    for (int k = 1; k <= 20; ++k) {
        const StagedScene still(scene, 0.2 * k, 300.0 / 72.0 / 4.0, true);
        const Drawing drawing = still.stage.at(0.2 * k);
        const View& view = drawing.views.front();
        for (const Curve& curve : view.curves) {
            if (curve.name.part != "leader" || curve.name.element == "axes") continue;
            const bool is_of_thing = std::find(named_things.begin(), named_things.end(),
                                               curve.name.element) != named_things.end();
            if (!is_of_thing) continue;
            ++n_leaders;
            const Eigen::Vector2d from = project(view, curve.placement.translation()).px;
            const Eigen::Vector2d to =
                project(view, curve.placement * Eigen::Vector3d::UnitX().eval()).px;
            for (const Label& label : view.labels)
                if (label.name.element != curve.name.element) {
                    EXPECT_LT(label_box(label).length_inside(from, to), 2.0)
                        << curve.name.element << " at " << 0.2 * k;
                }
        }
    }
    EXPECT_GT(n_leaders, 5);
}

// Both cones share the generator at the contact; a leader that ended there would name either.
TEST(ThingNames, OfConesPointToTheirFarSides) {
    Scene cones = free_scene({2.0, 2.0, 0.8}, {0.8, 0.0, 2.0}, "space");
    cones.names = {"body-cone", "space-cone"};
    cones.film.width_px = 1920;
    cones.film.height_px = 1080;
    int n_names = 0;
    for (int k = 1; k <= 10; ++k) {
        const StagedScene still(cones, 1.0 * k, 0.0, true);
        const Drawing drawing = still.stage.at(1.0 * k);
        const View& view = drawing.views.front();
        ASSERT_EQ(view.cones.size(), 2u);
        for (const auto& [name, label] : names_in(drawing)) {
            ++n_names;
            const bool is_body = view.cones[0].name.part == "body";
            const Cone& other = view.cones[(name == "body-cone") == is_body ? 1 : 0];
            const Eigen::Vector3d way = (*label.at - other.apex).normalized();
            const double off_rad = std::abs(std::acos(way.dot(other.axis)) - other.half_angle_rad);
            EXPECT_GT(off_rad, 0.1) << name << " " << k;
        }
    }
    EXPECT_GE(n_names, 12);
}

// The name of a trail stands at its young part, not where it has faded away.
TEST(ThingNames, OfTrailsStandWhereTheyAreSeen) {
    Scene scene = rolling_scene();
    scene.names = {"herpolhode"};
    scene.trail.herpolhode = "fading";
    int n_names = 0;
    for (int k = 4; k <= 10; ++k) {
        const StagedScene still(scene, 1.0 * k, 0.0, true);
        const Drawing drawing = still.stage.at(1.0 * k);
        const View& view = drawing.views.front();
        const auto names = names_in(drawing);
        const Curve* trail = nullptr;
        for (const Curve& curve : view.curves)
            if (curve.name == ShapeName{"herpolhode", 0, ""} && curve.fade_points > 0.0)
                trail = &curve;
        if (!names.contains("herpolhode") || trail == nullptr) continue;
        ++n_names;
        // A young part: turns of the trail may lie on each other.
        double share = 0.0;
        const auto& points = trail->geometry->points;
        for (double i = std::ceil(trail->first); i <= trail->last; i += 1.0) {
            const Eigen::Vector3d at =
                trail->placement * points[static_cast<std::size_t>(i) % points.size()];
            const double px =
                (project(view, at).px - project(view, *names.at("herpolhode").at).px).norm();
            if (px < 5.0) share = (i - trail->first) / (trail->last - trail->first);
        }
        EXPECT_GT(share, 0.5) << k;
    }
    EXPECT_GE(n_names, 4);
}

TEST(ThingNames, WithoutRoomAreReported) {
    Scene scene = rolling_scene();
    scene.film.width_px = 240;
    scene.film.height_px = 135;
    const StagedScene staged(scene, 10.0);
    const Drawing drawing = staged.stage.at(5.0);
    const auto names = names_in(drawing);
    std::set<std::string_view> told;
    for (const UnnamedThing& thing : drawing.unnamed) told.insert(thing.name);
    for (const char* name : {"polhode", "herpolhode", "inertia-ellipsoid", "invariable-plane"})
        EXPECT_TRUE(told.contains(name) || (names.contains(name) && names.at(name).opacity >= 0.5))
            << name;
    EXPECT_FALSE(told.empty());
}

}  // namespace
}  // namespace poinsot::thing_names_tests
