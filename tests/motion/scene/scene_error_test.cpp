// Every error of a scene knows its file, line and column.
#include "scene/scene_error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene_text.h"

namespace poinsot {
namespace {

InputPlace place_of_refused(const std::string& text, const std::vector<std::string>& overrides) {
    try {
        scene_of(text, overrides);
    } catch (const InputError& error) {
        return error.place().value_or(InputPlace{});
    }
    return {"not refused"};
}

TEST(SceneError, KnowsItsPlaceAsAnInputError) {
    const InputPlace unknown = place_of_refused(a_scene + "speed_rad_s = 3.0\n", {});
    EXPECT_EQ(unknown.file, "scenes/a.toml");
    EXPECT_EQ(unknown.line, 6);
    EXPECT_EQ(unknown.column, 1);
    const InputPlace not_toml = place_of_refused("[body\n", {});
    EXPECT_EQ(not_toml.file, "scenes/a.toml");
    EXPECT_EQ(not_toml.line, 1);
    EXPECT_GT(not_toml.column, 1);
    // A value of --set comes from no file.
    const InputPlace set = place_of_refused(a_scene, {"film.fps=-3"});
    EXPECT_EQ(set.file, "--set film.fps=-3");
    EXPECT_EQ(set.line, 0);
}

}  // namespace
}  // namespace poinsot
