// Labels of arrows and points: setting them, and requesting their places.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "drawing/stage/drawing_primitives.h"

namespace poinsot {

// Size of a name beside an arrow in a panel, pixels of the rendered picture per em.
double label_em_px(const Panel& panel);

// Sets a label at `scale` times the usual size of the panel.
TextBlock set_label(const Panel& panel, StageStore& store, std::string_view text,
                    double scale = 1.0);

// Sets the names e1, e2, e3 of the principal axes, and the lengths 1/√I1, 1/√I2, 1/√I3 of the
// half-axes.
std::array<TextBlock, 3> set_axis_labels(const Panel& panel, StageStore& store);
std::array<TextBlock, 3> set_half_axis_labels(const Panel& panel, StageStore& store, double scale);

// Requests a label beside a point of the view's axes, on the side away from another point.
void request_label_beside(const Panel& panel, const Eigen::Vector3d& at,
                          const Eigen::Vector3d& away_from, const TextBlock& type,
                          const Colour& colour, ViewBuilder& builder);

// Requests the label of an arrow: at its tip, on the side that it points to, turned clockwise by an
// angle in the picture. Names of arrows that may lie on one line are turned by different angles and
// off that line.
constexpr double omega_label_turn_rad = 0.8;
constexpr double axis_label_turn_rad = -0.5;
void request_label_at_tip(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                          ViewBuilder& builder, double turn_rad = 0.0);

// Adds an arrow with its label.
void add_named_arrow(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                     ViewBuilder& builder, double turn_rad = 0.0);
// Adds the principal axes up to these tips, the columns, with their names.
void add_principal_axes(const Panel& panel, const Eigen::Matrix3d& tips, double weight,
                        const std::array<TextBlock, 3>& types, ViewBuilder& builder,
                        double turn_rad = 0.0);

// Adds the arc of a turn, from any direction, with its name beside it.
void add_turn(const Panel& panel, const Turn& turn, const LineStyle& ink, const TextBlock& type,
              ViewBuilder& builder);

// The displacement of the label of this name by [labels].
Eigen::Vector2d offset_of_label(const StageContext& stage, std::string_view name);
// The name in [labels] of the label of a vector; empty: it has none.
std::string_view name_of_label(const ShapeName& name);

}  // namespace poinsot
