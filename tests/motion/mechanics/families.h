// Families of extreme bodies, generated from seeds, and the difference of their motion from the
// oracle's.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <iosfwd>
#include <random>
#include <span>
#include <string_view>

#include "mechanics/inertia.h"

namespace poinsot::families {

using Random = std::mt19937_64;

struct Body {
    Eigen::Vector3d moments{1.0, 1.0, 1.0};
    Eigen::Vector3d omega{0.0, 0.0, 1.0};
};

// Instants at which a motion is tested: three within the family's periods, or next to the eighths
// of a period, where sn and cn vanish or the reduced arguments of the series change sides.
enum class Instants { within, eighths };

// A family: a generator of bodies, and the number of polhode periods from the start that are
// tested.
struct Family {
    std::string_view name;
    Body (*draw)(Random& random);
    double periods = 3.0;
    Instants instants = Instants::within;
    double omega_bound = 2e-15;
    double attitude_bound = 2e-15;
    double herpolhode_bound = 3e-15;
};

std::span<const Family> all();

// Prints a family's name, for the names of tests.
void PrintTo(const Family& family, std::ostream* out);

// The largest residuals over a family's bodies and instants.
struct Residuals {
    double omega = 0.0;  // |error| over |ω|
    double attitude_rad = 0.0;
    double herpolhode = 0.0;       // |error| over |h|, or over 1e-300 for smaller h
    double energy = 0.0;           // |T(t) − T|/T
    double momentum = 0.0;         // |L(t) − L|/|L|, as vectors in space
    double unit_quaternion = 0.0;  // | |q| − 1 |
    int n_not_finite = 0;
    int n_instants = 0;
};

// Tests bodies first … last−1 of the family, each from its own seed.
Residuals measure(const Family& family, int first, int last);

// Returns the larger of two, term by term.
Residuals worse(const Residuals& a, const Residuals& b);

// True if every residual is within the family's bounds and everything is finite.
bool within_bounds(const Family& family, const Residuals& residuals);

}  // namespace poinsot::families
