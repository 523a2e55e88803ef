// Pages of a column's width: every scene at 85 mm in the theme for print.
#include "production/session/paper_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "drawing/stage/overlay.h"
#include "drawing/stage/panel.h"
#include "drawing/stage/type/labels.h"
#include "places.h"
#include "production/session/picture_setting.h"
#include "production/session/session.h"
#include "scene/files/load_scene.h"
#include "shapes/projection.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

constexpr double column_mm = 85.0;

SessionRequest on_a_column(double type_pt = default_type_pt) {
    SessionRequest request{installed_fonts()};
    request.print.width_mm = column_mm;
    request.print.type_pt = type_pt;
    return request;
}

Session session_at_column(const std::filesystem::path& file, std::vector<Override> overrides = {}) {
    overrides.push_back({"theme", "print"});
    return session_of(load_scene(file, overrides), on_a_column());
}

Drawing drawing_of(const Session& session, const Stage& stage) {
    return stage.at(session.scene.film.start_s);
}

Stage stage_of(const Session& session) {
    const PrintChoices print = on_a_column().print;
    return stage_of(session, {session.scene.film.start_s, session.scene.film.start_s, {}},
                    setting_of(session.scene, print));
}

TEST(PaperLayout, TitleAndCaptionTakeAQuarterOfThePageAtMost) {
    for (const std::filesystem::path& file : supplied_scenes()) {
        const Session session = session_at_column(file);
        const auto paper = print_size_of(on_a_column().print, 1920, 1080);
        const int overlays_px =
            rows_of_overlays(session.scene, session.fonts, session.scene.film.width_px,
                             paper->line_scale, paper->least);
        EXPECT_LE(4 * overlays_px, session.scene.film.height_px) << file;
    }
}

// Hand-outs of the lecture, 160 mm wide, with type of 11 pt, which is larger than that of
// `--slides`: every arrow has its name, and every axis of its own.
TEST(PaperLayout, HandOutsOfTheLectureNameTheirArrows) {
    SessionRequest request{installed_fonts()};
    request.print.width_mm = 160.0;
    request.print.type_pt = 11.0;
    const Session session = session_of(
        load_scene((source_folder() / "scenes/lecture.toml").string(), std::vector<Override>{}),
        request);
    const FilmPlan film = film_plan(session);
    PictureSpan span = whole_film(film);
    span.is_still = true;
    const Stage stage = poinsot::stage_of(session, span, setting_of(session.scene, request.print));
    const auto view_at = [&](const StopSpec& stop) {
        const std::int64_t frame = std::min(film.frame_at(stop.at_s), film.n_frames - 1);
        return stage.at(film.moment_of(frame)).views.front();
    };
    for (const StopSpec& stop : session.scene.stops) {
        const View view = view_at(stop);
        const auto n_names = [&view](std::string_view element) {
            return std::count_if(view.labels.begin(), view.labels.end(), [&](const Label& label) {
                return label.name.element == element && label.opacity > 0.5;
            });
        };
        std::set<std::string_view> shown;
        // Seen along it, an arrow is a dot: L in the view from above, of which the caption speaks.
        const Projection projection(view);
        const auto is_seen = [&](const Arrow& arrow) {
            return arrow.opacity > 0.5 &&
                   (projection.place(arrow.tip) - projection.place(arrow.tail)).norm() >
                       0.02 * view.height_px;
        };
        for (const Arrow& arrow : view.arrows)
            if (is_seen(arrow)) shown.insert(arrow.name.element);
        for (const std::string_view element :
             {"omega", "momentum", "radius", "gradient", "direction", "spin-direction"})
            if (shown.contains(element)) {
                EXPECT_GE(n_names(element), 1) << stop.title << ": " << element;
            }
        for (const std::string_view element : {"axes", "body-beside"})
            if (shown.contains(element)) {
                EXPECT_EQ(n_names(element), 3) << stop.title << ": " << element;
            }
    }
    // The sixth stop names the three half-axes.
    const View view = view_at(session.scene.stops.at(5));
    EXPECT_EQ(std::count_if(view.labels.begin(), view.labels.end(),
                            [](const Label& label) {
                                return label.name.element == "half-axes" && label.opacity > 0.5;
                            }),
              3);
    // The fifteenth has no plane, which the edges of the panel would cut.
    const View from_above = view_at(session.scene.stops.at(14));
    EXPECT_TRUE(std::none_of(from_above.planes.begin(), from_above.planes.end(),
                             [](const Plane& plane) { return plane.opacity > 0.0; }));
}

TEST(PaperLayout, NoPanelLiesUnderTitleOrCaption) {
    for (const std::filesystem::path& file : supplied_scenes()) {
        const Session session = session_at_column(file);
        const Stage stage = stage_of(session);
        const Drawing drawing = drawing_of(session, stage);
        for (const View& view : drawing.views) {
            if (!view.name.empty()) continue;  // a panel's
            for (const Label& label : view.labels) {
                const double top = label.top_left_px.y(), bottom = top + label.mask->height_px();
                for (const Panel& panel : stage.panels())
                    EXPECT_TRUE(bottom <= panel.box.y_px ||
                                top >= panel.box.y_px + panel.box.height_px)
                        << file << ": " << label.mask->source.text;
            }
        }
    }
}

