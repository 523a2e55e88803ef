#include "mechanics/top/heavy_top_regime.h"

namespace poinsot {

namespace top_setup {

TopRegime regime_of(const Cubic& c) {
    const WideDouble tolerance = 1e-12;
    if (c.beta == 0) return TopRegime::no_gravity;
    if (c.steady && c.x0 == 0) {
        return c.unstable ? TopRegime::sleeping_unstable : TopRegime::sleeping;
    }
    if (c.steady && c.y0 == 0) return TopRegime::hanging;
    if (!c.steady && c.X + c.G == 0) return TopRegime::separatrix;
    if (c.a == 0 && c.d == 0) return TopRegime::planar_pendulum;
    if (c.steady || c.delta < tolerance * c.x1 * c.y2) {
        // The two precessions of this θ have the product β/(2 cos θ); without a real second
        // one, below the horizontal, the one with the sense of slow precession has φ' a > 0.
        const WideDouble cosine = (c.y0 - c.x0) / 2;
        const WideDouble precession = (c.d + c.a * c.x0) / (c.x0 * c.y0);
        const bool slow = 2 * square(precession) * abs(cosine) <= c.beta;
        return slow ? TopRegime::steady_slow : TopRegime::steady_fast;
    }
    if (c.x2 == 0 || c.y1 == 0) return TopRegime::through_vertical;
    const WideDouble at_upper = c.d + c.a * c.x2;
    const WideDouble at_lower = c.d + c.a * c.x1;
    if (abs(at_upper) <= tolerance * (abs(c.d) + abs(c.a) * c.x2)) return TopRegime::cusp;
    return sign_of(at_upper) == sign_of(at_lower) ? TopRegime::wavy : TopRegime::looping;
}

}  // namespace top_setup

std::string_view name_of(TopRegime regime) {
    switch (regime) {
        case TopRegime::sleeping:
            return "sleeping";
        case TopRegime::sleeping_unstable:
            return "sleeping, unstable";
        case TopRegime::hanging:
            return "hanging";
        case TopRegime::steady_slow:
            return "steady precession, slow";
        case TopRegime::steady_fast:
            return "steady precession, fast";
        case TopRegime::wavy:
            return "wavy nutation";
        case TopRegime::cusp:
            return "cuspidal nutation";
        case TopRegime::looping:
            return "looping nutation";
        case TopRegime::through_vertical:
            return "through the vertical";
        case TopRegime::planar_pendulum:
            return "planar pendulum";
        case TopRegime::separatrix:
            return "separatrix";
        case TopRegime::no_gravity:
            return "without gravity";
    }
    return "";
}

}  // namespace poinsot
