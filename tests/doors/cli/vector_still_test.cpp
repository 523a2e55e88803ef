// Stills as vector files: valid files with text, their records, and errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "places.h"
#include "sanitized.h"

namespace poinsot::testing::vector_tests {
namespace {

// Output of another program, both streams; preceded by its exit code if that is not 0.
std::string said(const ScratchFolder& folder, const std::string& command) {
    std::string out;
    FILE* pipe =
        popen(("cd '" + folder.path().string() + "' && " + command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return "cannot run";
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
        out.append(buffer.data(), n);
    const int code = pclose(pipe);
    return code == 0 ? out : "failed: " + out;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

TEST(VectorStill, PdfIsValidSmallAndHasNoRaster) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(folder, "still '" + scene_path("generic") + "' -o g.pdf");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(contains(said(folder, "qpdf --check g.pdf"), "failed"))
        << said(folder, "qpdf --check g.pdf");
    EXPECT_EQ(lines_of(said(folder, "pdfimages -list g.pdf")).size(), 2u);
    // Every font is embedded, as a subset, with the characters of its glyphs.
    const auto fonts = lines_of(said(folder, "pdffonts g.pdf"));
    ASSERT_GT(fonts.size(), 3u);
    for (std::size_t k = 2; k < fonts.size(); ++k)
        EXPECT_TRUE(contains(fonts[k], "yes yes yes")) << fonts[k];
    const std::string pdf = text_of(folder.path() / "g.pdf");
    EXPECT_LT(pdf.size(), 95'000u);
}

// The words for curves have the curves' colours, and can still be read as text.
TEST(VectorStill, CaptionsNameCurvesInTheirColours) {
    const ScratchFolder folder;
    const std::string changes =
        "' --set 'caption=The herpolhode of $\\boldsymbol\\omega$, a curve' "
        "--set 'style.herpolhode=#006600' --set 'style.omega=#770077' --set labels=false -q -o ";
    for (const char* file : {"a.svg", "a.pdf"}) {
        const ProgramRun run =
            run_program_in(folder, "still '" + scene_path("generic") + changes + file);
        ASSERT_EQ(run.code, 0) << run.err;
    }
    const std::string svg = text_of(folder.path() / "a.svg");
    EXPECT_TRUE(
        std::regex_search(svg, std::regex("<text [^>]*fill=\"#006600\"[^>]*>herpolhode</text>")));
    EXPECT_TRUE(
        std::regex_search(svg, std::regex("<text [^>]*fill=\"#770077\"[^>]*>[^<]+</text>")));
    EXPECT_TRUE(std::regex_search(svg, std::regex("<text [^>]*>a curve</text>|, a curve</text>")));
    EXPECT_TRUE(contains(said(folder, "pdftotext a.pdf -"), "The herpolhode of"))
        << said(folder, "pdftotext a.pdf -");
}

// SVG has no gradients over meshes: an ellipsoid takes some 40 linear ones. A body takes some
// hundred, a measured motion some thousand dots.
TEST(VectorStill, NoSceneTakesMoreRoomThanItsShapesNeed) {
    const ScratchFolder folder;
    const std::string scenes = "'" + (source_folder() / "scenes").string() + "'/*.toml";
    const std::vector<std::string> suffixes =
        sanitized ? std::vector<std::string>{".svg"} : std::vector<std::string>{".svg", ".pdf"};
    for (const std::string& suffix : suffixes) {
        const ProgramRun run =
            run_program_in(folder, "still " + scenes + " -q -o '{scene}" + suffix + "'");
        ASSERT_EQ(run.code, 0) << run.err;
    }
    for (const std::filesystem::path& file : supplied_scenes()) {
        const std::string text = text_of(file);
        const bool is_large = contains(text, "object") || contains(text, "[measured]") ||
                              contains(text, "solid-angle");
        for (const std::string& suffix : suffixes) {
            const std::string page = file.stem().string() + suffix;
            const bool is_svg = suffix == ".svg";
            EXPECT_LT(std::filesystem::file_size(folder.path() / page),
                      is_large ? 360'000u : (is_svg ? 210'000u : 170'000u))
                << page;
        }
    }
}

TEST(VectorStill, ItsTextCanBeSearched) {
    const ScratchFolder folder;
    ASSERT_EQ(
        run_program_in(folder, "still '" + scene_path("invariable_plane") + "' -o i.pdf").code, 0);
    const std::string text = said(folder, "pdftotext i.pdf -");
    for (const char* part : {"invariable plane", "ω", "L", "ρ", "√"})
        EXPECT_TRUE(contains(text, part)) << part << " in\n" << text;
    ASSERT_EQ(
        run_program_in(folder, "still '" + scene_path("invariable_plane") + "' -o i.svg").code, 0);
    const std::string svg = text_of(folder.path() / "i.svg");
    EXPECT_TRUE(contains(svg, ">The invariable plane</text>"));
    EXPECT_TRUE(contains(svg, "@font-face"));
    EXPECT_FALSE(contains(svg, "<image"));
    EXPECT_EQ(said(folder, "xmllint --noout i.svg"), "");
}

TEST(VectorStill, HasTheRequestedSize) {
    const ScratchFolder folder;
    const std::string command = "still '" + scene_path("generic") + "' --width-mm 85 -o ";
    ASSERT_EQ(run_program_in(folder, command + "a.pdf").code, 0);
    // 85 mm = 240.9449 pt, which is no whole number of pixels at 300 dots per inch: 1003.94.
    EXPECT_TRUE(contains(said(folder, "pdfinfo a.pdf"), "Page size:       240.945"))
        << said(folder, "pdfinfo a.pdf");
    ASSERT_EQ(run_program_in(folder, command + "a.svg").code, 0);
    EXPECT_TRUE(contains(text_of(folder.path() / "a.svg"), "width=\"85mm\""));
    ASSERT_EQ(
        run_program_in(folder, "still '" + scene_path("generic") + "' --height-mm 61 -o b.svg")
            .code,
        0);
    EXPECT_TRUE(contains(text_of(folder.path() / "b.svg"), "height=\"61mm\""));
}

// The ids of all groups of an SVG.
std::set<std::string> groups_of(const std::string& svg) {
    std::set<std::string> groups;
    const std::regex group("<g id=\"([^\"]*)\"");
    for (std::sregex_iterator at(svg.begin(), svg.end(), group), end; at != end; ++at)
        EXPECT_TRUE(groups.insert((*at)[1]).second) << (*at)[1];
    return groups;
}

// With dashed hidden lines, every arrow has a head: filled, or outlined where it is hidden.
TEST(VectorStill, EveryArrowHasAHead) {
    const ScratchFolder folder;
    for (const char* name : {"generic", "symmetric_oblate", "tennis_racket", "four_views"}) {
        ASSERT_EQ(run_program_in(folder, "still '" + scene_path(name) +
                                             "' --theme print --width-mm 85 --set hidden=dashed "
                                             "-o a.svg")
                      .code,
                  0);
        const std::set<std::string> groups = groups_of(text_of(folder.path() / "a.svg"));
        // An arrow is drawn, or stands as its dashed axis.
        int n_arrows = 0;
        for (const std::string part : {"omega", "momentum", "axes-1", "axes-2", "axes-3"})
            for (const std::string panel : {"", "-space", "-body", "-object"}) {
                if (!groups.contains(part + panel) && !groups.contains(part + "-hidden" + panel))
                    continue;
                ++n_arrows;
                EXPECT_TRUE(groups.contains(part + "-head" + panel) ||
                            groups.contains(part + "-hidden-head" + panel) ||
                            // An arrow towards the viewer is a ring.
                            groups.contains(part + "-ring" + panel))
                    << name << ": " << part << panel;
            }
        EXPECT_GE(n_arrows, 5) << name;
    }
}

TEST(VectorStill, ItsTitleIsThatOfTheScene) {
    const ScratchFolder folder;
    ASSERT_EQ(run_program_in(folder, "still '" + scene_path("tennis_racket") +
                                         "' --set 'title=\"About $\\\\omega_2$\"' -o a.pdf")
                  .code,
              0);
    EXPECT_TRUE(contains(said(folder, "pdfinfo a.pdf"), "Title:           About ω₂"))
        << said(folder, "pdfinfo a.pdf");
}

TEST(VectorStill, OmitsTheNamesOfOmittedTips) {
    const ScratchFolder folder;
    const std::string command =
        "still '" + scene_path("generic") + "' --set 'show=[\"ellipsoid\",\"axes\"]' --time 3 -o ";
    ASSERT_EQ(run_program_in(folder, command + "a.svg --set hidden=pale").code, 0);
    ASSERT_EQ(run_program_in(folder, command + "b.svg --set hidden=omitted").code, 0);
    const auto all = groups_of(text_of(folder.path() / "a.svg"));
    const auto some = groups_of(text_of(folder.path() / "b.svg"));
    int n_omitted = 0;
    for (const std::string axis : {"axes-1", "axes-2", "axes-3"}) {
        EXPECT_TRUE(all.contains(axis + "-label"));
        EXPECT_EQ(some.contains(axis + "-label"), some.contains(axis + "-head")) << axis;
        n_omitted += some.contains(axis + "-label") ? 0 : 1;
    }
    EXPECT_GT(n_omitted, 0);
}

TEST(VectorStill, SheetsAreVectorsToo) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(
        folder, "still '" + scene_path("stability_map") +
                    "' --sweep 'start.omega_rad_s[1]=0.057,0.3' --sheet 2x1 --width-mm 170 "
                    "--set theme=print -o s.svg");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string svg = text_of(folder.path() / "s.svg");
    EXPECT_TRUE(contains(svg, "width=\"170mm\""));
    EXPECT_EQ(said(folder, "xmllint --noout s.svg"), "");
    const std::set<std::string> groups = groups_of(svg);
    for (const char* id :
         {"body", "body-2", "polhode-body", "polhode-body-2", "cell-1-label", "cell-2-label"})
        EXPECT_TRUE(groups.contains(id)) << id;
    ASSERT_EQ(run_program_in(folder, "still '" + scene_path("stability_map") +
                                         "' --sweep 'start.omega_rad_s[1]=0.057,0.3' --sheet 2x1 "
                                         "--width-mm 170 --set theme=print -o s.pdf")
                  .code,
              0);
    const std::string text = said(folder, "pdftotext -layout s.pdf -");
    for (const char* part : {"0.057", "0.3", "rad/s"}) EXPECT_TRUE(contains(text, part)) << text;
    EXPECT_FALSE(contains(text, "rad_s"));
}

TEST(VectorStill, HasARecordAndIsRerenderedByteIdentically) {
    const ScratchFolder folder;
    for (const std::string kind : {"pdf", "svg"}) {
        const std::string name = "a." + kind;
        ASSERT_EQ(run_program_in(folder, "still '" + scene_path("generic") +
                                             "' --shading none --time 3 --type-pt 9 -o " + name)
                      .code,
                  0);
        const ProgramRun told = run_program_in(folder, "explain --verify " + name);
        EXPECT_EQ(told.code, 0) << told.err;
        EXPECT_TRUE(contains(told.out, "shading: none")) << told.out;
        EXPECT_TRUE(contains(told.out, "paths within")) << told.out;
        const ProgramRun again = run_program_in(folder, "rerender " + name + " -o b." + kind);
        ASSERT_EQ(again.code, 0) << again.err;
        EXPECT_EQ(text_of(folder.path() / name), text_of(folder.path() / ("b." + kind)));

        // Changes one visible byte.
        std::string bytes = text_of(folder.path() / name);
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
        folder.write("c." + kind, bytes);
        const ProgramRun changed = run_program_in(folder, "explain --verify c." + kind);
        EXPECT_NE(changed.code, 0);
        EXPECT_TRUE(is_one_line(changed.err)) << changed.err;
    }
}

// On paper a side may have more pixels than a frame of a film; the record's scene contains this
// size.
TEST(VectorStill, AsLargeAsAPosterIsRerendered) {
    const ScratchFolder folder;
    ASSERT_EQ(run_program_in(folder, "still '" + scene_path("generic") +
                                         "' -q --shading none --width-mm 1500 -o a.pdf")
                  .code,
              0);
    EXPECT_TRUE(contains(run_program_in(folder, "explain a.pdf").out, "size = [17717, "));
    const ProgramRun again = run_program_in(folder, "rerender a.pdf -q -o b.pdf");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(text_of(folder.path() / "a.pdf") == text_of(folder.path() / "b.pdf"));
}

// Characters that XML or LaTeX cannot contain, that are invisible, or that no font of ours has:
// noncharacters, a variation selector, zero-width characters, a soft hyphen, tags, directional
// marks, and letters of other scripts; in TOML notation.
constexpr std::array<const char*, 16> odd_characters{
    "\\uFFFE",     "\\uFFFF", "\\U0001FFFE", "\\U0010FFFF", "\\uFDD0", "\\uFE0F",
    "\\u200B",     "\\u00AD", "\\U000E0041", "\\u202E",     "\\uFEFF", "\\u4E2D",
    "\\U0001F600", "\\u00AB", "\\u0416",     "\\uFFFD"};

// A scene with this text in every place that is set as text.
std::string scene_saying(const std::string& text) {
    return "title = \"Title " + text + "\"\ncaption = \"Caption " + text +
           "\"\n[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, "
           "0.75]\n[symbols]\nmomentum = \"\\\\text{L" +
           text + "}\"\n[[marks]]\nat = [1, 0, 0]\nname = \"\\\\text{M" + text + "}\"\n";
}

TEST(VectorStill, WithAnyCharacterIsReadable) {
    const ScratchFolder folder;
    std::string all;
    for (const char* character : odd_characters) all += std::string(" ") + character;
    folder.write("all.toml", scene_saying(all));
    for (const std::string options : {"", " --text paths"}) {
        const ProgramRun svg = run_program_in(folder, "still all.toml -o a.svg" + options);
        ASSERT_EQ(svg.code, 0) << svg.err;
        EXPECT_EQ(said(folder, "xmllint --noout a.svg"), "");
        const ProgramRun pdf = run_program_in(folder, "still all.toml -o a.pdf" + options);
        ASSERT_EQ(pdf.code, 0) << pdf.err;
        EXPECT_TRUE(contains(said(folder, "qpdf --check a.pdf"), "No syntax or stream encoding"));
        // Rendered as in pixels, with a box for characters without a glyph, which are reported.
        EXPECT_TRUE(contains(svg.err, "no installed font has")) << svg.err;
        for (const std::string name : {"a.svg", "a.pdf"}) {
            EXPECT_EQ(run_program_in(folder, "explain --verify " + name).code, 0) << name;
            const std::string again = "b" + name.substr(1);
            const ProgramRun made = run_program_in(folder, "rerender " + name + " -o " + again);
            EXPECT_EQ(made.code, 0) << made.err;
            EXPECT_TRUE(text_of(folder.path() / name) == text_of(folder.path() / again)) << name;
        }
    }
    // Also one by one, because one may hide the effect of another.
    for (const char* character : odd_characters) {
        folder.write("one.toml", scene_saying(character));
        ASSERT_EQ(run_program_in(folder, "still one.toml -o a.svg").code, 0) << character;
        EXPECT_EQ(said(folder, "xmllint --noout a.svg"), "") << character;
    }
}

// The file's name is the title of the page.
TEST(VectorStill, AcceptsAnySceneName) {
    const ScratchFolder folder;
    const std::string name = "a\xff\x01\uffff<&>\u200b";
    folder.write(name + ".toml", scene_saying(""));
    for (const std::string output : {"a.svg", "a.pdf"}) {
        const ProgramRun run = run_program_in(folder, "still '" + name + ".toml' -o " + output);
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run_program_in(folder, "explain --verify " + output).code, 0);
    }
    EXPECT_EQ(said(folder, "xmllint --noout a.svg"), "");
    EXPECT_TRUE(contains(text_of(folder.path() / "a.svg"), "&lt;&amp;&gt;"));
    EXPECT_TRUE(contains(said(folder, "qpdf --check a.pdf"), "No syntax or stream encoding"));
}

// Characters that LaTeX cannot set are omitted from the .tex, and reported.
TEST(VectorStill, InLatexCompilesWithAnyText) {
    const ScratchFolder folder;
    std::string all;
    for (const char* character : odd_characters) all += character;
    folder.write("all.toml", scene_saying(all));
    const ProgramRun still = run_program_in(folder, "still all.toml --text latex -o figure.pdf");
    ASSERT_EQ(still.code, 0) << still.err;
    for (const char* note :
         {"figure.tex leaves out U+FFFE, U+FFFF, U+1FFFE, U+10FFFF, U+FDD0, U+FE0F, U+200B, U+00AD",
          "pdfLaTeX leaves out « (U+00AB); \\usepackage[T1]{fontenc} lets it set them",
          "pdfLaTeX leaves out 中 (U+4E2D), 😀 (U+1F600), Ж (U+0416), � (U+FFFD); XeLaTeX"})
        EXPECT_TRUE(contains(still.err, note)) << note << " in\n" << still.err;
    EXPECT_FALSE(contains(
        run_program_in(folder, "still '" + scene_path("generic") + "' --text latex -o other.pdf")
            .err,
        "leaves out"));
    if (contains(said(folder, "command -v pdflatex"), "failed")) GTEST_SKIP() << "no pdflatex";
    for (const std::string packages : {"graphicx", "graphicx,color"})
        for (const std::string fonts : {"", "\\usepackage[T1]{fontenc}"}) {
            folder.write("document.tex", "\\documentclass{article}\\usepackage{" + packages + "}" +
                                             fonts +
                                             "\\begin{document}\\input{figure}\\end{document}\n");
            const std::string log = said(
                folder, "pdflatex -draftmode -halt-on-error -interaction=nonstopmode document");
            EXPECT_FALSE(contains(log, "failed: ")) << packages << fonts << ":\n" << log;
        }
}

TEST(VectorStill, ErrorsAreOneLine) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene_path("generic") + "' ";
    for (const std::string& options :
         {std::string("--depth 16 -o a.pdf"), std::string("--shading tome -o a.svg"),
          std::string("--shading none -o a.png"), std::string("--width-mm 10000 -o a.pdf"),
          std::string("-o a.eps"), std::string("--sheet 2x1 --journal aip -o a.png"),
          std::string("--sheet 2x1 --width-mm 85 -o a.png"),
          std::string("--sheet 2x1 --keep-text -o a.png"),
          std::string("--sheet 2x1 --height-mm 50 -o a.pdf"),
          std::string("--sheet 2x1 --depth 16 -o a.png"),
          std::string("--sheet 2x1 --shading none -o a.png")}) {
        const ProgramRun run = run_program_in(folder, still + options);
        EXPECT_EQ(run.code, 2) << options;
        EXPECT_TRUE(is_one_line(run.err)) << options << ": " << run.err;
        EXPECT_EQ(folder.listing(), "") << options;
    }
    EXPECT_TRUE(contains(run_program_in(folder, still + "--shading tome -o a.svg").err,
                         "did you mean \"tone\"?"));
}

// Readers drop a space at the beginning of a text, and some then misplace the next letter.
TEST(VectorStill, NoSvgTextBeginsWithASpace) {
    const ScratchFolder folder;
    ASSERT_EQ(run_program_in(folder, "still '" + scene_path("generic") + "' -q -o a.svg").code, 0);
    const std::string svg = text_of(folder.path() / "a.svg");
    int n_texts = 0;
    for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at)) {
        at = svg.find('>', at) + 1;
        EXPECT_NE(svg.at(at), ' ');
        ++n_texts;
    }
    EXPECT_GT(n_texts, 10);
}

TEST(VectorStill, TextAsPathsNeedsNoFonts) {
    const ScratchFolder folder;
    const std::string page = "still '" + scene_path("generic") + "' --width-mm 110 ";
    const std::string still = page + "--text paths -o ";
    ASSERT_EQ(run_program_in(folder, still + "a.pdf").code, 0);
    EXPECT_EQ(lines_of(said(folder, "pdffonts a.pdf")).size(), 2u);
    ASSERT_EQ(run_program_in(folder, still + "a.svg").code, 0);
    EXPECT_FALSE(contains(text_of(folder.path() / "a.svg"), "<text"));
    EXPECT_FALSE(contains(text_of(folder.path() / "a.svg"), "@font-face"));
    // The record contains the option, and the still is rendered again.
    EXPECT_TRUE(contains(run_program_in(folder, "explain a.pdf").out, "type-as: paths"));
    ASSERT_EQ(run_program_in(folder, "rerender a.pdf -o b.pdf").code, 0);
    EXPECT_EQ(text_of(folder.path() / "a.pdf"), text_of(folder.path() / "b.pdf"));
    // Text and outlines give the same picture, except for the smoothing of small letters.
    ASSERT_EQ(run_program_in(folder, page + "-o font.pdf").code, 0);
    const ProgramRun same = run_program_in(
        folder, "compare font.pdf a.pdf --max-differing 5% --max-over 1% --over-levels 64");
    EXPECT_EQ(same.code, 0) << same.out << same.err;
}

TEST(VectorStill, LatexSetsTheTextOfAFigureWithoutAny) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene_path("invariable_plane") + "' --text latex -o ";
    const ProgramRun run = run_program_in(folder, still + "fig.pdf");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(contains(run.err, "fig.tex"));
    EXPECT_EQ(lines_of(said(folder, "pdffonts fig.pdf")).size(), 2u);
    const std::string tex = text_of(folder.path() / "fig.tex");
    for (const char* part : {"\\includegraphics[width=\\unitlength]{fig.pdf}", "\\begin{picture}",
                             "The invariable plane", "\\rho", "\\sqrt{2T}"})
        EXPECT_TRUE(contains(tex, part)) << part;
    EXPECT_TRUE(
        contains(tex, "\\graphicspath{{FOLDER/}} in the preamble, and \\input{FOLDER/fig}"));
    // It may replace its own file, but not another's.
    EXPECT_EQ(run_program_in(folder, still + "fig.pdf").code, 0);
    folder.write("paper.tex", "\\documentclass{article}\n");
    for (const char* name : {"paper.pdf", "a.svg", "100%.pdf", "a.png"}) {
        const ProgramRun refused = run_program_in(folder, still + name);
        EXPECT_EQ(refused.code, 2) << name;
        EXPECT_TRUE(is_one_line(refused.err)) << name << ": " << refused.err;
    }
    EXPECT_EQ(text_of(folder.path() / "paper.tex"), "\\documentclass{article}\n");
}

