#include "numerics/bracketed_root.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace poinsot {

double bracketed_root(const std::function<double(double)>& function, double low, double high) {
    std::uintmax_t n_rounds = 200;
    const auto [a, b] = boost::math::tools::toms748_solve(
        function, low, high, boost::math::tools::eps_tolerance<double>(53), n_rounds);
    return std::abs(function(a)) <= std::abs(function(b)) ? a : b;
}

}  // namespace poinsot
