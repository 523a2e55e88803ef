// Every panel: finite for extreme motions, and refused for motions that it cannot show.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/stage/panel_kind.h"
#include "error/error.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(Panels, AreFiniteForExtremeMotions) {
    for (const char* kind : {"space", "body", "plan", "momentum", "object", "plot"}) {
        for (const FreeCase& one : extremes) {
            const std::string name = std::string(kind) + ", " + one.name;
            const StagedScene staged(free_scene(one.moments, one.omega, kind), 10.0);
            for (const double t : {0.0, 3.7, 10.0}) {
                const Drawing drawing = staged.stage.at(t);
                for (const View& view : drawing.views) expect_finite(view, name);
            }
        }
    }
}

TEST(Panels, WithMeasuredMotionsAreFiniteForExtremeMotions) {
    for (const char* kind : {"space", "body", "plan", "momentum", "object", "plot"}) {
        for (const FreeCase& one : extremes) {
            Scene scene = free_scene(one.moments, one.omega, kind);
            measure(scene, 10.0, 41, 1.01);
            const StagedScene staged(scene, 10.0);
            for (const double t : {0.0, 3.7, 10.0})
                for (const View& view : staged.stage.at(t).views)
                    expect_finite(view, std::string(kind) + ", " + one.name);
        }
    }
}

TEST(Panels, OfTopsAreFiniteForExtremeMotions) {
    for (const char* kind : {"top", "potential", "plot", "object"}) {
        for (const TopCase& one : tops) {
            const std::string name = std::string(kind) + ", " + one.name;
            const StagedScene staged(top_scene(one.start, kind, one.mgl_N_m), 10.0);
            for (const double t : {0.0, 3.7, 10.0}) {
                const Drawing drawing = staged.stage.at(t);
                for (const View& view : drawing.views) expect_finite(view, name);
            }
        }
    }
}

// Expects that the charts of all quantities of a motion are finite; returns their number.
int n_finite_charts(Scene scene, const std::string& name) {
    int n = 0;
    for (const PlotQuantity& quantity : plot_quantities()) {
        scene.panels.front().quantity = quantity.name;
        std::optional<StagedScene> staged;
        try {
            staged.emplace(scene, 10.0);
        } catch (const InputError&) {
            continue;  // it needs another kind of motion
        }
        ++n;
        for (const double t : {0.0, 3.7, 10.0})
            expect_finite(staged->stage.at(t).views.front(), std::string(quantity.name) + name);
    }
    return n;
}

TEST(Panels, EveryQuantityIsFiniteForExtremeMotions) {
    for (const FreeCase& one : extremes)
        EXPECT_GE(n_finite_charts(free_scene(one.moments, one.omega, "plot"), one.name), 5);
    for (const TopCase& one : tops)
        EXPECT_GE(n_finite_charts(top_scene(one.start, "plot", one.mgl_N_m), one.name), 5);
    for (const FreeCase& one : extremes) {
        Scene scene = free_scene(one.moments, one.omega, "plot");
        measure(scene, 10.0, 41, 1.01);
        EXPECT_GE(n_finite_charts(scene, one.name), 8);
    }
}

TEST(Panels, EveryKindCanBeMade) {
    for (const PanelKind& kind : panel_kinds()) {
        const Scene scene = scene_for(kind);
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        const View& view = view_of(drawing);
        EXPECT_GT(view.curves.size() + view.meshes.size(), 0u) << kind.name;
        EXPECT_GT(view.labels.size(), 0u) << kind.name;
        EXPECT_EQ(&panel_kind_named(kind.name), &kind);
    }
}

TEST(Panels, RejectMotionsThatTheyCannotShow) {
    EXPECT_THROW(StagedScene(top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "body"), 1.0),
                 InputError);
    EXPECT_THROW(StagedScene(free_scene(generic_moments, generic_omega, "top"), 1.0), InputError);
    EXPECT_THROW(StagedScene(free_scene(generic_moments, {0.0, 0.0, 0.0}, "plan"), 1.0),
                 InputError);
}

TEST(Panels, DefaultSuitsTheMotion) {
    Scene top = top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "top");
    top.panels.clear();
    EXPECT_EQ(StagedScene(top, 1.0).stage.panels().front().spec.kind, "top");
    Scene free = free_scene(generic_moments, generic_omega, "space");
    free.panels.clear();
    EXPECT_EQ(StagedScene(free, 1.0).stage.panels().front().spec.kind, "space");
}

}  // namespace
}  // namespace poinsot::panels_tests
