// The type of a figure as LaTeX: a picture environment over \includegraphics.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "typeset/latex.h"
#include "vector/page.h"

namespace poinsot {

// FIG.tex beside FIG.pdf.
std::filesystem::path latex_path_of(const std::filesystem::path& figure);

// Throws InputError for a name that LaTeX cannot take for a figure's, and where a file of that
// other name is there that is not one of these.
void check_latex_place(const std::filesystem::path& figure);

// What FIG.tex says: each label on its baseline, in the size that it has in the figure and the
// document's own fonts. page: without its type. Adds to the gaps. Throws LabelError for what has no
// meaning.
std::string latex_figure(const vector::Page& page, const std::vector<vector::Type>& type,
                         const std::filesystem::path& figure, LatexGaps& gaps);

}  // namespace poinsot
