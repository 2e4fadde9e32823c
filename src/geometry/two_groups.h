// Numbers the members of two groups in order, on all threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/parallel.h"

namespace pectin {

enum class Group : std::uint8_t { none, first, second };

// Divides some of the indices [0, count) into two groups. The members of the first group have the
// numbers from 0 on in ascending order, and those of the second group follow.
class TwoGroups {
  public:
    // group_of(i) returns the group of i. Several threads call it. Cost: O(count).
    template <typename GroupOf>
    TwoGroups(std::uint32_t count, const GroupOf& group_of)
        : groups_(count), starts_((count + kPiece - 1) / kPiece) {
        for_pieces(
            0, pieces(),
            [&](std::uint32_t first, std::uint32_t end) {
                for (std::uint32_t piece = first; piece < end; ++piece) {
                    for (std::uint32_t i = begin_of(piece); i < end_of(piece); ++i) {
                        groups_[i] = group_of(i);
                        ++starts_[piece][static_cast<std::size_t>(groups_[i])];
                    }
                }
            },
            1);
        number();
    }

    std::uint32_t size() const { return size_; }
    std::uint32_t size_of_first() const { return size_of_first_; }

    // Calls visit(i, number) for each member, on all threads.
    template <typename Visit>
    void for_each(const Visit& visit) const {
        for_pieces(
            0, pieces(),
            [&](std::uint32_t first, std::uint32_t end) {
                for (std::uint32_t piece = first; piece < end; ++piece) {
                    std::array<std::uint32_t, 3> next = starts_[piece];
                    for (std::uint32_t i = begin_of(piece); i < end_of(piece); ++i) {
                        const std::uint32_t number = next[static_cast<std::size_t>(groups_[i])]++;
                        if (groups_[i] != Group::none) visit(i, number);
                    }
                }
            },
            1);
    }

  private:
    std::uint32_t pieces() const { return static_cast<std::uint32_t>(starts_.size()); }
    std::uint32_t begin_of(std::uint32_t piece) const { return piece * kPiece; }
    std::uint32_t end_of(std::uint32_t piece) const {
        return piece + 1 < pieces() ? (piece + 1) * kPiece
                                    : static_cast<std::uint32_t>(groups_.size());
    }

    // Turns the number of members in each piece into the number of the piece's first member.
    void number() {
        for (const Group group : {Group::first, Group::second}) {
            for (std::array<std::uint32_t, 3>& start : starts_) {
                const std::uint32_t members = start[static_cast<std::size_t>(group)];
                start[static_cast<std::size_t>(group)] = size_;
                size_ += members;
            }
            if (group == Group::first) size_of_first_ = size_;
        }
    }

    std::vector<Group> groups_;
    std::vector<std::array<std::uint32_t, 3>> starts_;  // for each piece and group
    std::uint32_t size_ = 0, size_of_first_ = 0;
};

}  // namespace pectin
