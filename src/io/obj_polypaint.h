// Vertex colours that ZBrush writes into comments of OBJ files (polypaint).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/vec.h"
#include "io/read_report.h"

namespace pectin {

// Lines "#MRGB MMRRGGBBMMRRGGBB...": for each vertex, in the order of the file, eight hexadecimal
// digits for a mask and a colour. The mask protects vertices while one paints. It is no part of
// the model and is not kept.
class ObjPolypaint {
  public:
    // hexadecimals: what follows #MRGB in a line. A malformed line ends the reading, since nobody
    // knows which vertices later lines mean.
    void add(std::string_view hexadecimals, std::size_t line);

    // Gives the colours to the vertices that have none of their own. colors: n_vertices, NaN where
    // a vertex has none, or empty, which it stays where there is no paint. Reports what does not
    // fit. Cost: O(n_vertices).
    void apply(std::vector<Vec3f>& colors, std::size_t vertices, ReadReport& report) const;

  private:
    bool add_word(std::string_view digits);

    std::vector<std::uint32_t> entries_;  // 0xMMRRGGBB
    std::size_t first_line_ = 0;
    ReadFinding unreadable_;
};

}  // namespace pectin
