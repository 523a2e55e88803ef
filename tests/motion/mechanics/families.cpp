#include "mechanics/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <ostream>
#include <vector>

#include "mechanics/free/free_rotation.h"
#include "mechanics/free_rotation_oracle.h"

namespace poinsot::families {

namespace {

using Eigen::Vector3d;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
int integer(Random& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}
double sign(Random& random) { return integer(random, 0, 1) == 0 ? -1.0 : 1.0; }
double decade(Random& random, double low, double high) {
    return std::pow(10.0, uniform(random, low, high));
}
double ulps_up(double x, int n) {
    for (int i = 0; i < n; ++i) x = std::nextafter(x, std::numeric_limits<double>::infinity());
    return x;
}
double ulps_away(double x, int n) {
    const double towards = std::copysign(std::numeric_limits<double>::infinity(), n);
    for (int i = 0; i < std::abs(n); ++i) x = std::nextafter(x, towards);
    return x;
}

// Moments of a real body: sums of second moments of mass.
Vector3d physical_moments(Random& random) {
    const double x = uniform(random, 0.05, 1.0);
    const double y = uniform(random, 0.05, 1.0);
    const double z = uniform(random, 0.05, 1.0);
    return {y + z, z + x, x + y};
}
Vector3d spin(Random& random) {
    std::normal_distribution<double> component;
    return {component(random), component(random), component(random)};
}
std::array<int, 3> ranks(const Vector3d& I) {
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return I[i] < I[j]; });
    return order;
}
// The same body with its axes in another order.
Body shuffled(const Body& body, Random& random) {
    std::array<int, 3> order{0, 1, 2};
    std::shuffle(order.begin(), order.end(), random);
    Body result;
    for (int i = 0; i < 3; ++i) {
        result.moments[i] = body.moments[order[static_cast<std::size_t>(i)]];
        result.omega[i] = body.omega[order[static_cast<std::size_t>(i)]] * sign(random);
    }
    return result;
}

Body generic(Random& random) { return {physical_moments(random), spin(random)}; }

// ω_h on the separatrix, except for rounding: I_h ω_h²(I_h − I_m) = I_l ω_l²(I_m − I_l).
double on_separatrix_omega_high(const Body& body) {
    const auto [l, m, h] = ranks(body.moments);
    const Vector3d& I = body.moments;
    return body.omega[l] * std::sqrt(I[l] * (I[m] - I[l]) / (I[h] * (I[h] - I[m])));
}
Body on_separatrix(Random& random) {
    Body body = generic(random);
    body.omega[ranks(body.moments)[2]] =
        std::copysign(on_separatrix_omega_high(body), sign(random));
    return body;
}
Body near_separatrix(Random& random, double side) {
    Body body = on_separatrix(random);
    const int h = ranks(body.moments)[2];
    const int bits = integer(random, 1, 60);
    double& w = body.omega[h];
    // From half of it down to one ulp.
    w = bits <= 50 ? w * (1.0 + side * std::ldexp(1.0, -bits))
                   : ulps_away(w, static_cast<int>(side * std::copysign(1.0, w)) * (bits - 50));
    return body;
}
Body above_separatrix(Random& random) { return near_separatrix(random, 1.0); }
Body below_separatrix(Random& random) { return near_separatrix(random, -1.0); }

// k′ within 1e-15 to 1e-3 of ½, where the series changes.
Body change_of_series(Random& random) {
    Body body = generic(random);
    const int h = ranks(body.moments)[2];
    const auto k_complement = [&](double w) {
        body.omega[h] = w;
        RotationState start;
        start.omega_body = body.omega;
        return FreeRotation(InertiaTensor::from_principal_moments(body.moments), start)
            .constants()
            .complementary_modulus;
    };
    // k′ rises from 0 on the separatrix to 1 with ω_h; bisection finds k′ = ½.
    double low = std::abs(on_separatrix_omega_high(body));
    double high = 1e3 * low;
    for (int i = 0; i < 60; ++i) {
        const double mid = 0.5 * (low + high);
        (k_complement(mid) < 0.5 ? low : high) = mid;
    }
    body.omega[h] = high * (1.0 + sign(random) * decade(random, -15.0, -3.0));
    return body;
}

