// Numbers of scene files and of --set, compared with MPFR.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene/toml_document.h"
#include "text/random_decimals.h"

namespace poinsot::testing::decimals_tests {
namespace {

TEST(SceneNumbers, AreTheNearestDoubles) {
    RandomDecimals random(39);
    int n_in_files = 0;
    for (int i = 0; i < 30'000; ++i) {
        const std::string text = i % 3 == 0   ? random.near_a_middle(random.ordinary_double())
                                 : i % 3 == 1 ? random.any(320)
                                              : random.any(3);
        const double right = read_by_mpfr(text);
        if (!std::isfinite(right)) continue;
        ASSERT_EQ(parse_override_value(text, {}).number, right) << text;
        // toml++ accepts integers of 64 bits, and 128 characters.
        if (text.find_first_of(".e") == std::string::npos || text.size() > 120) continue;
        ++n_in_files;
        ASSERT_EQ(parse_toml("value = " + text, "a.toml").entries.at(0).value.number, right)
            << text;
    }
    EXPECT_GT(n_in_files, 20'000);
    EXPECT_EQ(parse_toml("value = 9007199254740993", "a.toml").entries.at(0).value.number,
              9007199254740992.0);
}

}  // namespace
}  // namespace poinsot::testing::decimals_tests
