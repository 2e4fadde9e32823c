#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "mesh/sort_ids.h"

namespace pectin {
namespace {

// Sizes around the threshold of the radix sort, and ids of one, two and three digits with
// duplicates.
TEST(SortIds, MatchesAComparisonSort) {
    constexpr unsigned kSeed = 7;
    std::mt19937 engine(kSeed);
    for (const std::size_t count : {0u, 1u, 2u, 511u, 512u, 513u, 20'000u}) {
        for (const std::uint32_t most : {0u, 1'000u, 2'047u, 2'048u, 3'000'000u, 0xffffffffu}) {
            std::uniform_int_distribution<std::uint32_t> number(0, most);
            std::vector<EdgeId> ids(count);
            for (EdgeId& id : ids) id = EdgeId{number(engine)};
            if (count > 0) ids.front() = EdgeId{most};
            std::vector<EdgeId> expected = ids;
            std::sort(expected.begin(), expected.end());
            sort_ids(std::span(ids));
            EXPECT_EQ(ids, expected) << count << " ids up to " << most << ", seed " << kSeed;
            sort_ids(std::span(ids));
            EXPECT_EQ(ids, expected);
        }
    }
}

}  // namespace
}  // namespace pectin