// Starts in a principal plane, u₀ = 0 or ±K.
Body principal_plane(Random& random) {
    Body body = generic(random);
    body.omega[integer(random, 0, 2)] = 0.0;
    return body;
}

// Integers for which the two sides of the separatrix's equation are exactly equal.
struct ExactSeparatrix {
    int low;
    int mid;
    int high;
    int omega_low;
    int omega_high;
};
const std::vector<ExactSeparatrix>& exact_separatrices() {
    static const std::vector<ExactSeparatrix> table = [] {
        std::vector<ExactSeparatrix> found;
        for (int low = 1; low <= 60; ++low) {
            for (int mid = low + 1; mid <= 90; ++mid) {
                for (int high = mid + 1; high <= low + mid; ++high) {
                    const int at_low = low * (mid - low);
                    const int at_high = high * (high - mid);
                    const int common = std::gcd(at_low, at_high);
                    const auto root = [](int x) {
                        return static_cast<int>(std::lround(std::sqrt(x)));
                    };
                    const int p = at_low / common;
                    const int q = at_high / common;
                    if (root(p) * root(p) != p || root(q) * root(q) != q) continue;
                    found.push_back({low, mid, high, root(q), root(p)});
                }
            }
        }
        return found;
    }();
    return table;
}
Body exact_separatrix(Random& random) {
    const auto& table = exact_separatrices();
    const ExactSeparatrix& e =
        table[static_cast<std::size_t>(integer(random, 0, static_cast<int>(table.size()) - 1))];
    const double unit = std::ldexp(1.0, integer(random, -8, 8));
    const double factor = std::ldexp(static_cast<double>(integer(random, 1, 1 << 20)), -20);
    const Body body{Vector3d(e.low, e.mid, e.high) * unit,
                    {e.omega_low * factor, uniform(random, -2.0, 2.0) * factor * e.omega_low,
                     e.omega_high * factor}};
    return shuffled(body, random);
}

// Nearly steady about the axis of the given rank: 0 lowest, 1 middle, 2 highest.
Body wobble(Random& random, std::size_t rank) {
    Body body{physical_moments(random), {}};
    const auto order = ranks(body.moments);
    const double size = decade(random, -300.0, -1.0);
    for (std::size_t i = 0; i < 3; ++i) {
        body.omega[order[i]] = sign(random) * (i == rank ? uniform(random, 0.5, 2.0)
                                                         : size * uniform(random, 0.1, 1.0));
    }
    return body;
}
Body wobble_about_lowest(Random& random) { return wobble(random, 0); }
Body wobble_about_middle(Random& random) { return wobble(random, 1); }
Body wobble_about_highest(Random& random) { return wobble(random, 2); }

