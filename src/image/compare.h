// Compares two pictures. The verdict counts pixels, which distinguishes the rounding noise of a
// processor from a defect; similarity measures serve only for ranking.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

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

    static CompareLimits exact() { return {0, 0, 0}; }
};

enum class Verdict {
    same,
    within_limits,
    pixels_differ,
    size_differs,
    depth_differs,   // 8 and 16 bits per component
    colours_differ,  // different colour spaces: equal samples would mean different colours
};

// How similar two pictures look, for ranking.
struct Likeness {
    double ssim = 1;  // 1: equal; see structural_similarity
    double flip = 0;  // 0: equal; see flip_error
};

struct Comparison {
    Verdict verdict = Verdict::same;
    std::string reason;  // one line; empty when the pictures are equal
    int expected_width = 0, expected_height = 0;
    int actual_width = 0, actual_height = 0;
    // When the sizes differ, the following members keep these defaults.
    std::int64_t n_pixels = 0;
    std::int64_t n_differing = 0;   // differ in any channel, including alpha
    std::int64_t n_over_level = 0;  // by more than the limits' level
    double largest_difference = 0;  // in 8-bit levels; 16-bit samples give fractions
    double mean_difference = 0;     // levels, over all channels
    // SSIM and FLIP, if the caller computes them: they take a hundred times as long as the counts.
    std::optional<Likeness> likeness;

    bool passes() const { return verdict == Verdict::same || verdict == Verdict::within_limits; }
};

Comparison compare(const Image& expected, const Image& actual, const CompareLimits& limits = {});

// Compares every stored bit and the colour space. If depths or colour spaces differ, the pictures
// are not equal whatever the limits, and the 8-bit samples are counted.
Comparison compare(const StoredPicture& expected, const StoredPicture& actual,
                   const CompareLimits& limits = {});

// SSIM and FLIP of two pictures of equal size, about 2 s of one core at 1920×1080.
Likeness likeness_of(const Image& expected, const Image& actual);

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
// the smallest is visible.
Image difference_picture(const StoredPicture& expected, const StoredPicture& actual);

}  // namespace poinsot
