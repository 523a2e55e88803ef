#include "shapes/identity.h"

#include <atomic>

namespace poinsot {

std::uint64_t next_identity() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

}  // namespace poinsot
