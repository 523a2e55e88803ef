#include "construction/polhode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "construction/adaptive_curve.h"
#include "mechanics/free/jacobi_solution.h"
#include "numerics/power_of_two.h"
#include "numerics/wide_double.h"

namespace poinsot {

using std::numbers::pi;

Polhode::Polhode(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                 bool on_separatrix)
    : body_from_principal_(inertia.body_from_principal()), moments_(inertia.moments_kg_m2()) {
    // Scaled to order one; only ratios matter from here on.
    const double I_largest = moments_.maxCoeff();
    const double omega_largest = omega_body.cwiseAbs().maxCoeff();
    const Eigen::Vector3d I = moments_ / I_largest;
    const Eigen::Vector3d omega = body_from_principal_.transpose() * (omega_body / omega_largest);

    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&I](int i, int j) { return I[i] < I[j]; });
    const int low = order[0];
    const int middle = order[1];
    const int high = order[2];

    // Δ_i = L² − 2T·I_i as sums of terms of one sign for the outer axes; Δ of the middle axis
    // determines the family, as in FreeRotation.
    const auto term = [&](int i, int j) { return I[j] * omega[j] * omega[j] * (I[j] - I[i]); };
    const double with_high = term(middle, high), with_low = term(middle, low);
    double delta_middle = with_high + with_low;
    // Where the two terms cancel, their rounding differs from FreeRotation's, so its function is
    // used.
    if (std::abs(delta_middle) < 1e-6 * with_high) {
        const Eigen::Vector3d omega_principal = body_from_principal_.transpose() * omega_body;
        const WideDouble unit = WideDouble(I_largest) * omega_largest;
        delta_middle = (momentum_difference(moments_, omega_principal, middle) / (unit * unit))
                           .double_double()
                           .hi;
    }
    if (on_separatrix) delta_middle = 0.0;
    a_ = delta_middle >= 0.0 ? high : low;
    b_ = middle;
    c_ = delta_middle >= 0.0 ? low : high;
    // √|Δ_a| without forming Δ_a, which underflows for wobbles below 1e-160.
    const auto root = [&](int j) {
        return omega[j] * std::sqrt(I[j]) * std::sqrt(std::abs(I[j] - I[a_]));
    };
    const double root_delta_a = std::hypot(root(b_), root(c_));
    const double delta_c = term(c_, a_) + term(c_, b_);
    const double twice_T = I.dot(omega.cwiseProduct(omega));

    const auto steady = [&](int i, int j) {
        return I[i] == I[j] || omega[i] == 0.0 || omega[j] == 0.0;
    };
    if (steady(0, 1) && steady(1, 2) && steady(0, 2)) {
        // Steady spin: the curve is the one point ρ.
        kind_ = Kind::point;
        const Eigen::Vector3d at = omega / std::sqrt(twice_T * I_largest);
        alpha_ = at[a_], beta_ = at[b_], gamma_ = at[c_];
        return;
    }

    // Amplitudes of ρ_i = L_i/(I_i √(2T)): L_a² = I_aΔ_c/(I_a−I_c), L_b² = I_bΔ_a/(I_b−I_a), L_c² =
    // I_cΔ_a/(I_c−I_a). The unit of I enters last, by the root of an even power of two: products
    // with the moments of a needle could underflow in it.
    const int half_exponent = exponent_of(I_largest) / 2;
    const double largest_near_one = std::ldexp(I_largest, -2 * half_exponent);
    const auto amplitude = [&](int i, double root_delta, double difference) {
        const double square = std::abs(I[i] * difference) * (twice_T * largest_near_one);
        return std::ldexp(root_delta / std::sqrt(square), -half_exponent);
    };
    // Δ_c underflows where ω nearly lies in the plane of two equal moments.
    const bool vanishes = delta_c == 0.0;
    const double root_delta_c =
        vanishes ? std::hypot(omega[a_] * std::sqrt(I[a_]) * std::sqrt(std::abs(I[a_] - I[c_])),
                              omega[b_] * std::sqrt(I[b_]) * std::sqrt(std::abs(I[b_] - I[c_])))
                 : std::sqrt(std::abs(delta_c));
    alpha_ = amplitude(a_, root_delta_c, I[a_] - I[c_]) * (omega[a_] < 0.0 ? -1.0 : 1.0);
    gamma_ = amplitude(c_, root_delta_a, I[c_] - I[a_]) * (omega[c_] < 0.0 ? -1.0 : 1.0);
    beta_ = amplitude(b_, root_delta_a, I[b_] - I[a_]);
    const double ratio = root_delta_a / root_delta_c;
    k2_ = I[b_] == I[c_] ? 0.0 : ratio * ratio * std::abs((I[b_] - I[c_]) / (I[b_] - I[a_]));
    k2_complement_ =
        vanishes ? 1.0 - k2_ : delta_middle * (I[a_] - I[c_]) / (delta_c * (I[a_] - I[b_]));
    kind_ = k2_ == 0.0 ? Kind::circle : k2_complement_ == 0.0 ? Kind::separatrix : Kind::closed;
}

