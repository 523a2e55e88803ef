// Lines, dots and text of a chart that is a drawing of its own, in pixels with y down.
#pragma once

#include <array>
#include <deque>
#include <string>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "drawing/style/theme.h"
#include "shapes/views.h"

namespace poinsot {

// Hues after Okabe & Ito (2008).
inline constexpr std::array<Colour, 6> chart_hues{{{0.04, 0.37, 0.65},
                                                   {0.81, 0.29, 0.07},
                                                   {0.00, 0.50, 0.36},
                                                   {0.61, 0.17, 0.53},
                                                   {0.54, 0.35, 0.00},
                                                   {0.18, 0.53, 0.77}}};

// Holds the geometry and text of a drawing; drawings refer to it and must not outlive it.
class ChartCanvas {
 public:
    // Widths and sizes are multiplied by `scale`, positions are not.
    ChartCanvas(const Theme& theme, FontSource fonts, int width_px, int height_px, double scale);
    ChartCanvas(const ChartCanvas&) = delete;
    ChartCanvas& operator=(const ChartCanvas&) = delete;

    const Theme& theme() const { return *theme_; }

    void add_line(std::vector<Eigen::Vector3d> points, double width_px, const Colour& colour,
                  double dash_px = 0.0);
    // A disc with a rim.
    void add_dot(double x_px, double y_px, double radius_px, const Colour& colour,
                 const Colour& rim_colour, double rim_px);
    // The point of the text's box at the shares `align` of its width and height lies at `at_px`.
    // Returns the width of the text.
    double add_type(const std::string& text, double size_px, const Eigen::Vector2d& at_px,
                    const Eigen::Vector2d& align, const Colour& colour);
    // A caption beside a point, which avoids others.
    void request_name(const std::string& name, const Eigen::Vector3d& beside,
                      const Eigen::Vector2d& away, const Colour& colour);

    Drawing drawing() const;

 private:
    const Theme* theme_;
    int width_px_, height_px_;
    double scale_;
    TextCache type_case_;
    std::deque<CurveGeometry> geometries_;
    std::vector<Curve> curves_;
    std::vector<Dot> dots_;
    std::vector<Label> labels_;
    std::vector<LabelRequest> requests_;
};

}  // namespace poinsot
