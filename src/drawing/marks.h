// Marks that several panels draw alike: arrows with their labels, dots, and arcs and lines placed
// from shared unit curves.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "drawing/panel.h"

namespace poinsot {

// What curves of a panel's view lie on (Curve::on_surface, on_plane): its first of each.
constexpr int the_ellipsoid = 0;
constexpr int the_plane = 0;

// Type beside arrows, px per em at 1080 rows.
constexpr double label_size = 34.0;

// How far the arrow along L goes on beyond the invariable plane, in units of the largest half-axis.
constexpr double momentum_beyond_plane = 0.34;

// No arrow of the space panel is longer, in the same units.
constexpr double longest_arrow_length = 1.42;

// How far the arrows along e1, e2, e3 stand out of the ellipsoid, in the same units.
constexpr double axis_overhang = 0.28;

// Tip of the arrow along ω that pierces the ellipsoid at ρ = ω/√(2T): 1.3 times as far, and at
// least 1.3. For views in which nothing stands where ρ ends.
Eigen::Vector3d omega_tip(const Eigen::Vector3d& rho);

// A little beyond the contact on the line of ρ, where what is named along that line keeps off it.
Eigen::Vector3d past_contact(const Eigen::Vector3d& rho);

// Where the axis of rotation ends on the other side, out of the ellipsoid: the mirror image of
// this.
Eigen::Vector3d spin_axis_end(const Eigen::Vector3d& rho);

// Tip of the arrow along L, through its foot on the plane.
Eigen::Vector3d momentum_tip(const ConstructionPicture& picture);

// An arrow whose proportions stay at any length: the head of a short one is at most two fifths of
// it. `weight` 1 is the usual thickness.
Arrow arrow_between(const Panel& panel, const Eigen::Vector3d& tail, const Eigen::Vector3d& tip,
                    const Ink& ink, double weight);

// From the origin.
inline Arrow arrow_to(const Panel& panel, const Eigen::Vector3d& tip, const Ink& ink,
                      double weight) {
    return arrow_between(panel, Eigen::Vector3d::Zero(), tip, ink, weight);
}

// The inertia ellipsoid in the theme's look, its half-axes still to be set.
Ellipsoid ellipsoid_of(const Panel& panel);

// Arrows that point at the viewer are drawn as such: a ring with a dot, for of the arrow itself
// only the head's cone is seen, a disc. It comes as the arrow turns towards the eye.
void mark_arrows_at_viewer(const Panel& panel, View& view);

// A label in the panel's type, `scale` times the usual size.
SetType set_label(const Panel& panel, std::string_view text, double scale = 1.0);

// A formula of ours with the scene's own names of quantities, [symbols], in place of the usual: of
// \boldsymbol{\omega}, \mathbf{L}, \boldsymbol{\rho}, \mathbf{e}_1 … and of the components
// \omega_… and L_…, spelt like this. L alone is the length of what \mathbf{L} is called.
std::string named_by_scene(const Scene& scene, std::string_view formula);
// The same of a title in words, with formulas between dollars: a word L is the vector.
std::string title_named_by_scene(const Scene& scene, std::string_view title);

// The label of an arrow: at its tip, on the side that it points to, turned clockwise by an angle in
// the picture. The names of arrows that may lie on one line are turned apart, and off that line.
constexpr double omega_label_turn_rad = 0.8;
constexpr double axis_label_turn_rad = -0.5;
void wish_at_tip(const Panel& panel, const Arrow& arrow, const SetType& type, Sheet& sheet,
                 double turn_rad = 0.0);

// A label beside a point of the view's axes, on the side away from another one.
void wish_beside(const Panel& panel, const Eigen::Vector3d& at, const Eigen::Vector3d& away_from,
                 const SetType& type, const Colour& colour, Sheet& sheet);

// A dot with the theme's rim.
Dot dot_at(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour,
           double radius_px = 6.5);

// How long the dashes of a line of this ink are, where it is usually drawn with such ones, 0:
// whole.
double dash_of(const Panel& panel, const Ink& ink, double usual_px = 0.0);

// A line of the panel's usual kind: `width_px` at 1080 rows.
Curve curve_of(const Panel& panel, const CurveGeometry* geometry, const Ink& ink, double width_px);

// The least em of type in a film, 1/45 of its height, in pixels of the picture drawn; on paper what
// the stage's options say.
double least_type_px(const StageData& stage);

// An arc of a circle about `centre` from the direction `from` towards the direction `towards` (unit
// vectors at right angles), over an angle from 0 to 2π; a whole circle from 2π on. Negative angles
// run the other way. One geometry serves all arcs of a stage.
Curve arc_about(const Panel& panel, const Eigen::Vector3d& centre, const Eigen::Vector3d& from,
                const Eigen::Vector3d& towards, double radius, double angle_rad, const Ink& ink,
                double width_px);

// An arc with an arrow's head at its end: a rate about an axis, right-handed for positive angles.
struct Turn {
    Eigen::Vector3d centre, axis;  // the axis is a unit vector
    double radius = 0.2;
    double angle_rad = 5.0;
};
// From the direction `from`, a unit vector at right angles to the axis; the head goes on beyond the
// angle by four fifths of its own.
void add_arc_arrow(const Panel& panel, const Turn& turn, const Eigen::Vector3d& from,
                   const Ink& ink, Sheet& sheet);
double arc_head_rad(double radius);
// From anywhere, and with its name beside it.
void add_turn(const Panel& panel, const Turn& turn, const Ink& ink, const SetType& type,
              Sheet& sheet);

// A straight line between two points; nothing is shown if they coincide.
Curve line_between(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const Ink& ink, double width_px);

}  // namespace poinsot