TEST(VectorStill, AJournalDeterminesWidthAndSmallestSizes) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene_path("generic") + "' ";
    ASSERT_EQ(run_program_in(folder, still + "--journal aip -o a.pdf").code, 0);
    // 85 mm = 240.94 pt.
    EXPECT_TRUE(contains(said(folder, "pdfinfo a.pdf"), "Page size:       240.9") ||
                contains(said(folder, "pdfinfo a.pdf"), "Page size:       241"))
        << said(folder, "pdfinfo a.pdf");
    EXPECT_TRUE(contains(run_program_in(folder, "explain a.pdf").out, "journal: aip"));
    ASSERT_EQ(run_program_in(folder, "rerender a.pdf -o b.pdf").code, 0);
    EXPECT_EQ(text_of(folder.path() / "a.pdf"), text_of(folder.path() / "b.pdf"));
    // No letter is smaller than 8 pt, no script than 6, no line thinner than half a point.
    ASSERT_EQ(run_program_in(folder, still + "--journal aip --keep-text -o a.svg").code, 0);
    const std::string svg = text_of(folder.path() / "a.svg");
    // The smallest number in elements of a kind.
    const auto least = [&svg](const std::string& element, const std::string& name) {
        double found = 1e9;
        for (std::size_t at = svg.find(element); at != std::string::npos;
             at = svg.find(element, at + 1)) {
            const std::size_t value = svg.find(name + "=\"", at);
            if (value < svg.find('>', at))
                found =
                    std::min(found, std::strtod(svg.c_str() + value + name.size() + 2, nullptr));
        }
        return found;
    };
    // In the file, 256 units are a point.
    EXPECT_GE(least("<text ", "font-size") / 256.0, 5.999);
    EXPECT_LT(least("<text ", "font-size") / 256.0, 8.0);  // a subscript
    EXPECT_TRUE(contains(svg, ".l{fill:none;stroke-linejoin:round;stroke-width:128}"));
    EXPECT_GE(least("<path ", "stroke-width") / 256.0, 0.5);
    for (const std::string& options :
         {std::string("--journal nature"), std::string("--journal aps --width-mm 200"),
          std::string("--type-pt 5")}) {
        const ProgramRun refused = run_program_in(folder, still + options + " -o c.pdf");
        EXPECT_EQ(refused.code, 2) << options;
        EXPECT_TRUE(is_one_line(refused.err)) << options << ": " << refused.err;
    }
    // Names that have no room are left out, and a note says which.
    const ProgramRun small = run_program_in(
        folder, "still '" + scene_path("football") + "' --width-mm 50 --height-mm 50 -o d.pdf");
    EXPECT_EQ(small.code, 0) << small.err;
    EXPECT_TRUE(contains(small.err, "note: no room for the name of ")) << small.err;
}

