// The rate of a sequence of pictures.
#pragma once

#include <cstdint>

namespace poinsot {

struct FrameRate {
    std::int64_t numerator = 30;
    std::int64_t denominator = 1;
    double per_second() const {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }
};

}  // namespace poinsot
