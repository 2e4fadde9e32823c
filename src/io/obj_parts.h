// Collects the parts of an OBJ file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/indexed_face_set.h"

namespace pectin {

// The parts that polygons and elements belong to, without duplicates.
class PartTable {
  public:
    PartTable() = default;
    PartTable(const PartTable&) = delete;  // sorted_ refers to parts_
    PartTable& operator=(const PartTable&) = delete;

    // The index of the part, and whether it is new.
    std::pair<std::uint32_t, bool> find_or_add(const Part& part) {
        const auto found = sorted_.find(part);
        if (found != sorted_.end()) return {*found, false};
        const auto added = static_cast<std::uint32_t>(parts_.size());
        parts_.push_back(part);
        sorted_.insert(added);
        bytes_ += sizeof(Part) + part.object.size() + part.group.size() + part.material.size();
        return {added, true};
    }
    std::size_t bytes() const { return bytes_; }
    std::vector<Part> take() { return std::move(parts_); }

  private:
    struct Less {
        using is_transparent = void;
        const std::vector<Part>& parts;

        static auto key(const Part& p) {
            return std::tie(p.smoothing_group, p.material, p.group, p.object);
        }
        const Part& part(std::uint32_t i) const { return parts[i]; }
        const Part& part(const Part& p) const { return p; }
        bool operator()(const auto& x, const auto& y) const { return key(part(x)) < key(part(y)); }
    };
    std::vector<Part> parts_;
    std::set<std::uint32_t, Less> sorted_{Less{parts_}};
    std::size_t bytes_ = 0;
};

}  // namespace pectin
