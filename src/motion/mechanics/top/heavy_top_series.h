// The constants and sums for evaluating Lagrange's top; heavy_top_setup.cpp computes the constants
// once, and only heavy_top.cpp uses them.
#pragma once

#include <array>
#include <complex>

#include "numerics/double_double.h"

namespace poinsot {

// One Cayley–Klein parameter, α = q_w + i q_z or β = q_x + i q_y, up to a common positive factor:
// amplitude · e^{iδ} · e^{i(rate t + cell_rate r)} · i^{winding·quarter} · (series of r).
//
// The quarter periods of the nutation are numbered so that the even ones are centred on the lower
// end (cos θ least) and the odd ones on the upper end. α is a θ1 function at the lower end and θ2
// at the upper one, β the other way round; both are regular and neither has a pole.
struct TopFactor {
    static constexpr int max_terms = 5;
    std::array<double, max_terms> theta1_re{}, theta1_im{};
    std::array<double, max_terms> theta2_re{}, theta2_im{};
    double lower_amplitude = 0.0;
    double upper_amplitude[2] = {0.0, 1.0};  // a product of two, against early underflow
    DoubleDouble rate;                       // of the phase
    double regular_rate = 0.0;               // the same without ±(ω3 − a)/2
    double cell_rate = 0.0;                  // phase per unit of u, radians
    int winding = 1;                         // +1 or −1
    bool through_zero = false;               // real except for the phase: passes through zero
    bool zero = false;                       // identically zero
};

// The solution x = 1 − cos θ = x1 − (x1−x2) sn²(u), u = λt + u0, of the top with Mgl ≥ 0. Rates
// are in the unit 2^n rad/s that TopSetup chooses.
struct TopSeries {
    bool reversed = false;    // Mgl < 0: e3 is reversed, and (α, β) stand for (−β, α)
    bool steady = false;      // θ is constant; the factors have amplitudes and rates only
    bool hyperbolic = false;  // series in the complementary nome (k' < 1/√2)
    bool scaled = false;      // the complementary nome is negligible, and e^{u} may overflow
    int n_terms = 1;
    DoubleDouble lambda;
    DoubleDouble u_start;    // from the turning point number quarter_start
    DoubleDouble quarter_u;  // K; infinite on the separatrix
    int quarter_start = 0;
    double argument_per_u = 1.0;  // π/2K or π/2K'
    double phase_rate = 0.0;      // of both factors together, without ±(ω3 − a)/2
    double nome = 0.0;            // complementary, of the hyperbolic series
    TopFactor factor[2];
};

// Fourier or hyperbolic functions of the odd and the even multiples of the argument.
struct Multiples {
    double odd_cos[TopFactor::max_terms];
    double odd_sin[TopFactor::max_terms];
    double even_cos[TopFactor::max_terms];
    double even_sin[TopFactor::max_terms];
};

// Multiples by Chebyshev's recurrence, which keeps the sines' relative accuracy at their zero.
// curvature is −1 for cos and sin, +1 for cosh and sinh.
Multiples multiples_of(double cosine, double sine, double curvature);

// A factor's series and its derivative by the argument.
struct SeriesValue {
    std::complex<double> value;
    std::complex<double> slope;
};

// The series of Σ re·cosine + i·im·sine over the odd (first = 1) or even (0) multiples.
SeriesValue sum_series(const std::array<double, TopFactor::max_terms>& re,
                       const std::array<double, TopFactor::max_terms>& im, const double* cosine,
                       const double* sine, int first, double curvature, int n_terms);

}  // namespace poinsot
