#include "mechanics/top/heavy_top_series.h"

namespace poinsot {

Multiples multiples_of(double cosine, double sine, double curvature) {
    const double double_cos = 1.0 + 2.0 * curvature * sine * sine;
    Multiples m{};
    m.even_cos[0] = 1.0;
    m.odd_cos[0] = cosine;
    m.odd_sin[0] = sine;
    m.even_cos[1] = double_cos;
    m.even_sin[1] = 2.0 * sine * cosine;
    m.odd_cos[1] = 2.0 * double_cos * cosine - cosine;
    m.odd_sin[1] = 2.0 * double_cos * sine + sine;
    for (int n = 2; n < TopFactor::max_terms; ++n) {
        m.even_cos[n] = 2.0 * double_cos * m.even_cos[n - 1] - m.even_cos[n - 2];
        m.even_sin[n] = 2.0 * double_cos * m.even_sin[n - 1] - m.even_sin[n - 2];
        m.odd_cos[n] = 2.0 * double_cos * m.odd_cos[n - 1] - m.odd_cos[n - 2];
        m.odd_sin[n] = 2.0 * double_cos * m.odd_sin[n - 1] - m.odd_sin[n - 2];
    }
    return m;
}

SeriesValue sum_series(const std::array<double, TopFactor::max_terms>& re,
                       const std::array<double, TopFactor::max_terms>& im, const double* cosine,
                       const double* sine, int first, double curvature, int n_terms) {
    SeriesValue sum{};
    for (int n = n_terms - 1; n >= 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        const double multiple = 2.0 * n + first;
        sum.value += std::complex<double>(re[i] * cosine[n], im[i] * sine[n]);
        sum.slope +=
            multiple * std::complex<double>(curvature * re[i] * sine[n], im[i] * cosine[n]);
    }
    return sum;
}

}  // namespace poinsot
