#include "mechanics/free_rotation_oracle.h"

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <utility>
#include <vector>

namespace poinsot::oracle {

namespace {

namespace mp = boost::multiprecision;
template <unsigned digits>
using Digits = mp::number<mp::mpfr_float_backend<digits, mp::allocate_stack>, mp::et_off>;
using Real = Digits<160>;
using Vector = std::array<Real, 3>;
using Matrix = std::array<Vector, 3>;  // rows

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// (xᵀy) for row matrices: Σ over rows.
Matrix transposed_times(const Matrix& x, const Matrix& y) {
    Matrix r;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            r[i][j] = x[0][i] * y[0][j] + x[1][i] * y[1][j] + x[2][i] * y[2][j];
    }
    return r;
}

// Convergence of the integrals: an angle of 1e18 rad would still be accurate to 1e-20.
const int integral_digits = 44;

Real tolerance_root(int order) { return pow(Real(10), Real(-integral_digits) / order); }

// Carlson's R_F by duplication; the error of the truncated series is of sixth order (DLMF 19.36.1).
Real carlson_rf(Real x, Real y, Real z) {
    const Real tolerance = tolerance_root(6);
    while (true) {
        const Real a = (x + y + z) / 3;
        const Real X = (a - x) / a;
        const Real Y = (a - y) / a;
        const Real Z = -X - Y;
        if (std::max({Real(abs(X)), Real(abs(Y)), Real(abs(Z))}) < tolerance) {
            const Real e2 = X * Y - Z * Z;
            const Real e3 = X * Y * Z;
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / sqrt(a);
        }
        const Real lambda = sqrt(x * y) + sqrt(y * z) + sqrt(z * x);
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
    }
}

// R_C(1, 1 + e).
Real carlson_rc(const Real& e) {
    if (abs(e) < Real(1e-4)) {
        Real sum = 0;
        for (int n = 25; n >= 1; n -= 2) sum = Real(1) / n - e * sum;
        return sum;
    }
    if (e > 0) return atan(sqrt(e)) / sqrt(e);
    const Real root = sqrt(-e);
    return log((1 + root) / (1 - root)) / (2 * root);
}

// Carlson's R_J for positive p (Carlson, Numer. Algorithms 10 (1995) 13).
Real carlson_rj(Real x, Real y, Real z, Real p) {
    const Real tolerance = tolerance_root(6);
    Real sum = 0;
    Real power = 1;
    Real delta = (p - x) * (p - y) * (p - z);
    while (true) {
        const Real a = (x + y + z + 2 * p) / 5;
        const Real X = (a - x) / a;
        const Real Y = (a - y) / a;
        const Real Z = (a - z) / a;
        const Real P = -(X + Y + Z) / 2;
        if (std::max({Real(abs(X)), Real(abs(Y)), Real(abs(Z)), Real(abs(P))}) < tolerance) {
            const Real e2 = X * Y + X * Z + Y * Z - 3 * P * P;
            const Real e3 = X * Y * Z + 2 * e2 * P + 4 * P * P * P;
            const Real e4 = (2 * X * Y * Z + e2 * P + 3 * P * P * P) * P;
            const Real e5 = X * Y * Z * P * P;
            return power / (a * sqrt(a)) *
                       (1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 -
                        9 * e2 * e3 / 52 + 3 * e5 / 26) +
                   6 * sum;
        }
        const Real rx = sqrt(x);
        const Real ry = sqrt(y);
        const Real rz = sqrt(z);
        const Real rp = sqrt(p);
        const Real d = (rp + rx) * (rp + ry) * (rp + rz);
        sum += power / d * carlson_rc(delta / (d * d));
        const Real lambda = rx * ry + ry * rz + rz * rx;
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
        p = (p + lambda) / 4;
        power /= 4;
        delta /= 64;
    }
}

struct Jacobi {
    Real sn;
    Real cn;
    Real dn;
};

// Descending Landen transformations (DLMF 22.7.1–3) until k is negligible, then sines.
template <unsigned digits>
Jacobi landen(const Real& given_u, const Real& k_complement) {
    using Number = Digits<digits>;
    Number kc(k_complement);
    Number scale = 1;
    std::vector<Number> moduli;
    const Number tiny = pow(Number(10), -static_cast<int>(digits));
    while (true) {
        const Number k1 = (1 - kc) / (1 + kc);
        moduli.push_back(k1);
        scale *= 1 + k1;
        if (k1 * k1 < tiny) break;
        kc = 2 * sqrt(kc) / (1 + kc);
    }
    const Number last_u = Number(given_u) / scale;
    Number sn = sin(last_u);
    Number cn = cos(last_u);
    Number dn = 1;
    for (auto k1 = moduli.rbegin(); k1 != moduli.rend(); ++k1) {
        const Number s2 = *k1 * sn * sn;
        const Number back = 1 / (1 + s2);
        cn = cn * dn * back;
        sn = (1 + *k1) * sn * back;
        dn = (1 - s2) * back;
    }
    return {Real(sn), Real(cn), Real(dn)};
}

// Near u = K, dn falls to k′ by cancellation: each decade of 1/k′ needs three more digits.
Jacobi jacobi(const Real& u, const Real& k_complement) {
    if (k_complement == 0) {
        const Real e = exp(-abs(u));
        const Real sech = 2 * e / (1 + e * e);
        const Real tanh = (1 - e * e) / (1 + e * e);
        return {u < 0 ? Real(-tanh) : tanh, sech, sech};
    }
    const double decades = -static_cast<double>(log10(k_complement));
    if (decades < 30.0) return landen<160>(u, k_complement);
    if (decades < 110.0) return landen<400>(u, k_complement);
    return landen<1100>(u, k_complement);
}

// Unit quaternion (w, x, y, z) of a rotation matrix, by its largest component.
std::array<long double, 4> quaternion(const Matrix& r) {
    const std::array<Real, 4> square{
        1 + r[0][0] + r[1][1] + r[2][2], 1 + r[0][0] - r[1][1] - r[2][2],
        1 - r[0][0] + r[1][1] - r[2][2], 1 - r[0][0] - r[1][1] + r[2][2]};
    const auto largest =
        static_cast<std::size_t>(std::max_element(square.begin(), square.end()) - square.begin());
    const std::array<Real, 3> odd{r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
    const std::array<Real, 3> even{r[1][2] + r[2][1], r[0][2] + r[2][0], r[0][1] + r[1][0]};
    std::array<Real, 4> q;
    q[largest] = sqrt(square[largest]) / 2;
    const Real quarter = 1 / (4 * q[largest]);
    for (std::size_t i = 1; i < 4; ++i) {
        if (largest == 0) {
            q[i] = odd[i - 1] * quarter;
        } else if (i != largest) {
            // The two vector components i and largest share the even part of the third.
            q[i] = even[6 - i - largest - 1] * quarter;
        }
    }
    if (largest != 0) q[0] = odd[largest - 1] * quarter;
    std::array<long double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i) result[i] = static_cast<long double>(q[i]);
    return result;
}

}  // namespace

