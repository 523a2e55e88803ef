#include "encoding/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace poinsot {

namespace {

using Colour = std::array<double, 3>;

// Approximate sensitivity of the eye to red, green and blue.
constexpr Colour channel_weights = {2, 4, 1.5};

double distance(const Colour& a, const Colour& b) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += channel_weights[c] * (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

struct Point {
    Colour colour;
    double n;
};

struct Box {
    std::size_t begin, end;  // of the points
    std::size_t axis;        // along which it varies most
    double variance;         // along it, weighted by the number of pixels
    double mean;             // along it
};

Box box_of(const std::vector<Point>& points, std::size_t begin, std::size_t end) {
    Box box{begin, end, 0, -1, 0};
    for (std::size_t c = 0; c < 3; ++c) {
        double n = 0, sum = 0, squares = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const double value = points[i].colour[c];
            n += points[i].n, sum += points[i].n * value, squares += points[i].n * value * value;
        }
        const double variance = channel_weights[c] * (squares - sum * sum / n);
        if (variance > box.variance) box = {begin, end, c, variance, sum / n};
    }
    return box;
}

Colour mean_of(std::span<const Point> points) {
    Colour mean{};
    double n = 0;
    for (const Point& point : points) {
        n += point.n;
        for (std::size_t c = 0; c < 3; ++c) mean[c] += point.n * point.colour[c];
    }
    for (double& value : mean) value /= n;
    return mean;
}

std::vector<Colour> split(std::vector<Point>& points, std::size_t n_colours) {
    std::vector<Box> boxes = {box_of(points, 0, points.size())};
    while (boxes.size() < n_colours) {
        const auto widest =
            std::max_element(boxes.begin(), boxes.end(),
                             [](const Box& a, const Box& b) { return a.variance < b.variance; });
        // A box of one cell has only the variance of rounding.
        if (widest->end - widest->begin < 2 || widest->variance <= 0) break;
        const Box box = *widest;
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(box.begin);
        const auto last = points.begin() + static_cast<std::ptrdiff_t>(box.end);
        const auto middle = std::partition(
            first, last, [&](const Point& point) { return point.colour[box.axis] < box.mean; });
        const auto at = static_cast<std::size_t>(middle - points.begin());
        if (at == box.begin || at == box.end) {
            widest->variance = 0;
            continue;
        }
        *widest = box_of(points, box.begin, at);
        boxes.push_back(box_of(points, at, box.end));
    }
    std::vector<Colour> colours;
    colours.reserve(boxes.size());
    for (const Box& box : boxes)
        colours.push_back(mean_of(std::span(points).subspan(box.begin, box.end - box.begin)));
    return colours;
}

void move_to_means(const std::vector<Point>& points, std::vector<Colour>& colours) {
    std::vector<Point> sums(colours.size());
    for (const Point& point : points) {
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < colours.size(); ++k) {
            const double d = distance(point.colour, colours[k]);
            if (d < least) least = d, nearest = k;
        }
        sums[nearest].n += point.n;
        for (std::size_t c = 0; c < 3; ++c) sums[nearest].colour[c] += point.n * point.colour[c];
    }
    for (std::size_t k = 0; k < colours.size(); ++k)
        if (sums[k].n > 0)
            for (std::size_t c = 0; c < 3; ++c) colours[k][c] = sums[k].colour[c] / sums[k].n;
}

// Bayer's matrix by its recursion: interleaved bits of x XOR y and of y, from the lowest.
int threshold(int x, int y) {
    int value = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int xb = x >> bit & 1, yb = y >> bit & 1;
        value = value << 2 | (xb ^ yb) << 1 | yb;
    }
    return value;
}

constexpr std::size_t cells_per_side = 64;
constexpr std::size_t n_remembered = 1 << 16;

}  // namespace

ColourCount::ColourCount() : cells_(cells_per_side * cells_per_side * cells_per_side) {}

