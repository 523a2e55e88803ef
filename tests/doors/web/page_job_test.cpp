// Pages and the workbench as files: the pictures of the workbench's gallery.
#include "web/pack/page_job.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "drawing/stage/stage.h"
#include "places.h"
#include "production/session/picture_setting.h"
#include "production/session/session.h"
#include "scene/files/load_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// Text in a picture as small as a thumb's nail is dust.
TEST(Gallery, ThumbnailsHaveNoLetters) {
    int n_scenes = 0, n_shapes = 0;
    for (const std::filesystem::path& file : supplied_scenes()) {
        std::vector<Override> overrides = thumbnail_overrides();
        overrides.push_back(
            {"film.size", fmt::format("{}x{}", thumbnail_px, thumbnail_px * 9 / 16)});
        SessionRequest request;
        request.fonts = installed_fonts();
        const Session session = session_of(load_scene(file, overrides), request);
        const double time_s = session.scene.film.start_s;
        // The masks of a drawing's labels belong to its stage.
        const Stage stage = stage_of(session, {.first_time_s = time_s, .last_time_s = time_s},
                                     setting_of(session.scene, request.print));
        const Drawing drawing = stage.at(time_s);
        for (const View& view : drawing.views) {
            for (const Label& label : view.labels)
                EXPECT_TRUE(label.mask == nullptr || label.mask->letters.empty())
                    << file << " " << label.mask->source.text;
            n_shapes += static_cast<int>(view.curves.size() + view.arrows.size() +
                                         view.ellipsoids.size() + view.meshes.size());
        }
        ++n_scenes;
    }
    EXPECT_GT(n_scenes, 40);
    EXPECT_GT(n_shapes, 10 * n_scenes);
}

}  // namespace
}  // namespace poinsot
