// Comparison of pictures, against closed forms and a direct evaluation of the published sums.
#include "compare/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/synthetic.h"
#include "image/thumbnail.h"

namespace poinsot {
namespace {

Image filled(int width, int height, Rgba8 colour) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.set(x, y, colour);
    return image;
}

// The picture with the first n pixels changed by some levels in one channel.
Image changed(Image image, int n, int levels) {
    for (int i = 0; i < n; ++i) {
        const int x = i % image.width(), y = i / image.width();
        Rgba8 colour = image.at(x, y);
        colour.g = static_cast<std::uint8_t>(colour.g + levels);
        image.set(x, y, colour);
    }
    return image;
}

TEST(Compare, EqualPicturesAreTheSame) {
    const Image image = synthetic_frame(64, 48, 3);
    const Comparison result = compare(image, image, CompareLimits::exact());
    EXPECT_EQ(result.verdict, Verdict::same);
    EXPECT_EQ(result.reason, "");
    EXPECT_EQ(result.n_differing, 0);
    EXPECT_EQ(result.n_pixels, 64 * 48);
    EXPECT_FALSE(result.flip || result.ssim);
}

TEST(Compare, CountsChangedPixels) {
    const Image before = filled(100, 100, {10, 20, 30, 255});
    const Comparison result = compare(before, changed(changed(before, 7, 1), 3, 8));
    EXPECT_EQ(result.n_pixels, 10000);
    EXPECT_EQ(result.n_differing, 7);
    EXPECT_EQ(result.n_over_level, 3);
    EXPECT_EQ(result.largest_difference, 9);
    EXPECT_DOUBLE_EQ(result.mean_difference, (3 * 9 + 4 * 1) / 40000.0);
}

// Each number appears once, and a limit of zero is expressed in words.
TEST(Compare, SaysWhatDiffersOnce) {
    const Image before = filled(100, 100, {10, 20, 30, 255});
    const Image after = changed(changed(before, 7, 1), 3, 8);
    EXPECT_EQ(
        compare(before, after, CompareLimits::exact()).reason,
        "7 of 10000 pixels differ (0.07 %, none allowed); the largest difference is 9 levels");
    EXPECT_EQ(compare(before, changed(before, 1, 1), CompareLimits::exact()).reason,
              "1 of 10000 pixels differ (0.01 %, none allowed); the largest difference is 1 level");
    EXPECT_EQ(compare(before, after).reason,
              "7 of 10000 pixels differ (0.07 %, 0.1 % allowed), 3 by more than 2 levels (0.03 %, "
              "0.0002 % allowed); the largest difference is 9 levels");
    // From level 0 on the lower cap is the one that counts.
    EXPECT_EQ(
        compare(before, after, {0.5, 0, 1e-4}).reason,
        "7 of 10000 pixels differ (0.07 %, 0.01 % allowed); the largest difference is 9 levels");
}

// Of 1,000,000 pixels, 0.1 % are 1,000 and 2e-6 are 2.
TEST(Compare, AppliesBothLimits) {
    const Image before = filled(1000, 1000, {10, 20, 30, 255});
    const auto verdict = [&before](int n_pixels, int levels, CompareLimits limits = {}) {
        return compare(before, changed(before, n_pixels, levels), limits).verdict;
    };
    EXPECT_EQ(verdict(1000, 2), Verdict::within_limits);
    EXPECT_EQ(verdict(1001, 2), Verdict::pixels_differ);
    EXPECT_EQ(verdict(2, 200), Verdict::within_limits);
    EXPECT_EQ(verdict(3, 3), Verdict::pixels_differ);
    EXPECT_EQ(verdict(1, 1, CompareLimits::exact()), Verdict::pixels_differ);
}

TEST(Compare, AlphaCountsLikeAnyChannel) {
    const Comparison result = compare(filled(4, 4, {1, 2, 3, 255}), filled(4, 4, {1, 2, 3, 250}));
    EXPECT_EQ(result.n_differing, 16);
    EXPECT_EQ(result.largest_difference, 5);
}

TEST(Compare, DifferentSizesAreReported) {
    const Comparison result = compare(filled(4, 3, {}), filled(3, 4, {}));
    EXPECT_EQ(result.verdict, Verdict::size_differs);
    EXPECT_EQ(result.reason, "expected 4×3 pixels, found 3×4");
    EXPECT_FALSE(result.passes());
}

StoredPicture deep_picture(std::uint16_t level) {
    StoredPicture picture;
    picture.deep = DeepImage(100, 100);
    std::fill(picture.deep.samples().begin(), picture.deep.samples().end(), level);
    picture.image = filled(100, 100, {128, 128, 128, 128});
    picture.info.bit_depth = 16;
    return picture;
}

// 257 levels of 16 bits are one level of 8 bits: pictures that round to the same 8 bits still
// differ.
TEST(Compare, DetectsDifferencesInEveryStoredBit) {
    const StoredPicture before = deep_picture(128 * 257);
    EXPECT_EQ(compare(before, before, CompareLimits::exact()).verdict, Verdict::same);
    StoredPicture after = before;
    for (auto& sample : after.deep.samples()) ++sample;
    const Comparison result = compare(before, after, CompareLimits::exact());
    EXPECT_EQ(result.verdict, Verdict::pixels_differ);
    EXPECT_EQ(result.n_differing, 10000);
    EXPECT_DOUBLE_EQ(result.largest_difference, 1 / 257.0);
    EXPECT_DOUBLE_EQ(result.mean_difference, 1 / 257.0);
    // The level limit is in 8-bit levels.
    after = before;
    after.deep.samples()[0] += 2 * 257;
    after.deep.samples()[4] += 2 * 257 + 1;
    EXPECT_EQ(compare(before, after).n_over_level, 1);
}

TEST(Compare, DifferentDepthsAndColourSpacesAreReported) {
    const StoredPicture deep = deep_picture(128 * 257);
    StoredPicture shallow = deep;
    shallow.deep = {};
    shallow.info.bit_depth = 8;
    const CompareLimits anything{1, 255, 1};
    const Comparison depth = compare(deep, shallow, anything);
    EXPECT_EQ(depth.verdict, Verdict::depth_differs);
    EXPECT_EQ(depth.reason, "expected 16 bits per component, found 8");
    EXPECT_FALSE(depth.passes());
    StoredPicture darker = shallow;
    darker.info.colours = "gamma 1";
    const Comparison colours = compare(shallow, darker, anything);
    EXPECT_EQ(colours.verdict, Verdict::colours_differ);
    EXPECT_EQ(colours.reason, "expected the colour space sRGB, found gamma 1");
    EXPECT_FALSE(colours.passes());
}

// Measures are taken only if they are asked for or limited, and only of pictures that differ.
TEST(Compare, MeasuresOnlyWhatIsNeeded) {
    const Image a = synthetic_frame(64, 48, 0), b = synthetic_frame(64, 48, 9);
    EXPECT_FALSE(compare(a, b).flip || compare(a, b).ssim);
    CompareLimits limits = CompareLimits::any_pixels();
    limits.most_flip = 1;
    EXPECT_TRUE(compare(a, b, limits).flip && !compare(a, b, limits).ssim);
    EXPECT_FALSE(compare(a, a, limits).flip);
    EXPECT_TRUE(compare(a, b, {}, {.ssim = true}).ssim && !compare(a, b, {}, {.ssim = true}).flip);
}

// FLIP and SSIM decide at their values: at exactly the value a picture passes, below it fails.
TEST(Compare, MeasuresDecideAtTheirLimits) {
    const Image a = synthetic_frame(64, 48, 0), b = synthetic_frame(64, 48, 9);
    const double flip = flip_error(a, b), ssim = structural_similarity(a, b);
    const auto verdict = [&](std::optional<double> most_flip, std::optional<double> least_ssim) {
        CompareLimits limits = CompareLimits::any_pixels();
        limits.most_flip = most_flip;
        limits.least_ssim = least_ssim;
        return compare(a, b, limits).verdict;
    };
    EXPECT_EQ(verdict(flip, {}), Verdict::within_limits);
    EXPECT_EQ(verdict(flip - 1e-6, {}), Verdict::pixels_differ);
    EXPECT_EQ(verdict({}, ssim), Verdict::within_limits);
    EXPECT_EQ(verdict({}, ssim + 1e-6), Verdict::pixels_differ);
    EXPECT_EQ(verdict(flip, ssim + 1e-6), Verdict::pixels_differ);
    // Pixels decide as well where they are limited.
    CompareLimits exact = CompareLimits::exact();
    exact.most_flip = 1;
    EXPECT_EQ(compare(a, b, exact).verdict, Verdict::pixels_differ);
}

TEST(Compare, SaysEachLimitOnce) {
    const Image before = filled(100, 100, {10, 20, 30, 255});
    CompareLimits limits = CompareLimits::any_pixels();
    limits.most_flip = 1e-9;
    limits.least_ssim = 0.5;
    const std::string reason = compare(before, changed(before, 7, 9), limits).reason;
    EXPECT_EQ(reason.find("7 of 10000 pixels differ (0.07 %); the largest difference is 9 levels; "
                          "FLIP "),
              0u)
        << reason;
    EXPECT_NE(reason.find(" (1e-09 allowed); SSIM 0."), std::string::npos) << reason;
    EXPECT_NE(reason.find(" (at least 0.5 required)"), std::string::npos) << reason;
}

// Differences in an ignored region count neither as pixels nor in the measures; others do.
TEST(Compare, LeavesOutIgnoredRegions) {
    const Image before = synthetic_frame(64, 48, 0);
    Image after = before;
    for (int y = 10; y < 14; ++y)
        for (int x = 20; x < 30; ++x) after.set(x, y, {255, 0, 0, 255});
    const CompareExtras extras{.ssim = true, .flip = true, .ignored = {{20, 10, 10, 4}}};
    const Comparison all = compare(before, after, CompareLimits::exact(), extras);
    EXPECT_EQ(all.verdict, Verdict::within_limits);
    EXPECT_EQ(all.n_differing, 0);
    EXPECT_EQ(all.n_ignored, 40);
    EXPECT_EQ(all.n_ignored_differing, 40);
    EXPECT_FALSE(all.flip);
    EXPECT_EQ(compare(before, before, CompareLimits::exact(), extras).verdict, Verdict::same);
    EXPECT_EQ(all.n_pixels, 64 * 48 - 40);
    // One pixel narrower: a column of four counts.
    const CompareExtras less{.ssim = true, .flip = true, .ignored = {{20, 10, 9, 4}}};
    const Comparison column = compare(before, after, CompareLimits::exact(), less);
    EXPECT_EQ(column.n_differing, 4);
    Image only_column = before;
    for (int y = 10; y < 14; ++y) only_column.set(29, y, {255, 0, 0, 255});
    const double rest = 64.0 * 48 / (64 * 48 - 36);
    EXPECT_NEAR(*column.flip, flip_error(before, only_column) * rest, 1e-12);
    EXPECT_NEAR(*column.ssim, 1 - (1 - structural_similarity(before, only_column)) * rest, 1e-12);
}

// Regions may overlap and extend beyond the picture; each pixel is ignored once.
TEST(Compare, ClipsIgnoredRegions) {
    const Image before = filled(10, 8, {10, 20, 30, 255}), after = filled(10, 8, {11, 20, 30, 255});
    const auto n_differing = [&](std::vector<PictureRegion> ignored) {
        return compare(before, after, CompareLimits::exact(), {.ignored = std::move(ignored)})
            .n_differing;
    };
    EXPECT_EQ(n_differing({{-5, -5, 7, 7}}), 80 - 4);
    EXPECT_EQ(n_differing({{8, 6, 2000000000, 2000000000}}), 80 - 4);
    EXPECT_EQ(n_differing({{2, 2, 3, 3}, {3, 3, 3, 3}}), 80 - 9 - 9 + 4);
    EXPECT_EQ(n_differing({{20, 20, 3, 3}, {3, 3, 0, 5}, {3, 3, -2, 5}}), 80);
    EXPECT_EQ(n_differing({{0, 0, 10, 8}}), 0);
}

// The edge of a half plane, whose distance from the left is a fraction of a pixel: one column has
// the mean of both colours.
Image half_plane(double edge_px) {
    Image image(40, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 40; ++x) {
            const double share = std::clamp(edge_px - x, 0.0, 1.0);
            const auto level = static_cast<std::uint8_t>(std::lround(220 - 180 * share));
            image.set(x, y, {level, level, level, 255});
        }
    return image;
}

// Anti-aliasing explains an edge that moves by less than a pixel, not one that moves farther, a
// line that is missing, or another shade.
TEST(Compare, AllowsWhatAntiAliasingExplains) {
    CompareLimits limits = CompareLimits::exact();
    limits.antialiasing = true;
    const Comparison moved = compare(half_plane(17.1), half_plane(17.9), limits);
    EXPECT_EQ(moved.verdict, Verdict::within_limits);
    EXPECT_EQ(moved.n_antialiased, 20);
    EXPECT_EQ(moved.n_differing, 0);
    EXPECT_EQ(
        moved.reason,
        "0 of 800 pixels differ (0 %, none allowed); anti-aliasing explains 20 more, which are "
        "allowed");
    EXPECT_EQ(compare(half_plane(17.1), half_plane(19.3), limits).verdict, Verdict::pixels_differ);
    Image line = half_plane(10), none = line;
    for (int y = 0; y < 20; ++y) line.set(30, y, {40, 40, 40, 255});
    EXPECT_EQ(compare(line, none, limits).n_differing, 20);
    EXPECT_EQ(compare(none, line, limits).n_differing, 20);
    const Comparison shade = compare(none, changed(none, 800, 3), limits);
    EXPECT_EQ(shade.n_antialiased, 0);
    EXPECT_EQ(compare(half_plane(17.1), half_plane(17.9), CompareLimits::exact()).n_antialiased, 0);
}

TEST(DifferenceLayer, ShowsEachPixelForItsReason) {
    const auto stored = [](const Image& image) {
        StoredPicture picture;
        picture.image = image;
        return picture;
    };
    Image after = half_plane(17.9);
    after.set(30, 3, {219, 220, 220, 255});
    after.set(35, 3, {0, 0, 0, 255});
    CompareLimits limits = CompareLimits::exact();
    limits.antialiasing = true;
    const PictureRegion ignored{0, 0, 5, 5};
    const Image layer =
        difference_layer(stored(half_plane(17.1)), stored(after), limits, {&ignored, 1}).image;
    EXPECT_EQ(layer.at(25, 10), (Rgba8{0, 0, 0, 0}));
    EXPECT_EQ(layer.at(35, 3), (Rgba8{217, 0, 54, 255}));
    EXPECT_EQ(layer.at(17, 10), (Rgba8{30, 110, 255, 255}));
    EXPECT_EQ(layer.at(4, 4).a, 110);
    // A pixel of the thumbnail shows the strongest difference that it stands for.
    const Image small = layer_thumbnail(layer, 10);
    EXPECT_EQ(small.width(), 10);
    EXPECT_EQ(small.at(35 / 4, 0), (Rgba8{217, 0, 54, 255}));
    // Of pictures of different sizes, what only one of them has is red.
    const Image sizes = difference_layer(stored(filled(4, 3, {1, 1, 1, 255})),
                                         stored(filled(3, 3, {1, 1, 1, 255})), limits, {})
                            .image;
    EXPECT_EQ(sizes.at(3, 1), (Rgba8{217, 0, 54, 255}));
    EXPECT_EQ(sizes.at(2, 1), (Rgba8{0, 0, 0, 0}));
}

TEST(DifferenceLayer, LeavesOutPixelsThatDifferByALevelOnlyBesideClearerOnes) {
    const auto stored = [](const Image& image) {
        StoredPicture picture;
        picture.image = image;
        return picture;
    };
    const Image before = filled(8, 8, {100, 100, 100, 255});
    Image faint = before;
    faint.set(1, 2, {101, 100, 100, 255});
    faint.set(5, 2, {100, 99, 100, 255});
    const CompareLimits limits = CompareLimits::exact();
    const DifferenceLayer alone = difference_layer(stored(before), stored(faint), limits, {});
    EXPECT_EQ(alone.n_faint_left_out, 0);
    EXPECT_EQ(alone.image.at(1, 2), (Rgba8{255, 176, 0, 255}));
    EXPECT_EQ(alone.image.at(5, 2), (Rgba8{255, 176, 0, 255}));

    Image clear = faint;
    clear.set(6, 6, {103, 100, 100, 255});
    const DifferenceLayer beside = difference_layer(stored(before), stored(clear), limits, {});
    EXPECT_EQ(beside.n_faint_left_out, 2);
    EXPECT_EQ(beside.image.at(1, 2), (Rgba8{0, 0, 0, 0}));
    EXPECT_EQ(beside.image.at(6, 6).a, 255);
}

// Flat pictures have no variance: SSIM is (2ab + C1)/(a² + b² + C1).
TEST(Ssim, OfFlatGreysAgreesWithTheClosedForm) {
    constexpr double c1 = 6.5025;
    for (const auto& [a, b] : {std::pair{0, 255}, {100, 110}, {128, 128}, {7, 8}}) {
        const auto level_a = static_cast<std::uint8_t>(a), level_b = static_cast<std::uint8_t>(b);
        const double expected = (2.0 * a * b + c1) / (1.0 * a * a + 1.0 * b * b + c1);
        EXPECT_NEAR(structural_similarity(filled(20, 15, {level_a, level_a, level_a, 255}),
                                          filled(20, 15, {level_b, level_b, level_b, 255})),
                    expected, 3e-6);  // measured 1.04e-6, from variances in single precision
    }
}

// Direct evaluation of Wang 2004, eqs. 13–16, at every pixel in double precision.
double direct_ssim(const Image& a, const Image& b) {
    const auto luma = [](const Image& image, int x, int y) {
        const Rgba8 c =
            image.at(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
        return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    };
    double total = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            double w = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
            const auto each = [&](auto&& use) {
                for (int j = -5; j <= 5; ++j)
                    for (int i = -5; i <= 5; ++i)
                        use(std::exp(-(i * i + j * j) / 4.5), luma(a, x + i, y + j),
                            luma(b, x + i, y + j));
            };
            each([&](double g, double p, double q) { w += g, ma += g * p, mb += g * q; });
            ma /= w, mb /= w;
            each([&](double g, double p, double q) {
                va += g / w * (p - ma) * (p - ma), vb += g / w * (q - mb) * (q - mb);
                cov += g / w * (p - ma) * (q - mb);
            });
            total += (2 * ma * mb + 6.5025) * (2 * cov + 58.5225) /
                     ((ma * ma + mb * mb + 6.5025) * (va + vb + 58.5225));
        }
    }
    return total / (a.width() * a.height());
}

