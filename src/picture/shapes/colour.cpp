#include "shapes/colour.h"

#include <algorithm>
#include <cmath>

namespace poinsot {

std::string hex_text(const Colour& colour) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const double share : {colour.r, colour.g, colour.b}) {
        const long level = std::lround(255.0 * std::clamp(share, 0.0, 1.0));
        text += {digits[level / 16], digits[level % 16]};
    }
    return text;
}

}  // namespace poinsot
