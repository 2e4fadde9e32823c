#include "geometry/two_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/random_mesh.h"

namespace pectin {
namespace {

// Counts around the size of a piece, on one thread and on several.
TEST(TwoGroups, AreNumberedInAscendingOrderTheFirstGroupBeforeTheSecond) {
    constexpr std::uint64_t kSeed = 91;
    test::Random random(kSeed);
    for (const std::uint32_t count :
         {0u, 1u, 100u, kPiece - 1, kPiece, kPiece + 1, 7 * kPiece + 5}) {
        std::vector<Group> groups(count);
        for (Group& group : groups) group = static_cast<Group>(random.integer(0, 2));
        std::vector<std::uint32_t> expected;
        for (const Group wanted : {Group::first, Group::second}) {
            for (std::uint32_t i = 0; i < count; ++i) {
                if (groups[i] == wanted) expected.push_back(i);
            }
        }
        const TwoGroups numbered(count, [&](std::uint32_t i) { return groups[i]; });
        ASSERT_EQ(numbered.size(), expected.size()) << "seed " << kSeed << ", count " << count;
        EXPECT_EQ(numbered.size_of_first(), std::ranges::count(groups, Group::first));
        std::vector<std::uint32_t> found(numbered.size());
        numbered.for_each([&](std::uint32_t i, std::uint32_t number) { found[number] = i; });
        EXPECT_EQ(found, expected) << "seed " << kSeed << ", count " << count;
    }
}

}  // namespace
}  // namespace pectin
