#include "compare/given_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "error/error.h"
#include "production/stills/picture_regions.h"
#include "text/nearest.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/rational.h"

namespace poinsot {

namespace {

// "40" or "10%".
std::optional<IgnoredRegion::Length> parse_length(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    IgnoredRegion::Length length;
    length.is_percent = text.ends_with('%');
    if (length.is_percent) text.remove_suffix(1);
    if (text.ends_with("px")) text.remove_suffix(2);
    const auto value = number_of<double>(text);
    if (!value || !std::isfinite(*value) || std::abs(*value) > 1e6) return std::nullopt;
    length.value = *value;
    return length;
}

double checked_share(double value) {
    if (value >= 0 && value <= 1) return value;
    throw InputError(
        fmt::format("{:g}: not a share of the pixels; give a share from 0 to 1", value));
}

double checked_level(double value) {
    if (value >= 0 && value <= 255 && value == std::floor(value)) return value;
    throw InputError(fmt::format("{:g}: not a level; give a level from 0 to 255", value));
}

double checked_flip(double value) {
    if (value >= 0 && value <= 1) return value;
    throw InputError(
        fmt::format("{:g}: not a FLIP value; give 0 (equal) to 1, such as 0.01", value));
}

double checked_ssim(double value) {
    if (value >= -1 && value <= 1) return value;
    throw InputError(
        fmt::format("{:g}: not an SSIM value; give at most 1 (equal), such as 0.99", value));
}

constexpr std::string_view share_wanted = "a share of the pixels, as 0.001 or \"0.1%\"";
constexpr NumberLimit limit_rows[] = {
    {.name = "max_differing",
     .value = &GivenLimits::max_differing,
     .limits = &CompareLimits::differing_share,
     .json_name = "differing_share",
     .kind = LimitKind::share,
     .help = "share of the pixels that may differ, as 0.001 or 0.1%",
     .takes = "SHARE",
     .wanted = share_wanted,
     .checked = checked_share},
    {.name = "max_over",
     .value = &GivenLimits::max_over,
     .limits = &CompareLimits::over_level_share,
     .json_name = "over_level_share",
     .kind = LimitKind::share,
     .help = "share of the pixels that may differ by more than --over-levels",
     .takes = "SHARE",
     .wanted = share_wanted,
     .checked = checked_share},
    {.name = "over_levels",
     .value = &GivenLimits::over_levels,
     .limits = &CompareLimits::level,
     .json_name = "level",
     .kind = LimitKind::level,
     .help = "threshold of --max-over in levels of 255; default 2",
     .takes = "N",
     .wanted = "a level from 0 to 255",
     .checked = checked_level},
    {.name = "max_flip",
     .value = &GivenLimits::max_flip,
     .limits = &CompareLimits::most_flip,
     .json_name = "max_flip",
     .kind = LimitKind::number,
     .is_measure = true,
     .help = "largest visible difference (FLIP, 0 to 1) that passes, as 0.01; then any number of "
             "pixels may differ unless another option limits it",
     .takes = "FLIP",
     .wanted = "a number from 0 to 1",
     .checked = checked_flip},
    {.name = "min_ssim",
     .value = &GivenLimits::min_ssim,
     .limits = &CompareLimits::least_ssim,
     .json_name = "min_ssim",
     .kind = LimitKind::number,
     .is_measure = true,
     .help = "least structural similarity (SSIM, 1: equal) that passes, as 0.99; then any number "
             "of pixels may differ unless another option limits it",
     .takes = "SSIM",
     .wanted = "a number of at most 1",
     .checked = checked_ssim},
};

}  // namespace

std::span<const NumberLimit> number_limits() { return limit_rows; }

PictureRegion IgnoredRegion::in(int width, int height) const {
    const auto px = [&](std::size_t i, int side) {
        const Length& length = (*rectangle)[i];
        return length.is_percent ? length.value * side / 100 : length.value;
    };
    const double left = px(0, width), top = px(1, height);
    const int first_x = static_cast<int>(std::floor(left));
    const int first_y = static_cast<int>(std::floor(top));
    return {first_x, first_y, static_cast<int>(std::ceil(left + px(2, width))) - first_x,
            static_cast<int>(std::ceil(top + px(3, height))) - first_y};
}

IgnoredRegion parse_region(std::string_view text) {
    IgnoredRegion region{std::string(text), {}};
    if (text.find(',') == std::string_view::npos) {
        const std::vector<std::string_view> names = region_names();
        if (std::find(names.begin(), names.end(), text) == names.end())
            throw InputError(fmt::format(
                "{}; a region is a name or a rectangle, as 10,20,300,40 or 0%,90%,100%,10%",
                unknown("region", text, names)));
        return region;
    }
    std::array<IgnoredRegion::Length, 4> lengths;
    std::string_view rest = text;
    bool is_valid = std::count(text.begin(), text.end(), ',') == 3;
    for (std::size_t i = 0; is_valid && i < 4; ++i) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        const auto length = parse_length(rest.substr(0, end));
        is_valid = length.has_value() && (i < 2 || length->value > 0);
        if (is_valid) lengths[i] = *length;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!is_valid)
        throw InputError(
            fmt::format("{}: not a rectangle; give left, top, width and height in pixels or %, as "
                        "10,20,300,40 or 0%,90%,100%,10%",
                        printable(text)));
    region.rectangle = lengths;
    return region;
}

