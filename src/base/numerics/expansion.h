// Exact sums and products of doubles (Shewchuk's expansions), for the sign and size of a difference
// that cancels.
#pragma once

#include <array>
#include <cassert>

#include "numerics/double_double.h"

namespace poinsot {

// A number as an exact sum of doubles that do not overlap, in order of increasing size. Exact
// unless an operation underflows or overflows. Source: Shewchuk, Discrete Comput. Geom. 18 (1997)
// 305.
class Expansion {
 public:
    explicit Expansion(double value) { append(value); }

    // this + value (Grow-Expansion).
    Expansion plus(double value) const {
        Expansion sum;
        double carry = value;
        for (int i = 0; i < size_; ++i) {
            const DoubleDouble step = two_sum(carry, terms_[i]);
            sum.append(step.lo);
            carry = step.hi;
        }
        sum.append(carry);
        return sum;
    }
    Expansion plus(const Expansion& other) const {
        Expansion sum = *this;
        for (int i = 0; i < other.size_; ++i) sum = sum.plus(other.terms_[i]);
        return sum;
    }
    // this · factor, term by term.
    Expansion times(double factor) const {
        Expansion product;
        for (int i = 0; i < size_; ++i) {
            const DoubleDouble step = two_product(terms_[i], factor);
            product = product.plus(step.lo).plus(step.hi);
        }
        return product;
    }
    Expansion times(DoubleDouble factor) const { return times(factor.lo).plus(times(factor.hi)); }

    // The value to double-double's precision; exactly zero if the value is zero.
    DoubleDouble value() const {
        DoubleDouble sum;
        for (int i = 0; i < size_; ++i) sum = sum + terms_[i];
        return sum;
    }

 private:
    Expansion() = default;
    void append(double term) {
        if (term == 0.0) return;
        assert(size_ < static_cast<int>(terms_.size()));
        terms_[size_++] = term;
    }

    std::array<double, 64> terms_{};
    int size_ = 0;
};

}  // namespace poinsot
