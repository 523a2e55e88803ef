// Marks that several panels share: arrows with their labels, dots, and arcs and lines placed from
// shared unit curves.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>

#include "drawing/stage/panel.h"
#include "drawing/stage/type/type_sizes.h"

namespace poinsot {

// Index of the view's first ellipsoid or plane, the surface of curves (Curve::on_surface,
// on_plane).
constexpr int first_ellipsoid = 0;
constexpr int the_plane = 0;

// Size of names beside arrows on paper, px per em at 1080 rows.
constexpr double label_size = paper_sizes.vector_name;

// The same in a panel, pixels of the rendered picture per em.
double label_em_px(const Panel& panel);

// Length of the arrow along L beyond the invariable plane, in units of the largest half-axis.
constexpr double momentum_beyond_plane = 0.34;

// Upper bound of the length of the space panel's arrows, in the same units.
constexpr double longest_arrow_length = 1.42;

// Length of the arrows along e1, e2, e3 outside of the ellipsoid, in the same units.
constexpr double axis_overhang = 0.28;

// Lengths of the arrows along x, y, z, and of the axis of the turn from there to e1, e2, e3, in the
// same units.
constexpr double given_axis_length = 1.25;
constexpr double turn_axis_length = 1.3;

// Tip of the arrow along ω, which pierces the ellipsoid at ρ = ω/√(2T): 1.3 |ρ|, at least 1.3. For
// views that show nothing at the tip of ρ.
Eigen::Vector3d omega_tip(const Eigen::Vector3d& rho);

// A point slightly beyond the contact on the line of ρ; labels of that line keep their distance
// from it.
Eigen::Vector3d past_contact(const Eigen::Vector3d& rho);

// End of the axis of rotation outside of the ellipsoid; its other end is the mirror image.
Eigen::Vector3d spin_axis_end(const Eigen::Vector3d& rho);

// Tip of the arrow along L, beyond its foot on the plane.
Eigen::Vector3d momentum_tip(const ConstructionPicture& picture);

// An arrow that keeps its proportions at any length: the head is at most two fifths of a short
// arrow. `weight` 1 is the usual thickness.
Arrow arrow_between(const Panel& panel, const Eigen::Vector3d& tail, const Eigen::Vector3d& tip,
                    const LineStyle& ink, double weight);

// An arrow from the origin.
inline Arrow arrow_to(const Panel& panel, const Eigen::Vector3d& tip, const LineStyle& ink,
                      double weight) {
    return arrow_between(panel, Eigen::Vector3d::Zero(), tip, ink, weight);
}

// The inertia ellipsoid in the theme's style; its half-axes are left to the caller.
Ellipsoid ellipsoid_of(const Panel& panel);

// Replaces arrows that point at the viewer by a ring with a dot, since only the disc of the head's
// cone is visible of such an arrow. The ring appears gradually as the arrow turns towards the eye.
void mark_arrows_at_viewer(const Panel& panel, View& view);

// Sets a label at `scale` times the usual size of the panel.
TextBlock set_label(const Panel& panel, StageStore& store, std::string_view text,
                    double scale = 1.0);

// Sets the names e1, e2, e3 of the principal axes, and the lengths 1/√I1, 1/√I2, 1/√I3 of the
// half-axes.
std::array<TextBlock, 3> set_axis_labels(const Panel& panel, StageStore& store);
std::array<TextBlock, 3> set_half_axis_labels(const Panel& panel, StageStore& store, double scale);

// Replaces the built-in names of quantities in a formula by the scene's [symbols]:
// \boldsymbol{\omega}, \mathbf{L}, \boldsymbol{\rho}, \mathbf{e}_1 … and the components \omega_…
// and L_…, in exactly this spelling. L alone is the length of the vector that \mathbf{L} names.
std::string named_by_scene(const Scene& scene, std::string_view formula);
// The same for a title in words with formulas between dollars: a word L is the vector.
std::string title_named_by_scene(const Scene& scene, std::string_view title);

// The label of an arrow: at its tip, on the side that it points to, turned clockwise by an angle in
// the picture. Names of arrows that may lie on one line are turned by different angles and off that
// line.
constexpr double omega_label_turn_rad = 0.8;
constexpr double axis_label_turn_rad = -0.5;
void wish_at_tip(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                 ViewBuilder& builder, double turn_rad = 0.0);
// Adds an arrow with its label.
void add_named_arrow(const Panel& panel, const Arrow& arrow, const TextBlock& type,
                     ViewBuilder& builder, double turn_rad = 0.0);
// Tips of principal axes that extend beyond an ellipsoid with these half-axes, as columns.
inline Eigen::DiagonalMatrix<double, 3> beyond_half_axes(const Eigen::Vector3d& half_axes) {
    return Eigen::DiagonalMatrix<double, 3>((half_axes.array() + axis_overhang).matrix());
}
// Adds the principal axes up to these tips, the columns, with their names.
void add_principal_axes(const Panel& panel, const Eigen::Matrix3d& tips, double weight,
                        const std::array<TextBlock, 3>& types, ViewBuilder& builder,
                        double turn_rad = 0.0);

// Requests a label beside a point of the view's axes, on the side away from another point.
void wish_beside(const Panel& panel, const Eigen::Vector3d& at, const Eigen::Vector3d& away_from,
                 const TextBlock& type, const Colour& colour, ViewBuilder& builder);

// A dot with the theme's outline.
Dot dot_at(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour,
           double radius_px = 6.5);

// Dash length of a line of this ink, where `usual_px` is the element's default; 0: solid.
double dash_of(const Panel& panel, const LineStyle& ink, double usual_px = 0.0);

// A line in the panel's usual style, `width_px` wide at 1080 rows.
Curve curve_of(const Panel& panel, const CurveGeometry* geometry, const LineStyle& ink,
               double width_px);

// The least em size of text, in pixels of the rendered picture: in a film 1/45 of its height; on
// paper the value of the stage's options.
double least_type_px(const StageContext& stage);

// Pixels of the rendered picture for a point on paper, or 1/540 of a slide's height.
double px_per_pt(const StageContext& stage);

// How far [labels] moves the label of this name.
Eigen::Vector2d offset_of_label(const StageContext& stage, std::string_view name);
// The name in [labels] of the label of a vector; empty: it has none.
std::string_view name_of_label(const ShapeName& name);

// On paper all text has sizes in points, the same in every panel: titles are larger than headings,
// these than names, and these than numbers. Whether the stage is on paper:
inline bool is_on_paper(const StageContext& stage) { return stage.options.least.type_px > 0.0; }
// The scale of text on paper relative to 1080 rows: that of lines, `px`, or a larger one at which a
// name and its subscript have their least sizes.
double paper_type_px(const Scene& scene, double px, const LeastSizes& least);
inline double paper_type_px(const StageContext& stage) {
    return paper_type_px(stage.scene, stage.px, stage.options.least);
}
// The sizes of its text.
inline const TypeSizes& type_sizes(const StageContext& stage) {
    return is_on_paper(stage) ? paper_sizes : screen_sizes;
}

// An arc of a circle about `centre` from the direction `from` towards the direction `towards`
// (perpendicular unit vectors), over an angle from 0 to 2π; a whole circle from 2π on. Negative
// angles are in the opposite sense. All arcs of a stage share one geometry.
Curve arc_about(const Panel& panel, const Eigen::Vector3d& centre, const Eigen::Vector3d& from,
                const Eigen::Vector3d& towards, double radius, double angle_rad,
                const LineStyle& ink, double width_px);

// An arc with an arrowhead at its end: a rate about an axis, right-handed for positive angles.
struct Turn {
    Eigen::Vector3d centre, axis;  // the axis is a unit vector
    double radius = 0.2;
    double angle_rad = 5.0;
};
// Adds the arc from the direction `from`, a unit vector perpendicular to the axis; the head extends
// beyond the angle by four fifths of its length.
void add_arc_arrow(const Panel& panel, const Turn& turn, const Eigen::Vector3d& from,
                   const LineStyle& ink, ViewBuilder& builder);
double arc_head_rad(double radius);
// Adds the arc from any direction, with its name beside it.
void add_turn(const Panel& panel, const Turn& turn, const LineStyle& ink, const TextBlock& type,
              ViewBuilder& builder);

// A straight line between two points; invisible if they coincide.
Curve line_between(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const LineStyle& ink, double width_px);

}  // namespace poinsot
