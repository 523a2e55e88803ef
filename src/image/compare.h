// Two pictures compared: the verdict by counts of pixels, which tell a processor's noise from a
// defect, and measures of likeness for ranking only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "image/png.h"

namespace poinsot {

// What may differ. The defaults tell the noise of another processor's rounding from a change of the
// picture; within one portable profile nothing may differ. They come from tests/trust's
// seeded_defects: noise was at most 3e-5 of the pixels, by 1 level; the least defects by which no
// more than 1e-3 of the pixels differ change 7e-6 of them by more than 2 levels.
struct CompareLimits {
    double differing_share = 0.001;  // of all pixels, may differ at all
    int level = 2;                   // levels of 0…255, in the channel that differs most
    double over_level_share = 2e-6;  // of all pixels, may differ by more than level

    static CompareLimits exact() { return {0, 0, 0}; }
};

enum class Verdict {
    same,
    within_limits,
    pixels_differ,
    size_differs,
    depth_differs,   // 8 bits a component, and 16
    colours_differ,  // the same samples would be other colours
};

// How alike two pictures look, for ranking.
struct Likeness {
    double ssim = 1;  // 1: alike; see structural_similarity
    double flip = 0;  // 0: alike; see flip_error
};

struct Comparison {
    Verdict verdict = Verdict::same;
    std::string reason;  // one line, empty when the pictures are the same
    int expected_width = 0, expected_height = 0;
    int actual_width = 0, actual_height = 0;
    // The rest stays as it is here when the sizes differ.
    std::int64_t n_pixels = 0;
    std::int64_t n_differing = 0;   // differ in any channel, alpha among them
    std::int64_t n_over_level = 0;  // by more than the limits' level
    double largest_difference = 0;  // levels; of 16 bits, parts of one are counted
    double mean_difference = 0;     // levels, over all channels
    // Measured by the caller, where it is wanted: it takes a hundred times as long as the counts.
    std::optional<Likeness> likeness;

    bool passes() const { return verdict == Verdict::same || verdict == Verdict::within_limits; }
};

Comparison compare(const Image& expected, const Image& actual, const CompareLimits& limits = {});

// The same with every bit that the files hold, and what makes colours of them. Of different depths
// or colours the 8 bits are measured, whatever the limits.
Comparison compare(const StoredPicture& expected, const StoredPicture& actual,
                   const CompareLimits& limits = {});

// SSIM and FLIP of two pictures of one size, about 2 s of one core at 1920×1080.
Likeness likeness_of(const Image& expected, const Image& actual);

// Mean structural similarity of the luma of two pictures of one size, laid on white.
// Source: Wang, Bovik, Sheikh & Simoncelli, IEEE Trans. Image Processing 13 (2004) 600: 11×11
// Gaussian window of σ = 1.5 px, K1 = 0.01, K2 = 0.03. At the border the window sees the border's
// values repeated, so that every pixel counts.
double structural_similarity(const Image& expected, const Image& actual);

// Mean perceived difference of two pictures of one size, laid on white and flipped between at 67
// pixels a degree (a 0.7 m wide 3840 px screen seen from 0.7 m); 0 to 1.
// Source: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild, FLIP: A Difference
// Evaluator for Alternating Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2) (2020).
double flip_error(const Image& expected, const Image& actual);

// expected | differences × 16 | actual, side by side. Where only one of the pictures reaches, the
// middle is white; a difference in alpha shows as grey.
Image difference_picture(const Image& expected, const Image& actual);

// The same; of two with 16 bits the differences are in their own levels, so that the least shows.
Image difference_picture(const StoredPicture& expected, const StoredPicture& actual);

}  // namespace poinsot
