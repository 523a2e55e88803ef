// Which options an output can have, and what is made before anything is drawn.
#include "orders/film.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>

#include "error/error.h"
#include "refusal.h"

namespace poinsot {
namespace {

// Options of a film, as the guide has them.
const std::pair<std::string, std::function<void(FilmOrder&)>> options[] = {
    {"frames",
     [](FilmOrder& order) {
         order.frames = {0, 9};
     }},
    {"part",
     [](FilmOrder& order) {
         order.part = {1, 2};
     }},
    {"jobs", [](FilmOrder& order) { order.n_jobs = 2; }},
    {"certify", [](FilmOrder& order) { order.certify = true; }},
};

std::set<std::string> refused_of(const FilmOrder& order) {
    std::set<std::string> refused;
    for (const auto& [name, give] : options) {
        FilmOrder given = order;
        give(given);
        const std::string message = refusal_message([&] { check_order(given); });
        if (message.empty()) continue;
        EXPECT_TRUE(message.ends_with("; leave --" + name + " out")) << message;
        refused.insert(name);
    }
    return refused;
}

TEST(FilmOrder, FitsItsOutput) {
    const std::set<std::string> none, frames{"frames", "part"};
    const std::set<std::string> all{"certify", "frames", "jobs", "part"};
    for (const std::string film : {"", "a.mp4", "a.webm", "a.gif", "a.mov", "f_####.png"})
        EXPECT_EQ(refused_of({.output = film}), none) << film;
    EXPECT_EQ(refused_of({.output = "a.HTML"}), all);
    EXPECT_EQ(refused_of({.output = "a.pptx"}), frames);
    EXPECT_EQ(refused_of({.slides = "deck"}), frames);
    EXPECT_EQ(refusal_message([] { check_order({.output = "a.mp4", .slides = "deck"}); }),
              "--slides writes a film for each stop into its folder; leave --output out");
}

TEST(FilmOrder, HasPossibleNumbers) {
    for (const int n : {0, -1, 4097})
        EXPECT_NE(refusal_message([n] { check_order({.n_jobs = n}); }), "") << n;
    for (const int n : {1, 4096}) EXPECT_NO_THROW(check_order({.n_jobs = n})) << n;
    EXPECT_NE(refusal_message([] { check_order({.part = {{1, 2}}, .n_jobs = 2}); }), "");
    EXPECT_NO_THROW(check_order({.part = {{1, 2}}, .n_jobs = 1}));
    using Range = std::pair<std::int64_t, std::int64_t>;
    for (const Range& range : {Range{-1, 3}, Range{3, 2}})
        EXPECT_EQ(refusal_message([&] { check_order({.frames = range}); }),
                  "--frames " + std::to_string(range.first) + " to " +
                      std::to_string(range.second) +
                      ": not a range of frames; give the first and the last one, from 0");
}

}  // namespace
}  // namespace poinsot
