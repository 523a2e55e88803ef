#include <gtest/gtest.h>
#include <poinsot/error.h>
#include <poinsot/motion.h>
#include <poinsot/scene.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "image/files/png_files.h"
#include "system/files/atomic_file.h"
#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using poinsot::EnvironmentError;
using poinsot::InputError;
using poinsot::library::Motion;
using poinsot::library::Scene;
using poinsot::library::State;
using poinsot::library::Still;
using poinsot::library::Table;
using poinsot::library::Watch;

const std::string text = R"([body]
moments_kg_m2 = [4.0, 3.0, 1.5]
[start]
omega_rad_s = [1.2, 0.8, 2.4]
[film]
size = "64x36"
duration_s = 4.0
)";

TEST(LibraryScene, SamplesAreThoseOfTheMotionColumnByColumn) {
    const std::array<double, 4> times{-3.0, 0.0, 0.25, 1e9};
    const Table table = Scene::from_text(text).sample(times);
    const Motion motion({4.0, 3.0, 1.5}, {1.2, 0.8, 2.4});
    ASSERT_EQ(table.n_rows, times.size());
    ASSERT_EQ(table.values.size(), table.names.size() * times.size());
    ASSERT_EQ(table.names[2], "omega_body_2");
    ASSERT_EQ(table.names[4], "q_w");
    for (std::size_t row = 0; row < times.size(); ++row) {
        const State state = motion.at(times[row]);
        EXPECT_EQ(table.values[0 * times.size() + row], times[row]);
        EXPECT_EQ(table.values[2 * times.size() + row], state.omega_body[1]);
        EXPECT_EQ(table.values[4 * times.size() + row], state.space_from_body.w());
    }
}

TEST(LibraryScene, ValuesReplaceThoseOfTheText) {
    const Scene scene = Scene::from_text(text, "top.toml");
    const Scene other = scene.with({"start.omega_rad_s=[0.0, 0.0, 2.0]", "film.size=32x18"});
    EXPECT_EQ(other.name(), "top");
    EXPECT_EQ(scene.width_px(), 64);
    EXPECT_EQ(other.width_px(), 32);
    const std::array<double, 1> now{0.5};
    EXPECT_EQ(other.sample(now).values[3], 2.0);
    EXPECT_EQ(other.values().size(), 2u);
}

TEST(LibraryScene, ErrorsKnowTheirPlace) {
    try {
        Scene::from_text("[body]\nmoments_kg_m2 = [1, 2]\n", "bad.toml");
        FAIL();
    } catch (const InputError& error) {
        ASSERT_TRUE(error.place());
        EXPECT_EQ(error.place()->file, "bad.toml");
        EXPECT_EQ(error.place()->line, 2);
    }
}

TEST(LibraryScene, ThePngHoldsThePixelsAndTheRecord) {
    const Still still = Scene::from_text(text).still();
    ASSERT_EQ(still.rgba().size(), 4u * 64 * 36);
    const poinsot::TemporaryFolder folder;
    const fs::path file = folder / "still.png";
    poinsot::write_whole(file, still.png());
    const poinsot::StoredPicture read = poinsot::read_stored_png(file);
    EXPECT_TRUE(std::ranges::equal(read.image.bytes(), still.rgba()));
    EXPECT_FALSE(read.info.texts.empty());
    EXPECT_NE(still.bound().find("px of the truth"), std::string::npos);
}

TEST(LibraryScene, SeveralThreadsDrawTheSamePicture) {
    const Scene scene = Scene::from_text(text);
    const std::vector<std::uint8_t> alone = scene.still({.time_s = 1.0}).png();
    std::array<std::vector<std::uint8_t>, 4> drawn;
    std::vector<std::thread> threads;
    for (auto& png : drawn)
        threads.emplace_back([&png, &scene] { png = scene.still({.time_s = 1.0}).png(); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& png : drawn) EXPECT_EQ(png, alone);
}

TEST(LibraryScene, AFilmStopsWhereTheWatchSaysSo) {
    const poinsot::TemporaryFolder folder;
    const Scene scene =
        Scene::from_text(text).with({"film.size=640x360", "film.duration_s=40", "film.fps=60"});
    const std::string film = (folder / "film.mp4").string();
    Watch watch;
    std::int64_t n_stopped_after = 0;
    watch.frames = [&](std::int64_t n_done, std::int64_t) { n_stopped_after = n_done; };
    watch.stop = [&] { return n_stopped_after > 0; };
    EXPECT_THROW(scene.render(film, {}, watch), EnvironmentError);
    EXPECT_FALSE(fs::exists(film));
    // Later work is not stopped.
    EXPECT_EQ(scene.with({"film.size=64x36"}).still().width_px(), 64);
}

TEST(LibraryScene, DrawsAgainAfterTheDrawingThreadHasEnded) {
    const Scene scene = Scene::from_text(text);
    const std::vector<std::uint8_t> before = scene.still().png();
    poinsot::library::stop_drawing();
    EXPECT_EQ(scene.still().png(), before);
}

TEST(LibraryScene, WhatAWatchThrowsReachesTheCaller) {
    struct Mine {};
    Watch watch;
    watch.frames = [](std::int64_t, std::int64_t) { throw Mine(); };
    // The folder also takes the finished frames, with which the next call would continue.
    const poinsot::TemporaryFolder folder;
    const fs::path film = folder / "film.gif";
    const Scene scene = Scene::from_text(text).with({"film.size=640x360", "film.duration_s=40"});
    EXPECT_THROW(scene.render(film.string(), {}, watch), Mine);
    EXPECT_FALSE(fs::exists(film));
}

}  // namespace