Eigen::Vector3d Polhode::at(double chi_rad) const {
    Eigen::Vector3d rho;
    if (kind_ == Kind::point) {
        rho[a_] = alpha_, rho[b_] = beta_, rho[c_] = gamma_;
        return body_from_principal_ * rho;
    }
    const double s = std::sin(chi_rad);
    const double c = std::cos(chi_rad);
    // dn² = cos² + k'² sin², which does not cancel as 1 − k² sin² does.
    rho[a_] = alpha_ * std::sqrt(c * c + k2_complement_ * s * s);
    if (kind_ == Kind::circle && k2_ == 0.0) rho[a_] = alpha_;
    rho[b_] = beta_ * s;
    rho[c_] = gamma_ * c;
    return body_from_principal_ * rho;
}

Eigen::Vector3d Polhode::tangent(double chi_rad) const {
    if (kind_ == Kind::point) return Eigen::Vector3d::Zero();
    const double s = std::sin(chi_rad);
    const double c = std::cos(chi_rad);
    // d dn/dχ = −k² sin χ cos χ/dn. On the separatrix dn = |cos χ|, and its slope is that of the
    // branch within (−π/2, π/2).
    const double dn = std::sqrt(c * c + k2_complement_ * s * s);
    Eigen::Vector3d slope;
    slope[a_] = dn > 0.0 ? -alpha_ * k2_ * s * (c / dn) : 0.0;
    slope[b_] = beta_ * c;
    slope[c_] = -gamma_ * s;
    return body_from_principal_ * slope;
}

std::optional<Polhode::Circle> Polhode::circle() const {
    if (kind_ != Kind::circle) return std::nullopt;
    const auto along = [&](int axis, double length) -> Eigen::Vector3d {
        return length * body_from_principal_.col(axis);
    };
    return Circle{along(a_, alpha_), along(c_, gamma_), along(b_, beta_)};
}

double Polhode::first_chi_rad() const {
    return kind_ == Kind::point ? 0.0 : kind_ == Kind::separatrix ? -pi / 2.0 : -pi;
}

double Polhode::last_chi_rad() const { return kind_ == Kind::point ? 0.0 : -first_chi_rad(); }

SampledCurve Polhode::samples(double tolerance) const {
    return sample_adaptively(
        [this](double chi) { return at(chi); },
        {.first = first_chi_rad(), .last = last_chi_rad(), .tolerance = tolerance});
}

std::vector<Eigen::Vector3d> Polhode::sampled(double tolerance, double* off) const {
    std::vector<Eigen::Vector3d> points;
    const SampledCurve curve = samples(tolerance);
    for (const CurveSample& sample : curve.samples) points.push_back(sample.point);
    if (off != nullptr) *off = curve.off;
    if (closed()) points.pop_back();
    return points;
}

Polhode::Annulus Polhode::annulus() const {
    // |ρ|² − (ρ·n)² has its extremes at χ = 0 and χ = ±π/2. ρ's component in the plane is
    // ρ_i Σ_j I_jρ_j²(I_j−I_i)/Σ_j(I_jρ_j)² along axis i, which keeps its digits where the curve is
    // small and where the moments are nearly equal.
    const auto radius = [this](double chi) {
        const Eigen::Vector3d rho = body_from_principal_.transpose() * at(chi);
        const double size = rho.cwiseAbs().maxCoeff();
        const Eigen::Vector3d x = rho / size;
        const Eigen::Vector3d I = moments_ / moments_.maxCoeff();
        const Eigen::Vector3d momentum = I.cwiseProduct(x);
        Eigen::Vector3d across;
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d differences = I.array() - I[i];
            across[i] = x[i] * momentum.cwiseProduct(x).dot(differences) / momentum.squaredNorm();
        }
        return size * norm_of(across);
    };
    if (kind_ == Kind::point) return {0.0, 0.0};
    const double r0 = radius(0.0);
    const double r1 = kind_ == Kind::separatrix ? 0.0 : radius(pi / 2.0);
    return {std::min(r0, r1), std::max(r0, r1)};
}

std::vector<std::vector<Eigen::Vector3d>> separatrices(const InertiaTensor& inertia,
                                                       double tolerance, double* off) {
    if (off != nullptr) *off = 0.0;
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&I](int i, int j) { return I[i] < I[j]; });
    const int low = order[0];
    const int middle = order[1];
    const int high = order[2];
    if (I[low] == I[middle] || I[middle] == I[high]) return {};

    // I_h(I_h−I_m)ρ_h² = I_l(I_m−I_l)ρ_l²: two planes through the middle axis, each cutting the
    // ellipsoid in an ellipse.
    const double weight_high = std::sqrt((I[middle] - I[low]) / (I[high] - I[low]) / I[high]);
    const double weight_low = std::sqrt((I[high] - I[middle]) / (I[high] - I[low]) / I[low]);
    std::vector<std::vector<Eigen::Vector3d>> curves;
    for (const double sign : {1.0, -1.0}) {
        const auto point = [&](double chi) {
            Eigen::Vector3d rho;
            rho[middle] = std::sin(chi) / std::sqrt(I[middle]);
            rho[high] = weight_high * std::cos(chi);
            rho[low] = sign * weight_low * std::cos(chi);
            return Eigen::Vector3d(inertia.body_from_principal() * rho);
        };
        std::vector<Eigen::Vector3d> points;
        const SampledCurve curve =
            sample_adaptively(point, {.first = -pi, .last = pi, .tolerance = tolerance});
        for (const CurveSample& s : curve.samples) points.push_back(s.point);
        if (off != nullptr) *off = std::max(*off, curve.off);
        points.pop_back();
        curves.push_back(std::move(points));
    }
    return curves;
}

}  // namespace poinsot