// Here the polhode is behind the body: its name would be white on white.
TEST(VectorStill, ANameThatHasFadedIsAbsentAndReported) {
    const ScratchFolder folder;
    const ProgramRun run =
        run_program_in(folder, "still '" + scene_path("generic") +
                                   "' --journal aps --time 9.6 --text latex -o a.pdf");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string tex = text_of(folder.path() / "a.tex");
    EXPECT_FALSE(contains(tex, "}polhode}")) << tex;
    EXPECT_TRUE(contains(tex, "herpolhode"));
    EXPECT_FALSE(contains(tex, "\\color[rgb]{1,1,1}"));
    EXPECT_TRUE(contains(run.err, "note: no name for polhode, of which too little is in sight"))
        << run.err;
    EXPECT_TRUE(contains(run.err, "the name of polhode (too little in sight)")) << run.err;
}

// The author's caption says what title, caption and clock say; the report says what to check.
TEST(VectorStill, AJournalLeavesTextToTheCaptionAndReports) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene_path("separatrix") + "' --journal aip ";
    const ProgramRun figure = run_program_in(folder, still + "-o a.svg");
    ASSERT_EQ(figure.code, 0) << figure.err;
    for (const std::string words :
         {"size: 85.0 x ", "least line: 0.5 pt", "least type: 8 pt; sub- and superscripts: 6",
          "least contrast with the page: type ", "least margin of type and arrows: ",
          "left out: title, captions and clock (--keep-text draws them)"})
        EXPECT_TRUE(contains(figure.err, words)) << words << " in " << figure.err;
    const std::string svg = text_of(folder.path() / "a.svg");
    EXPECT_TRUE(contains(svg, "<title>The separatrix</title>"));
    EXPECT_FALSE(contains(svg, "id=\"clock-label\"")) << "drawn";
    EXPECT_FALSE(contains(svg, "id=\"caption-label\"")) << "drawn";
    EXPECT_TRUE(contains(svg, "(a)"));
    EXPECT_TRUE(contains(svg, "(c)"));
    EXPECT_FALSE(contains(figure.err, "theme")) << figure.err;
    ASSERT_EQ(run_program_in(folder, "rerender a.svg -o b.svg").code, 0);
    EXPECT_EQ(svg, text_of(folder.path() / "b.svg"));

    const ProgramRun kept = run_program_in(folder, still + "--keep-text -o c.svg");
    ASSERT_EQ(kept.code, 0) << kept.err;
    EXPECT_FALSE(contains(kept.err, "--keep-text")) << kept.err;
    EXPECT_TRUE(contains(text_of(folder.path() / "c.svg"), "id=\"caption-label\""));
    const ProgramRun alone =
        run_program_in(folder, "still '" + scene_path("generic") + "' --keep-text -o d.svg");
    EXPECT_EQ(alone.code, 2);
    EXPECT_TRUE(is_one_line(alone.err)) << alone.err;
}

