#include "mechanics/top/heavy_top_cubic.h"

namespace poinsot::top_setup {

namespace {

// Of two expressions for a difference, the one that cancels less.
WideDouble less_cancelled(const WideDouble& p, const WideDouble& q, const WideDouble& r,
                          const WideDouble& s) {
    const WideDouble one = p - q;
    const WideDouble other = r - s;
    return abs(one) * (abs(r) + abs(s)) >= abs(other) * (abs(p) + abs(q)) ? one : other;
}

// The distance from x0 to the root of P above it: Newton's method from a bound beyond the root,
// which converges monotonically for a polynomial with real roots only.
WideDouble distance_to_upper_root(const Cubic& c) {
    if (c.p0 == 0) {
        if (c.p1 <= 0) return 0;
        const WideDouble root = sqrt(square(c.p2) + 4 * c.beta * c.p1);
        return c.p2 <= 0 ? WideDouble(2 * c.p1 / (root - c.p2))
                         : WideDouble((c.p2 + root) / (2 * c.beta));
    }
    WideDouble w = c.y0;
    if (c.p2 < 0) {
        const WideDouble root = sqrt(square(c.p1) - 4 * c.p2 * c.p0);
        const WideDouble bound = c.p1 >= 0 ? WideDouble((c.p1 + root) / (-2 * c.p2))
                                           : WideDouble(2 * c.p0 / (root - c.p1));
        if (bound < w) w = bound;
    }
    constexpr int max_steps = 500;
    for (int step = 0; step < max_steps; ++step) {
        const WideDouble value = c.p0 + w * (c.p1 + w * (c.p2 - w * c.beta));
        const WideDouble slope = c.p1 + w * (2 * c.p2 - 3 * w * c.beta);
        if (slope >= 0) break;
        const WideDouble correction = value / slope;
        w = w - correction;
        if (!(abs(correction) > 0x1p-103 * w)) break;
    }
    return w;
}

}  // namespace

// q ← q i.
TopAtStart reversed(const TopAtStart& s) {
    return {s.A, s.C, -s.mgl, -s.qx, s.qw, s.qz, -s.qy, s.omega1, -s.omega2, -s.omega3};
}

Cubic solve_cubic(const TopAtStart& s) {
    Cubic c;
    c.beta = 2 * s.mgl / s.A;
    c.a = s.C * s.omega3 / s.A;
    c.x0 = 2 * (square(s.qx) + square(s.qy));
    c.y0 = 2 * (square(s.qw) + square(s.qz));
    const WideDouble vertical1 = 2 * (s.qx * s.qz - s.qw * s.qy);  // the vertical in body axes
    const WideDouble vertical2 = 2 * (s.qy * s.qz + s.qw * s.qx);
    const WideDouble along = s.omega1 * vertical1 + s.omega2 * vertical2;  // φ' sin²θ
    const WideDouble transverse = square(s.omega1) + square(s.omega2);
    c.x_dot = vertical2 * s.omega1 - vertical1 * s.omega2;
    c.d = along - c.a * c.x0;
    c.e = along + c.a * c.y0;
    c.gamma = transverse - c.beta * c.x0;
    c.p0 = square(c.x_dot);
    c.p1 = (c.y0 - c.x0) * transverse + c.x0 * c.y0 * c.beta - 2 * c.a * along;
    c.p2 = (c.y0 - c.x0) * c.beta - transverse - square(c.a);
    c.x1 = c.x2 = c.x0;
    c.y1 = c.y2 = c.y0;
    if (c.p0 == 0 && c.p1 == 0) {
        c.steady = true;
        c.unstable = c.p2 > 0;
        return c;
    }

    // P divided by x1 − x0 − w leaves β w² + c1 w + c0, whose root nearer to zero is x2.
    c.above = distance_to_upper_root(c);
    const WideDouble c0 = c.above == 0 ? WideDouble(-c.p1) : WideDouble(c.p0 / c.above);
    const WideDouble c1 =
        c.above == 0 ? WideDouble(-c.p2)
                     : less_cancelled(c.beta * c.above, c.p2, c.p1 / c.above, -c0 / c.above);
    WideDouble discriminant = square(c1) - 4 * c.beta * c0;
    if (discriminant < 0) discriminant = 0;
    c.below = c0 == 0 ? WideDouble(0) : WideDouble(2 * c0 / (c1 + sqrt(discriminant)));
    c.delta = c.above + c.below;
    c.x1 = c.x0 + c.above;
    c.y2 = c.y0 + c.below;

    // Viète: β x2 and G have the product β d²/x1 and a known difference; both are sums of
    // positives.
    const WideDouble M = square(c.d) / c.x1;
    const WideDouble h = (2 * (c.gamma - c.a * c.d) - M) / c.x1;
    const WideDouble larger = (abs(h) + sqrt(square(h) + 4 * c.beta * M)) / 2;
    const WideDouble smaller = larger == 0 ? WideDouble(0) : WideDouble(c.beta * M / larger);
    c.G = h >= 0 ? larger : smaller;
    c.X = h >= 0 ? smaller : larger;
    c.x2 = h < 0 ? WideDouble(c.X / c.beta) : (c.G == 0 ? WideDouble(0) : WideDouble(M / c.G));
    c.y1 = square(c.e) / (c.y2 * (2 * c.beta + c.G));
    return c;
}

}  // namespace poinsot::top_setup
