#include "mesh/growing_array.h"
#include "support/test_run.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace pectin {
namespace {

GrowingArray<int> counted(int count) {
    GrowingArray<int> array;
    for (int i = 0; i < count; ++i) array.push_back(i);
    return array;
}

TEST(GrowingArray, KeepsWhatItHoldsWhileItGrows) {
    // Far more than kHugePage bytes.
    GrowingArray<int> array;
    for (int i = 0; i < 5'000'000; ++i) array.push_back(i);
    for (int i = 0; i < 5'000'000; ++i) ASSERT_EQ(array[static_cast<std::size_t>(i)], i);
}

TEST(GrowingArray, FillsOnlyWhatAResizeAdds) {
    GrowingArray<int> array = counted(3);
    array.resize(5, 7);
    EXPECT_EQ(std::vector<int>(array.begin(), array.end()), (std::vector{0, 1, 2, 7, 7}));
    array.resize(1);
    array.resize(3, 9);
    EXPECT_EQ(std::vector<int>(array.begin(), array.end()), (std::vector{0, 9, 9}));
}

TEST(GrowingArray, ACopyIsIndependentAndHasNoSpareCapacity) {
    GrowingArray<int> array = counted(5);
    array.reserve(100);
    GrowingArray<int> copy = array;
    EXPECT_EQ(copy.capacity(), 5u);
    EXPECT_EQ(copy, array);
    copy[2] = 17;
    EXPECT_EQ(array[2], 2);
    EXPECT_FALSE(copy == array);
}

TEST(GrowingArray, IsEmptyOnceMovedFrom) {
    GrowingArray<int> array = counted(4);
    const GrowingArray<int> taken = std::move(array);
    EXPECT_EQ(taken.size(), 4u);
    EXPECT_TRUE(array.empty());  // NOLINT(bugprone-use-after-move)
    EXPECT_EQ(array.capacity(), 0u);
}

TEST(GrowingArray, StaysAsItWasWhereThereIsNoMemory) {
    GrowingArray<std::uint64_t> array;
    array.push_back(42);
    if (!test::is_sanitized()) {  // the sanitizer's allocator would abort
        EXPECT_THROW(array.reserve(std::numeric_limits<std::size_t>::max() / 16), std::bad_alloc);
    }
    // The number of bytes would overflow to a small one.
    EXPECT_THROW(array.reserve(std::numeric_limits<std::size_t>::max() / 8 + 2), std::bad_alloc);
    ASSERT_EQ(array.size(), 1u);
    EXPECT_EQ(array[0], 42u);
}

TEST(GrowingArray, KeepsWhatItHoldsFromAFewBytesToMany) {
    GrowingArray<std::uint64_t> array;
    for (std::size_t capacity = 1; capacity < 1'000'000; capacity *= 3) {
        array.reserve(capacity);
        EXPECT_EQ(array.capacity(), capacity);
        while (array.size() < capacity) array.push_back(array.size());
        const GrowingArray<std::uint64_t> copy = array;
        for (std::size_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i], i);
    }
}

// Sizes below a page, of a page, of a huge page and one byte less and more, and of several.
TEST(GrowingArray, KeepsWhatItHoldsAcrossTheEdgesOfPages) {
    const std::size_t sizes[] = {1,
                                 4096,
                                 kHugePage - 1,
                                 kHugePage,
                                 kHugePage + 1,
                                 3 * kHugePage - 4096,
                                 3 * kHugePage - 5,
                                 5 * kHugePage + 4097};
    for (std::size_t from : sizes) {
        for (std::size_t to : sizes) {
            if (to <= from) continue;
            SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
            GrowingArray<std::uint8_t> array;
            array.reserve(from);
            const auto value = [](std::size_t i) { return static_cast<std::uint8_t>(i * i >> 7); };
            while (array.size() < from) array.push_back(value(array.size()));
            array.reserve(to);
            EXPECT_EQ(array.capacity(), to);
            while (array.size() < to) array.push_back(value(array.size()));
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < to; ++i) wrong += array[i] != value(i) ? 1 : 0;
            EXPECT_EQ(wrong, 0u);
        }
    }
}

// Capacities fill whole huge pages. The page size is not a multiple of the 24 bytes of an element.
TEST(GrowingArray, GrowsToTheEndOfAHugePage) {
    struct Wide {
        std::uint64_t words[3];
    };
    GrowingArray<Wide> array;
    array.reserve(100'000);
    EXPECT_EQ(array.capacity(), 100'000u);
    for (std::size_t times = 0; times < 5; ++times) {
        array.reserve_additional(array.capacity() + 1);
        EXPECT_LT(~(array.capacity() * sizeof(Wide) - 1) % kHugePage, sizeof(Wide));
        if (kHasPagedBlocks) {
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % kHugePage, 0u);
        }
        array.grow(array.capacity());
    }
}

TEST(GrowingArray, GrowsByUninitialisedElements) {
    GrowingArray<int> array = counted(10);
    array.grow(1000);
    ASSERT_EQ(array.size(), 1010u);
    for (int i = 0; i < 1010; ++i) array[static_cast<std::size_t>(i)] = i;
    array.grow(1);
    ASSERT_EQ(array.size(), 1011u);
    for (int i = 0; i < 1010; ++i) ASSERT_EQ(array[static_cast<std::size_t>(i)], i);
}

}  // namespace
}  // namespace pectin