Body nearly_symmetric(Random& random) {
    Body body{{}, spin(random)};
    const double equal = uniform(random, 0.5, 1.0);
    const double other = uniform(random, 0.05, 2.0 * equal);
    body.moments = {equal, ulps_up(equal, integer(random, 0, 4)), other};
    return shuffled(body, random);
}
Body nearly_spherical(Random& random) {
    Body body{{}, spin(random)};
    const double equal = uniform(random, 0.5, 2.0);
    body.moments = {equal, ulps_up(equal, integer(random, 0, 4)),
                    ulps_up(equal, integer(random, 0, 4))};
    return shuffled(body, random);
}
Body close_moments(Random& random) {
    Body body{{}, spin(random)};
    const double gap = decade(random, -16.0, -1.0);
    body.moments = {1.0, 1.0 + gap * uniform(random, 0.0, 1.0), 1.0 + gap};
    return shuffled(body, random);
}
Body lamina(Random& random) {
    // Multiples of 2^−20 add without rounding.
    const double x = std::ldexp(integer(random, 1, 1 << 20), -20);
    const double y = std::ldexp(integer(random, 1, 1 << 20), -20);
    return shuffled({{x, y, x + y}, spin(random)}, random);
}
Body needle(Random& random) {
    const double thin = decade(random, -12.0, -1.0);
    Body body{{thin, 1.0, 1.0 + thin * uniform(random, 0.0, 1.0)}, spin(random)};
    // In half of the cases it spins fast about its length.
    if (integer(random, 0, 1) == 0) body.omega[0] *= decade(random, 0.0, 8.0);
    return shuffled(body, random);
}
Body any_ratio(Random& random) {
    return {{decade(random, -12.0, 12.0), decade(random, -12.0, 12.0), decade(random, -12.0, 12.0)},
            spin(random)};
}
Body scaled(Random& random) {
    Body body = generic(random);
    body.moments *= decade(random, -150.0, 150.0);
    body.omega *= decade(random, -150.0, 150.0);
    return body;
}
Body subnormal(Random& random) {
    Body body = generic(random);
    const int kept = integer(random, 0, 2);
    for (int i = 0; i < 3; ++i) {
        if (i == kept || integer(random, 0, 3) == 0) continue;
        body.omega[i] = 4.9406564584124654e-324 * integer(random, 1, 1000) * sign(random);
    }
    return body;
}
Body symmetric(Random& random) {
    const double equal = uniform(random, 0.5, 1.0);
    const double other = uniform(random, 0.05, 2.0 * equal);
    return shuffled({{equal, equal, other}, spin(random)}, random);
}
Body permanent(Random& random) {
    Body body = generic(random);
    switch (integer(random, 0, 2)) {
        case 0:
            body.moments = Vector3d::Constant(body.moments[0]);
            break;
        case 1:
            body.moments[1] = body.moments[0];
            body.omega[2] = 0.0;
            break;
        default:
            body.omega[0] = body.omega[1] = 0.0;
    }
    return body;
}

constexpr std::array table{
    Family{"generic", generic},
    Family{"generic, 1e9 periods", generic, 1e9},
    Family{"near the separatrix, above", above_separatrix},
    Family{"near the separatrix, below", below_separatrix},
    Family{"near the separatrix, 1e9 periods", above_separatrix, 1e9},
    Family{"separatrix exactly", exact_separatrix},
    Family{"change of series, k' near 1/2", change_of_series},
    Family{"from a principal plane, at eighths", principal_plane, 1e6, Instants::eighths},
    Family{"wobble 1e-1 to 1e-300, lowest axis", wobble_about_lowest},
    Family{"wobble 1e-1 to 1e-300, middle axis", wobble_about_middle},
    Family{"wobble 1e-1 to 1e-300, highest axis", wobble_about_highest},
    Family{"two moments within 4 ulp", nearly_symmetric},
    Family{"three moments within 4 ulp", nearly_spherical},
    Family{"three moments within 1e-16 to 1e-1", close_moments},
    Family{"lamina, I1 + I2 = I3", lamina},
    Family{"needle and plate, ratio to 1e12", needle},
    Family{"needle and plate, 1e9 periods", needle, 1e9},
    Family{"any moments 1e-12 to 1e12", any_ratio},
    Family{"I and omega scaled by 1e-150 to 1e150", scaled},
    Family{"subnormal components", subnormal},
    Family{"symmetric", symmetric},
    Family{"symmetric, 1e9 periods", symmetric, 1e9},
    Family{"permanent", permanent, 1e6},
};

using LongVector = Eigen::Matrix<long double, 3, 1>;
using LongQuaternion = Eigen::Quaternion<long double>;

LongVector wide(const std::array<long double, 3>& x) { return {x[0], x[1], x[2]}; }

void note(double& worst, long double residual) {
    worst = std::max(worst, static_cast<double>(residual));
}