void ColourCount::add(const Image& image) {
    const auto bytes = image.bytes();
    for (std::size_t i = 0; i < bytes.size(); i += 4) {
        if (bytes[i + 3] < 128) continue;
        Cell& cell = cells_[(bytes[i] / 4u * cells_per_side + bytes[i + 1] / 4u) * cells_per_side +
                            bytes[i + 2] / 4u];
        cell.n += 1;
        for (std::size_t c = 0; c < 3; ++c) cell.sum[c] += bytes[i + c];
    }
}

std::vector<Rgba8> palette_for(const ColourCount& count, std::size_t n_colours) {
    std::vector<Point> points;
    for (const ColourCount::Cell& cell : count.cells())
        if (cell.n > 0)
            // Weighted by square roots: thin lines have few pixels but carry the meaning, large
            // backgrounds do not.
            points.push_back({{cell.sum[0] / cell.n, cell.sum[1] / cell.n, cell.sum[2] / cell.n},
                              std::sqrt(cell.n)});
    if (points.empty()) return {Rgba8{}};
    std::vector<Colour> colours = split(points, n_colours);
    for (int round = 0; round < 4; ++round) move_to_means(points, colours);
    std::vector<Rgba8> palette;
    for (const Colour& colour : colours) {
        const auto level = [](double v) { return static_cast<std::uint8_t>(std::lround(v)); };
        palette.push_back({level(colour[0]), level(colour[1]), level(colour[2]), 255});
    }
    return palette;
}

Ditherer::Ditherer(std::vector<Rgba8> palette, std::uint8_t transparent_index)
    : palette_(std::move(palette)),
      transparent_index_(transparent_index),
      remembered_(n_remembered) {}

std::uint8_t Ditherer::nearest(const std::array<int, 3>& colour) const {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::max();
    const Colour wanted = {double(colour[0]), double(colour[1]), double(colour[2])};
    for (std::size_t k = 0; k < palette_.size(); ++k) {
        const Rgba8 c = palette_[k];
        const double d = distance(wanted, {double(c.r), double(c.g), double(c.b)});
        if (d < least) least = d, nearest = k;
    }
    return static_cast<std::uint8_t>(nearest);
}

const Ditherer::Mix& Ditherer::mix_for(const std::uint8_t* rgb) {
    const std::uint32_t colour = rgb[0] << 16 | rgb[1] << 8 | rgb[2];
    Mix& mix = remembered_[colour * 2654435761u >> 16];
    if (mix.colour == colour) return mix;
    mix.colour = colour;
    mix.first = nearest({rgb[0], rgb[1], rgb[2]});
    // The second colour lies about as far on the other side; its share follows from the projection
    // onto the line between them.
    const Rgba8 p = palette_[mix.first];
    mix.second = nearest({2 * rgb[0] - p.r, 2 * rgb[1] - p.g, 2 * rgb[2] - p.b});
    const Rgba8 q = palette_[mix.second];
    const Colour way = {double(q.r - p.r), double(q.g - p.g), double(q.b - p.b)};
    const Colour part = {double(rgb[0] - p.r), double(rgb[1] - p.g), double(rgb[2] - p.b)};
    double along = 0, length = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        along += channel_weights[c] * way[c] * part[c];
        length += channel_weights[c] * way[c] * way[c];
    }
    mix.share =
        length > 0
            ? static_cast<std::uint8_t>(std::lround(64 * std::clamp(along / length, 0.0, 1.0)))
            : std::uint8_t{0};
    return mix;
}

void Ditherer::apply(const Image& image, std::uint8_t* indices, std::ptrdiff_t stride) {
    std::array<std::array<std::uint8_t, 8>, 8> matrix{};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            matrix[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>(threshold(x, y));
    const std::uint8_t* pixel = image.bytes().data();
    for (int y = 0; y < image.height(); ++y, indices += stride) {
        const auto& row = matrix[static_cast<std::size_t>(y % 8)];
        for (int x = 0; x < image.width(); ++x, pixel += 4) {
            if (pixel[3] < 128) {
                indices[x] = transparent_index_;
                continue;
            }
            const Mix& mix = mix_for(pixel);
            indices[x] = row[static_cast<std::size_t>(x % 8)] < mix.share ? mix.second : mix.first;
        }
    }
}

}  // namespace poinsot
