// The page of a figure: its size, and its panels one above another on a page as narrow as a column.
#pragma once

#include <string>
#include <vector>

#include "production/session/print_size.h"
#include "scene/scene.h"
#include "typeset/font_source.h"

namespace poinsot {

// Sets the scene's size in pixels to that on paper, if an option is about paper. If only a width is
// given, chooses the height, and on a narrow page the grid of the panels; adds a note about the
// grid. The other options are used when the picture is made.
void lay_out_on_paper(const PrintChoices& print, const FontSource& fonts, Scene& scene,
                      std::vector<std::string>& notes);

}  // namespace poinsot
