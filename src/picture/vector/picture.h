// Draws shapes as vectors on a sheet of paper, as render/ draws them as pixels. Depends on shapes/
// only.
#pragma once

#include "shapes/views.h"
#include "vector/passes/surfaces.h"
#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

struct PaperChoices {
    double pt_per_px = 0.24;  // points on paper per pixel of the drawing
    Shading shading = Shading::tone;
    DrawPixels draw_pixels{};  // used only by Shading::picture
};

// Returns the sheet of a drawing. It refers to the drawing's fonts, which must outlive it.
SheetOfPaper paper_of(const Drawing& drawing, const PaperChoices& choices);

}  // namespace poinsot::vector
