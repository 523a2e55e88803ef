// Decimals at random, among them the middles of two doubles and their neighbours; and their nearest
// doubles by GMP and MPFR, which share no line with the program.
#pragma once

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace poinsot::testing {

// A rational number of GMP.
class Exact {
 public:
    Exact() { mpq_init(value_); }
    Exact(const Exact& other) : Exact() { mpq_set(value_, other.value_); }
    Exact(std::int64_t whole) : Exact() { mpq_set_si(value_, whole, 1); }
    Exact& operator=(const Exact& other) {
        mpq_set(value_, other.value_);
        return *this;
    }
    ~Exact() { mpq_clear(value_); }

    // Of "-12.5e-3", split by hand: digits over a power of ten.
    static Exact of_decimal(const std::string& text) {
        const std::size_t e = std::min(text.find_first_of("eE"), text.size());
        long exponent = e < text.size() ? std::stol(text.substr(e + 1)) : 0;
        std::string digits = text.substr(0, e);
        if (const std::size_t point = digits.find('.'); point != std::string::npos) {
            exponent -= static_cast<long>(digits.size() - point - 1);
            digits.erase(point, 1);
        }
        Exact number, power;
        mpz_set_str(mpq_numref(number.value_), digits.c_str(), 10);
        mpz_ui_pow_ui(mpq_numref(power.value_), 10, static_cast<unsigned long>(std::abs(exponent)));
        return exponent < 0 ? number / power : number * power;
    }

    friend Exact operator+(const Exact& a, const Exact& b) { return combined(mpq_add, a, b); }
    friend Exact operator-(const Exact& a, const Exact& b) { return combined(mpq_sub, a, b); }
    friend Exact operator*(const Exact& a, const Exact& b) { return combined(mpq_mul, a, b); }
    friend Exact operator/(const Exact& a, const Exact& b) { return combined(mpq_div, a, b); }

    bool is_zero() const { return mpq_sgn(value_) == 0; }

    // The nearest double to this times π^power.
    double nearest(int power_of_pi = 0) const {
        mpfr_t wide;
        mpfr_init2(wide, 4000);
        int inexact = 0;
        if (power_of_pi != 0) {
            mpfr_const_pi(wide, MPFR_RNDN);
            mpfr_pow_si(wide, wide, power_of_pi, MPFR_RNDN);
            mpfr_mul_q(wide, wide, value_, MPFR_RNDN);
        }
        const Double range;
        mpfr_t number;
        mpfr_init2(number, 53);
        inexact = power_of_pi != 0 ? mpfr_set(number, wide, MPFR_RNDN)
                                   : mpfr_set_q(number, value_, MPFR_RNDN);
        inexact = mpfr_check_range(number, inexact, MPFR_RNDN);
        mpfr_subnormalize(number, inexact, MPFR_RNDN);
        const double value = mpfr_get_d(number, MPFR_RNDN);
        mpfr_clears(wide, number, nullptr);
        return value;
    }

    // MPFR with double's exponents while it lives.
    class Double {
     public:
        Double() {
            mpfr_set_emin(-1073);
            mpfr_set_emax(1024);
        }
        ~Double() {
            mpfr_set_emin(emin_);
            mpfr_set_emax(emax_);
        }

     private:
        mpfr_exp_t emin_ = mpfr_get_emin(), emax_ = mpfr_get_emax();
    };

 private:
    template <typename Operation>
    static Exact combined(Operation operation, const Exact& a, const Exact& b) {
        Exact result;
        operation(result.value_, a.value_, b.value_);
        return result;
    }
    mpq_t value_;
};

// A decimal's nearest double as MPFR reads its text.
inline double read_by_mpfr(const std::string& text) {
    const Exact::Double range;
    mpfr_t number;
    mpfr_init2(number, 53);
    const int inexact = mpfr_strtofr(number, text.c_str(), nullptr, 10, MPFR_RNDN);
    mpfr_subnormalize(number, inexact, MPFR_RNDN);
    const double value = mpfr_get_d(number, MPFR_RNDN);
    mpfr_clear(number);
    return value;
}

class RandomDecimals {
 public:
    explicit RandomDecimals(std::uint64_t seed) : random_(seed) {}

    std::int64_t between(std::int64_t least, std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(least, most)(random_);
    }

    // 1 to 40 digits, a point anywhere among them, and a power of ten in half of them.
    std::string any(int most_exponent) {
        const auto n = static_cast<std::size_t>(between(1, 40));
        std::string digits;
        for (std::size_t i = 0; i < n; ++i)
            digits += static_cast<char>('0' + between(i == 0 ? 1 : 0, 9));
        const auto point = static_cast<std::size_t>(between(0, static_cast<std::int64_t>(n)));
        std::string text = digits.substr(0, point) + "." + digits.substr(point);
        if (point == 0) text = "0" + text;
        if (point == n) text.pop_back();
        const std::int64_t exponent = between(-most_exponent, most_exponent);
        if (exponent % 2 == 0) text += "e" + std::to_string(exponent);
        return (between(0, 1) == 0 ? "" : "-") + text;
    }

    // The middle of two neighbouring doubles, all its digits; or a decimal a little to one side.
    std::string near_a_middle(double size) {
        const double low = std::abs(size), high = std::nextafter(low, HUGE_VAL);
        mpfr_t middle, half;
        mpfr_init2(middle, 1200);
        mpfr_init2(half, 1200);
        mpfr_set_d(middle, low, MPFR_RNDN);
        mpfr_set_d(half, high, MPFR_RNDN);
        mpfr_add(middle, middle, half, MPFR_RNDN);
        mpfr_div_2ui(middle, middle, 1, MPFR_RNDN);
        char* written = nullptr;
        // No middle has more than 768 digits.
        mpfr_asprintf(&written, "%.800Re", middle);
        std::string text = written;
        mpfr_free_str(written);
        mpfr_clears(middle, half, nullptr);
        std::string exponent = text.substr(text.find('e'));
        std::string digits = text.substr(0, text.find('e'));
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.') digits += '0';
        switch (between(0, 2)) {
            case 0:
                break;
            case 1:
                digits += std::string(static_cast<std::size_t>(between(0, 12)), '0') + "1";
                break;
            default:
                if (digits.back() == '0') break;
                --digits.back();
                digits += std::string(static_cast<std::size_t>(between(1, 12)), '9');
        }
        return (between(0, 1) == 0 ? "" : "-") + digits + exponent;
    }

    // Any finite double but 0, subnormal ones as well.
    double any_double() {
        while (true) {
            const double value = std::bit_cast<double>(random_());
            if (std::isfinite(value) && value != 0.0 &&
                std::abs(value) < std::numeric_limits<double>::max())
                return value;
        }
    }

    // One from 1e-6 to 1e18.
    double ordinary_double() {
        return std::ldexp(1.0 + std::ldexp(static_cast<double>(random_() >> 12), -52),
                          static_cast<int>(between(-20, 60)));
    }

 private:
    std::mt19937_64 random_;
};

}  // namespace poinsot::testing
