// What a key takes, in words and at its edges.
#include "scene/value_type.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numbers>

namespace poinsot {

namespace {

using Kind = ValueType::Kind;

TEST(ValueType, BoundsAreWrittenAsPeopleWriteThem) {
    EXPECT_EQ(bound_text(0.0), "0");
    EXPECT_EQ(bound_text(0.25), "0.25");
    EXPECT_EQ(bound_text(-36000.0), "-36000");
    EXPECT_EQ(bound_text(10000.0), "10000");
    EXPECT_EQ(bound_text(65536.0), "65536");
    EXPECT_EQ(bound_text(1e5), "1e5");
    EXPECT_EQ(bound_text(1e12), "1e12");
    EXPECT_EQ(bound_text(1.5e6), "1500000");
    EXPECT_EQ(bound_text(1e-6), "1e-6");
    EXPECT_EQ(bound_text(1e-12), "1e-12");
    EXPECT_EQ(bound_text(1e-300), "1e-300");
    EXPECT_EQ(bound_text(std::numbers::pi), "3.141592653589793");
}

TEST(ValueType, BoundsHoldAtTheirEdges) {
    const double least = std::numeric_limits<double>::denorm_min();
    EXPECT_TRUE(positive.hold(least));
    EXPECT_FALSE(positive.hold(0.0));
    EXPECT_FALSE(positive.hold(-0.0));
    EXPECT_TRUE(within(0.0, 1.0).hold(-0.0));
    EXPECT_TRUE(within(0.0, 1.0).hold(1.0));
    EXPECT_FALSE(within(0.0, 1.0).hold(-least));
    EXPECT_FALSE(within(0.0, 1.0).hold(1.0 + std::numeric_limits<double>::epsilon()));
    EXPECT_TRUE(no_bounds.hold(-std::numeric_limits<double>::max()));
    EXPECT_EQ(no_bounds.words(), "");
    EXPECT_EQ(positive.words(), " greater than 0");
    EXPECT_EQ(within(1e-6, 100.0).words(), " from 1e-6 to 100");
}

TEST(ValueType, SaysInWordsWhatItTakes) {
    constexpr std::array<std::string_view, 3> names{"pale", "dashed", "omitted"};
    EXPECT_EQ((ValueType{.kind = Kind::boolean}).words(), "true or false");
    EXPECT_EQ((ValueType{.kind = Kind::text}).words(), "a string");
    EXPECT_EQ((ValueType{.kind = Kind::text, .names = names}).words(),
              R"("pale", "dashed" or "omitted")");
    EXPECT_EQ((ValueType{.kind = Kind::text, .list = "views"}).words(),
              "a name in `poinsot list views`");
    EXPECT_EQ(
        (ValueType{.kind = Kind::text, .list = "elements", .size = ValueType::Size{}}).words(),
        "a list of names in `poinsot list elements`");
    EXPECT_EQ((ValueType{.kind = Kind::text, .size = ValueType::Size{}}).words(),
              "a list of strings");
    EXPECT_EQ((ValueType{.kind = Kind::integer, .bounds = within(1, 64)}).words(),
              "an integer from 1 to 64");
    EXPECT_EQ((ValueType{.kind = Kind::number, .bounds = positive, .unit = "s"}).words(),
              "a positive number in s");
    EXPECT_EQ((ValueType{.kind = Kind::number,
                         .bounds = positive,
                         .unit = "kg m²",
                         .size = ValueType::Size{3, 3}})
                  .words(),
              "three positive numbers in kg m²");
    EXPECT_EQ((ValueType{.kind = Kind::number, .size = ValueType::Size{3, 3}, .n_rows = 3}).words(),
              "three rows of three numbers");
    EXPECT_EQ(
        (ValueType{
             .kind = Kind::number, .size = ValueType::Size{4, 4}, .names_of_values = "w, x, y, z"})
            .words(),
        "four numbers w, x, y, z");
    EXPECT_EQ((ValueType{.kind = Kind::number, .bounds = positive, .size = ValueType::Size{1, 64}})
                  .words(),
              "a list of 1 to 64 positive numbers");
    EXPECT_EQ((ValueType{.kind = Kind::integer,
                         .bounds = within(1, 65536),
                         .unit = "pixels",
                         .size = ValueType::Size{2, 2},
                         .or_text = "a string"})
                  .words(),
              "two integers from 1 to 65536 in pixels or a string");
}

}  // namespace

}  // namespace poinsot
