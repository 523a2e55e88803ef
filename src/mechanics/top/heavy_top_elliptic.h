// The elliptic functions of Lagrange's top in 113-bit arithmetic: modulus, phase and theta series.
// The symbols are those of heavy_top_cubic.h.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <utility>

#include "mechanics/top/heavy_top_cubic.h"
#include "mechanics/top/heavy_top_series.h"

namespace poinsot::top_setup {

inline const Real pi = boost::math::constants::pi<Real>();

inline double to_double(const Real& x) { return x.convert_to<double>(); }

// The modulus with what belongs to it; K is infinite on the separatrix, K' where β = 0.
struct Modulus {
    Real k_prime;
    Real K = 0, K_prime = 0;  // 0 stands for infinite
    Real nome = 0;            // of the series in use
    bool hyperbolic = false;

    explicit Modulus(const Cubic& c);

    // π/2K or π/2K′.
    Real argument_per_u() const;
};

// The series of one factor whose θ1 has its zero at i v; returns the rate of the phase of θ2 per
// unit u at its centre.
Real fill_series(const Modulus& m, const Real& v, int sign, TopFactor& f);

// The phase of the nutation at the start: the nearer turning point and the distance from it in u.
std::pair<int, Real> starting_phase(const Cubic& c, const Modulus& m);

}  // namespace poinsot::top_setup
