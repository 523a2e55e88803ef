// JSON output. The tests of the commands parse their output with Python.
#include "text/json_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace poinsot {
namespace {

TEST(Json, ObjectsKeepOrderOnOneOrSeveralLines) {
    JsonObject object;
    object.add("name", "a\"b").add("n", std::int64_t{3}).add("is", true).add("x", 0.1);
    object.json("size", json_numbers(1920, 1080.5));
    EXPECT_EQ(object.line(),
              R"({"name": "a\"b", "n": 3, "is": true, "x": 0.1, "size": [1920, 1080.5]})");
    EXPECT_EQ(object.lines(),
              "{\n  \"name\": \"a\\\"b\",\n  \"n\": 3,\n  \"is\": true,\n  \"x\": 0.1,\n"
              "  \"size\": [1920, 1080.5]\n}\n");
    EXPECT_EQ(JsonObject().line(), "{}");
}

TEST(Json, ListsHaveOneValuePerLine) {
    const std::vector<std::string> values{"1", "{}"};
    EXPECT_EQ(json_list(values), "[1, {}]");
    EXPECT_EQ(json_lines(values), "[\n  1,\n  {}\n]");
    EXPECT_EQ(json_lines(values, 2), "[\n    1,\n    {}\n  ]");
    EXPECT_EQ(json_lines({}), "[]");
}

TEST(Json, NonFiniteNumbersAreNull) {
    EXPECT_EQ(json_number(0.1), "0.1");
    EXPECT_EQ(json_number(std::numeric_limits<double>::infinity()), "null");
    EXPECT_EQ(json_number(std::numeric_limits<double>::quiet_NaN()), "null");
}

}  // namespace
}  // namespace poinsot
