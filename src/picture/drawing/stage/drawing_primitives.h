// The shapes that panels and elements draw with: arrows, dots, and arcs and lines placed from
// shared unit curves.
#pragma once

#include <Eigen/Core>
#include <numbers>

#include "drawing/stage/panel.h"

namespace poinsot {

// Index of the view's first ellipsoid or plane, the surface of curves (Curve::on_surface,
// on_plane).
constexpr int first_ellipsoid = 0;
constexpr int the_plane = 0;

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

// Gives an ellipsoid a fine contour in the hue of a line: as strong on the picture's ground as a
// contrast of 3.5 requires, or as strong as the line if that is less.
void add_contour(const Panel& panel, const Colour& line, Ellipsoid& ellipsoid);

// Replaces arrows that point at the viewer by a ring with a dot, since only the disc of the head's
// cone is visible of such an arrow. The ring appears gradually as the arrow turns towards the eye.
void mark_arrows_at_viewer(const Panel& panel, View& view);

// Tips of principal axes that extend beyond an ellipsoid with these half-axes, as columns.
inline Eigen::DiagonalMatrix<double, 3> beyond_half_axes(const Eigen::Vector3d& half_axes) {
    return Eigen::DiagonalMatrix<double, 3>((half_axes.array() + axis_overhang).matrix());
}

// A dot with the theme's outline.
Dot dot_at(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour,
           double radius_px = 6.5);

// Dash length of a line of this ink, where `usual_px` is the element's default; 0: solid.
double dash_of(const Panel& panel, const LineStyle& ink, double usual_px = 0.0);

// A line in the panel's usual style, `width_px` wide at 1080 rows.
Curve curve_of(const Panel& panel, const CurveGeometry* geometry, const LineStyle& ink,
               double width_px);

// An arc of a circle from the direction `from` towards the direction `towards`, perpendicular unit
// vectors, over an angle from 0 to 2π; a whole circle from 2π on. Negative angles are in the
// opposite sense.
struct Arc {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d from = Eigen::Vector3d::UnitX(), towards = Eigen::Vector3d::UnitY();
    double radius = 1.0;
    double angle_rad = 2.0 * std::numbers::pi;
};
// All arcs of a stage share one geometry.
Curve arc_curve(const Panel& panel, const Arc& arc, const LineStyle& ink, double width_px);

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

// A straight line between two points; invisible if they coincide.
Curve line_between(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const LineStyle& ink, double width_px);

}  // namespace poinsot