double parse_share(std::string_view text) {
    const bool percent = text.ends_with('%');
    const std::string_view digits = text.substr(0, text.size() - (percent ? 1 : 0));
    const auto value = rational_of(digits);
    const double share = value ? nearest_double(*value / (percent ? 100 : 1)) : -1.0;
    if (!(share >= 0 && share <= 1))
        throw InputError(fmt::format(
            "{}: not a share of the pixels; give a share from 0 to 1, or from 0% to 100%",
            printable(text)));
    return share;
}

bool GivenLimits::decides() const {
    return std::any_of(
        std::begin(limit_rows), std::end(limit_rows),
        [this](const NumberLimit& limit) { return (this->*limit.value).has_value(); });
}

GivenLimits GivenLimits::over(const GivenLimits& below) const {
    GivenLimits both = *this;
    const auto fill = [](auto& value, const auto& from) {
        if (!value) value = from;
    };
    for (const NumberLimit& limit : limit_rows) fill(both.*limit.value, below.*limit.value);
    fill(both.antialiasing, below.antialiasing);
    for (const IgnoredRegion& region : below.ignore)
        if (std::find(both.ignore.begin(), both.ignore.end(), region) == both.ignore.end())
            both.ignore.push_back(region);
    return both;
}

CompareLimits limits_of(const GivenLimits& given, const std::optional<CompareLimits>& profile,
                        const CompareLimits& otherwise) {
    CompareLimits limits = otherwise;
    if (profile) limits = *profile;
    if (given.limits_pixels())
        limits = {};
    else if (!profile && std::any_of(std::begin(limit_rows), std::end(limit_rows),
                                     [&given](const NumberLimit& limit) {
                                         return limit.is_measure && given.*limit.value;
                                     }))
        limits = CompareLimits::any_pixels();
    for (const NumberLimit& limit : limit_rows) {
        const std::optional<double>& value = given.*limit.value;
        const auto set = [&](const auto member) {
            using Value = std::remove_reference_t<decltype(limits.*member)>;
            if (value) limits.*member = static_cast<Value>(*value);
        };
        std::visit(set, limit.limits);
    }
    limits.antialiasing = given.antialiasing.value_or(false);
    return limits;
}

std::optional<CompareLimits> limits_of_profile(std::string_view name) {
    if (name.empty()) return std::nullopt;
    if (name == "portable") return CompareLimits::exact();
    if (name == "native") return CompareLimits{};
    throw InputError(fmt::format("{}: unknown; choose portable or native", printable(name)));
}

}  // namespace poinsot
