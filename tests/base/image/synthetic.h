// A picture similar to poinsot's, made by simple loops: flat background, grid, shaded body that
// turns with the frame number, thin smooth curves. Input for encoders and comparisons.
#pragma once

#include <algorithm>
#include <cmath>

#include "image/image.h"

namespace poinsot {

inline Image synthetic_frame(int width, int height, int k) {
    Image image(width, height);
    const double scale = height / 1080.0;
    const double turn = 0.05 * k;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double r = 0.96, g = 0.96, b = 0.95;
            const double px = (x - 0.5 * width) / scale, py = (y - 0.5 * height) / scale;
            // Grid lines of the lower half, converging upwards.
            if (py > 150) {
                const double depth = 40000 / (py - 100), side = px * depth / 400;
                const double line =
                    std::min(std::abs(side / 40 - std::round(side / 40)) * 16000 / depth,
                             std::abs(depth / 40 - std::round(depth / 40)) * 40);
                const double shade = std::clamp(1.5 - line, 0.0, 1.0) * 0.35;
                r -= shade, g -= shade, b -= shade;
            }
            // The body: an ellipse with smooth light and one moving stripe.
            const double ex = px / 420, ey = py / 260, rr = ex * ex + ey * ey;
            const double edge = std::clamp((1 - std::sqrt(rr)) * 260 + 0.5, 0.0, 1.0);
            if (edge > 0) {
                const double ez = std::sqrt(std::max(0.0, 1 - rr));
                const double light = 0.35 + 0.6 * std::max(0.0, 0.4 * ex - 0.6 * ey + 0.7 * ez);
                const double longitude = std::atan2(ex, ez + 1e-9) + turn;
                const double stripe =
                    std::clamp(3 - 150 * std::abs(std::remainder(longitude, 1.0)), 0.0, 1.0);
                r += edge * ((0.25 + 0.5 * stripe) * light - r);
                g += edge * ((0.45 + 0.2 * stripe) * light - g);
                b += edge * ((0.80 - 0.5 * stripe) * light - b);
            }
            // A curve of constant width around it, growing with the frame number.
            const double radius = std::hypot(px, py * 1.6), angle = std::atan2(py, px) + 3.2;
            const double wave = 560 + 25 * std::sin(9 * angle + 0.3);
            if (angle < 0.2 + turn) {
                const double cover = std::clamp(2 - std::abs(radius - wave), 0.0, 1.0);
                r += cover * (0.8 - r), g += cover * (0.2 - g), b += cover * (0.1 - b);
            }
            const auto level = [](double v) {
                return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
            };
            image.set(x, y, {level(r), level(g), level(b), 255});
        }
    }
    return image;
}

}  // namespace poinsot
