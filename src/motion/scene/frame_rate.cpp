#include "scene/frame_rate.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>

#include "text/numbers.h"

namespace poinsot {

namespace {

constexpr std::int64_t most = 1000;  // frames a second

std::optional<RateRatio> reduced(std::int64_t numerator, std::int64_t denominator) {
    if (numerator <= 0 || denominator <= 0) return std::nullopt;
    const std::int64_t common = std::gcd(numerator, denominator);
    numerator /= common;
    denominator /= common;
    // Encoders take terms of 31 bits; a million leaves room for every rate in use.
    constexpr std::int64_t most_term = 1'000'000;
    if (numerator > most_term || denominator > most_term) return std::nullopt;
    if (numerator > most * denominator || numerator * most < denominator) return std::nullopt;
    return RateRatio{numerator, denominator};
}

}  // namespace

std::optional<RateRatio> rate_of_decimal(double frames_per_s) {
    if (!std::isfinite(frames_per_s) || frames_per_s <= 0.0 || frames_per_s > most) {
        return std::nullopt;
    }
    // Broadcasting rates are n·1000/1001, written as rounded decimals.
    struct Broadcast {
        double written;
        std::int64_t nominal;
    };
    constexpr std::array<Broadcast, 7> broadcast{{{23.976, 24},
                                                  {23.98, 24},
                                                  {29.97, 30},
                                                  {47.952, 48},
                                                  {59.94, 60},
                                                  {119.88, 120},
                                                  {239.76, 240}}};
    for (const Broadcast& rate : broadcast) {
        if (frames_per_s == rate.written) return reduced(rate.nominal * 1000, 1001);
    }
    const double thousandths = std::round(frames_per_s * 1000.0);
    if (thousandths / 1000.0 != frames_per_s) return std::nullopt;
    return reduced(static_cast<std::int64_t>(thousandths), 1000);
}

std::optional<RateRatio> rate_of_text(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        const auto decimal = number_of<double>(text);
        return decimal ? rate_of_decimal(*decimal) : std::nullopt;
    }
    const auto numerator = number_of<std::int64_t>(text.substr(0, slash));
    const auto denominator = number_of<std::int64_t>(text.substr(slash + 1));
    if (!numerator || !denominator) return std::nullopt;
    return reduced(*numerator, *denominator);
}

std::string text_of_rate(const RateRatio& rate) {
    return rate.second == 1 ? fmt::format("{}", rate.first)
                            : fmt::format("{}/{}", rate.first, rate.second);
}

}  // namespace poinsot
