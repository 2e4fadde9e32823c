#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "adapt/refinement_queue.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using Queue = RefinementQueue;

TEST(RefinementQueue, GivesEveryEdgeOnceLongestOctaveFirst) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        Queue queue;
        std::vector<int> waits(60'000, 0);
        const auto push = [&](std::uint32_t e) {
            queue.push(EdgeId{e}, 1000 + e % 3, static_cast<std::size_t>(random.integer(0, 3)));
            waits[e] = 1;
        };
        const auto count = static_cast<std::uint32_t>(random.integer(0, 59'999));
        for (std::uint32_t e = 0; e < count; ++e) push(e);
        while (!queue.is_empty()) {
            const Queue::Entries next = queue.take();
            std::vector<EdgeId> taken;
            for (const auto& lane : next.lanes) taken.insert(taken.end(), lane.begin(), lane.end());
            ASSERT_FALSE(taken.empty());
            for (EdgeId e : taken) {
                EXPECT_EQ(next.octave, 1000 + index(e) % 3);
                EXPECT_EQ(waits[index(e)]--, 1);
            }
            for (std::uint32_t longer = index(taken.front()) % 3 + 1; longer < 3; ++longer) {
                for (std::uint32_t e = longer; e < count; e += 3) ASSERT_EQ(waits[e], 0);
            }
            if (random.chance(0.2)) push(index(taken.front()));
        }
        EXPECT_EQ(std::count(waits.begin(), waits.end(), 0), 60'000);
    }
}

// Each lane goes on where it was, and has a part of the order to itself.
TEST(RefinementQueue, ServesManyInLanesThatLieFarApart) {
    Queue queue;
    const std::uint32_t count = 80'000;
    for (std::uint32_t e = 0; e < count; ++e) queue.push(EdgeId{e}, 1000);
    const Queue::Entries first = queue.take();
    EXPECT_FALSE(first.is_one_lane);
    std::vector<std::uint32_t> begins;
    for (const auto& lane : first.lanes) {
        ASSERT_EQ(lane.size(), kLaneLength);
        begins.push_back(index(lane.front()));
        for (std::size_t i = 0; i < lane.size(); ++i) {
            EXPECT_EQ(index(lane[i]), begins.back() + i);
        }
    }
    const Queue::Entries second = queue.take();
    for (std::size_t i = 0; i < kLanes; ++i) {
        EXPECT_EQ(index(second.lanes[i].front()), begins[i] + kLaneLength);
    }
    std::ranges::sort(begins);
    for (std::size_t i = 1; i < begins.size(); ++i) {
        EXPECT_GE(begins[i] - begins[i - 1], count / (2 * kLanes));
    }
}

TEST(RefinementQueue, ServesFewInTheirOrder) {
    Queue queue;
    for (std::uint32_t e = 0; e < 1500; ++e) queue.push(EdgeId{e}, 1000);
    std::uint32_t expected = 0;
    while (!queue.is_empty()) {
        const Queue::Entries next = queue.take();
        EXPECT_TRUE(next.is_one_lane);
        for (EdgeId e : next.lanes.front()) EXPECT_EQ(index(e), expected++);
    }
    EXPECT_EQ(expected, 1500u);
}

}  // namespace
}  // namespace pectin