TEST(VectorStill, AJournalSaysWhichThemeItReplaces) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "dark.toml")
        << "theme = \"dark\"\n[body]\nmoments_kg_m2 = [4.0, 3.0, 1.5]\n"
           "[start]\nomega_rad_s = [1.2, 0.8, 2.4]\n[film]\nduration_s = 1.0\n";
    const ProgramRun replaced = run_program_in(folder, "still dark.toml --journal aps -o a.svg");
    ASSERT_EQ(replaced.code, 0) << replaced.err;
    EXPECT_TRUE(contains(replaced.err, "theme print, not in its own theme dark")) << replaced.err;
    const ProgramRun kept =
        run_program_in(folder, "still dark.toml --journal aps --theme dark -o b.svg");
    ASSERT_EQ(kept.code, 0) << kept.err;
    EXPECT_TRUE(contains(kept.err, "is drawn in theme dark, as the command line says")) << kept.err;
}

TEST(VectorStill, PicturesCanBePlacedBetweenTheLines) {
    const ScratchFolder folder;
    const ProgramRun run =
        run_program_in(folder, "still '" + scene_path("generic") +
                                   "' --width-mm 40 --shading picture --portable -o a.pdf");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto images = lines_of(said(folder, "pdfimages -list a.pdf"));
    ASSERT_GE(images.size(), 4u);  // two of headings, the background, the ellipsoid
    EXPECT_FALSE(contains(said(folder, "qpdf --check a.pdf"), "failed"));
    ASSERT_EQ(run_program_in(folder, "rerender a.pdf -o b.pdf").code, 0);
    EXPECT_EQ(text_of(folder.path() / "a.pdf"), text_of(folder.path() / "b.pdf"));
}

TEST(VectorStill, TwoPagesAreComparedAsPictures) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene_path("generic") + "' --width-mm 60 -o ";
    ASSERT_EQ(run_program_in(folder, still + "a.pdf").code, 0);
    ASSERT_EQ(run_program_in(folder, still + "b.pdf").code, 0);
    ASSERT_EQ(run_program_in(folder, still + "c.pdf --time 3").code, 0);
    EXPECT_EQ(run_program_in(folder, "compare a.pdf b.pdf").code, 0);
    const ProgramRun differs = run_program_in(folder, "compare a.pdf c.pdf --diff d.png");
    EXPECT_EQ(differs.code, 1) << differs.out << differs.err;
    EXPECT_TRUE(contains(folder.listing(), "d.png"));
    folder.write("broken.pdf", "%PDF-1.4\n");
    EXPECT_EQ(run_program_in(folder, "compare a.pdf broken.pdf").code, 2);
    EXPECT_EQ(run_program_in(folder, "compare a.pdf none.pdf").code, 2);
}

}  // namespace
}  // namespace poinsot::testing::vector_tests
