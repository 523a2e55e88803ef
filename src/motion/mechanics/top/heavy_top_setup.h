// The setup of Lagrange's top in wide double-double arithmetic: from the cubic's roots to periods,
// nomes and phase rates. The symbols are those of heavy_top_cubic.h.
#pragma once

#include "mechanics/top/heavy_top.h"
#include "mechanics/top/heavy_top_cubic.h"

namespace poinsot {

// Fills a HeavyTop, as its friend.
struct TopSetup {
    HeavyTop& top;
    top_setup::Cubic cubic{};
    WideDouble half_spin = 0;           // (ω3 − a)/2
    WideDouble angle_rate[2] = {0, 0};  // mean rates of φ+ψ and φ−ψ
    WideDouble lambda = 0, quarter = 0;
    WideDouble regular_rate = 0;  // of both factors

    explicit TopSetup(HeavyTop& filled) : top(filled) {}

    // Takes rates in rad/s, and computes with them in units of 2^n rad/s near the fastest.
    void solve(const top_setup::TopAtStart& given);

 private:
    void fill_steady(TopSeries& series);
    void fill_nutating(TopSeries& series);
    void set_rate(TopFactor& factor, int which, const WideDouble& regular);
    void fill_amplitudes(TopSeries& series, const WideDouble& k_prime) const;
    void fill_public(const top_setup::TopAtStart& given);
    void fill_nutation();
};

}  // namespace poinsot
