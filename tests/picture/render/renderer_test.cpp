// Whole pictures: reproducibility, sizes, alpha, views, and caching between pictures.
#include <dlfcn.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "error/error.h"
#include "pictures.h"
#include "refusal.h"
#include "render/context/gl_handles.h"

namespace poinsot::testing {
namespace {

const CurveGeometry& surface_curve() {
    static const CurveGeometry curve = curve_of(9201, 300, true, [](double t) {
        const double angle = 2.0 * std::numbers::pi * t;
        const double z = 0.5;
        const double r = std::sqrt(1.0 - z * z / 0.64);
        return Eigen::Vector3d(r * std::cos(angle), 0.7 * r * std::sin(angle), z);
    });
    return curve;
}

const CurveGeometry& plane_curve() {
    static const CurveGeometry curve = circle(9202, 0.5, -0.8);
    return curve;
}

// An open curve, which continues.
const CurveGeometry& plane_path() {
    static const CurveGeometry curve = curve_of(9203, 200, false, [](double t) {
        const double angle = 8.0 * std::numbers::pi * t;
        const double r = 1.0 - 0.5 * t;
        return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), -0.8);
    });
    return curve;
}

Drawing lecture(int width_px = 320, int height_px = 180) {
    return lecture_drawing(width_px, height_px, surface_curve(), plane_curve());
}

TEST(Renderer, IsReproducible) {
    const Image first = renderer().render(lecture());
    // The second picture caches the static content, the third uses the cache.
    EXPECT_EQ(renderer().render(lecture()), first);
    EXPECT_EQ(renderer().render(lecture()), first);
}

// The bytes that a browser's canvas shows of a drawing, from the uppermost row down.
std::vector<std::uint8_t> shown_bytes(Renderer& renderer, const Drawing& drawing) {
    const GlRenderbuffer colours = GlRenderbuffer::make();
    const GlFramebuffer framebuffer = GlFramebuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, colours.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, drawing.width_px, drawing.height_px);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours.id());
    renderer.render_to(drawing, framebuffer.id(), ScreenAlpha::opaque);
    const auto row = 4 * static_cast<std::ptrdiff_t>(drawing.width_px);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(row * drawing.height_px));
    glReadPixels(0, 0, drawing.width_px, drawing.height_px, GL_RGBA, GL_UNSIGNED_BYTE,
                 bytes.data());
    for (auto top = bytes.begin(), end = bytes.end(); top < end - row; top += row, end -= row)
        std::swap_ranges(top, top + row, end - row);
    return bytes;
}

// Encoded by a shader.
TEST(Renderer, ShowsTheBytesThatItReturns) {
    const Drawing drawing = lecture();
    const Image image = renderer().render(drawing);
    EXPECT_TRUE(std::ranges::equal(shown_bytes(renderer(), drawing), image.bytes()));
    // The next picture is not disturbed.
    EXPECT_EQ(renderer().render(drawing), image);
}

TEST(Renderer, FilmFramesEqualSeparatePictures) {
    const auto frame = [](int k) {
        Drawing drawing = lecture();
        drawing.views[0].ellipsoids[0].centre.x() = 0.02 * k;
        drawing.views[0].arrows[0].tip.x() = 0.1 * k;
        drawing.views[0].curves[0].last = 20.0 * k;
        return drawing;
    };
    std::vector<Image> film(6);
    for (int k = 0; k < 6; ++k) renderer().render_into(frame(k), film[static_cast<std::size_t>(k)]);
    for (int k = 0; k < 6; ++k) {
        Renderer alone(context());
        EXPECT_TRUE(alone.render(frame(k)) == film[static_cast<std::size_t>(k)]) << k;
    }
}

TEST(Renderer, FramesWrittenIntoAnyImageEqualSeparatePictures) {
    const auto frame = [](int k) {
        Drawing drawing = lecture();
        drawing.views[0].ellipsoids[0].centre.x() = 0.1 * (k % 5);
        drawing.views[0].curves[1].last = 3.0 * k;
        drawing.views[0].curves[1].geometry = &plane_path();
        drawing.views[0].curves[1].lasting = true;
        return drawing;
    };
    // Two images in turn, as for a film; one with pixels changed by other code, a copy, and one of
    // another size.
    Renderer film(context());
    Image first, second, third;
    for (int k = 0; k < 24; ++k) {
        Image& image = k % 2 == 0 ? first : second;
        if (k == 12) image.set(3, 4, {1, 2, 3, 4});
        if (k == 14) std::fill_n(image.bytes().begin(), 9000, std::uint8_t{7});
        if (k == 16) image = third;
        if (k == 18) image = Image(8, 8);
        film.render_into(frame(k), image);
        if (k == 10) third = image;
        Renderer alone(context());
        EXPECT_TRUE(alone.render(frame(k)) == image) << k;
    }
}

