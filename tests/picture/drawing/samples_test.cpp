// Supersampling refines a picture and does not move its contents.
#include <gtest/gtest.h>

#include "drawing/stage/panel.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

struct Place {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    Camera camera;
};

// A picture with this number of samples per side of a pixel, and its stage.
struct Sampled {
    Sampled(const Scene& scene, int samples)
        : motion(problem_of(scene)),
          stage(scene, theme_of(scene), motion,
                {.width_px = scene.film.width_px * samples,
                 .height_px = scene.film.height_px * samples,
                 .samples = samples,
                 .last_time_s = 3.0,
                 .fonts = installed_fonts()}),
          drawing(stage.at(1.0)) {}
    Motion motion;
    Stage stage;
    Drawing drawing;
};

// Positions of a picture's views.
std::vector<Place> places(const Scene& scene, int samples) {
    const Sampled picture(scene, samples);
    std::vector<Place> all;
    for (const View& view : picture.drawing.views)
        all.push_back({view.x_px, view.y_px, view.width_px, view.height_px, view.camera});
    return all;
}

Scene with_type(std::vector<std::string> kinds) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, kinds.front());
    scene.title = "Where things stand";
    scene.caption = "$I$ = (1, 2, 2.9) kg m$^2$";
    scene.panels.clear();
    for (const std::string& kind : kinds) {
        PanelSpec spec;
        spec.kind = kind;
        spec.column = static_cast<int>(scene.panels.size());
        scene.panels.push_back(spec);
    }
    scene.grid.columns.assign(kinds.size(), 1.0);
    return scene;
}

TEST(Samples, DoNotMovePanelsAndCameras) {
    const std::vector<std::vector<std::string>> pictures{
        {"space"}, {"plan"}, {"space", "body", "plot"}};
    for (const std::vector<std::string>& kinds : pictures) {
        // 643 pixels are not a multiple of the number of columns; heights of text are rounded
        // differently at each size.
        for (const int width_px : {640, 643, 960}) {
            Scene scene = with_type(kinds);
            scene.film.width_px = width_px;
            scene.film.height_px = 9 * width_px / 16;
            const std::vector<Place> alone = places(scene, 1);
            for (const int n : {2, 3, 4}) {
                const std::vector<Place> fine = places(scene, n);
                ASSERT_EQ(fine.size(), alone.size());
                for (std::size_t k = 0; k < fine.size(); ++k) {
                    const Place &a = alone[k], &b = fine[k];
                    EXPECT_EQ(b.x_px, n * a.x_px) << kinds[0] << width_px;
                    EXPECT_EQ(b.y_px, n * a.y_px) << kinds[0] << width_px;
                    EXPECT_EQ(b.width_px, n * a.width_px) << kinds[0] << width_px;
                    EXPECT_EQ(b.height_px, n * a.height_px) << kinds[0] << width_px;
                    // Charts and text are drawn in rendered pixels, whose number differs. Other
                    // cameras agree up to rounding.
                    if (a.camera.orthographic) continue;
                    EXPECT_LT((b.camera.eye - a.camera.eye).norm(), 1e-9 * a.camera.eye.norm());
                    EXPECT_LT((b.camera.target - a.camera.target).norm(),
                              1e-9 * a.camera.eye.norm());
                }
            }
        }
    }
}

// Ends of the lines of all flat views, and positions of their text, in final pixels.
struct Sheet2d {
    std::vector<Eigen::Vector2d> ends, type;
};

Sheet2d flat_parts(const Scene& scene, int samples) {
    const Sampled picture(scene, samples);
    Sheet2d builder;
    for (const View& view : picture.drawing.views) {
        if (!view.camera.orthographic) continue;
        for (const Curve& curve : view.curves)
            for (const Eigen::Vector3d& point :
                 {curve.geometry->points.front(), curve.geometry->points.back()})
                builder.ends.emplace_back((curve.placement * point).head<2>() / samples);
        for (const Label& label : view.labels)
            builder.type.emplace_back(label.top_left_px / samples);
    }
    return builder;
}

TEST(Samples, DoNotChangeCharts) {
    for (const int width_px : {640, 643, 960}) {
        Scene scene = with_type({"space", "plot"});
        scene.film.width_px = width_px;
        scene.film.height_px = 9 * width_px / 16;
        const Sheet2d alone = flat_parts(scene, 1);
        ASSERT_GT(alone.ends.size(), 20u);
        ASSERT_GT(alone.type.size(), 8u);
        for (const int n : {2, 3, 4}) {
            const Sheet2d fine = flat_parts(scene, n);
            ASSERT_EQ(fine.ends.size(), alone.ends.size());
            ASSERT_EQ(fine.type.size(), alone.type.size());
            for (std::size_t k = 0; k < fine.ends.size(); ++k)
                EXPECT_LT((fine.ends[k] - alone.ends[k]).norm(), 1e-6) << width_px << " " << n;
            for (std::size_t k = 0; k < fine.type.size(); ++k)
                EXPECT_LT((fine.type[k] - alone.type[k]).norm(), 1e-6)
                    << width_px << " " << n << " " << k;
        }
    }
}

// The masks of all views, and their positions in final pixels.
TEST(Samples, DoNotChangeText) {
    const std::vector<std::vector<std::string>> pictures{{"space", "plot"}, {"momentum", "plan"}};
    for (const std::vector<std::string>& kinds : pictures) {
        const Scene scene = with_type(kinds);
        const Sampled alone(scene, 1);
        for (const int n : {2, 3, 4}) {
            const Sampled fine(scene, n);
            ASSERT_EQ(fine.drawing.views.size(), alone.drawing.views.size());
            for (std::size_t k = 0; k < fine.drawing.views.size(); ++k) {
                const std::vector<Label>&a = alone.drawing.views[k].labels,
                      &b = fine.drawing.views[k].labels;
                ASSERT_EQ(b.size(), a.size()) << kinds[0] << n;
                for (std::size_t i = 0; i < a.size(); ++i) {
                    EXPECT_LT((b[i].top_left_px / n - a[i].top_left_px).norm(), 1e-6)
                        << kinds[0] << n;
                    EXPECT_NEAR(b[i].halo_px / n, a[i].halo_px, 1e-12);
                    EXPECT_EQ(b[i].mask->samples, n);
                    EXPECT_EQ(b[i].mask->width, a[i].mask->width);
                    EXPECT_EQ(b[i].mask->coverage, a[i].mask->coverage) << kinds[0] << n;
                }
            }
        }
    }
}

}  // namespace
}  // namespace poinsot
