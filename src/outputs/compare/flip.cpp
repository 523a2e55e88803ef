// FLIP for standard dynamic range pictures; section numbers refer to the paper.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "compare/compare.h"
#include "image/alpha.h"
#include "image/channel.h"
#include "numerics/srgb.h"

namespace poinsot {

namespace {

constexpr double pixels_per_degree = 67;

struct Triple {
    double a, b, c;
};
using Channels = std::array<Channel, 3>;

// CIE XYZ of linear sRGB (primaries and white D65 of IEC 61966-2-1).
Triple xyz_of(const Triple& rgb) {
    return {0.4124564 * rgb.a + 0.3575761 * rgb.b + 0.1804375 * rgb.c,
            0.2126729 * rgb.a + 0.7151522 * rgb.b + 0.0721750 * rgb.c,
            0.0193339 * rgb.a + 0.1191920 * rgb.b + 0.9503041 * rgb.c};
}
Triple rgb_of(const Triple& xyz) {
    return {3.2404542 * xyz.a - 1.5371385 * xyz.b - 0.4985314 * xyz.c,
            -0.9692660 * xyz.a + 1.8760108 * xyz.b + 0.0415560 * xyz.c,
            0.0556434 * xyz.a - 0.2040259 * xyz.b + 1.0572252 * xyz.c};
}
const Triple white_xyz = xyz_of({1, 1, 1});

// The opponent space YCxCz, linear in light (§4.1).
Triple opponent_of(const Triple& rgb) {
    const Triple xyz = xyz_of(rgb);
    const double x = xyz.a / white_xyz.a, y = xyz.b / white_xyz.b, z = xyz.c / white_xyz.c;
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}
Triple rgb_of_opponent(const Triple& ycc) {
    const double y = (ycc.a + 16) / 116, x = y + ycc.b / 500, z = y - ycc.c / 200;
    return rgb_of({x * white_xyz.a, y * white_xyz.b, z * white_xyz.c});
}

// CIE L*a*b* with Hunt's adjustment of chroma (§4.1.2).
Triple hunt_lab_of(const Triple& rgb) {
    const Triple xyz = xyz_of(rgb);
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29.0;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29.0;
    };
    const double x = f(xyz.a / white_xyz.a), y = f(xyz.b / white_xyz.b), z = f(xyz.c / white_xyz.c);
    const double lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Triple& p, const Triple& q) {
    return std::abs(p.a - q.a) + std::hypot(p.b - q.b, p.c - q.c);
}

std::array<double, 256> srgb_to_linear() {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = linear_from_srgb(static_cast<double>(i) / 255);
    return table;
}

Channels opponent_channels(const Image& image) {
    static const std::array<double, 256> linear = srgb_to_linear();
    Image flat;
    flatten_on_white(image, flat);
    const Channel empty(image.width(), image.height());
    Channels channels = {empty, empty, empty};
    const auto bytes = flat.bytes();
    for (std::size_t i = 0; i < empty.values.size(); ++i) {
        const Triple ycc =
            opponent_of({linear[bytes[4 * i]], linear[bytes[4 * i + 1]], linear[bytes[4 * i + 2]]});
        channels[0].values[i] = static_cast<float>(ycc.a);
        channels[1].values[i] = static_cast<float>(ycc.b);
        channels[2].values[i] = static_cast<float>(ycc.c);
    }
    return channels;
}

// Standard deviation, in pixels, of one term a·√(π/b)·exp(−π²x²/b) of the spatial contrast
// sensitivity; x in degrees.
double deviation_px(double b) { return std::sqrt(b / 2) / std::numbers::pi * pixels_per_degree; }

// Blue–yellow sensitivity is a sum of two Gaussians. The published filter keeps the factor √(π/b)
// in two dimensions, so that each Gaussian has the volume a·√(b/π).
Channel blurred(const Channel& channel, std::span<const std::array<double, 2>> terms) {
    const int radius = static_cast<int>(std::ceil(3 * deviation_px(0.04)));
    double volume = 0;
    for (const auto& [a, b] : terms) volume += a * std::sqrt(b);
    Channel sum(channel.width, channel.height);
    for (const auto& [a, b] : terms) {
        const std::vector<float> kernel = gaussian_kernel(deviation_px(b), radius);
        const Channel term = convolved(channel, kernel, kernel);
        const auto weight = static_cast<float>(a * std::sqrt(b) / volume);
        for (std::size_t i = 0; i < sum.values.size(); ++i)
            sum.values[i] += weight * term.values[i];
    }
    return sum;
}

// The part of a picture that the eye resolves, in the colour space of the distances (§4.1.1,
// §4.1.2).
std::vector<Triple> perceived(const Channels& channels) {
    constexpr std::array<std::array<double, 2>, 1> achromatic = {{{1, 0.0047}}};
    constexpr std::array<std::array<double, 2>, 1> red_green = {{{1, 0.0053}}};
    constexpr std::array<std::array<double, 2>, 2> blue_yellow = {{{34.1, 0.04}, {13.5, 0.025}}};
    const Channel y = blurred(channels[0], achromatic), cx = blurred(channels[1], red_green),
                  cz = blurred(channels[2], blue_yellow);
    std::vector<Triple> colours(y.values.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const Triple rgb = rgb_of_opponent({y.values[i], cx.values[i], cz.values[i]});
        colours[i] = hunt_lab_of({std::clamp(rgb.a, 0.0, 1.0), std::clamp(rgb.b, 0.0, 1.0),
                                  std::clamp(rgb.c, 0.0, 1.0)});
    }
    return colours;
}

// Derivatives of a Gaussian; the positive and the negative weights each sum to one (§4.2).
std::vector<float> derivative_kernel(double sigma, int radius, int order) {
    std::vector<double> weights;
    double positive = 0, negative = 0;
    for (int i = -radius; i <= radius; ++i) {
        const double gauss = std::exp(-0.5 * i * i / (sigma * sigma));
        const double weight = gauss * (order == 1 ? -i : i * i / (sigma * sigma) - 1);
        (weight > 0 ? positive : negative) += std::abs(weight);
        weights.push_back(weight);
    }
    std::vector<float> kernel;
    kernel.reserve(weights.size());
    for (const double weight : weights)
        kernel.push_back(static_cast<float>(weight / (weight > 0 ? positive : negative)));
    return kernel;
}

// Strength of edges (order 1) or points (order 2) in luminance.
Channel features(const Channel& luminance, int order) {
    const double sigma = 0.5 * 0.082 * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const std::vector<float> across = derivative_kernel(sigma, radius, order);
    const std::vector<float> along = gaussian_kernel(sigma, radius);
    Channel x = convolved(luminance, across, along);
    const Channel y = convolved(luminance, along, across);
    for (std::size_t i = 0; i < x.values.size(); ++i)
        x.values[i] = std::hypot(x.values[i], y.values[i]);
    return x;
}

// Maps a colour distance to 0…1, compressing large ones (§4.1.3).
double remapped(double distance) {
    constexpr double exponent = 0.7, knee = 0.4, knee_value = 0.95;
    static const double largest =
        std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), exponent);
    const double power = std::pow(distance, exponent);
    if (power < knee * largest) return knee_value / (knee * largest) * power;
    return knee_value + (power - knee * largest) / (largest - knee * largest) * (1 - knee_value);
}

}  // namespace

double flip_error(const Image& expected, const Image& actual) {
    assert(expected.width() == actual.width() && expected.height() == actual.height());
    std::array<Channels, 2> opponent = {opponent_channels(expected), opponent_channels(actual)};
    const std::vector<Triple> colours_a = perceived(opponent[0]),
                              colours_b = perceived(opponent[1]);
    for (Channels& channels : opponent)
        for (float& value : channels[0].values) value = (value + 16) / 116;
    const Channel edges_a = features(opponent[0][0], 1), edges_b = features(opponent[1][0], 1);
    const Channel points_a = features(opponent[0][0], 2), points_b = features(opponent[1][0], 2);
    double sum = 0;
    for (std::size_t i = 0; i < colours_a.size(); ++i) {
        const double colour = remapped(hyab(colours_a[i], colours_b[i]));
        const double feature = std::max(std::abs(edges_a.values[i] - edges_b.values[i]),
                                        std::abs(points_a.values[i] - points_b.values[i]));
        // A difference in features amplifies the difference in colour (§4.3).
        sum += std::pow(colour, 1 - std::sqrt(feature / std::numbers::sqrt2));
    }
    return sum / static_cast<double>(colours_a.size());
}

}  // namespace poinsot
