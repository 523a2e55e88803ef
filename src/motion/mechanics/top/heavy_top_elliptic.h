// The elliptic functions of Lagrange's top in wide double-double arithmetic: modulus, phase and
// theta series. The symbols are those of heavy_top_cubic.h.
#pragma once

#include <utility>

#include "mechanics/top/heavy_top_cubic.h"
#include "mechanics/top/heavy_top_series.h"
#include "numerics/elliptic_integrals.h"

namespace poinsot::top_setup {

inline const WideDouble pi(pi_dd);

// The modulus, its quarter periods and nome; K is infinite on the separatrix, K' where β = 0.
struct Modulus {
    WideDouble k_prime;
    WideDouble K = 0, K_prime = 0;  // 0 stands for infinite
    WideDouble nome = 0;            // of the series in use
    bool hyperbolic = false;

    explicit Modulus(const Cubic& c);

    // π/2K or π/2K′.
    WideDouble argument_per_u() const;
};

// The series of one factor whose θ1 has its zero at i v; returns the rate of the phase of θ2 per
// unit u at its centre.
WideDouble fill_series(const Modulus& m, const WideDouble& v, int sign, TopFactor& f);

// The phase of the nutation at the start: the nearer turning point and the distance from it in u.
std::pair<int, WideDouble> starting_phase(const Cubic& c, const Modulus& m);

}  // namespace poinsot::top_setup
