#include "drawing/style/theme.h"

#include <cstdint>
#include <vector>

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

// 0xRRGGBB as designers write it.
constexpr Colour hex(std::uint32_t rgb) {
    return {static_cast<double>((rgb >> 16) & 0xff) / 255.0,
            static_cast<double>((rgb >> 8) & 0xff) / 255.0,
            static_cast<double>(rgb & 0xff) / 255.0};
}

// The hues start from Okabe & Ito (2008). They were changed as little as needed to make the
// quantities of one view distinguishable for all common kinds of colour vision;
// tests/drawing/theme_test.cpp has the margins. N, ∇F and φ, which no view shows together, have one
// colour. Marked points have it, too: a scene that marks a point beside N or ∇F gives the point
// another colour. Measured points are of that green which differs most from the two curves, L and
// ω.
const Theme light{
    .name = "light",
    .summary = "for bright rooms, on a projector or screen; colour-blind safe",
    .background = {.top = hex(0xe9eef5), .bottom = hex(0xfbfcfd), .alpha = 1.0},
    .light = {},
    .text = hex(0x1c2430),
    .halo = hex(0xfbfcfd),
    .ellipsoid = hex(0xe8b56a),
    .ellipsoid_opacity = 0.66,
    .ellipsoid_lines = hex(0x6b4a1a),
    .plane = hex(0xd5dee9),
    .grid = hex(0x8495aa),
    .plane_opacity = 0.9,
    .polhode = hex(0x0565c5),
    .herpolhode = hex(0xcf4a12),
    .herpolhode_weight = 1.0,
    .momentum = hex(0x1c2430),
    .omega = hex(0x9a247d),
    .rho = hex(0xe41748),
    .gradient = hex(0x6a2bd9),
    .torque = hex(0x6a2bd9),
    .axes = {hex(0x9c6915), hex(0x056857), hex(0x2787c6)},
    .contact = hex(0x1c2430),
    .mark = hex(0x6a2bd9),
    .measured = hex(0x004818),
    .body_cone = hex(0x2787c6),
    .space_cone = hex(0xcf4a12),
    .annulus = hex(0x66778d),
    .separatrix = hex(0x1c2430),
    .sphere = hex(0x9fb4cc),
    .solid = hex(0xa9b7c6),
    .solid_lines = hex(0x3d4a5a),
    .angles = {hex(0xcf4a12), hex(0x6a2bd9), hex(0x3d4400)},
    .energy = hex(0x32883e),
    .potential = hex(0x4a5a70),
    .rule = hex(0x6f8096),
};

const Theme dark{
    .name = "dark",
    .summary = "for dark rooms or dark slides; colour-blind safe",
    .background = {.top = hex(0x11161d), .bottom = hex(0x1b222d), .alpha = 1.0},
    .light = {.towards = {0.3, -0.6, 0.8}, .key = 0.85, .sky = 0.36},
    .text = hex(0xe8edf3),
    .halo = hex(0x11161d),
    .ellipsoid = hex(0x86602a),
    .ellipsoid_opacity = 0.62,
    .ellipsoid_lines = hex(0xf2d9a8),
    .plane = hex(0x252f3d),
    .grid = hex(0x51627a),
    .plane_opacity = 0.9,
    .polhode = hex(0x6fc9fc),
    .herpolhode = hex(0xfc884e),
    .herpolhode_weight = 1.0,
    .momentum = hex(0xf2f4f7),
    .omega = hex(0xbd6cc1),
    .rho = hex(0xff4d5e),
    .gradient = hex(0x8650ff),
    .torque = hex(0x8650ff),
    .axes = {hex(0xe0b04a), hex(0x05a77c), hex(0x94a0dd)},
    .contact = hex(0xf2f4f7),
    .mark = hex(0x8650ff),
    .measured = hex(0xa8fc30),
    .body_cone = hex(0x94a0dd),
    .space_cone = hex(0xfc884e),
    .annulus = hex(0x8090a6),
    .separatrix = hex(0xf2f4f7),
    .ghost = hex(0x939ca8),
    .sphere = hex(0x6d86a3),
    .solid = hex(0x8393a6),
    .solid_lines = hex(0xe8edf3),
    .angles = {hex(0xfc884e), hex(0x8650ff), hex(0xf0f0a0)},
    .energy = hex(0x8fe827),
    .potential = hex(0x8a8c88),
    .rule = hex(0x71829a),
};

