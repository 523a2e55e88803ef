// The exact free motion stays within its bounds in every family of extremes; accuracy_table tests
// 10,000 bodies per family and prints the results.
#include "mechanics/families.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace poinsot::families {
namespace {

constexpr int n_bodies = 300;

class FreeRotationFamily : public testing::TestWithParam<Family> {};

TEST_P(FreeRotationFamily, StaysWithinBounds) {
    const Residuals r = measure(GetParam(), 0, n_bodies);
    EXPECT_EQ(r.n_not_finite, 0);
    // Measured over 10,000 bodies of all families: see the output of accuracy_table.
    EXPECT_LE(r.omega, GetParam().omega_bound);
    EXPECT_LE(r.attitude_rad, GetParam().attitude_bound);
    EXPECT_LE(r.herpolhode, GetParam().herpolhode_bound);
    EXPECT_TRUE(within_bounds(GetParam(), r)) << "energy " << r.energy << ", momentum "
                                              << r.momentum << ", |q| − 1 " << r.unit_quaternion;
}

std::string test_name(const testing::TestParamInfo<Family>& info) {
    std::string name;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Extremes, FreeRotationFamily,
                         testing::ValuesIn(all().begin(), all().end()), test_name);

}  // namespace
}  // namespace poinsot::families
