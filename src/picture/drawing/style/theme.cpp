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

// The hues start from Okabe & Ito (2008). Lightness and chroma were chosen so that every line has a
// contrast of 3 on every surface as rendered, and that lines which meet are distinguishable for all
// common kinds of colour vision: tests/outputs/production/palette_test.cpp and
// tests/picture/drawing/theme_test.cpp have the margins. The body is pale and lit mostly by the
// sky, so that its shaded side, too, carries dark lines. N, ∇F and marked points, which no view
// shows together, have one colour: a scene that marks a point beside N or ∇F gives the point
// another colour. Measured points are of that green which differs most from the two curves, L and
// ω.
const Theme light{
    .name = "light",
    .summary = "for pages, screens and bright rooms; colour-blind safe",
    .background = {.top = hex(0xe9eef5), .bottom = hex(0xfbfcfd), .alpha = 1.0},
    .light = {.towards = {0.3, -0.6, 0.8}, .key = 0.42, .sky = 0.78},
    .text = hex(0x1c2430),
    .halo = hex(0xfbfcfd),
    .ellipsoid = hex(0xfbe0a8),
    .ellipsoid_opacity = 0.66,
    .ellipsoid_lines = hex(0x8a5c1e),
    .plane = hex(0xd5dee9),
    .grid = hex(0xa3b1c2),
    .plane_opacity = 0.9,
    .polhode = hex(0x0045b6),
    .herpolhode = hex(0xcd5203),
    .polhode_weight = 1.3,
    .herpolhode_weight = 1.6,
    .momentum = hex(0x1c2430),
    .omega = hex(0x581476),
    .rho = hex(0xb81c68),
    .gradient = hex(0x7617f4),
    .torque = hex(0x7617f4),
    .axes = {hex(0x7d5100), hex(0x02483d), hex(0x0c71af)},
    .contact = hex(0x1c2430),
    .mark = hex(0x7617f4),
    .measured = hex(0x00491a),
    .body_cone = hex(0x0c71af),
    .space_cone = hex(0xcd5203),
    .annulus = hex(0x66778d),
    .separatrix = hex(0x1c2430),
    .sphere = hex(0x9fb4cc),
    .solid = hex(0xa9b7c6),
    .solid_lines = hex(0x374352),
    .angles = {hex(0xcd5203), hex(0x8201e9), hex(0x3d4401)},
    .energy = hex(0x32873c),
    .potential = hex(0x3d4b60),
    .rule = hex(0x6f8096),
};

const Theme dark{
    .name = "dark",
    .summary = "for films and slides; keeps the most contrast on a projector, in a lit hall too",
    .background = {.top = hex(0x11161d), .bottom = hex(0x1b222d), .alpha = 1.0},
    .light = {.towards = {0.3, -0.6, 0.8}, .key = 0.95, .sky = 0.26},
    .text = hex(0xe8edf3),
    .halo = hex(0x11161d),
    .ellipsoid = hex(0x342610),
    .ellipsoid_opacity = 0.72,
    .ellipsoid_lines = hex(0xf2d9a8),
    .plane = hex(0x252f3d),
    .grid = hex(0x42516a),
    .plane_opacity = 0.9,
    .polhode = hex(0x75d2fe),
    .herpolhode = hex(0xff8c21),
    .polhode_weight = 1.2,
    .herpolhode_weight = 1.5,
    .momentum = hex(0xf2f4f7),
    .omega = hex(0xb971a9),
    .rho = hex(0xff5d5d),
    .gradient = hex(0xa472fb),
    .torque = hex(0xa472fb),
    .axes = {hex(0xf5bf1a), hex(0x00f7b9), hex(0x8ca5cd)},
    .contact = hex(0xf2f4f7),
    .mark = hex(0xa472fb),
    .measured = hex(0xa4fd14),
    .body_cone = hex(0x8ca5cd),
    .space_cone = hex(0xff8c21),
    .annulus = hex(0x8090a6),
    .separatrix = hex(0xf2f4f7),
    .ghost = hex(0x939ca8),
    .sphere = hex(0x364559),
    .solid = hex(0x62718a),
    .solid_lines = hex(0xe8edf3),
    .angles = {hex(0xff8c21), hex(0xb26aff), hex(0xa5bf84)},
    .energy = hex(0x8ce907),
    .potential = hex(0xe1bebc),
    .rule = hex(0x71829a),
};

