// A table with one row for each slot of one kind of element.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "mesh/array_bytes.h"
#include "mesh/growing_array.h"

namespace pectin {

// Describes one column of a table.
template <typename T>
struct Column {
    T cleared;                 // what a freed slot holds
    std::size_t per_slot = 1;  // array entries per slot
    bool is_optional = false;  // an optional column may be absent: its array is then empty
    // An absent column means the same as one that is cleared throughout, and equals it.
    bool may_be_left_out = false;
};
// As Column::cleared: a freed slot holds its own id.
struct OwnId {};

template <typename T, typename Id>
constexpr T cleared_value(const Column<T>& column, Id) {
    return column.cleared;
}
template <typename Id>
constexpr Id cleared_value(const Column<OwnId>&, Id id) {
    return id;
}

// The columns of one kind of element together with the list of its free slots.
//
// `Columns` holds the arrays and lists them once, in
//     static void for_each_column(visit, columns...)
// which calls visit(Column, array...) for each column with that array of every given object.
// Whatever concerns all columns goes through that list. Columns::Id is the type of a slot's id, and
// Columns::size() returns the number of slots.
//
// The free list is a stack: allocate() returns the slot that was freed last, and adds a slot only
// if none is free.
template <typename Columns>
class SlotTable : public Columns {
  public:
    using Id = typename Columns::Id;
    static constexpr std::uint32_t kAllSlots = 0xffffffffu;

    std::uint32_t slots() const { return static_cast<std::uint32_t>(this->size()); }
    std::span<const Id> free_slots() const { return {free_.data(), free_.size()}; }
    bool has_free_slots() const { return !free_.empty(); }

    // --- Allocation. O(columns). What an allocated slot holds is for the caller to write.
    // Precondition of allocate() and grow(): the capacity suffices.
    Id allocate() {
        if (!free_.empty()) return free_.pop_value();
        grow(1);
        return Id{slots() - 1};
    }
    // Adds slots behind all others, whatever is free.
    void grow(std::size_t count) {
        for_each_present([&](const auto& column, auto& array) {
            array.grow_unchecked(column.per_slot * count);
        });
    }
    void reserve(std::size_t slots) {
        for_each_present(
            [&](const auto& column, auto& array) { array.reserve(column.per_slot * slots); });
    }
    void reserve_additional(std::size_t count) {
        for_each_present([&](const auto& column, auto& array) {
            array.reserve_additional(column.per_slot * count);
        });
    }
    // GrowingArray::prepare() for all columns.
    void prepare(std::size_t count) {
        for_each_present(
            [&](const auto& column, auto& array) { array.prepare(column.per_slot * count); });
    }
    // Slots that can be added without moving an array.
    std::size_t spare_capacity() {
        std::size_t spare = std::numeric_limits<std::size_t>::max();
        for_each_present([&](const auto& column, auto& array) {
            spare = std::min(spare, (array.capacity() - array.size()) / column.per_slot);
        });
        return spare;
    }
    bool can_allocate(std::size_t count) {
        return count <= free_.size() || count - free_.size() <= spare_capacity();
    }

    // --- Release.
    // Writes what a freed slot holds, so that its bytes do not depend on its history.
    void clear(Id id) {
        for_each_present([id](const auto& column, auto& array) {
            const std::size_t first = column.per_slot * static_cast<std::size_t>(id);
            for (std::size_t k = 0; k < column.per_slot; ++k) {
                array[first + k] = cleared_value(column, id);
            }
        });
    }
    // Clears the slot and adds it to the free list, or removes it: see set_kept_slots().
    void release(Id id) {
        clear(id);
        const auto slot = static_cast<std::uint32_t>(id);
        if (slot >= kept_slots_ && slot + 1 == slots() && free_.empty()) {
            resize(slot);
        } else {
            free_.push_back(id);
        }
    }
    // From now on, release() removes a slot from number `kept` on if it is the last of the table
    // and no other is free. allocate() would then add it again, so this changes no later
    // allocation.
    void set_kept_slots(std::uint32_t kept) { kept_slots_ = kept; }
    // Drops the slots from number `slots` on. Precondition: none of them is listed as free.
    void resize(std::size_t slots) {
        for_each_present(
            [&](const auto& column, auto& array) { array.resize(column.per_slot * slots); });
    }
    void clear_all() {
        Columns::for_each_column([](const auto&, auto& array) { array.clear(); }, *this);
        free_.clear();
    }

    // --- The free list alone, for slots that are cleared already or need no clearing.
    void push_free(Id id) { free_.push_back(id); }
    void clear_free() { free_.clear(); }
    void reserve_free(std::size_t count) { free_.reserve_additional(count); }
    // Adds `count` entries, which the caller writes with set_free(); returns the first one's index.
    // Precondition: reserve_free() has made room.
    std::size_t grow_free(std::size_t count) {
        const std::size_t first = free_.size();
        free_.grow_unchecked(count);
        return first;
    }
    void set_free(std::size_t i, Id id) { free_[i] = id; }

    // Same slots, same bytes, same free list.
    bool has_same_bytes(const SlotTable& other) const {
        bool is_same = same_bytes(free_, other.free_);
        Columns::for_each_column(
            [&](const auto& column, const auto& x, const auto& y) {
                is_same = is_same && (same_bytes(x, y) || are_left_out(column, x, y));
            },
            *this, other);
        return is_same;
    }
    bool is_cleared(Id id) const {
        bool is_cleared = true;
        Columns::for_each_column(
            [&](const auto& column, const auto& array) {
                if (column.is_optional && array.empty()) return;
                const std::size_t first = column.per_slot * static_cast<std::size_t>(id);
                for (std::size_t k = 0; k < column.per_slot; ++k) {
                    is_cleared = is_cleared && array[first + k] == cleared_value(column, id);
                }
            },
            *this);
        return is_cleared;
    }
    std::size_t memory_bytes() const {
        std::size_t bytes = capacity_bytes(free_);
        Columns::for_each_column(
            [&](const auto&, const auto& array) { bytes += capacity_bytes(array); }, *this);
        return bytes;
    }

  private:
    // Whether one of two columns is absent and the other holds nothing.
    template <typename T>
    static bool are_left_out(const Column<T>& column, const GrowingArray<T>& x,
                             const GrowingArray<T>& y) {
        const auto is_cleared = [&](const T& value) { return value == column.cleared; };
        return column.may_be_left_out && (x.empty() || y.empty()) &&
               std::all_of(x.begin(), x.end(), is_cleared) &&
               std::all_of(y.begin(), y.end(), is_cleared);
    }
    template <typename T>
    static bool are_left_out(const Column<OwnId>&, const GrowingArray<T>&, const GrowingArray<T>&) {
        return false;
    }

    // visit(Column, array) for all columns that are not absent.
    template <typename Visit>
    void for_each_present(Visit visit) {
        Columns::for_each_column(
            [&](const auto& column, auto& array) {
                if (!column.is_optional || !array.empty()) visit(column, array);
            },
            *this);
    }

    GrowingArray<Id> free_;
    std::uint32_t kept_slots_ = kAllSlots;
};

}  // namespace pectin
