#include "production/vectors/figure_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "drawing/stage/label_requests.h"
#include "drawing/style/colour_vision.h"
#include "numerics/srgb.h"
#include "production/session/print_size.h"
#include "shapes/projection.h"
#include "typeset/plain_text.h"

namespace poinsot {

namespace {

// The least of positive values; 0: none yet.
void lower(double& least, double value) {
    if (value > 0.0 && (!(least > 0.0) || value < least)) least = value;
}

// The contrast of ink with the end of the background's gradient that is more like it. The page
// shines through ink that is not opaque, in linear light.
double contrast_with(const Background& page, const Colour& ink, double opacity) {
    const auto blended = [opacity](double over, double under) {
        return srgb_from_linear(opacity * linear_from_srgb(over) +
                                (1.0 - opacity) * linear_from_srgb(under));
    };
    const auto on = [&](const Colour& under) {
        return contrast({blended(ink.r, under.r), blended(ink.g, under.g), blended(ink.b, under.b)},
                        under);
    };
    return std::min(on(page.top), on(page.bottom));
}

// Shapes below the first opacity are ignored. Lines over the figure, such as leaders, cursors and
// rules of charts, are pale by intention: their contrast is measured only above the second.
constexpr double visible = 0.2, opaque = 0.95;

void measure_type(const Drawing& drawing, const View& view, double pt_per_px,
                  FigureReport& report) {
    for (const Label& label : view.labels) {
        if (label.mask == nullptr || label.mask->letters.empty() || label.opacity < visible)
            continue;
        const double pt = pt_per_px * label.mask->samples;
        const double em_px = label.mask->source.em_px;
        // Letters that are smaller than the text's size are sub- and superscripts.
        constexpr double full = 0.99;
        lower(report.least_type_pt, pt * em_px);
        for (const MaskLetter& letter : label.mask->letters)
            if (letter.em_px < full * em_px) lower(report.least_script_pt, pt * letter.em_px);
        lower(report.type_contrast,
              contrast_with(drawing.background, label.colour, std::min(label.opacity, 1.0)));
        const Eigen::Vector2d corner =
            label.top_left_px + Eigen::Vector2d(label.mask->width_px(), label.mask->height_px());
        report.margin_pt = std::min({report.margin_pt, pt_per_px * label.top_left_px.minCoeff(),
                                     pt_per_px * (drawing.width_px - corner.x()),
                                     pt_per_px * (drawing.height_px - corner.y())});
    }
}

void measure_lines(const Drawing& drawing, const View& view, double pt_per_px,
                   FigureReport& report) {
    const bool has_solids = !view.ellipsoids.empty() || !view.planes.empty() ||
                            !view.cones.empty() || !view.meshes.empty();
    const auto see = [&](const auto& line, bool turns_pale) {
        const double opacity = std::min(line.opacity, 1.0);
        const bool is_in_space = line.occlusion == Occlusion::by_solids;
        if (is_in_space || opacity >= opaque)
            lower(report.line_contrast, contrast_with(drawing.background, line.colour, opacity));
        const double behind = opacity * line.hidden_opacity;
        if (is_in_space && turns_pale && has_solids && behind > 0.0)
            lower(report.hidden_contrast, contrast_with(drawing.background, line.colour, behind));
    };
    for (const Curve& curve : view.curves) {
        if (curve.geometry == nullptr || curve.opacity < visible) continue;
        if (curve.name.part == "edge") continue;  // it is to be as pale as the paper
        const bool thins = curve.hidden == HiddenStyle::dashed && !curve.stands_for_hidden;
        lower(report.least_line_pt,
              pt_per_px * curve.width_px * (thins ? curve.hidden_share : 1.0));
        see(curve, curve.hidden == HiddenStyle::dimmed);
    }
    for (const Arrow& arrow : view.arrows) {
        if (arrow.opacity < visible) continue;
        lower(report.least_line_pt, pt_per_px * arrow.shaft_px);
        see(arrow, true);
        for (const Eigen::Vector3d& end : {arrow.tail, arrow.tip}) {
            const Projected seen = project(view, end);
            if (!(seen.depth > 0.0)) continue;
            report.margin_pt = std::min({report.margin_pt, pt_per_px * seen.px.minCoeff(),
                                         pt_per_px * (drawing.width_px - seen.px.x()),
                                         pt_per_px * (drawing.height_px - seen.px.y())});
        }
    }
    for (const Ellipsoid& ellipsoid : view.ellipsoids) {
        lower(report.least_line_pt, pt_per_px * ellipsoid.section_px);
        lower(report.least_line_pt, pt_per_px * ellipsoid.ruling_px);
    }
    for (const Plane& plane : view.planes) lower(report.least_line_pt, pt_per_px * plane.grid_px);
    for (const Cone& cone : view.cones) lower(report.least_line_pt, pt_per_px * cone.rim_px);
}

}  // namespace

FigureReport report_on(const Drawing& drawing, double pt_per_px) {
    FigureReport report;
    const double mm_per_px = pt_per_px / pt_per_inch * mm_per_inch;
    report.width_mm = mm_per_px * drawing.width_px;
    report.height_mm = mm_per_px * drawing.height_px;
    report.margin_pt = 0.5 * pt_per_px * std::min(drawing.width_px, drawing.height_px);
    for (const View& view : drawing.views) {
        measure_type(drawing, view, pt_per_px, report);
        measure_lines(drawing, view, pt_per_px, report);
    }
    for (const std::string& text : drawing.left_out)
        report.left_out.push_back(fmt::format("\"{}\"", plain_text(text)));
    std::set<std::string_view> named;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels) named.insert(name_of_label(label.name));
    for (const UnnamedThing& thing : drawing.unnamed) {
        // Another panel may have the name.
        if (named.contains(thing.name)) continue;
        report.left_out.push_back(fmt::format("the name of {}{}", thing.name,
                                              thing.is_in_sight ? "" : " (too little in sight)"));
    }
    return report;
}

std::string in_words(const FigureReport& report) {
    const auto or_none = [](double value, const char* unit) {
        return value > 0.0 ? fmt::format("{:.3g}{}", value, unit) : "none";
    };
    std::string words =
        fmt::format("size: {:.1f} x {:.1f} mm\n", report.width_mm, report.height_mm);
    words += fmt::format("least line: {}\n", or_none(report.least_line_pt, " pt"));
    words +=
        fmt::format("least type: {}; sub- and superscripts: {}\n",
                    or_none(report.least_type_pt, " pt"), or_none(report.least_script_pt, " pt"));
    words += fmt::format(
        "least contrast with the page: type {}, lines {}{}\n",
        or_none(report.type_contrast, " : 1"), or_none(report.line_contrast, " : 1"),
        report.hidden_contrast > 0.0
            ? fmt::format(", pale lines behind bodies {:.3g} : 1", report.hidden_contrast)
            : "");
    words += fmt::format("least margin of type and arrows: {:.3g} pt\n", report.margin_pt);
    std::string left_out;
    for (const std::string& one : report.left_out)
        left_out += fmt::format("{}{}", left_out.empty() ? "" : ", ", one);
    return words + fmt::format("left out: {}", left_out.empty() ? "nothing" : left_out);
}

}  // namespace poinsot
