// The elementary functions are accurate, exact where the result is a double, bit-identical on every
// processor, and override glibc's in every loaded library.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "places.h"

namespace poinsot {
namespace {

using Function = double (*)(double);
using Reference = int (*)(mpfr_t, const mpfr_t, mpfr_rnd_t);

struct Row {
    const char* name;
    Function function;
    Reference reference;
    double from, to;  // arguments, uniform
};

const std::vector<Row>& rows() {
    static const std::vector<Row> table{
        {"sin", ::sin, mpfr_sin, -1e3, 1e3},         {"sin, far", ::sin, mpfr_sin, -1e15, 1e15},
        {"cos", ::cos, mpfr_cos, -1e3, 1e3},         {"tan", ::tan, mpfr_tan, -1.5, 1.5},
        {"asin", ::asin, mpfr_asin, -1, 1},          {"acos", ::acos, mpfr_acos, -1, 1},
        {"atan", ::atan, mpfr_atan, -1e3, 1e3},      {"sinh", ::sinh, mpfr_sinh, -700, 700},
        {"cosh", ::cosh, mpfr_cosh, -700, 700},      {"tanh", ::tanh, mpfr_tanh, -20, 20},
        {"asinh", ::asinh, mpfr_asinh, -1e3, 1e3},   {"acosh", ::acosh, mpfr_acosh, 1, 1e3},
        {"atanh", ::atanh, mpfr_atanh, -0.99, 0.99}, {"exp", ::exp, mpfr_exp, -700, 700},
        {"exp2", ::exp2, mpfr_exp2, -1000, 1000},    {"expm1", ::expm1, mpfr_expm1, -1, 1},
        {"log", ::log, mpfr_log, 1e-3, 1e3},         {"log2", ::log2, mpfr_log2, 1e-3, 1e3},
        {"log1p", ::log1p, mpfr_log1p, -0.9, 10}};
    return table;
}

std::vector<double> arguments(const Row& row, int n) {
    // mt19937_64 is specified bit by bit; the distributions of the standard library are not.
    std::mt19937_64 random(20261121);
    std::vector<double> values;
    for (int i = 0; i < n; ++i) {
        const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
        values.push_back(row.from + (row.to - row.from) * share);
    }
    return values;
}

// Error in units in the last place of the correctly rounded result.
double error_ulp(const Row& row, double x) {
    mpfr_t argument, result;
    mpfr_init2(argument, 53);
    mpfr_init2(result, 200);
    mpfr_set_d(argument, x, MPFR_RNDN);
    row.reference(result, argument, MPFR_RNDN);
    const double rounded = mpfr_get_d(result, MPFR_RNDN);
    mpfr_sub_d(result, result, row.function(x), MPFR_RNDN);
    const double magnitude = std::abs(rounded);
    const double ulp = std::nextafter(magnitude, INFINITY) - magnitude;
    const double error = std::abs(mpfr_get_d(result, MPFR_RNDN)) / ulp;
    mpfr_clear(argument);
    mpfr_clear(result);
    return error;
}

TEST(ElementaryFunctions, AreWithinOneUlp) {
    for (const Row& row : rows()) {
        double worst = 0.0;
        for (const double x : arguments(row, 3000)) worst = std::max(worst, error_ulp(row, x));
        RecordProperty(row.name, std::to_string(worst));
        EXPECT_LE(worst, 1.0) << row.name;  // SLEEF's stated bound
    }
}

// Chart ticks and powers of lengths rely on this.
TEST(ElementaryFunctions, AreExactWhereTheResultIsADouble) {
    double ten = 1.0;
    for (int n = 0; n <= 22; ++n, ten *= 10.0) EXPECT_EQ(::pow(10.0, n), ten) << n;
    for (int n = -1022; n <= 1023; ++n) {
        EXPECT_EQ(::exp2(n), std::ldexp(1.0, n)) << n;
        EXPECT_EQ(::log2(std::ldexp(1.0, n)), n) << n;
    }
    for (double x = 1.0; x <= 1000.0; x += 1.0) {
        EXPECT_EQ(::pow(x, 2.0), x * x) << x;
        EXPECT_EQ(::pow(x * x, 0.5), x) << x;
    }
    EXPECT_EQ(::sin(0.0), 0.0);
    EXPECT_EQ(::cos(0.0), 1.0);
    EXPECT_EQ(::exp(0.0), 1.0);
    EXPECT_EQ(::log(1.0), 0.0);
}

TEST(ElementaryFunctions, FollowTheStandardAtSpecialValues) {
    constexpr double infinity = INFINITY;
    EXPECT_TRUE(std::isnan(::sin(infinity)));
    EXPECT_EQ(::exp(-infinity), 0.0);
    EXPECT_EQ(::exp(1000.0), infinity);
    EXPECT_EQ(::log(0.0), -infinity);
    EXPECT_TRUE(std::isnan(::log(-1.0)));
    EXPECT_EQ(::pow(0.0, 0.0), 1.0);
    EXPECT_EQ(::pow(-2.0, 3.0), -8.0);
    EXPECT_TRUE(std::isnan(::pow(-2.0, 0.5)));
    EXPECT_EQ(::atan2(0.0, -1.0), M_PI);
    EXPECT_EQ(::atan2(-0.0, -1.0), -M_PI);
    EXPECT_EQ(::atan2(1.0, 0.0), M_PI / 2);
    EXPECT_TRUE(std::signbit(::sin(-0.0)));
}

// FNV-1a over the bits of every result. The processor sweep runs this test on five emulated
// processors.
TEST(ElementaryFunctions, HaveTheSameBitsOnEveryProcessor) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto add = [&hash](double value) {
        for (auto bits = std::bit_cast<std::uint64_t>(value), i = std::uint64_t{0}; i < 8; ++i) {
            hash = (hash ^ (bits >> 8 * i & 0xffU)) * 0x100000001b3U;
        }
    };
    for (const Row& row : rows()) {
        for (const double x : arguments(row, 5000)) {
            add(row.function(x));
            add(::pow(std::abs(x), 0.3));
            add(::atan2(x, 0.7));
            add(static_cast<double>(::powf(static_cast<float>(std::abs(x)), 0.7F)));
        }
    }
    EXPECT_EQ(hash, 8350898747473725707U);
}

// The compiler may merge sin and cos into sincos. Here it cannot: the volatile pointers hide the
// callee.
TEST(ElementaryFunctions, SincosEqualsSinAndCos) {
    double (*volatile sin_alone)(double) = ::sin;
    double (*volatile cos_alone)(double) = ::cos;
    float (*volatile sinf_alone)(float) = ::sinf;
    float (*volatile cosf_alone)(float) = ::cosf;
    for (const double x : arguments({"", nullptr, nullptr, -1e3, 1e3}, 100'000)) {
        double sine = 0.0, cosine = 0.0;
        ::sincos(x, &sine, &cosine);
        ASSERT_EQ(sine, sin_alone(x)) << x;
        ASSERT_EQ(cosine, cos_alone(x)) << x;
        const auto y = static_cast<float>(x);
        float sine_f = 0.0F, cosine_f = 0.0F;
        ::sincosf(y, &sine_f, &cosine_f);
        ASSERT_EQ(sine_f, sinf_alone(y)) << y;
        ASSERT_EQ(cosine_f, cosf_alone(y)) << y;
    }
}

TEST(ElementaryFunctions, OverrideGlibcInEveryLoadedLibrary) {
    Dl_info here{};
    ASSERT_NE(dladdr(reinterpret_cast<void*>(&rows), &here), 0);
    std::ifstream list(source_folder() / "src/base/libm/exported.txt");
    int n_names = 0;
    for (std::string line; std::getline(list, line);) {
        std::erase_if(line, [](char c) { return c == ' ' || c == ';'; });
        if (line == "{" || line == "}") continue;
        void* const found = dlsym(RTLD_DEFAULT, line.c_str());
        Dl_info where{};
        ASSERT_TRUE(found != nullptr && dladdr(found, &where) != 0) << line;
        EXPECT_STREQ(where.dli_fname, here.dli_fname) << line;
        ++n_names;
    }
    EXPECT_GE(n_names, 28);
}

}  // namespace
}  // namespace poinsot
