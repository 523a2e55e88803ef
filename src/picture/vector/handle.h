// Owns an object of a C library and calls its release function.
#pragma once

#include <memory>

namespace poinsot::vector {

template <auto Destroy>
struct Destroyer {
    template <typename T>
    void operator()(T* made) const {
        Destroy(made);
    }
};
template <typename T, auto Destroy>
using Handle = std::unique_ptr<T, Destroyer<Destroy>>;

}  // namespace poinsot::vector
