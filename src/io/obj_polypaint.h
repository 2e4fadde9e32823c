// Reads vertex colours that ZBrush writes in comments of OBJ files (polypaint).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/vec.h"
#include "io/read_report.h"

namespace pectin {

// The lines have the form "#MRGB MMRRGGBBMMRRGGBB...", with eight hexadecimal digits per vertex in
// the order of the file: a mask and a colour. The mask protects vertices from being edited. It is
// not kept.
class ObjPolypaint {
  public:
    // Adds a line. A malformed line ends the reading, because it is unknown which vertices the
    // later lines belong to. hexadecimals: the text after #MRGB.
    void add(std::string_view hexadecimals, std::size_t line);

    // Sets the colours of vertices that have none. Reports masks and entries that do not match.
    // colors: one per vertex, NaN if it has no colour; may be empty, and stays so if there are no
    // #MRGB lines. Cost: O(vertices).
    void apply(std::vector<Vec3f>& colors, std::size_t vertices, ReadReport& report) const;

  private:
    bool add_word(std::string_view digits);

    std::vector<std::uint32_t> entries_;  // 0xMMRRGGBB
    std::size_t first_line_ = 0;
    ReadFinding unreadable_;
};

}  // namespace pectin
