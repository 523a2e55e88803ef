// The names of shapes: which element of the picture a shape belongs to.
#pragma once

#include <string_view>

namespace poinsot {

// Vector files group shapes by name. No name influences what is drawn.
struct ShapeName {
    std::string_view
        element{};            // such as "polhode"; owned by the stage, which outlives its drawings
    int number = 0;           // of the arrow in its element, from 1; 0 if there is only one
    std::string_view part{};  // such as "head"; empty for the shape itself
    bool operator==(const ShapeName&) const = default;
};

}  // namespace poinsot