// A plane ends inside its panel, so that no edge cuts it.
TEST(PaperLayout, PlanesEndInsideTheirPanels) {
    int n_planes = 0;
    for (const std::filesystem::path& file : supplied_scenes()) {
        const Session session = session_at_column(file);
        // A camera may stand nearer than what fits, as that of the cover does.
        if (session.scene.camera.distance < 5.0) continue;
        const Stage stage = stage_of(session);
        const Drawing drawing = drawing_of(session, stage);
        for (std::size_t k = 0; k < stage.panels().size(); ++k) {
            const Panel& panel = stage.panels()[k];
            if (panel.camera_at) continue;  // a camera may move close to it
            for (const Plane& plane : drawing.views[k].planes) {
                ++n_planes;
                const Eigen::Vector3d x = plane.normal.unitOrthogonal();
                const Eigen::Vector3d y = plane.normal.cross(x);
                for (int i = 0; i < 64; ++i) {
                    const double angle = 2.0 * std::numbers::pi * i / 64;
                    const Eigen::Vector2d at =
                        project(drawing.views[k],
                                plane.centre +
                                    plane.radius * (std::cos(angle) * x + std::sin(angle) * y))
                            .px;
                    // The last fiftieth of the radius is invisible.
                    const double slack = 0.02 * panel.box.width_px;
                    EXPECT_TRUE(at.x() > panel.box.x_px - slack &&
                                at.x() < panel.box.x_px + panel.box.width_px + slack &&
                                at.y() > panel.box.y_px - slack &&
                                at.y() < panel.box.y_px + panel.box.height_px + slack)
                        << file << ", panel " << k << ": " << at.transpose();
                }
            }
        }
    }
    EXPECT_GT(n_planes, 20);
}

TEST(PaperLayout, TallPanelsStandAboveTheOthers) {
    const std::string file = (source_folder() / "scenes/separatrix.toml").string();
    const Session session = session_at_column(file);
    const Scene& scene = session.scene;
    EXPECT_EQ(scene.grid.columns, (std::vector<double>{1.0, 1.0}));
    ASSERT_EQ(scene.grid.rows.size(), 2u);
    EXPECT_EQ(scene.panels[0].kind, "space");
    EXPECT_EQ(scene.panels[0].columns, 2);
    EXPECT_EQ(scene.panels[0].rows, 1);
    for (const std::size_t k : {1u, 2u}) {
        EXPECT_EQ(scene.panels[k].row, 1);
        EXPECT_EQ(scene.panels[k].column, static_cast<int>(k) - 1);
    }
    EXPECT_NE(session.as_read.find("grid.rows"), std::string::npos) << session.as_read;
    EXPECT_TRUE(std::any_of(session.notes.begin(), session.notes.end(), [](const auto& note) {
        return note.find("large panels have a row of their own") != std::string::npos;
    }));

    // A page of two columns, or one whose height is given, keeps the grid of the scene.
    SessionRequest request = on_a_column();
    request.print.height_mm = 60.0;
    EXPECT_EQ(session_of(load_scene(file), request).scene.grid.columns.front(), 1.45);
    request.print.height_mm.reset();
    request.print.width_mm = 178.0;
    EXPECT_EQ(session_of(load_scene(file), request).scene.grid.columns.front(), 1.45);
}

// Title > headings > names > numbers, each of one size in the whole figure, at any size of labels.
// Names and axes have no room in a panel of two centimetres: a note says so.
TEST(PaperLayout, NarrowPanelsAreNoted) {
    const auto narrow = [](std::vector<Override> overrides) {
        const std::string file = (source_folder() / "scenes/four_views.toml").string();
        std::vector<std::string> found;
        for (const std::string& note : session_at_column(file, std::move(overrides)).notes)
            if (note.find("narrowest panel") != std::string::npos) found.push_back(note);
        return found;
    };
    EXPECT_TRUE(narrow({}).empty());  // two panels of 42.5 mm
    const std::vector<std::string> notes = narrow({{"grid.columns", "[1.0, 3.0]"}});
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("on a page 85 mm wide, the narrowest panel is 21 mm wide"),
              std::string::npos)
        << notes[0];
}

TEST(PaperLayout, SizesOfTypeFollowOneHierarchy) {
    for (const double type_pt : {7.0, default_type_pt, 12.0})
        for (const char* name : {"separatrix", "heavy_top_cusp", "four_views", "stable_largest"}) {
            SessionRequest request = on_a_column(type_pt);
            request.print.least_type_pt = std::min(type_pt, 8.0);
            request.print.height_mm = 200.0;  // space for all text
            const Session session = session_of(
                load_scene((source_folder() / "scenes" / (std::string(name) + ".toml")).string(),
                           std::vector<Override>{{"theme", "print"}}),
                request);
            const Stage stage =
                poinsot::stage_of(session, {}, setting_of(session.scene, request.print));
            const Drawing drawing = stage.at(session.scene.film.start_s);
            std::map<int, std::set<double>> sizes;  // by rank
            for (const View& view : drawing.views)
                for (const Label& label : view.labels)
                    sizes[label.rank].insert(std::round(100.0 * label.mask->source.em_px) / 100.0);
            ASSERT_EQ(sizes[rank_of_title].size(), 1u) << name;
            ASSERT_EQ(sizes[rank_of_headings].size(), 1u) << name;
            ASSERT_EQ(sizes[rank_of_names].size(), 1u) << name << type_pt;
            EXPECT_GT(*sizes[rank_of_title].begin(), *sizes[rank_of_headings].begin()) << name;
            EXPECT_GT(*sizes[rank_of_headings].begin(), *sizes[rank_of_names].begin()) << name;
            for (const auto& [rank, of_rank] : sizes) {
                if (rank <= rank_of_title) continue;
                EXPECT_LE(*of_rank.rbegin(), *sizes[rank_of_names].begin() + 0.01)
                    << name << ", rank " << rank;
            }
        }
}

}  // namespace
}  // namespace poinsot