void compare(const Body& body, const oracle::Answer& truth, const MotionSample& got,
             Residuals& worst) {
    const LongVector omega = got.state.omega_body.cast<long double>();
    const LongQuaternion q = got.state.space_from_body.cast<long double>();
    const LongVector h = got.herpolhode_space.cast<long double>();
    ++worst.n_instants;
    if (!omega.allFinite() || !q.coeffs().allFinite() || !h.allFinite()) {
        ++worst.n_not_finite;
        return;
    }
    const LongVector omega_true = wide(truth.omega);
    note(worst.omega, (omega - omega_true).norm() / omega_true.norm());
    const LongQuaternion q_true(truth.attitude[0], truth.attitude[1], truth.attitude[2],
                                truth.attitude[3]);
    note(worst.attitude_rad, 2.0L * std::min((q.coeffs() - q_true.coeffs()).norm(),
                                             (q.coeffs() + q_true.coeffs()).norm()));
    const LongVector h_true = wide(truth.herpolhode);
    note(worst.herpolhode, (h - h_true).norm() / std::max(h_true.norm(), 1e-300L));

    // Conserved quantities need no oracle.
    const LongVector I = body.moments.cast<long double>();
    const LongVector omega_0 = body.omega.cast<long double>();
    const long double energy = omega.dot(I.cwiseProduct(omega));
    const long double energy_0 = omega_0.dot(I.cwiseProduct(omega_0));
    note(worst.energy, std::abs(energy - energy_0) / energy_0);
    const LongVector momentum_0 = I.cwiseProduct(omega_0);
    const LongVector momentum = q.normalized() * I.cwiseProduct(omega);
    note(worst.momentum, (momentum - momentum_0).norm() / momentum_0.norm());
    note(worst.unit_quaternion, std::abs(q.norm() - 1.0L));
}

std::vector<double> instants(const Family& family, const FreeRotation& motion, const Body& body,
                             Random& random) {
    // Without a period, ten turns are used.
    const double turn = 2.0 * std::numbers::pi / body.omega.stableNorm();
    const double period = motion.constants().polhode_period_s.value_or(10.0 * turn);
    if (family.instants == Instants::eighths) {
        std::vector<double> times;
        for (int n = 0; n < 4; ++n) {
            const double eighths = integer(random, 0, 16) + 8.0 * integer(random, 0, 1 << n);
            times.push_back(ulps_away(0.125 * eighths * period, integer(random, -2, 2)));
        }
        return times;
    }
    // The phases are in double-double: enough for 1e15 rad of turning.
    const double span = std::min(family.periods * period, 1e15 / body.omega.stableNorm());
    return {uniform(random, 0.0, span), uniform(random, -span, 0.0),
            uniform(random, -0.5, 0.5) * std::min(period, span)};
}

}  // namespace

std::span<const Family> all() { return table; }

void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

Residuals measure(const Family& family, int first, int last) {
    Residuals worst;
    for (int n = first; n < last; ++n) {
        std::seed_seq seed{20261121, static_cast<int>(family.name.size()), n};
        Random random(seed);
        const Body body = family.draw(random);
        RotationState start;
        start.omega_body = body.omega;
        const FreeRotation motion(
            InertiaTensor::from_principal_moments(body.moments, Physicality::waived), start);
        const oracle::FreeMotion truth(body.moments, body.omega);
        for (const double t : instants(family, motion, body, random)) {
            compare(body, truth.at(t),
                    motion.sample(t, {.attitude = true, .herpolhode = true, .euler_angles = false}),
                    worst);
        }
    }
    return worst;
}

Residuals worse(const Residuals& a, const Residuals& b) {
    return {std::max(a.omega, b.omega),           std::max(a.attitude_rad, b.attitude_rad),
            std::max(a.herpolhode, b.herpolhode), std::max(a.energy, b.energy),
            std::max(a.momentum, b.momentum),     std::max(a.unit_quaternion, b.unit_quaternion),
            a.n_not_finite + b.n_not_finite,      a.n_instants + b.n_instants};
}

bool within_bounds(const Family& family, const Residuals& r) {
    return r.n_not_finite == 0 && r.omega <= family.omega_bound &&
           r.attitude_rad <= family.attitude_bound && r.herpolhode <= family.herpolhode_bound &&
           r.energy <= 2e-15 && r.momentum <= 2e-15 && r.unit_quaternion <= 1e-15;
}

}  // namespace poinsot::families
