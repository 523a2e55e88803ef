// The text of a figure as LaTeX: a picture environment over \includegraphics.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "typeset/latex.h"
#include "vector/sheet_of_paper.h"

namespace poinsot {

// FIG.tex beside FIG.pdf.
std::filesystem::path latex_path_of(const std::filesystem::path& figure);

// Throws InputError if LaTeX cannot use the figure's name, and if FIG.tex exists and was not
// written by this program.
void check_latex_place(const std::filesystem::path& figure);

// The contents of FIG.tex: each label on its baseline, in its size in the figure and in the
// document's own fonts. page: without its text. Appends to the gaps. Throws LabelError for text
// that cannot be converted.
std::string latex_figure(const vector::SheetOfPaper& page, const std::vector<vector::Type>& type,
                         const std::filesystem::path& figure, LatexGaps& gaps);

}  // namespace poinsot
