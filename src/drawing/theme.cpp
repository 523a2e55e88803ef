#include "drawing/theme.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "error/error.h"

namespace poinsot {

namespace {

// 0xRRGGBB as designers write it.
constexpr Colour hex(std::uint32_t rgb) {
    return {static_cast<double>((rgb >> 16) & 0xff) / 255.0,
            static_cast<double>((rgb >> 8) & 0xff) / 255.0,
            static_cast<double>(rgb & 0xff) / 255.0};
}

// Hues after Okabe & Ito (2008), distinguishable with every common colour vision.
const std::array<Theme, 1> table{{
    {
        .name = "light",
        .summary = "bright room, projector or screen",
        .background = {.top = hex(0xe9eef5), .bottom = hex(0xfbfcfd), .alpha = 1.0},
        .light = {},
        .text = hex(0x1c2430),
        .halo = hex(0xfbfcfd),
        .ellipsoid = hex(0xe8b56a),
        .ellipsoid_opacity = 0.72,
        .ellipsoid_lines = hex(0x6b4a1a),
        .plane = hex(0xd5dee9),
        .grid = hex(0x8495aa),
        .plane_opacity = 0.9,
        .polhode = hex(0x0b5fa5),
        .herpolhode = hex(0xcf4a12),
        .momentum = hex(0x1c2430),
        .omega = hex(0x9c2c86),
        .axes = {hex(0x8a5a00), hex(0x00805c), hex(0x2f86c4)},
        .contact = hex(0x1c2430),
        .body_cone = hex(0x2f86c4),
        .space_cone = hex(0xcf4a12),
        .annulus = hex(0x8495aa),
        .separatrix = hex(0x1c2430),
        .sphere = hex(0x9fb4cc),
        .solid = hex(0xa9b7c6),
        .solid_lines = hex(0x3d4a5a),
        .angles = {hex(0xcf4a12), hex(0x0b5fa5), hex(0x6a7600)},
        .energy = hex(0xa8741a),
        .potential = hex(0x4a5a70),
        .rule = hex(0x8495aa),
    },
}};

}  // namespace

std::span<const Theme> themes() { return table; }

const Theme& theme_named(std::string_view name) {
    for (const Theme& theme : table) {
        if (theme.name == name) return theme;
    }
    std::string known;
    for (const Theme& theme : table)
        known += fmt::format("{}{}", known.empty() ? "" : ", ", theme.name);
    throw InputError(fmt::format("unknown theme \"{}\"; choose one of: {}", name, known));
}

}  // namespace poinsot