TEST(Ssim, AgreesWithDirectEvaluation) {
    const Image a = synthetic_frame(64, 48, 0), b = synthetic_frame(64, 48, 12);
    const double expected = direct_ssim(a, b);
    EXPECT_LT(expected, 0.95);
    EXPECT_NEAR(structural_similarity(a, b), expected, 1e-6);  // measured 1e-8
}

TEST(Flip, IsZeroForEqualPictures) {
    const Image image = synthetic_frame(64, 48, 3);
    EXPECT_EQ(flip_error(image, image), 0);
}

// FLIP is 1 for the two colours with the largest distance: green and blue.
TEST(Flip, IsOneBetweenGreenAndBlue) {
    EXPECT_NEAR(flip_error(filled(8, 8, {0, 255, 0, 255}), filled(8, 8, {0, 0, 255, 255})), 1,
                1e-5);  // measured 2e-7
}

// Flat greys have no features and no chroma; with L* = 116 cbrt(Y) − 16 the distance is |ΔL*|, and
// FLIP its 0.7th power, scaled so that 0.4 of the largest power is 0.95.
TEST(Flip, OfFlatGreysAgreesWithTheClosedForm) {
    const auto lightness = [](int level) {
        const double v = level / 255.0;
        return 116 * std::cbrt(std::pow((v + 0.055) / 1.055, 2.4)) - 16;
    };
    // |ΔL*| + |Δ(a, b)| of sRGB green (87.735, −86.183, 83.180) and blue (32.297, 79.188,
    // −107.860), chroma scaled by 0.01 L*. Source of the two: CIE L*a*b* at D65 (Lindbloom).
    const double da = 0.87735 * -86.183 - 0.32297 * 79.188;
    const double db = 0.87735 * 83.180 + 0.32297 * 107.860;
    const double largest = std::pow(87.735 - 32.297 + std::hypot(da, db), 0.7);
    for (const auto& [a, b] : {std::pair{100, 101}, {128, 140}, {40, 60}}) {
        const auto p = static_cast<std::uint8_t>(a), q = static_cast<std::uint8_t>(b);
        const double expected =
            0.95 / (0.4 * largest) * std::pow(std::abs(lightness(a) - lightness(b)), 0.7);
        EXPECT_NEAR(flip_error(filled(8, 8, {p, p, p, 255}), filled(8, 8, {q, q, q, 255})),
                    expected, 2e-4);
    }
}