struct FreeMotion::Constants {
    bool steady = false;
    Vector I, w, delta;  // principal axes
    Real L, T2;
    int a = 2, b = 1, c = 0;
    int sign_a = 1, sign_b = 1, sign_c = 1, s = 1;
    Real A, B, C, kc, lambda, u0, K, p;
    Real angle_per_u, angle_factor, angle_half_period;
    Real angle_0;
    Matrix frame_0;

    // Integral of the precession's rate from u = 0: half periods, and the remainder by R_J.
    Real precession(const Real& u) const {
        Real half_periods = 0;
        Real r = u;
        if (K > 0) {
            half_periods = round(u / (2 * K));
            r = u - 2 * K * half_periods;
        }
        const Jacobi j = jacobi(r, kc);
        const Real s2 = j.sn * j.sn;
        const Real c2 = j.cn * j.cn;
        const Real third =
            j.sn == 0 ? Real(0)
                      : Real(j.sn * s2 / 3 * carlson_rj(c2, j.dn * j.dn, Real(1), c2 + p * s2));
        return angle_per_u * u + angle_factor * (2 * half_periods * angle_half_period + third);
    }
    // Momentum in principal axes.
    Vector momentum(const Real& u) const {
        const Jacobi j = jacobi(u, kc);
        Vector m;
        m[a] = sign_a * A * j.dn;
        m[b] = sign_b * B * j.sn;
        m[c] = sign_c * s * C * j.cn;
        return m;
    }
    // Rows: the part of axis a across L, its quarter turn about L, L; in principal axes.
    Matrix frame(const Vector& m) const {
        const Real across = sqrt(m[b] * m[b] + m[c] * m[c]);
        Vector z{m[0] / L, m[1] / L, m[2] / L};
        Vector x;
        x[a] = across / L;
        x[b] = -m[a] * m[b] / (L * across);
        x[c] = -m[a] * m[c] / (L * across);
        return {x, cross(z, x), z};
    }
};

namespace {

// L² − 2T·I_i of each axis.
Vector momentum_differences(const Eigen::Vector3d& I, const Eigen::Vector3d& w) {
    Vector delta{Real(0), Real(0), Real(0)};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) delta[i] += Real(I[j]) * w[j] * w[j] * (Real(I[j]) - I[i]);
    }
    return delta;
}

}  // namespace

