// Marks at k·α, k = 0, 1, 2, …, on a circle of circumference 1: after how many marks two are close
// to each other, and after how many no large gap is left. Source: Sós, Ann. Univ. Sci. Budapest 1
// (1958) 127: the gaps between n such marks have at most three lengths.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace poinsot {

// How many marks it takes until no gap between neighbours is longer than `gap`. None where α is a
// fraction whose marks never do, or would take more than 2^53. Precondition: gap > 0.
std::optional<double> marks_until_gap(double alpha, double gap);

// The least k ≥ 1, among the denominators of α's continued fraction up to `most`, whose mark
// `accept(k, distance)` takes; `distance` is that of the mark from the first one, 0 … 1/2.
std::optional<std::int64_t> returning_mark(
    double alpha, std::int64_t most,
    const std::function<bool(std::int64_t k, double distance)>& accept);

}  // namespace poinsot
