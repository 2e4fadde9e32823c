#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "adapt/refinement_queue.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using Queue = RefinementQueue;

TEST(RefinementQueue, ReturnsEveryEdgeOnceLongestClassFirst) {
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
            const Queue::Batch next = queue.take();
            std::vector<EdgeId> taken;
            for (const auto& partition : next.partitions)
                taken.insert(taken.end(), partition.begin(), partition.end());
            ASSERT_FALSE(taken.empty());
            for (EdgeId e : taken) {
                EXPECT_EQ(next.length_class, 1000 + index(e) % 3);
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

// Each partition continues where its last batch ended, in a part of the order that is its own.
TEST(RefinementQueue, DividesManyEdgesIntoDistantPartitions) {
    Queue queue;
    const std::uint32_t count = 80'000;
    for (std::uint32_t e = 0; e < count; ++e) queue.push(EdgeId{e}, 1000);
    const Queue::Batch first = queue.take();
    EXPECT_FALSE(first.is_serial);
    std::vector<std::uint32_t> begins;
    for (const auto& partition : first.partitions) {
        ASSERT_EQ(partition.size(), kPartitionBatch);
        begins.push_back(index(partition.front()));
        for (std::size_t i = 0; i < partition.size(); ++i) {
            EXPECT_EQ(index(partition[i]), begins.back() + i);
        }
    }
    const Queue::Batch second = queue.take();
    for (std::size_t i = 0; i < kPartitions; ++i) {
        EXPECT_EQ(index(second.partitions[i].front()), begins[i] + kPartitionBatch);
    }
    std::ranges::sort(begins);
    for (std::size_t i = 1; i < begins.size(); ++i) {
        EXPECT_GE(begins[i] - begins[i - 1], count / (2 * kPartitions));
    }
}

TEST(RefinementQueue, ReturnsFewEdgesInTheirOrder) {
    Queue queue;
    for (std::uint32_t e = 0; e < 1500; ++e) queue.push(EdgeId{e}, 1000);
    std::uint32_t expected = 0;
    while (!queue.is_empty()) {
        const Queue::Batch next = queue.take();
        EXPECT_TRUE(next.is_serial);
        for (EdgeId e : next.partitions.front()) EXPECT_EQ(index(e), expected++);
    }
    EXPECT_EQ(expected, 1500u);
}

}  // namespace
}  // namespace pectin
