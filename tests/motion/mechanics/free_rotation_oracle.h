// The torque-free motion by other formulas and with hundreds of digits: the independent reference
// for the families. It is checked against the reference cases, which were integrated by Taylor
// series.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

namespace poinsot::oracle {

// ω in principal axes, attitude (w, x, y, z) from those axes, herpolhode in space axes.
struct Answer {
    std::array<long double, 3> omega{};
    std::array<long double, 4> attitude{};
    std::array<long double, 3> herpolhode{};
};

// Jacobi's functions by descending Landen transformations of k′, and the textbook's angle of
// precession about L by Carlson's R_F and R_J; space and principal axes coincide at t = 0. Sources:
// DLMF 22.7(i), 19.25, 19.36; Landau & Lifshitz, Mechanics §37. 160 digits or more.
class FreeMotion {
 public:
    FreeMotion(const Eigen::Vector3d& moments_kg_m2, const Eigen::Vector3d& omega_rad_s);
    ~FreeMotion();
    FreeMotion(FreeMotion&&) noexcept;
    FreeMotion& operator=(FreeMotion&&) noexcept;

    Answer at(double time_s) const;

 private:
    struct Constants;
    std::unique_ptr<Constants> constants_;
};

}  // namespace poinsot::oracle