// As a page does whose viewer moves the cursor of the film.
TEST(Renderer, ShowsAFrameAlikeAfterAnyOthers) {
    GlyphMask mask;
    mask.id = 9204;
    mask.width = 60;
    mask.height = 11;
    for (int k = 0; k < mask.width * mask.height; ++k)
        mask.coverage.push_back(static_cast<std::uint8_t>(k * k % 251));
    const auto frame = [&mask](int k) {
        Drawing drawing = lecture(160, 90);
        View& view = drawing.views[0];
        view.ellipsoids[0].centre.x() = 0.1 * (k % 3);
        view.curves[1].last = 7.0 * k + 1.0;
        view.curves[1].geometry = &plane_path();
        view.curves[1].lasting = true;
        if (k > 6) view.camera.eye.x() += 0.1;
        Label label;
        label.mask = &mask;
        label.top_left_px = {12.3, 9.0};
        label.halo_px = 3.0 + 0.002 * k;
        view.labels = {label};
        return drawing;
    };
    Renderer jumping(context());
    std::vector<std::vector<std::uint8_t>> shown(12);
    for (const std::size_t k : {0u, 1u, 2u, 3u, 11u, 4u, 10u, 5u, 9u, 6u, 8u, 7u})
        shown[k] = shown_bytes(jumping, frame(static_cast<int>(k)));
    for (const std::size_t k : {2u, 4u, 5u, 7u, 8u, 10u}) {
        Renderer alone(context());
        EXPECT_TRUE(shown_bytes(alone, frame(static_cast<int>(k))) == shown[k]) << k;
    }
}

TEST(Renderer, RedrawsStaticContentAtEveryChange) {
    Drawing drawing = lecture();
    const Image first = renderer().render(drawing);
    renderer().render(drawing);
    drawing.views[0].planes[0].grid_spacing = 0.5;
    EXPECT_GT(n_different(renderer().render(drawing), first), 500u);
    drawing.views[0].planes[0].grid_spacing = 0.25;
    EXPECT_EQ(renderer().render(drawing), first);
    drawing.views[0].background.top = {0.1, 0.1, 0.1};
    EXPECT_GT(n_different(renderer().render(drawing), first), 500u);
}

// Run by the next test in a separate process; writes the picture's bytes to a file.
TEST(Renderer, DISABLED_WritesItsBytes) {
    const char* file = std::getenv("POINSOT_TEST_BYTES");
    ASSERT_NE(file, nullptr);
    const bool egl = std::string(std::getenv("POINSOT_TEST_BACKEND")) == "egl";
    const OffscreenContext context(egl ? Backend::egl : Backend::osmesa, Portability::portable);
    Renderer alone(context);
    const Image image = alone.render(lecture());
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(image.bytes().data()),
               static_cast<std::streamsize>(image.bytes().size()));
}

std::string bytes_drawn_with(const char* backend, const char* n_threads) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() /
        ("poinsot_" + std::to_string(getpid()) + backend + n_threads);
    const pid_t child = fork();
    if (child == 0) {
        setenv("POINSOT_TEST_BYTES", file.c_str(), 1);
        setenv("POINSOT_TEST_BACKEND", backend, 1);
        setenv("LP_NUM_THREADS", n_threads, 1);
        unsetenv("GTEST_TOTAL_SHARDS");
        unsetenv("GTEST_SHARD_INDEX");
        const int quiet = open("/dev/null", O_WRONLY);
        dup2(quiet, 1);
        execl("/proc/self/exe", "test_render", "--gtest_also_run_disabled_tests",
              "--gtest_filter=Renderer.DISABLED_WritesItsBytes", static_cast<char*>(nullptr));
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << backend;
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::filesystem::remove(file);
    return bytes;
}

// OSMesa, or its replacement where Mesa no longer has it (from 25.1 on).
const char* first_backend() {
    void* const osmesa = dlopen("libOSMesa.so.8", RTLD_LAZY);
    if (osmesa == nullptr) return "egl";
    dlclose(osmesa);
    return "osmesa";
}

TEST(Renderer, BytesAreIndependentOfBackendAndThreads) {
    const std::string reference = bytes_drawn_with(first_backend(), "0");
    ASSERT_EQ(reference.size(), 320u * 180u * 4u);
    EXPECT_EQ(bytes_drawn_with(first_backend(), "1"), reference);
    EXPECT_EQ(bytes_drawn_with(first_backend(), "4"), reference);
    EXPECT_EQ(bytes_drawn_with("egl", "2"), reference);
}

TEST(Renderer, BytesAreIndependentOfShaderCompilation) {
    const std::string reference = bytes_drawn_with(first_backend(), "2");
    ASSERT_EQ(reference.size(), 320u * 180u * 4u);
    ASSERT_EQ(setenv("GALLIVM_PERF", "nopt", 1), 0);
    EXPECT_EQ(bytes_drawn_with(first_backend(), "2"), reference);
    unsetenv("GALLIVM_PERF");
}

TEST(Renderer, RejectsPicturesItCannotDraw) {
    const auto message = [](int width_px, int height_px) -> std::string {
        return refusal_message([&] { renderer().render(lecture(width_px, height_px)); });
    };
    EXPECT_NE(message(100000, 90).find("16384"), std::string::npos);
    EXPECT_NE(message(160, 0).find("160x0"), std::string::npos);
    EXPECT_NE(message(-5, 90).find("-5x90"), std::string::npos);
    EXPECT_EQ(renderer().render(lecture(33, 17)).width(), 33);
}

