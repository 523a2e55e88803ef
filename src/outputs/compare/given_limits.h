// Limits on the difference of two pictures, as a command line, a compare.toml or the manifest of
// baselines gives them, and the limits that follow.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compare/compare.h"

namespace poinsot {

// A part of a picture that is not compared: a rectangle, or the name of what is shown there (see
// production/stills/picture_regions.h).
struct IgnoredRegion {
    struct Length {
        double value = 0;
        bool is_percent = false;  // of the picture's width or height; else pixels
        bool operator==(const Length&) const = default;
    };
    std::string text;                                  // as given: "clock", "0,0,100%,40"
    std::optional<std::array<Length, 4>> rectangle{};  // left, top, width, height

    // The rectangle in a picture of this size, rounded outwards. Precondition: `rectangle`.
    PictureRegion in(int width, int height) const;
    bool operator==(const IgnoredRegion&) const = default;
};

// Reads "10,20,300,40", "0%,90%,100%,10%" or a name. Throws InputError without a place.
IgnoredRegion parse_region(std::string_view text);

// Reads a share of the pixels: "0.001" or "0.1%". Throws InputError without a place.
double parse_share(std::string_view text);

// The limits of a profile; none without a name. Within a portable one no pixel may differ; the
// default limits of a native one separate a processor's rounding from a defect. Throws InputError
// without a place.
std::optional<CompareLimits> limits_of_profile(std::string_view name);

// Limits as somebody gives them; empty: not given.
struct GivenLimits {
    std::optional<double> max_differing{}, max_over{};  // shares of the pixels
    std::optional<double> over_levels{}, max_flip{}, min_ssim{};
    std::optional<bool> antialiasing{};
    std::vector<IgnoredRegion> ignore{};

    // These values where they are given, else those of `below`; regions of both.
    GivenLimits over(const GivenLimits& below) const;
    // Whether one of the numbers, which decide without a profile, is given.
    bool decides() const;
    bool limits_pixels() const { return max_differing || max_over || over_levels; }
    bool operator==(const GivenLimits&) const = default;
};

// A limit that is a number, as an option of `compare`, a key of compare.toml and a keyword of
// Python.
enum class LimitKind { share, level, number };
struct NumberLimit {
    std::string_view name;  // "max_flip"; the option is --max-flip
    std::optional<double> GivenLimits::*value;
    // What it limits, and the name of that in JSON.
    std::variant<double CompareLimits::*, int CompareLimits::*,
                 std::optional<double> CompareLimits::*>
        limits;
    std::string_view json_name;
    LimitKind kind;
    // Of a measure: without a profile it decides alone, and any number of pixels may differ.
    bool is_measure = false;
    std::string_view help, takes;      // of the option
    std::string_view wanted;           // what the value is, for messages
    double (*checked)(double number);  // throws InputError without a place if out of range
};
std::span<const NumberLimit> number_limits();

// The limits of a pair. If `given` limits pixels, the defaults of CompareLimits complete it,
// whatever the profile. Else the profile applies; without one, any number of pixels may differ if a
// measure decides, and otherwise `otherwise` applies.
CompareLimits limits_of(const GivenLimits& given, const std::optional<CompareLimits>& profile,
                        const CompareLimits& otherwise);

}  // namespace poinsot
