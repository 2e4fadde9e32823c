// Memory and bitwise equality of arrays.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include "mesh/growing_array.h"

namespace pectin {

template <typename T>
std::size_t capacity_bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

template <typename T>
std::size_t capacity_bytes(const GrowingArray<T>& v) {
    return v.capacity() * sizeof(T);
}

// Bitwise equality, for types without padding: NaN equals itself and -0 differs from 0.
template <typename T>
bool same_bytes(const T& x, const T& y) {
    static_assert(std::is_trivially_copyable_v<T>);
    return std::memcmp(&x, &y, sizeof(T)) == 0;
}
template <typename T>
bool same_bytes(const std::vector<T>& x, const std::vector<T>& y) {
    return x.size() == y.size() &&
           (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0);
}
template <typename T>
bool same_bytes(const GrowingArray<T>& x, const GrowingArray<T>& y) {
    return x.size() == y.size() &&
           (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0);
}

}  // namespace pectin