TEST(Flip, IsSymmetricAndGrowsWithTheContrastOfALine) {
    const auto with_line = [](std::uint8_t level) {
        Image image = filled(41, 41, {128, 128, 128, 255});
        for (int y = 0; y < 41; ++y) image.set(20, y, {level, level, level, 255});
        return image;
    };
    const Image none = with_line(128);
    double previous = 0;
    for (const std::uint8_t level : {130, 135, 150, 180, 255}) {
        const double error = flip_error(none, with_line(level));
        EXPECT_GT(error, previous);
        EXPECT_EQ(flip_error(with_line(level), none), error);
        previous = error;
    }
}

// At 67 pixels a degree the eye does not resolve blue and yellow squares of one pixel.
TEST(Flip, IgnoresDetailThatTheEyeCannotResolve) {
    Image squares(40, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            squares.set(x, y, (x + y) % 2 ? Rgba8{128, 128, 118, 255} : Rgba8{128, 128, 138, 255});
    const Image grey = filled(40, 40, {128, 128, 128, 255});
    const Image blue = filled(40, 40, {128, 128, 138, 255});
    EXPECT_LT(flip_error(grey, squares), 0.25 * flip_error(grey, blue));
}

TEST(DifferencePicture, ShowsExpectedDifferenceActual) {
    Image expected = filled(2, 1, {100, 100, 100, 255}), actual = expected;
    actual.set(1, 0, {103, 100, 50, 255});
    const Image sheet = difference_picture(expected, actual);
    ASSERT_EQ(sheet.width(), 6);
    EXPECT_EQ(sheet.at(1, 0), expected.at(1, 0));
    EXPECT_EQ(sheet.at(2, 0), (Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(sheet.at(3, 0), (Rgba8{48, 0, 255, 255}));
    EXPECT_EQ(sheet.at(5, 0), actual.at(1, 0));
}

TEST(DifferencePicture, ShowsASingleLevelOfSixteenBits) {
    const StoredPicture before = deep_picture(128 * 257);
    StoredPicture after = before;
    after.deep.samples()[1] += 1;
    after.deep.samples()[2] -= 3;
    EXPECT_EQ(difference_picture(before, after).at(100, 0), (Rgba8{0, 16, 48, 255}));
    EXPECT_EQ(difference_picture(before, after).at(101, 0), (Rgba8{0, 0, 0, 255}));
}

TEST(DifferencePicture, IsGreyWhereDifferencesAreIgnored) {
    const StoredPicture before{filled(3, 1, {100, 100, 100, 255}), {}, {}};
    StoredPicture after = before;
    for (int x = 0; x < 3; ++x) after.image.set(x, 0, {101, 100, 100, 255});
    const std::vector<PictureRegion> ignored{{1, 0, 1, 1}};
    const Image sheet = difference_picture(before, after, ignored);
    EXPECT_EQ(sheet.at(3, 0), (Rgba8{16, 0, 0, 255}));
    EXPECT_EQ(sheet.at(4, 0), (Rgba8{110, 110, 110, 255}));
    EXPECT_EQ(sheet.at(5, 0), (Rgba8{16, 0, 0, 255}));
    EXPECT_EQ(sheet.at(7, 0), after.image.at(1, 0));
}

TEST(DifferencePicture, IsWhiteWhereOnlyOnePictureHasPixels) {
    const Image sheet =
        difference_picture(filled(1, 2, {9, 9, 9, 255}), filled(2, 1, {9, 9, 9, 255}));
    ASSERT_EQ(sheet.width(), 6);
    ASSERT_EQ(sheet.height(), 2);
    EXPECT_EQ(sheet.at(2, 0), (Rgba8{0, 0, 0, 255}));
    EXPECT_EQ(sheet.at(3, 0), (Rgba8{255, 255, 255, 255}));
    EXPECT_EQ(sheet.at(2, 1), (Rgba8{255, 255, 255, 255}));
    EXPECT_EQ(sheet.at(1, 0), (Rgba8{0, 0, 0, 0}));
}

}  // namespace
}  // namespace poinsot
