// A colour as stored in pictures.
#pragma once

#include <string>

namespace poinsot {

struct Colour {
    double r = 0.0, g = 0.0, b = 0.0;  // sRGB-encoded, 0…1
    bool operator==(const Colour&) const = default;
};

// As in CSS: "#cd5203".
std::string hex_text(const Colour& colour);

}  // namespace poinsot
