#include "mechanics/free/polhode_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "error/error.h"
#include "numerics/wide_double.h"

namespace poinsot {

namespace {

// Principal axes from the lowest moment to the highest.
std::array<int, 3> ranked_axes(const Eigen::Vector3d& I) {
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return I[i] < I[j]; });
    return order;
}

// Whether a number is the double nearest to a value, or one beside it: what a calculation in
// doubles gives for a root.
bool stands_for(double number, const WideDouble& value) {
    const double nearest = value.rounded();
    return std::nextafter(nearest, number) == number;
}

// Whether the given L or distance is that of a rotation about this axis.
bool is_that_of_axis(const ConservedQuantities& conserved, double I) {
    if (conserved.plane_distance)
        return stands_for(*conserved.plane_distance, WideDouble(1.0) / sqrt(WideDouble(I)));
    const WideDouble L2 = WideDouble(2.0) * conserved.energy_J * I;
    return stands_for(*conserved.momentum_kg_m2_s, sqrt(L2));
}

// L² − 2T·I of the three axes, in units of 2T.
std::array<WideDouble, 3> differences(const ConservedQuantities& conserved,
                                      const Eigen::Vector3d& I) {
    WideDouble inertia;  // L²/2T
    if (conserved.plane_distance)
        inertia = WideDouble(1.0) / square(WideDouble(*conserved.plane_distance));
    else
        inertia = square(WideDouble(*conserved.momentum_kg_m2_s)) /
                  (WideDouble(2.0) * conserved.energy_J);
    for (int i = 0; i < 3; ++i)
        if (is_that_of_axis(conserved, I[i])) inertia = I[i];
    return {inertia - I[0], inertia - I[1], inertia - I[2]};
}

// A value and the ends of the range that it lies outside of, with as many digits as tell the three
// apart.
struct OutOfRange {
    std::string given, least, most;

    OutOfRange(double value, double low, double high) {
        constexpr int usual_digits = 9, all_digits = 17;
        for (int digits = usual_digits; digits <= all_digits; ++digits) {
            least = fmt::format("{:.{}g}", low, digits);
            most = fmt::format("{:.{}g}", high, digits);
            given = fmt::format("{:.{}g}", value, digits);
            if (given != least && given != most && (least != most || low == high)) return;
        }
    }
    std::string range() const {
        return least == most ? "of " + least : "between " + least + " and " + most;
    }
};

[[noreturn]] void refuse_range(const ConservedQuantities& conserved, double I_low, double I_high) {
    if (conserved.plane_distance) {
        const OutOfRange distance(*conserved.plane_distance, 1.0 / std::sqrt(I_high),
                                  1.0 / std::sqrt(I_low));
        throw InputError(fmt::format(
            "plane_distance = {} is impossible for this body: 2T I_min <= L^2 <= 2T I_max "
            "requires sqrt(2T)/L {} 1/sqrt(kg m^2)",
            distance.given, distance.range()));
    }
    const double T2 = 2.0 * conserved.energy_J;
    const OutOfRange momentum(*conserved.momentum_kg_m2_s, std::sqrt(T2 * I_low),
                              std::sqrt(T2 * I_high));
    throw InputError(
        fmt::format("momentum_kg_m2_s = {} is impossible for this body with energy_J = {:g}: "
                    "2T I_min <= L^2 <= 2T I_max requires L {} kg m^2/s",
                    momentum.given, conserved.energy_J, momentum.range()));
}

}  // namespace

PolhodeStart start_on_polhode(const InertiaTensor& inertia, const ConservedQuantities& conserved,
                              const std::optional<Eigen::Vector3d>& direction_body) {
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    const auto [low, middle, high] = ranked_axes(I);
    const std::array<WideDouble, 3> delta = differences(conserved, I);
    if (delta.at(low).sign() < 0 || delta.at(high).sign() > 0)
        refuse_range(conserved, I[low], I[high]);

    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    if (direction_body)
        direction = inertia.body_from_principal().transpose() * direction_body->stableNormalized();
    const WideDouble twice_T = WideDouble(2.0) * conserved.energy_J;

    // The sphere has one T for each L, and turns about any axis.
    if (I[low] == I[high]) {
        if (direction.isZero(0.0)) direction[2] = 1.0;
        return {inertia.body_from_principal() * direction *
                    sqrt(twice_T / WideDouble(I[low])).rounded(),
                false};
    }

    // ω = (r cos, r sin, w) along (c, b, a), where the polhode encircles a and b is the middle
    // axis: r² and w² as sums of terms of one sign, from Σ I_j (I_j − I_i) ω_j² = Δ_i with i = a
    // and b.
    const bool about_high = delta.at(middle).sign() >= 0 && I[middle] < I[high];
    const int a = about_high ? high : low;
    const int c = about_high ? low : high;
    const int b = middle;
    const double length = std::hypot(direction[c], direction[b]);
    const WideDouble cosine = length > 0.0 ? direction[c] / length : 1.0;
    const WideDouble sine = length > 0.0 ? direction[b] / length : 0.0;
    const auto term = [&](int j, int i) { return WideDouble(I[j]) * (WideDouble(I[j]) - I[i]); };
    const WideDouble r2 =
        twice_T * delta.at(a) / (term(c, a) * square(cosine) + term(b, a) * square(sine));
    const WideDouble w2 = (twice_T * delta.at(b) - term(c, b) * square(cosine) * r2) / term(a, b);
    Eigen::Vector3d omega;
    const WideDouble r = sqrt(r2);
    omega[c] = (r * cosine).rounded();
    omega[b] = (r * sine).rounded();
    omega[a] = std::copysign(sqrt(w2).rounded(), direction[a]);
    return {inertia.body_from_principal() * omega,
            delta.at(b).is_zero() && I[low] < I[middle] && I[middle] < I[high]};
}

}  // namespace poinsot
