// A colour as stored in pictures.
#pragma once

namespace poinsot {

struct Colour {
    double r = 0.0, g = 0.0, b = 0.0;  // sRGB-encoded, 0…1
    bool operator==(const Colour&) const = default;
};

}  // namespace poinsot
