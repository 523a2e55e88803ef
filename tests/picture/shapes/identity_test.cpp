// Ids of geometry and masks are unique in a process.
#include "shapes/identity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

namespace poinsot {
namespace {

TEST(Identity, IsUniqueAcrossThreads) {
    constexpr std::size_t each = 20'000;
    std::array<std::vector<std::uint64_t>, 4> taken;
    {
        std::vector<std::jthread> threads;
        threads.reserve(taken.size());
        for (auto& numbers : taken)
            threads.emplace_back([&numbers] {
                numbers.reserve(each);
                for (std::size_t i = 0; i < each; ++i) numbers.push_back(next_identity());
            });
    }
    std::vector<std::uint64_t> all;
    for (const auto& numbers : taken) all.insert(all.end(), numbers.begin(), numbers.end());
    std::sort(all.begin(), all.end());
    EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
    EXPECT_EQ(all.size(), taken.size() * each);
    EXPECT_GT(all.front(), 0u);
}

}  // namespace
}  // namespace poinsot
