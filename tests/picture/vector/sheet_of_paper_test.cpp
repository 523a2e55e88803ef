// Files of a sheet of paper, PDF and SVG, are reproducible, accepted by other programs, and return
// their metadata.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "random_views.h"
#include "vector/pdf.h"
#include "vector/picture.h"
#include "vector/svg.h"

namespace poinsot::vector {
namespace {

// A view with one object of every kind.
struct Everything {
    Everything() {
        drawing.width_px = 1000;
        drawing.height_px = 750;
        View& view = drawing.views.emplace_back();
        view.width_px = 1000;
        view.height_px = 750;
        view.camera.eye = {2.5, -4.5, 2.2};
        view.camera.target = {0.0, 0.0, -0.2};
        Ellipsoid& ellipsoid = view.ellipsoids.emplace_back();
        ellipsoid.half_axes = Eigen::Vector3d(1.0, 0.7, 0.55).asDiagonal();
        Plane& plane = view.planes.emplace_back();
        plane.centre = {0.0, 0.0, -0.7};
        for (int k = 0; k < 200; ++k)
            circle.points.emplace_back(1.3 * std::cos(2.0 * std::numbers::pi * k / 200.0),
                                       1.3 * std::sin(2.0 * std::numbers::pi * k / 200.0), 0.1);
        circle.closed = true;
        Curve& curve = view.curves.emplace_back();
        curve.geometry = &circle;
        curve.colour = {0.7, 0.1, 0.1};
        Arrow& arrow = view.arrows.emplace_back();
        arrow.tip = {0.3, 0.2, 1.5};
        arrow.colour = {0.1, 0.2, 0.7};
        arrow.shaft_px = 4.0;
        arrow.head_px = 16.0;
        arrow.head_length_px = 26.0;
        Dot& dot = view.dots.emplace_back();
        dot.at = {0.0, -0.7, 0.0};
        Cone& cone = view.cones.emplace_back();
        cone.apex = {-1.5, 0.0, 0.0};
        cone.half_angle_rad = 0.4;
        cone.length = 0.8;
        for (const auto& corner :
             {Eigen::Vector3f(1.2f, 0.0f, 0.0f), Eigen::Vector3f(1.9f, 0.0f, 0.0f),
              Eigen::Vector3f(1.5f, 0.0f, 0.7f)})
            triangle.positions.push_back(corner);
        view.meshes.emplace_back().geometry = &triangle;
        view.ellipsoids.front().name = {"ellipsoid"};
        view.planes.front().name = {"plane"};
        view.curves.front().name = {"polhode"};
        view.arrows.front().name = {"omega"};
        view.dots.front().name = {"contact"};
        view.cones.front().name = {"cones"};
        view.meshes.front().name = {"body"};
    }
    CurveGeometry circle;
    MeshGeometry triangle;
    Drawing drawing;
};

SheetOfPaper paper_of_everything(Shading shading = Shading::tone) {
    const Everything everything;
    return paper_of(everything.drawing, {.pt_per_px = print_pt_per_px, .shading = shading});
}

std::string output_of(const std::string& command) {
    std::string out;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return "cannot run";
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
        out.append(buffer.data(), n);
    const int code = pclose(pipe);
    return code == 0 ? out : "exit " + std::to_string(code) + ": " + out;
}

class Files : public ::testing::Test {
 protected:
    Files() {
        std::string pattern = (std::filesystem::temp_directory_path() / "vectorXXXXXX").string();
        folder_ = mkdtemp(pattern.data());
    }
    ~Files() override { std::filesystem::remove_all(folder_); }
    std::string write(const std::string& name, const std::string& bytes) const {
        const std::string path = (folder_ / name).string();
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::filesystem::path folder_;
};

TEST_F(Files, AreReproducible) {
    EXPECT_EQ(pdf_of(paper_of_everything()), pdf_of(paper_of_everything()));
    EXPECT_EQ(svg_of(paper_of_everything(), "a", "b"), svg_of(paper_of_everything(), "a", "b"));
}

TEST_F(Files, PdfIsValidAndHasNoRaster) {
    for (const Shading shading : {Shading::tone, Shading::none}) {
        const std::string text = "a (text) with \\ and ω\r\nin it";
        const std::string pdf =
            with_pdf_text(pdf_of(paper_of_everything(shading)), "t (ω)", "X", text);
        const std::string path = write("a.pdf", pdf);
        EXPECT_EQ(output_of("qpdf --check " + path).find("exit"), std::string::npos)
            << output_of("qpdf --check " + path);
        EXPECT_NE(output_of("pdfinfo " + path).find("Title:           t (ω)"), std::string::npos);
        const std::string images = output_of("pdfimages -list " + path);
        EXPECT_EQ(std::count(images.begin(), images.end(), '\n'), 2) << images;
        const PdfText found = pdf_text(pdf, "X");
        EXPECT_EQ(found.text, text);
        EXPECT_EQ(found.before, pdf_of(paper_of_everything(shading)));
    }
}

TEST_F(Files, SvgIsWellFormedAndHasNoRaster) {
    for (const Shading shading : {Shading::tone, Shading::none}) {
        const std::string text = "<&> and ω\r\nin it";
        const std::string svg = svg_of(paper_of_everything(shading), "t & t", text);
        const std::string path = write("a.svg", svg);
        EXPECT_EQ(output_of("xmllint --noout " + path), "");
        EXPECT_EQ(svg.find("<image"), std::string::npos);
        EXPECT_EQ(svg_text(svg), text);
    }
}

// The ids of a document's elements of this kind.
std::vector<std::string> ids_of(const std::string& svg, const std::string& element = "[a-zA-Z]+") {
    const std::regex with_id("<" + element + " (?:[a-z]+=\"[^\"]*\" )*id=\"([^\"]*)\"");
    std::vector<std::string> ids;
    for (std::sregex_iterator at(svg.begin(), svg.end(), with_id), end; at != end; ++at)
        ids.push_back((*at)[1]);
    return ids;
}

TEST_F(Files, SvgGroupsEachObjectByItsName) {
    const std::string svg = svg_of(paper_of_everything(), "", "");
    const std::vector<std::string> groups = ids_of(svg, "g");
    for (const char* name :
         {"ellipsoid", "plane", "polhode", "omega", "omega-head", "contact", "cones", "body"})
        EXPECT_EQ(std::count(groups.begin(), groups.end(), name), 1) << name;
    EXPECT_NE(svg.find("<g id=\"polhode\" inkscape:groupmode=\"layer\" "
                       "inkscape:label=\"polhode\">"),
              std::string::npos);
}

TEST_F(Files, SvgIdsAreUniqueAndValidInSeveralPanels) {
    Everything everything;
    Drawing& drawing = everything.drawing;
    drawing.width_px = 3000;
    View& one = drawing.views.front();
    one.name = "space";
    // Two polhodes that are not drawn one after the other.
    one.curves.push_back(one.curves.front());
    one.curves.back().name = {"herpolhode"};
    one.curves.push_back(one.curves.front());
    for (const auto& [name, x_px] : {std::pair{"body", 1000}, {"space", 2000}}) {
        View more = drawing.views.front();
        more.name = name;
        more.x_px = x_px;
        drawing.views.push_back(more);
    }
    const std::string svg =
        svg_of(paper_of(drawing, {.pt_per_px = print_pt_per_px}), "several", "");
    const std::vector<std::string> ids = ids_of(svg);
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
    const std::regex valid("[A-Za-z][A-Za-z0-9-]*");
    for (const std::string& id : ids) EXPECT_TRUE(std::regex_match(id, valid)) << id;
    for (const char* id : {"space", "body", "space-2", "polhode-space", "polhode-space-2",
                           "polhode-body", "polhode-space-2-2", "herpolhode-body"})
        EXPECT_EQ(std::count(ids.begin(), ids.end(), id), 1) << id;
    EXPECT_EQ(output_of("xmllint --noout " + write("a.svg", svg)), "");
    // As many groups end as begin.
    const auto n_of = [&svg](const std::string& what) {
        int n = 0;
        for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1))
            ++n;
        return n;
    };
    EXPECT_EQ(n_of("<g ") + n_of("<g>"), n_of("</g>"));
}

TEST_F(Files, HaveNoGradientsWithoutShading) {
    const std::string svg = svg_of(paper_of_everything(Shading::none), "", "");
    EXPECT_EQ(svg.find("Gradient"), std::string::npos);
    EXPECT_NE(svg_of(paper_of_everything(), "", "").find("Gradient"), std::string::npos);
}

}  // namespace
}  // namespace poinsot::vector
