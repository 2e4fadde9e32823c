// An array that can grow without being copied.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "mesh/memory_block.h"

namespace pectin {

// Like std::vector, for trivially copyable types, in a block of memory_block.h.
// Functions that need memory throw std::bad_alloc if there is none; the array is then unchanged.
template <typename T>
class GrowingArray {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

  public:
    using value_type = T;

    GrowingArray() = default;
    explicit GrowingArray(std::span<const T> values) { append(values); }
    GrowingArray(const GrowingArray& other) { append(other); }
    GrowingArray(GrowingArray&& other) noexcept { swap(other); }
    GrowingArray& operator=(GrowingArray other) noexcept {
        swap(other);
        return *this;
    }
    ~GrowingArray() { free_block(data_, capacity_ * sizeof(T)); }

    void swap(GrowingArray& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::size_t capacity() const { return capacity_; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    T& back() { return data_[size_ - 1]; }
    const T& back() const { return data_[size_ - 1]; }

    // reserve() makes room for `capacity` elements in all and not more. reserve_additional() makes
    // room for `count` further ones; the capacity then grows geometrically.
    void reserve(std::size_t capacity) {
        if (capacity > capacity_) move_to(capacity);
    }
    void reserve_additional(std::size_t count) {
        if (capacity_ - size_ < count) [[unlikely]]
            grow_to(size_ + count);
    }
    // Makes room for `count` further elements, and not more, and lets the system provide the memory
    // now. Later each first write to a page would wait for that.
    void prepare(std::size_t count) {
        constexpr std::size_t kPage = 4096;
        reserve(size_ + count);
        const std::size_t end = sizeof(T) * (size_ + count);
        auto* const bytes = reinterpret_cast<volatile std::byte*>(data_);
        for (std::size_t i = sizeof(T) * size_; i < end; i += kPage) bytes[i] = std::byte{0};
    }
    void push_back(T value) {
        reserve_additional(1);
        data_[size_++] = value;
    }
    // Precondition: the capacity suffices.
    void push_back_unchecked(T value) {
        assert(size_ < capacity_);
        data_[size_++] = value;
    }
    void grow(std::size_t count) {  // by uninitialised elements
        reserve_additional(count);
        size_ += count;
    }
    void grow_unchecked(std::size_t count) {
        assert(size_ + count <= capacity_);
        size_ += count;
    }
    void pop_back() { --size_; }
    T pop_value() { return data_[--size_]; }
    void clear() { size_ = 0; }
    void resize(std::size_t size, T fill = T{}) {
        if (size > size_) reserve_additional(size - size_);
        for (std::size_t i = size_; i < size; ++i) data_[i] = fill;
        size_ = size;
    }
    void assign(std::size_t size, T value) {
        reserve(size);
        clear();
        resize(size, value);
    }
    void assign(std::span<const T> values) {  // must not be part of this array
        reserve(values.size());
        clear();
        append(values);
    }
    void append(std::span<const T> values) {  // must not be part of this array
        if (values.empty()) return;
        reserve_additional(values.size());
        std::memcpy(static_cast<void*>(data_ + size_), values.data(), values.size_bytes());
        size_ += values.size();
    }

  private:
    static constexpr std::size_t kMost = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T);

    // At least doubles the capacity, and rounds large ones up to whole huge pages, which the system
    // provides as a whole in any case.
    [[gnu::noinline]] void grow_to(std::size_t least) {
        std::size_t capacity = std::max(least, 2 * capacity_);
        if (capacity_ > 0 && capacity >= kHugePage / sizeof(T) && capacity <= kMost) {
            const std::size_t pages = (capacity * sizeof(T) + kHugePage - 1) / kHugePage;
            capacity = pages * kHugePage / sizeof(T);
        }
        move_to(capacity);
    }
    void move_to(std::size_t capacity) {
        if (capacity > kMost) throw std::bad_alloc();
        void* const moved = grown_block(data_, capacity_ * sizeof(T), capacity * sizeof(T));
        if (!moved) throw std::bad_alloc();
        data_ = static_cast<T*>(moved);
        capacity_ = capacity;
    }

    T* data_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
};

template <typename T>
bool operator==(const GrowingArray<T>& x, const GrowingArray<T>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end());
}

}  // namespace pectin
