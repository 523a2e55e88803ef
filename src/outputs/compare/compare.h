// Compares two pictures. By default the verdict counts pixels, which distinguishes the rounding
// noise of a processor from a defect; FLIP and SSIM decide only where a limit is set for them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/picture_region.h"
#include "image/png.h"

namespace poinsot {

// Allowed differences. The defaults separate the rounding noise of another processor from a change
// of the picture; within one portable profile no difference is allowed. They come from
// seeded_defects in tests/trust: noise was at most 3e-5 of the pixels, by 1 level; among the
// defects that change no more than 1e-3 of the pixels, the smallest changes 7e-6 of them by more
// than 2 levels.
struct CompareLimits {
    double differing_share = 0.001;  // share of all pixels that may differ at all
    int level = 2;  // levels of 0…255, in the channel with the largest difference
    double over_level_share = 2e-6;  // share of all pixels that may differ by more than level
    std::optional<double> most_flip{}, least_ssim{};  // limits of the measures below
    // Whether pixels may differ where anti-aliasing explains it: at edges, where each picture's
    // pixel lies between the colours around the same place in the other picture.
    bool antialiasing = false;

    static CompareLimits exact() { return {0, 0, 0}; }
    // Any number of pixels may differ; the limits of the measures decide.
    static CompareLimits any_pixels() { return {1, 255, 1}; }
    bool limits_pixels() const { return differing_share < 1 || over_level_share < 1; }
};

// Options of a comparison besides its limits.
struct CompareExtras {
    bool ssim = false, flip = false;       // measure these even if no limit needs them
    std::vector<PictureRegion> ignored{};  // differences there do not count
};

enum class Verdict {
    same,
    within_limits,
    pixels_differ,
    size_differs,
    depth_differs,   // 8 and 16 bits per component
    colours_differ,  // different colour spaces: equal samples would mean different colours
};

struct Comparison {
    Verdict verdict = Verdict::same;
    std::string reason;  // one line; empty when the pictures are equal
    int expected_width = 0, expected_height = 0;
    int actual_width = 0, actual_height = 0;
    // When the sizes differ, the following members keep these defaults.
    std::int64_t n_pixels = 0;             // without the ignored ones
    std::int64_t n_differing = 0;          // differ in any channel, including alpha
    std::int64_t n_over_level = 0;         // by more than the limits' level
    std::int64_t n_antialiased = 0;        // differ as well, but anti-aliasing explains it
    std::int64_t n_ignored = 0;            // in ignored regions
    std::int64_t n_ignored_differing = 0;  // of these, those that differ
    double largest_difference = 0;         // in 8-bit levels; 16-bit samples give fractions
    double mean_difference = 0;            // levels, over all channels
    // If they were asked for and the pictures differ: they take a hundred times as long as the
    // counts. Over the pixels that are not ignored.
    std::optional<double> ssim, flip;

    bool passes() const { return verdict == Verdict::same || verdict == Verdict::within_limits; }
};

// Of two pictures that have different sizes.
Comparison size_difference(int expected_width, int expected_height, int actual_width,
                           int actual_height);

Comparison compare(const Image& expected, const Image& actual, const CompareLimits& limits = {},
                   const CompareExtras& extras = {});

// Compares every stored bit and the colour space. If depths or colour spaces differ, the pictures
// are not equal whatever the limits, and the 8-bit samples are counted.
Comparison compare(const StoredPicture& expected, const StoredPicture& actual,
                   const CompareLimits& limits = {}, const CompareExtras& extras = {});

// Mean structural similarity of the luma of two pictures of equal size, drawn on white. Source:
// Wang, Bovik, Sheikh & Simoncelli, IEEE Trans. Image Processing 13 (2004) 600: 11×11 Gaussian
// window of σ = 1.5 px, K1 = 0.01, K2 = 0.03. Border values are repeated outside the border, so
// that every pixel counts.
double structural_similarity(const Image& expected, const Image& actual);

// Mean perceived difference, 0 to 1, when flipping between two pictures of equal size, drawn on
// white, at 67 pixels per degree (a 0.7 m wide 3840 px screen at a distance of 0.7 m). Source:
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild, FLIP: A Difference Evaluator
// for Alternating Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2) (2020).
double flip_error(const Image& expected, const Image& actual);

// Shows expected | differences × 16 | actual, side by side. Where only one picture has pixels, the
// middle is white; a difference in alpha is grey.
Image difference_picture(const Image& expected, const Image& actual);

// The same for stored pictures. With 16 bits in both, the differences are in 16-bit levels, so that
// the smallest is visible. In ignored regions the middle is an even grey.
Image difference_picture(const StoredPicture& expected, const StoredPicture& actual,
                         std::span<const PictureRegion> ignored = {});

// The differences as a layer over either picture: transparent where the pictures are equal; from
// amber (one level) to red (16 levels and more) where they differ; blue where anti-aliasing
// explains the difference; grey in ignored regions; red where only one of them has pixels. If some
// pixels differ by more than a level, those that differ by less are transparent and counted.
struct DifferenceLayer {
    Image image;
    std::int64_t n_faint_left_out = 0;
};
DifferenceLayer difference_layer(const StoredPicture& expected, const StoredPicture& actual,
                                 const CompareLimits& limits,
                                 std::span<const PictureRegion> ignored);

}  // namespace poinsot
