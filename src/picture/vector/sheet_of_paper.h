// The contents of a sheet of paper: paths, fills and type, in points (1/72 inch), x right, y down
// from the upper left corner. The only input of the PDF and SVG writers.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shapes/colour.h"
#include "vector/fit.h"

namespace poinsot::vector {

struct Step {
    enum class Kind { move, line, cubic, close };
    Kind kind = Kind::move;
    Eigen::Vector2d control_1 = Eigen::Vector2d::Zero(), control_2 = Eigen::Vector2d::Zero();
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    bool operator==(const Step&) const = default;
};

struct Path {
    std::vector<Step> steps;
    bool operator==(const Path&) const = default;

    void move(const Eigen::Vector2d& to);
    void line(const Eigen::Vector2d& to);
    void cubic(const Eigen::Vector2d& control_1, const Eigen::Vector2d& control_2,
               const Eigen::Vector2d& to);
    void close();
    // Adds consecutive Béziers; a straight one becomes a line.
    void add(const std::vector<Bezier>& beziers, bool begins = true);
    void add_rectangle(const Eigen::Vector2d& corner, const Eigen::Vector2d& size);
    void add(const Path& other);
};

struct PaperInk {
    Colour colour;
    double alpha = 1.0;
    bool operator==(const PaperInk&) const = default;
};

struct Stop {
    double at = 0.0;  // 0…1
    PaperInk ink;
};

// A linear gradient.
struct LinearFade {
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::UnitX();
    std::vector<Stop> stops;
};

// A radial gradient from a focus to a circle, under an affine map: in its own axes the circle has
// radius 1 about the origin.
struct RadialFade {
    Eigen::Affine2d paper_from_circle = Eigen::Affine2d::Identity();
    Eigen::Vector2d focus = Eigen::Vector2d::Zero();  // inside the circle
    std::vector<Stop> stops;
};

// A lit surface: colours over a disc, given at rings and spokes. Ring k of n_rings + 1 has the
// radius sin(½π k/n_rings), so that rings are dense at the limb. The last ring, in the limb's
// colours, lies slightly outside the disc, because the bright limb is narrower than the distance of
// two rings.
struct ShadedDisc {
    Eigen::Affine2d paper_from_disc = Eigen::Affine2d::Identity();
    double alpha = 1.0;
    int n_rings = 0, n_spokes = 0;
    std::vector<Colour> colours;  // (n_rings + 1) × n_spokes, ring by ring

    double radius(int ring) const;
    const Colour& at(int ring, int spoke) const;
    // Linear interpolation; outside the last ring, the colour on it.
    Colour at(const Eigen::Vector2d& in_disc) const;
};

using Paint = std::variant<PaperInk, LinearFade, RadialFade, ShadedDisc>;

struct Fill {
    Path path;
    Paint paint;
    bool even_odd = false;
};

struct Stroke {
    Path path;
    PaperInk ink;
    double width_pt = 1.0;
    std::vector<double> dashes_pt;  // dash, gap, …; empty: solid
    double dash_offset_pt = 0.0;
    bool round = true;  // round caps; joins are always round
};

// A glyph and its position on a baseline.
struct PlacedLetter {
    const std::filesystem::path* font_file = nullptr;
    std::uint32_t glyph = 0;
    double x_pt = 0.0, y_pt = 0.0;
    double em_pt = 10.0;
    std::optional<Colour> colour{};  // in place of that of the text's ink
};

// The text of the letters and their position, for programs that typeset them again.
struct Wording {
    std::string text;        // in the grammar of typeset/
    bool is_formula = true;  // false: running text with formulas
    double em_pt = 10.0;
    Eigen::Vector2d corner_pt = Eigen::Vector2d::Zero(), size_pt = Eigen::Vector2d::Zero();
    double baseline_pt = 0.0;   // of the first line, from the corner
    double held_at = 0.5;       // share of the width that stays in place
    double max_width_pt = 0.0;  // of its lines; 0: one line
};

struct Type {
    Wording wording;
    std::vector<PlacedLetter> letters;
    Path rules;  // filled with the same ink
    PaperInk ink;
    PaperInk halo;  // alpha 0: no halo
    double halo_pt = 0.0;
};

// Pixels: rows of sRGB-encoded R, G, B and non-premultiplied alpha, top row first.
struct Raster {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

struct Picture {
    Raster raster;
    Eigen::Vector2d corner_pt = Eigen::Vector2d::Zero(), size_pt = Eigen::Vector2d::UnitX();
};

// Everything from here to the matching ClipEnd is drawn only inside the path.
struct ClipBegin {
    Path path;
    bool even_odd = false;
    bool operator==(const ClipBegin&) const = default;
};
struct ClipEnd {};

// Everything from here to the matching GroupEnd belongs to one object of the picture.
struct GroupBegin {
    std::string id;  // unique on the sheet; letters, digits and hyphens
};
struct GroupEnd {};

using Item = std::variant<Fill, Stroke, Type, Picture, ClipBegin, ClipEnd, GroupBegin, GroupEnd>;

struct SheetOfPaper {
    double width_pt = 0.0, height_pt = 0.0;
    std::vector<Item> items;
    // Adds an item. If a clip begins that equals the clip just ended, that one is continued; a
    // group that is still empty when it ends is removed.
    void add(Item&& item);
    // Begins a group inside the open ones. If the sheet has this id already, a number is appended.
    void begin_group(const std::string& id);
    // Continues the group that was entered last if it has this id; otherwise ends it and begins
    // another. Empty: only ends it.
    void enter_group(const std::string& id);
    double off_pt = 0.0;  // largest deviation of any path from the exact curve, before rounding
    std::map<std::string, int> ids{};  // number of groups begun, by id
    std::string entered{};             // the group entered last; empty: none
};

}  // namespace poinsot::vector
