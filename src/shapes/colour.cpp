#include "shapes/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poinsot {

std::string hex_text(const Colour& colour) {
    const auto level = [](double share) {
        return static_cast<int>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", level(colour.r), level(colour.g), level(colour.b));
}

}  // namespace poinsot
