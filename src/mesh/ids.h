// Strong types for the slots of a TriMesh.
#pragma once

#include <cstdint>

namespace pectin {

enum class VertexId : std::uint32_t {};
enum class HalfEdgeId : std::uint32_t {};
enum class EdgeId : std::uint32_t {};
enum class FaceId : std::uint32_t {};
enum class WedgeId : std::uint32_t {};

// The id of no element. A mesh has at most 2^32 - 1 elements of each kind.
template <typename Id>
inline constexpr Id kNone = static_cast<Id>(0xffffffffu);

template <typename Id>
constexpr std::uint32_t index(Id id) {
    return static_cast<std::uint32_t>(id);
}

template <typename Id>
constexpr bool exists(Id id) {
    return id != kNone<Id>;
}

}  // namespace pectin
