// A scene that is written and read again is exactly the same scene.
#include "scene/write_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "places.h"
#include "scene/camera_views.h"
#include "scene/toml/toml_text.h"
#include "scene_text.h"

namespace poinsot {

namespace {

TEST(RoundTrip, DoublesOfEveryNotationAreReadBack) {
    for (const double value : {0.0, -0.0, 1.0, 1e20, 1e21, 5e-324, -1.7976931348623157e308,
                               2.2250738585072014e-308, 0.1, 1e-5}) {
        const Scene scene = scene_of(a_scene + "[film]\nstart_s = " + toml_text(value) + "\n");
        EXPECT_EQ(bits(scene.film.start_s), bits(value)) << toml_text(value);
    }
}

TEST(RoundTrip, AttitudesOfAnyLengthAreReadBack) {
    for (const Eigen::Vector4d& given :
         {Eigen::Vector4d{0.5, -0.5, 0.5, 0.5}, {-0.3, 0.1, 0.9, -0.2}, {0.0, 1.0, 1e-9, 0.7}}) {
        for (const int exponent : {-900, 0, 900}) {
            const Eigen::Vector4d q = std::ldexp(1.0, exponent) * given;
            const Scene scene = scene_of(a_scene + "attitude = " + toml_text(q) + "\n");
            // measured 3e-16
            EXPECT_LT(std::abs(scene.start.space_from_body.norm() - 1.0), 1e-15);
            EXPECT_GE(scene.start.space_from_body.w(), 0.0);
            const Scene again = scene_of(to_toml(scene));
            EXPECT_EQ(again.start.space_from_body.coeffs(), scene.start.space_from_body.coeffs());
        }
    }
}

// In TOML a line belongs to the header above it.
TEST(RoundTrip, KeysWithoutATableAreWrittenFirst) {
    const std::string given =
        "show = [\"plane\"]\nlabels = false\nunlabelled = [\"omega\"]\n"
        "[symbols]\nomega = \"w\"\n" +
        a_scene;
    const Scene scene = scene_of(given);
    const std::string written = to_toml(scene);
    for (const char* key : {"\nshow = ", "\nlabels = ", "\nunlabelled = "})
        EXPECT_LT(written.find(key), written.find("\n[")) << written;
    const Scene again = scene_of(written);
    EXPECT_EQ(to_toml(again), written);
    EXPECT_EQ(again.show, scene.show);
    EXPECT_FALSE(again.labels);
    EXPECT_EQ(again.unlabelled, scene.unlabelled);
    EXPECT_EQ(again.symbols.omega, "w");
}

TEST(RoundTrip, NoNamesAreReadBack) {
    // true is the default, and false is no name at all.
    EXPECT_FALSE(scene_of("names = true\n" + a_scene).names);
    const Scene none = scene_of(to_toml(scene_of("names = false\n" + a_scene)));
    ASSERT_TRUE(none.names);
    EXPECT_TRUE(none.names->empty());
}

// A view's aim is not written together with a target, which contradicts it.
TEST(RoundTrip, TargetsWithAViewAreReadBack) {
    for (const CameraView& view : camera_views()) {
        const Scene scene = scene_of(a_scene + "[camera]\nview = \"" + std::string(view.name) +
                                     "\"\ntarget = [1.0, 2.0, 3.0]\n");
        const Scene again = scene_of(to_toml(scene));
        EXPECT_EQ(again.camera.target, Eigen::Vector3d(1.0, 2.0, 3.0)) << view.name;
        EXPECT_EQ(to_toml(again), to_toml(scene)) << view.name;
    }
}

TEST(RoundTrip, NegativeZerosOfAnAttitudeAreReadBack) {
    // Also for −1, 0, 0, 0, whose sign is changed.
    for (const char* attitude : {"[1.0, -0.0, 0.0, 0.0]", "[-1.0, 0.0, 0.0, 0.0]"}) {
        const Scene scene = scene_of(a_scene + "attitude = " + attitude + "\n");
        const Scene again = scene_of(to_toml(scene));
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(bits(again.start.space_from_body.coeffs()[i]),
                      bits(scene.start.space_from_body.coeffs()[i]))
                << attitude;
    }
}

// A printed still has as many pixels as its size in inches times its dots per inch.
TEST(RoundTrip, LargestStillsAreReadBack) {
    Scene scene = scene_of(a_scene);
    scene.film.width_px = 65536;
    scene.film.height_px = 16385;
    const Scene again = scene_of(to_toml(scene));
    EXPECT_EQ(again.film.width_px, 65536);
    EXPECT_EQ(again.film.height_px, 16385);
}

TEST(RoundTrip, EverySceneOfTheLectureIsReadBack) {
    int n_scenes = 0;
    for (const std::filesystem::path& file : supplied_scenes()) {
        ++n_scenes;
        const Scene scene = load_scene(file);
        const Scene again = parse_scene(to_toml(scene), file.string(), {}, files_of_folder());
        EXPECT_EQ(to_toml(again), to_toml(scene)) << file;
    }
    EXPECT_GE(n_scenes, 10);
}

}  // namespace

}  // namespace poinsot
