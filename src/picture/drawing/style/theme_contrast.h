// Checks that a theme's colours are visible and distinguishable; the colours of its letters.
#pragma once

#include <string>
#include <vector>

#include "drawing/style/theme.h"
#include "scene/scene.h"

namespace poinsot {

// The theme's backgrounds of letters; only the halo if the picture's background is transparent.
std::vector<Colour> grounds_of(const Theme& theme);

// The colour of letters that name something of this colour: the same hue, as much darker (or
// lighter, on a dark background) as a contrast of 4.5 with all backgrounds requires. Lines need
// only 3. The theme's own colour of text is returned as it is.
Colour letter_colour(const Theme& theme, const Colour& colour);

// The path of a top's axis: e3's look, half-way to the colour of text, which an eye without green
// tells from φ's arc.
LineStyle path_of_e3(const Theme& theme);

// Violations of the rules that the built-in themes follow (docs/guide.md, "Your own theme"):
// one line each, with the position of the key. `theme`: the scene's. Empty if the scene
// has no style.
std::vector<std::string> contrast_notes(const Scene& scene, const Theme& theme);

}  // namespace poinsot