TEST(Renderer, LeavesUndrawnPixelsTransparent) {
    Drawing drawing = flat_drawing(64, 64, 64.0);
    EXPECT_EQ(covered_px(renderer().render(drawing)), 0.0);
    // A half-covered pixel has half the alpha and the full colour.
    Ellipsoid sphere = plain_ellipsoid(20.0 * Eigen::Matrix3d::Identity());
    sphere.opacity = 0.5;
    drawing.views[0].ellipsoids.push_back(sphere);
    const CurveGeometry line = curve_of(
        9203, 2, false, [](double t) { return Eigen::Vector3d(-30.0 + 60.0 * t, 28.0, 0.0); });
    Curve curve;
    curve.geometry = &line;
    curve.colour = {0.2, 0.6, 1.0};
    curve.width_px = 3.0;
    curve.opacity = 0.5;
    drawing.views[0].curves.push_back(curve);
    const Image image = renderer().render(drawing);
    const Rgba8 there = image.at(32, 4);
    EXPECT_NEAR(there.a, 128, 1);
    EXPECT_NEAR(there.r, 51, 1);
    EXPECT_NEAR(there.g, 153, 1);
    EXPECT_NEAR(there.b, 255, 1);
}

TEST(Renderer, DoesNotDitherExactLevels) {
    for (int level = 0; level < 256; ++level) {
        Drawing drawing;
        drawing.width_px = drawing.height_px = 16;
        const double c = level / 255.0;
        drawing.background.top = drawing.background.bottom = {c, c, c};
        const Image image = renderer().render(drawing);
        const auto byte = static_cast<std::uint8_t>(level);
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                ASSERT_EQ(image.at(x, y), (Rgba8{byte, byte, byte, 255})) << level;
    }
}

TEST(Renderer, DithersGradientsInsteadOfBanding) {
    Drawing drawing;
    drawing.width_px = 64;
    drawing.height_px = 512;
    drawing.background.top = {0.50, 0.50, 0.50};
    drawing.background.bottom = {0.54, 0.54, 0.54};
    const Image image = renderer().render(drawing);
    // The mean of 8 rows rises evenly by 10 levels over 512 rows: never off by half a level.
    for (int top = 0; top + 8 <= 512; top += 8) {
        double sum = 0.0;
        for (int y = top; y < top + 8; ++y)
            for (int x = 0; x < 64; ++x) sum += image.at(x, y).g;
        const double expected = 255.0 * (0.50 + 0.04 * (top + 4.0) / 512.0);
        EXPECT_NEAR(sum / 512.0, expected, 0.15) << top;
    }
}

TEST(Renderer, ClipsViewsToTheirRectangles) {
    Drawing drawing = lecture(300, 200);
    View inset = flat_drawing(80, 60, 60.0).views[0];
    inset.x_px = 200;
    inset.y_px = 20;
    inset.background.alpha = 1.0;
    inset.background.top = inset.background.bottom = {0.0, 1.0, 0.0};
    Ellipsoid sphere = plain_ellipsoid(100.0 * Eigen::Matrix3d::Identity());
    sphere.colour = {0.0, 1.0, 0.0};
    drawing.views.push_back(inset);
    const Image bare = renderer().render(drawing);
    for (int y = 20; y < 80; ++y)
        for (int x = 200; x < 280; ++x) ASSERT_EQ(bare.at(x, y), (Rgba8{0, 255, 0, 255}));
    // A body larger than its view is clipped to it.
    drawing.views[1].ellipsoids.push_back(sphere);
    const Image filled = renderer().render(drawing);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 300; ++x)
            if (x < 200 || x >= 280 || y < 20 || y >= 80) {
                ASSERT_EQ(filled.at(x, y), bare.at(x, y)) << x << "," << y;
            }
}

TEST(Renderer, PartsEqualTheWholePicture) {
    // Tiles of a poster: the same views moved by whole dither cells.
    const Image whole = renderer().render(lecture(320, 192));
    Drawing part = lecture(320, 192);
    part.width_px = 160;
    part.height_px = 96;
    part.views[0].x_px = -160;
    part.views[0].y_px = -96;
    const Image tile = renderer().render(part);
    int n_far = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 160; ++x)
            n_far += std::abs(tile.at(x, y).g - whole.at(x + 160, y + 96).g) > 2;
    EXPECT_EQ(n_far, 0);
}

TEST(Renderer, IsMovable) {
    close_shared_renderer();
    OffscreenContext context;
    const std::string backend = context.info().backend;
    Renderer first(context);
    const Image image = first.render(lecture());
    OffscreenContext moved_context(std::move(context));
    Renderer second(std::move(first));
    EXPECT_EQ(second.render(lecture()), image);
    Renderer third(moved_context);
    third = std::move(second);
    EXPECT_EQ(third.render(lecture()), image);
    EXPECT_EQ(moved_context.info().backend, backend);
    EXPECT_FALSE(backend.empty());
}

}  // namespace
}  // namespace poinsot::testing
