// The number of shapes of a drawing, by which two programs compare theirs.
#pragma once

#include <cstddef>

#include "shapes/views.h"

namespace poinsot {

inline std::size_t n_shapes(Drawing drawing) {
    std::size_t n = 0;
    for (View& view : drawing.views)
        for_each_list(view, [&n](const auto& list) { n += list.size(); });
    return n;
}

}  // namespace poinsot
