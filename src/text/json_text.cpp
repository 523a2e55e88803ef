#include "text/json_text.h"

#include <fmt/format.h>

#include <cmath>

namespace poinsot {

std::string json_number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace poinsot