// For paper: a white background, little ink on surfaces, and lines of one kind (curves, arrows from
// the centre, axes) that differ in lightness alone.
const Theme print{
    .name = "print",
    .summary = "for paper, in colour or grey",
    .background = {.top = hex(0xffffff), .bottom = hex(0xffffff), .alpha = 1.0},
    .light = {.towards = {0.3, -0.6, 0.8}, .key = 0.45, .sky = 0.68},
    .text = hex(0x101010),
    .halo = hex(0xffffff),
    .ellipsoid = hex(0xf0ece4),
    .ellipsoid_opacity = 0.64,
    .ellipsoid_lines = hex(0x4f4b43),
    .plane = hex(0xf1f1f1),
    .grid = hex(0xc8c8c8),
    .plane_opacity = 0.9,
    .polhode = hex(0x00499f),
    .herpolhode = hex(0xda4300),
    .polhode_weight = 1.2,
    .herpolhode_weight = 1.6,
    .momentum = hex(0x101010),
    .omega = hex(0x6d0158),
    .rho = hex(0xbc174c),
    .gradient = hex(0x7012f5),
    .torque = hex(0x7012f5),
    .axes = {hex(0x6a4c08), hex(0x00351f), hex(0x327dbc)},
    .contact = hex(0x101010),
    .mark = hex(0x7012f5),
    .measured = hex(0x023c04),
    .body_cone = hex(0x327dbc),
    .space_cone = hex(0x962a1e),
    .annulus = hex(0x8a8a8a),
    .separatrix = hex(0x101010),
    .sphere = hex(0xc4c9cf),
    .solid = hex(0xc2c6cb),
    .solid_lines = hex(0x3a3a3a),
    .angles = {hex(0xda4300), hex(0x7935e4), hex(0x1a3805)},
    .energy = hex(0x4b9230),
    .potential = hex(0x3e4856),
    .rule = hex(0x858585),
    .hidden = "dashed",
};

// Every pair of lines is distinguishable for all kinds of colour vision, and the two curves also by
// their style.
const Theme colour_blind{
    .name = "colour-blind",
    .summary = "largest colour differences for every kind of colour vision; thicker herpolhode",
    .background = {.top = hex(0xf7f9fb), .bottom = hex(0xffffff), .alpha = 1.0},
    .light = {.towards = {0.3, -0.6, 0.8}, .key = 0.45, .sky = 0.68},
    .text = hex(0x000000),
    .halo = hex(0xffffff),
    .ellipsoid = hex(0xf5e8c6),
    .ellipsoid_opacity = 0.66,
    .ellipsoid_lines = hex(0x5d4c20),
    .plane = hex(0xe1e6ec),
    .grid = hex(0xadb7c2),
    .plane_opacity = 0.9,
    .polhode = hex(0x0026a8),
    .herpolhode = hex(0xc65809),
    .polhode_weight = 1.2,
    .herpolhode_weight = 1.5,
    .momentum = hex(0x000000),
    .omega = hex(0x710f62),
    .rho = hex(0xb90a2d),
    .gradient = hex(0x7214e5),
    .torque = hex(0x7214e5),
    .axes = {hex(0x4e2e00), hex(0x366754), hex(0x007dca)},
    .contact = hex(0x000000),
    .mark = hex(0x7214e5),
    .measured = hex(0x348d59),
    .body_cone = hex(0x007dca),
    .space_cone = hex(0xc65809),
    .annulus = hex(0x76828f),
    .separatrix = hex(0x000000),
    .sphere = hex(0x9fb4cc),
    .solid = hex(0xa9b7c6),
    .solid_lines = hex(0x2d3844),
    .angles = {hex(0xc65809), hex(0x830ff4), hex(0x005631)},
    .energy = hex(0x749d06),
    .potential = hex(0x495569),
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
