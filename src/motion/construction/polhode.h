// The polhode: the path of the contact point on the inertia ellipsoid, as a curve without time.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "construction/adaptive_curve.h"
#include "mechanics/inertia.h"

namespace poinsot {

// The closed curve (or the open branch of the separatrix) that the contact point ρ runs along, in
// body axes and lengths of the ellipsoid F(ρ) = 1.
//
// With a the encircled principal axis, b the middle one and c the other, it is
//     ρ = (±α·√(1 − k² sin²χ), β·sin χ, γ·cos χ),  k² in [0, 1],
// the intersection of F(ρ) = 1 with the cone of the same L²/2T. On the separatrix k = 1 and χ stays
// in (−π/2, π/2).
class Polhode {
 public:
    enum class Kind { point, circle, closed, separatrix };

    // Through the contact point that belongs to ω (body axes, rad/s, not zero). `on_separatrix`:
    // see MotionProblem.
    Polhode(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
            bool on_separatrix = false);

    Kind kind() const { return kind_; }
    // Index of the principal axis that the curve encircles.
    int encircled_axis() const { return a_; }

    // The point at parameter χ in rad, body axes.
    Eigen::Vector3d at(double chi_rad) const;

    // Its derivative by χ.
    Eigen::Vector3d tangent(double chi_rad) const;

    // Range of χ: [−π, π] closed, [−π/2, π/2] on the separatrix, [0, 0] for a point.
    double first_chi_rad() const;
    double last_chi_rad() const;
    bool closed() const { return kind_ == Kind::closed || kind_ == Kind::circle; }

    // The centre of a circle and the half-axes multiplied by cos χ and sin χ, body axes; none for
    // other kinds.
    struct Circle {
        Eigen::Vector3d centre, cosine_axis, sine_axis;
    };
    std::optional<Circle> circle() const;

    // Sampled so that the polyline is within `tolerance` (the ellipsoid's lengths) of the curve; a
    // closed curve does not repeat its first point. `off` receives the largest distance found.
    std::vector<Eigen::Vector3d> sampled(double tolerance, double* off = nullptr) const;
    // The same with the χ of each point, and with the first point of a closed curve once more.
    SampledCurve samples(double tolerance) const;

    // Smallest and largest distance of the curve's points from the foot of the plane's normal: the
    // herpolhode's annulus.
    struct Annulus {
        double inner = 0.0;
        double outer = 0.0;
    };
    Annulus annulus() const;

 private:
    Eigen::Matrix3d body_from_principal_;
    Eigen::Vector3d moments_;
    int a_ = 2, b_ = 1, c_ = 0;
    double alpha_ = 0.0;  // signed amplitudes, along ρ
    double beta_ = 0.0;
    double gamma_ = 0.0;
    double k2_ = 0.0;  // modulus squared and its complement, both without cancellation
    double k2_complement_ = 1.0;
    Kind kind_ = Kind::point;
};

// The two separatrices of a body with three different moments: ellipses through the middle axis,
// body axes. Empty for symmetric bodies.
std::vector<std::vector<Eigen::Vector3d>> separatrices(const InertiaTensor& inertia,
                                                       double tolerance, double* off = nullptr);

}  // namespace poinsot
