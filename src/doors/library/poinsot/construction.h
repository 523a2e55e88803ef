// Poinsot's construction of a torque-free motion as geometry.
//
// The inertia ellipsoid F(ρ) = ρᵀIρ = 1 rolls on the invariable plane n·x = √(2T)/L, n = L/|L|, and
// touches it at ρ = ω/√(2T). Lengths are in 1/√(kg m²).
#pragma once

#include <poinsot/motion.h>

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poinsot::library {

// The point ρ in which the ellipsoid touches the plane.
struct ContactPoint {
    Eigen::Vector3d body = Eigen::Vector3d::Zero();   // body axes
    Eigen::Vector3d space = Eigen::Vector3d::Zero();  // space axes
};

// The path of the contact point on the ellipsoid.
struct Polhode {
    std::vector<Eigen::Vector3d> points;  // body axes; a closed curve does not repeat the first one
    bool closed = true;                   // false: a separatrix, or a single point
    double largest_distance = 0.0;        // found between the curve and the polyline
};

// The circular cones of a symmetric body, which roll on each other.
struct Cones {
    int symmetry_axis = 2;                // principal axis, 0 to 2
    double body_half_angle_rad = 0.0;     // between ω and the symmetry axis
    double space_half_angle_rad = 0.0;    // between ω and L
    double body_precession_rad_s = 0.0;   // of ω about the symmetry axis, (I₃−I₁)ω₃/I₁
    double space_precession_rad_s = 0.0;  // of the symmetry axis about L, L/I₁
};

// How far a state is from the construction; all are 0 for the exact motion.
struct Residuals {
    double contact_plane_gap = 0.0;  // of ρ from the plane, relative to the plane's distance
    double tangency_gap = 0.0;       // of the ellipsoid's point of tangency, likewise
    double slip = 0.0;      // speed of that point, relative to |ω| times the largest half-axis
    double momentum = 0.0;  // |L(t) − L(0)|/|L(0)|, space axes
    double energy = 0.0;    // |T(t) − T(0)|/T(0)
    double unit_quaternion = 0.0;  // | |q| − 1 |
};

// One claim of a certificate: the largest residual over all instants.
struct Claim {
    std::string name;   // "contact_plane_gap"
    std::string means;  // one sentence
    double worst = 0.0;
    double at_time_s = 0.0;
    double bound = 0.0;
    std::size_t n_measured = 0;  // instants; 0: the claim could not be tested
    bool holds() const { return n_measured > 0 && worst <= bound; }
};

struct Certificate {
    std::vector<Claim> claims;
    bool holds = true;  // no tested claim exceeds its bound
};

// Immutable; copies share its data.
class __attribute__((visibility("default"))) Construction {
 public:
    // Throws InputError for a motion with a torque, or at rest.
    explicit Construction(const Motion& motion);

    // 1/√I1, 1/√I2, 1/√I3: the half-axes of the ellipsoid along the principal axes.
    Eigen::Vector3d half_axes() const;
    // √(2T)/L: the distance of the invariable plane from the centre.
    double plane_distance() const;
    // n = L/|L|, space axes.
    Eigen::Vector3d normal_space() const;

    ContactPoint contact(double time_s) const;

    // The curve as points; the polyline is within `tolerance` of it.
    Polhode polhode(double tolerance) const;

    // The contact point at each instant from the foot of the plane's normal, space axes: the
    // herpolhode. Adding plane_distance() * normal_space() gives ContactPoint::space.
    std::vector<Eigen::Vector3d> herpolhode(std::span<const double> times_s) const;
    // Least and greatest distance of the herpolhode from that foot.
    struct Radii {
        double least = 0.0;
        double greatest = 0.0;
    };
    Radii herpolhode_radii() const;

    // None unless exactly two moments are equal.
    std::optional<Cones> cones() const;

    // The instants within an interval, in order, at which a body flips over: ω along its middle
    // axis changes its sign, and this axis comes within 45° of L before and of −L after, or the
    // other way round. Empty for other motions. Throws InputError for more than a million.
    std::vector<double> flips(double first_time_s, double last_time_s) const;

    Residuals residuals(double time_s) const;

    // Tests the construction at these instants. `attitude_error_rad`: how exact a motion of a
    // stepping method shall be, which is also compared with the exact motion. An exact motion is
    // tested against the bound of its rounding errors.
    Certificate certificate(std::span<const double> times_s,
                            double attitude_error_rad = 1e-6) const;

    Construction(const Construction&) = default;
    Construction& operator=(const Construction&) = default;
    ~Construction() = default;

 private:
    struct Impl;
    std::shared_ptr<const Impl> impl_;
};

}  // namespace poinsot::library