FreeMotion::FreeMotion(const Eigen::Vector3d& moments_kg_m2, const Eigen::Vector3d& omega_rad_s) {
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return moments_kg_m2[i] < moments_kg_m2[j]; });
    const auto [low, mid, high] = order;
    constants_ = std::make_unique<Constants>();
    Constants& k = *constants_;
    Real L2 = 0;
    k.T2 = 0;
    for (int i = 0; i < 3; ++i) {
        k.I[i] = moments_kg_m2[i];
        k.w[i] = omega_rad_s[i];
        L2 += k.I[i] * k.I[i] * k.w[i] * k.w[i];
        k.T2 += k.I[i] * k.w[i] * k.w[i];
    }
    k.delta = momentum_differences(moments_kg_m2, omega_rad_s);
    k.L = sqrt(L2);
    const auto idle = [&](int i, int j) { return k.I[i] == k.I[j] || k.w[i] == 0 || k.w[j] == 0; };
    k.steady = idle(0, 1) && idle(1, 2) && idle(0, 2);
    if (k.steady) return;

    k.b = mid;
    k.a = k.delta[mid] >= 0 ? high : low;
    k.c = k.delta[mid] >= 0 ? low : high;
    k.s = k.a == low ? 1 : -1;
    const Real& Ia = k.I[k.a];
    const Real& Ib = k.I[k.b];
    const Real& Ic = k.I[k.c];
    k.kc = sqrt(k.delta[k.b] * (Ia - Ic) / (k.delta[k.c] * (Ia - Ib)));

    k.A = sqrt(Ia * k.delta[k.c] / (Ia - Ic));
    k.B = sqrt(Ib * k.delta[k.a] / (Ib - Ia));
    k.C = sqrt(Ic * k.delta[k.a] / (Ic - Ia));
    k.lambda = sqrt(abs(k.delta[k.c] * (Ia - Ib) / (Ia * Ib * Ic)));
    k.sign_a = k.w[k.a] < 0 ? -1 : 1;
    k.sign_c = k.s * k.w[k.c] < 0 ? -1 : 1;
    k.sign_b = ((k.b - k.a + 3) % 3 == 1 ? 1 : -1) * k.sign_a * k.sign_c;
    const Real sn = k.sign_b * Ib * k.w[k.b] / k.B;
    const Real cn = k.sign_c * k.s * Ic * k.w[k.c] / k.C;
    const Real dn = k.sign_a * Ia * k.w[k.a] / k.A;
    k.u0 = sn * carlson_rf(cn * cn, dn * dn, Real(1));
    k.K = k.kc > 0 ? carlson_rf(Real(0), k.kc * k.kc, Real(1)) : Real(0);

    // φ̇ = (L/Ic)(cn² + r sn²)/(cn² + p sn²) with r = (Ic−Ia)/(Ib−Ia), p = r·Ib/Ic.
    const Real r = (Ic - Ia) / (Ib - Ia);
    k.p = r * Ib / Ic;
    k.angle_per_u = k.L / (Ic * k.lambda);
    k.angle_factor = k.angle_per_u * (r - k.p);
    if (k.kc > 0) k.angle_half_period = carlson_rj(Real(0), k.kc * k.kc, Real(1), k.p) / 3;
    k.angle_0 = k.precession(k.u0);
    Vector m;
    for (int i = 0; i < 3; ++i) m[i] = k.I[i] * k.w[i];
    k.frame_0 = k.frame(m);
}

FreeMotion::~FreeMotion() = default;
FreeMotion::FreeMotion(FreeMotion&&) noexcept = default;
FreeMotion& FreeMotion::operator=(FreeMotion&&) noexcept = default;

Answer FreeMotion::at(double time_s) const {
    const Constants& k = *constants_;
    Answer answer;
    if (k.steady) {
        const Real rate = sqrt(dot(k.w, k.w));
        const Real half = rate * time_s / 2;
        answer.attitude[0] = static_cast<long double>(cos(half));
        for (std::size_t i = 0; i < 3; ++i) {
            answer.omega[i] = static_cast<long double>(k.w[i]);
            if (rate > 0)
                answer.attitude[i + 1] = static_cast<long double>(sin(half) * k.w[i] / rate);
        }
        return answer;
    }
    const Real u = k.u0 + k.lambda * time_s;
    // Whole periods are subtracted before Landen's sines.
    const Real r = k.K > 0 ? Real(u - 4 * k.K * round(u / (4 * k.K))) : u;
    const Vector m = k.momentum(r);
    const Real angle = k.precession(u) - k.angle_0;
    const Matrix now = k.frame(m);
    Matrix turned = now;
    for (int j = 0; j < 3; ++j) {
        turned[0][j] = cos(angle) * now[0][j] - sin(angle) * now[1][j];
        turned[1][j] = sin(angle) * now[0][j] + cos(angle) * now[1][j];
    }
    // turned maps principal axes to (x, y, L); so does frame_0 at the start, where space and body
    // axes coincide.
    const Matrix space_from_body = transposed_times(k.frame_0, turned);
    answer.attitude = quaternion(space_from_body);
    Vector h;
    for (int i = 0; i < 3; ++i) {
        answer.omega[static_cast<std::size_t>(i)] = static_cast<long double>(Real(m[i] / k.I[i]));
        h[i] = m[i] / k.I[i] * k.delta[i] / (k.L * k.L);
    }
    for (int i = 0; i < 3; ++i) {
        answer.herpolhode[static_cast<std::size_t>(i)] =
            static_cast<long double>(dot(space_from_body[i], h));
    }
    return answer;
}

}  // namespace poinsot::oracle
