// Checks how exactly a computed motion fulfils Poinsot's construction, over all instants of a film.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "construction/poinsot_construction.h"
#include "mechanics/motion.h"

namespace poinsot {

// One claim of the certificate: the largest residual over all instants, and its instant.
struct CertifiedClaim {
    std::string_view name;   // "contact_plane_gap"
    std::string_view means;  // one sentence
    double worst = 0.0;
    double at_time_s = 0.0;
    double bound = 0.0;
    std::int64_t n_measured = 0;  // instants; 0: the claim was not tested
    bool measured() const { return n_measured > 0; }
    bool holds() const { return measured() && worst <= bound; }
    bool fails() const { return measured() && !(worst <= bound); }
};

struct Certificate {
    std::int64_t n_instants = 0;
    std::vector<CertifiedClaim> claims;
    bool holds() const;  // true if no claim that was tested fails
};

// Largest relative residual of an exact evaluation: a few units in the last place of each quantity.
// Measured 4e-15 over the reference cases.
inline constexpr double exact_residual_bound = 2e-14;

// The bound of the speeds, relative to the greatest speed: speeds are differences in time, and the
// bound covers the error of these. They are measured only where a step in time is large against the
// last place of the time.
inline constexpr double speed_difference_bound = 1e-9;

// Evaluates the motion at every instant. `bound` is the error that the method promises. For a
// closed form it is the relative bound exact_residual_bound, multiplied at the surface of a needle
// by the largest half-axis over the plane's distance. For a stepped motion it is the attitude error
// in rad that the scene's accuracy allows; the bound of every claim follows from it. A stepped
// motion is also compared with the closed form, because a phase error along the motion does not
// change T, L and the contact.
Certificate certify(const Motion& motion, std::span<const double> times_s, double bound);

}  // namespace poinsot