// For paper: a white background, little ink on surfaces, and lines that differ in lightness alone.
const Theme print{
    .name = "print",
    .summary = "for paper, in colour or grey",
    .background = {.top = hex(0xffffff), .bottom = hex(0xffffff), .alpha = 1.0},
    .light = {.towards = {0.3, -0.6, 0.8}, .key = 0.66, .sky = 0.46},
    .text = hex(0x101010),
    .halo = hex(0xffffff),
    .ellipsoid = hex(0xe6e1d8),
    .ellipsoid_opacity = 0.55,
    .ellipsoid_lines = hex(0x6a665e),
    .plane = hex(0xf1f1f1),
    .grid = hex(0xaaaaaa),
    .plane_opacity = 0.9,
    .polhode = hex(0x054597),
    .herpolhode = hex(0xc63e2f),
    .herpolhode_weight = 1.4,
    .momentum = hex(0x101010),
    .omega = hex(0x6f0552),
    .rho = hex(0xe8256a),
    .gradient = hex(0x7844da),
    .torque = hex(0x7844da),
    .axes = {hex(0x533d09), hex(0x00745a), hex(0x5d98cd)},
    .contact = hex(0x101010),
    .mark = hex(0x7844da),
    .measured = hex(0x003c00),
    .body_cone = hex(0x5d98cd),
    .space_cone = hex(0x9c2d20),
    .annulus = hex(0x8a8a8a),
    .separatrix = hex(0x101010),
    .sphere = hex(0xc4c9cf),
    .solid = hex(0xc2c6cb),
    .solid_lines = hex(0x3a3a3a),
    .angles = {hex(0xc63e2f), hex(0x7844da), hex(0x1f3a10)},
    .energy = hex(0x629c40),
    .potential = hex(0x566272),
    .rule = hex(0x858585),
};

// Every pair of lines is distinguishable for all kinds of colour vision, and the two curves also by
// their style.
const Theme colour_blind{
    .name = "colour-blind",
    .summary = "largest colour differences for every kind of colour vision; thicker herpolhode",
    .background = {.top = hex(0xf7f9fb), .bottom = hex(0xffffff), .alpha = 1.0},
    .light = {},
    .text = hex(0x000000),
    .halo = hex(0xffffff),
    .ellipsoid = hex(0xf0dfb4),
    .ellipsoid_opacity = 0.60,
    .ellipsoid_lines = hex(0x5d4c20),
    .plane = hex(0xe1e6ec),
    .grid = hex(0x8f9caa),
    .plane_opacity = 0.9,
    .polhode = hex(0x053882),
    .herpolhode = hex(0xd05a04),
    .herpolhode_weight = 1.5,
    .momentum = hex(0x000000),
    .omega = hex(0xab4c8c),
    .rho = hex(0xc8102e),
    .gradient = hex(0x6b3fc4),
    .torque = hex(0x6b3fc4),
    .axes = {hex(0x523305), hex(0x056f4d), hex(0x2e8acc)},
    .contact = hex(0x000000),
    .mark = hex(0x6b3fc4),
    .measured = hex(0x3c9c60),
    .body_cone = hex(0x2e8acc),
    .space_cone = hex(0xd05a04),
    .annulus = hex(0x76828f),
    .separatrix = hex(0x000000),
    .sphere = hex(0x9fb4cc),
    .solid = hex(0xa9b7c6),
    .solid_lines = hex(0x2d3844),
    .angles = {hex(0xd05a04), hex(0x6b3fc4), hex(0x3c7a66)},
    .energy = hex(0x799a40),
    .potential = hex(0x3c4a5c),
    .rule = hex(0x6f7c8a),
};

// The colours of a theme over a transparent background.
Theme transparent_of(Theme theme, std::string_view name, std::string_view summary,
                     const Colour& halo) {
    theme.name = name;
    theme.summary = summary;
    theme.background.alpha = 0.0;
    theme.halo = halo;
    return theme;
}

const Theme theme_rows[] = {
    light,
    dark,
    print,
    colour_blind,
    transparent_of(light, "transparent",
                   "the light theme on a transparent background, for slides and pages",
                   hex(0xffffff)),
    transparent_of(dark, "transparent-dark",
                   "the dark theme on a transparent background, for dark slides", hex(0x000000))};

}  // namespace

std::span<const Theme> themes() { return theme_rows; }

const Theme& theme_named(std::string_view name) {
    if (const Theme* row = find_row(theme_rows, name)) return *row;
    const std::vector<std::string_view> names = names_of(theme_rows);
    const bool none_near = did_you_mean(name, names).empty();
    throw InputError(unknown("theme", name, names) +
                     (none_near ? ", or the path of a theme file, as in my.toml" : ""));
}

}  // namespace poinsot
