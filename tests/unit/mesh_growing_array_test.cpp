#include "mesh/growing_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <span>
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
    // Past the size from which the allocator moves a block by its pages.
    GrowingArray<int> array;
    for (int i = 0; i < 1'000'000; ++i) array.push_back(i);
    for (int i = 0; i < 1'000'000; ++i) ASSERT_EQ(array[static_cast<std::size_t>(i)], i);
}

TEST(GrowingArray, FillsOnlyWhatAResizeAdds) {
    GrowingArray<int> array = counted(3);
    array.resize(5, 7);
    EXPECT_EQ(std::vector<int>(array.begin(), array.end()), (std::vector{0, 1, 2, 7, 7}));
    array.resize(1);
    array.resize(3, 9);
    EXPECT_EQ(std::vector<int>(array.begin(), array.end()), (std::vector{0, 9, 9}));
}

TEST(GrowingArray, ACopyIsAsLargeAsItHasToBeAndItsOwn) {
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
    if (!std::getenv("PECTIN_TEST_SANITIZED")) {  // their allocator ends the program instead
        EXPECT_THROW(array.reserve(std::numeric_limits<std::size_t>::max() / 16), std::bad_alloc);
    }
    // So many that their bytes would wrap round to few.
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

TEST(GrowingArray, GrowsByWhatIsThenWritten) {
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
