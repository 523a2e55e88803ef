#include "numerics/three_gaps.h"

#include <algorithm>
#include <cmath>

namespace poinsot {

std::optional<double> marks_until_gap(double alpha, double gap) {
    constexpr double most = 9007199254740992.0;  // 2^53
    // The nearest marks on either side of the first one, and which they are: of n_right + n_left
    // marks the gaps have these two lengths.
    double right = alpha - std::floor(alpha), left = 1.0 - right;
    double n_right = 1.0, n_left = 1.0;
    // The two lengths are rests of Euclid's algorithm, so that the marks multiply from step to
    // step. NaN ends it.
    while (std::max(right, left) > gap) {
        double& longer = right > left ? right : left;
        double& n_longer = right > left ? n_right : n_left;
        const double shorter = std::min(right, left);
        const double n_shorter = right > left ? n_left : n_right;
        if (!(shorter > 0.0)) return std::nullopt;
        // Each further mark cuts the shorter gap off the longer one.
        const double n_cuts = std::max(
            1.0, std::min(std::floor(longer / shorter), std::ceil((longer - gap) / shorter)));
        longer = std::max(0.0, longer - n_cuts * shorter);
        n_longer += n_cuts * n_shorter;
        if (n_right + n_left > most) return std::nullopt;
    }
    return n_right + n_left;
}

std::optional<std::int64_t> returning_mark(
    double alpha, std::int64_t most,
    const std::function<bool(std::int64_t k, double distance)>& accept) {
    double rest = alpha - std::floor(alpha);
    std::int64_t before = 0, k = 1;
    // Denominators of convergents grow at least as Fibonacci's numbers; NaN ends at `rest`.
    while (k <= most) {
        const double distance = std::abs(std::remainder(static_cast<double>(k) * alpha, 1.0));
        if (accept(k, distance)) return k;
        if (!(rest > 0.0)) return std::nullopt;
        const double quotient = std::floor(1.0 / rest);
        if (!(quotient < static_cast<double>(most))) return std::nullopt;
        rest = 1.0 / rest - quotient;
        const std::int64_t next = static_cast<std::int64_t>(quotient) * k + before;
        before = k;
        k = next;
    }
    return std::nullopt;
}

}  // namespace poinsot
