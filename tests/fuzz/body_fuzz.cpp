// Any doubles as a tensor, an angular velocity and an attitude: the motion must be right, or
// refused by name, and every call must end.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "mechanics/any_body.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Six elements, ω, the attitude; what is missing is zero.
    std::array<double, 13> numbers{};
    if (size > sizeof numbers) size = sizeof numbers;
    std::memcpy(numbers.data(), data, size);
    const auto& [xx, yy, zz, xy, xz, yz, wx, wy, wz, qw, qx, qy, qz] = numbers;
    poinsot::any_body::Body body;
    body.tensor_kg_m2 << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    body.omega_rad_s = {wx, wy, wz};
    body.attitude = Eigen::Quaterniond(qw, qx, qy, qz);
    for (const auto physicality : {poinsot::Physicality::required, poinsot::Physicality::waived}) {
        body.physicality = physicality;
        const poinsot::any_body::Outcome outcome = poinsot::any_body::moved(body);
        if (outcome.fault.empty()) continue;
        std::fprintf(stderr, "%s\n", outcome.fault.c_str());
        std::abort();
    }
    return 0;
}
