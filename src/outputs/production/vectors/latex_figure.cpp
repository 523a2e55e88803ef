#include "production/vectors/latex_figure.h"

#include <fmt/format.h>

#include "error/error.h"
#include "system/files/file_kind.h"
#include "system/files/own_files.h"
#include "system/seal.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr std::string_view signature = "% Written by poinsot: ";

// Sizes and positions are relative to the figure's width, which the document may change; text keeps
// its size.
constexpr std::string_view preamble = R"(%
% In the preamble:             \usepackage{{graphicx}}, and xcolor or color for colours
% Where the figure belongs:    \input{{{0}}}
% In another folder, FOLDER:   \graphicspath{{{{FOLDER/}}}} in the preamble, and \input{{FOLDER/{0}}}
%
% To change the width, write \def\figurewidth{{0.8\linewidth}} before \input; the size of type stays.
% To change the size of type, define \poinsotsize (one argument, in big points) before \input.
\begingroup
\providecommand\color[2][]{{}}%
\providecommand\boldsymbol[1]{{\mbox{{\boldmath$#1$}}}}%
\providecommand\dddot[1]{{\mathord{{\mathop{{#1}}\limits^{{\mbox{{\scriptsize...}}}}}}}}%
\providecommand\mathbb[1]{{\mathbf{{#1}}}}%
\providecommand\poinsotsize[1]{{\fontsize{{#1bp}}{{#1bp}}\selectfont}}%
\makeatletter
% Characters that only some fonts have: they are left out if the document uses none of these fonts.
\def\poinsotonly#1#2{{\@ifundefined{{T@TU}}%
{{\@ifundefined{{T@#1}}{{}}{{{{\fontencoding{{#1}}\selectfont #2}}}}}}{{#2}}}}%
\ifx\figurewidth\undefined \setlength\unitlength{{{1:.3f}bp}}%
\else \setlength\unitlength{{\figurewidth}}\fi
\makeatother
\begin{{picture}}(1,{2:.6f})%
\put(0,0){{\includegraphics[width=\unitlength]{{{3}}}}}%
)";

std::string letter_of(double held_at) {
    if (held_at < 0.25) return "[l]";
    return held_at > 0.75 ? "[r]" : "";
}

std::string put(const vector::SheetOfPaper& page, const vector::Type& type, LatexGaps& gaps) {
    const vector::Wording& words = type.wording;
    std::string text =
        latex_of(words.text, words.is_formula ? TypeMode::math : TypeMode::text, gaps);
    if (words.max_width_pt > 0.0)
        text = fmt::format("\\parbox[t]{{{:.5f}\\unitlength}}{{\\raggedright {}}}",
                           words.max_width_pt / page.width_pt, text);
    const double x = words.corner_pt.x() + words.held_at * words.size_pt.x();
    const double y = page.height_pt - words.corner_pt.y() - words.baseline_pt;
    // LaTeX has no transparent text: the colour is blended with that of the halo.
    const double keep = type.ink.alpha;
    const auto mixed = [keep](double ink, double halo) { return keep * ink + (1.0 - keep) * halo; };
    return fmt::format(
        "\\put({:.6f},{:.6f}){{\\makebox[0pt]{}{{\\poinsotsize{{{:.4g}}}"
        "\\color[rgb]{{{:.3g},{:.3g},{:.3g}}}{}}}}}%\n",
        x / page.width_pt, y / page.width_pt, letter_of(words.held_at), words.em_pt,
        mixed(type.ink.colour.r, type.halo.colour.r), mixed(type.ink.colour.g, type.halo.colour.g),
        mixed(type.ink.colour.b, type.halo.colour.b), text);
}

}  // namespace

std::filesystem::path latex_path_of(const std::filesystem::path& figure) {
    return std::filesystem::path(figure).replace_extension(".tex");
}

void check_latex_place(const std::filesystem::path& figure) {
    const std::string name = figure.filename().string();
    if (suffix_of(figure) != ".pdf")
        throw InputError(fmt::format(
            "--text latex needs a PDF, which pdflatex can include; end the name {} in .pdf",
            printable(name)));
    if (name.find_first_of("%#{}\\~^$&\"") != std::string::npos || printable(name) != name)
        throw InputError(fmt::format(
            "--text latex: LaTeX cannot take {} as a figure's name; leave out % # $ & ~ ^ \\ \", "
            "braces and characters that cannot be seen",
            printable(name)));
    check_replaceable(
        {.path = latex_path_of(figure), .is_own = sealed_with(signature), .what = "--text latex"});
}

std::string latex_figure(const vector::SheetOfPaper& page, const std::vector<vector::Type>& type,
                         const std::filesystem::path& figure, LatexGaps& gaps) {
    const std::string name = figure.filename().string();
    std::string text = fmt::format("{}the type of {}\n% sha256 {}\n", signature, name, blank_seal);
    text += fmt::format(preamble, figure.stem().string(), page.width_pt,
                        page.height_pt / page.width_pt, name);
    for (const vector::Type& one : type) text += put(page, one, gaps);
    return sealed(text + "\\end{picture}%\n\\endgroup\n");
}

}  // namespace poinsot
