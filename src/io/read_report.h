// Reports what a reader dropped from a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "geometry/up_axis.h"

namespace pectin {

// How often something was found, and the line of the first occurrence.
struct ReadFinding {
    std::uint32_t count = 0;
    std::size_t line = 0;  // counted from 1; 0 if there is none

    void add(std::size_t at_line, std::uint32_t times = 1) {
        if (times == 0) return;
        if (count == 0 || at_line < line) line = at_line;
        count += times;
    }
    bool operator==(const ReadFinding&) const = default;
};

// All of this is dropped; the rest of the file is read. BuildReport, in contrast, counts what is
// kept.
struct ReadReport {
    ReadFinding missing_uvs;  // corners with the index of a texture coordinate that the file lacks
    ReadFinding missing_normals;     // corners with the index of a normal that the file lacks
    ReadFinding undefined_uvs;       // corners whose `vt` has numbers that are not finite
    ReadFinding undefined_normals;   // corners whose `vn` is zero or not three finite numbers
    ReadFinding undefined_colors;    // vertices with a colour or weight that is not finite
    ReadFinding empty_statements;    // f, l and p without corners
    ReadFinding unknown_statements;  // statements whose keyword the format does not have
    ReadFinding unpainted_vertices;  // vertices after the last #MRGB colour of the file
    ReadFinding surplus_paint;       // #MRGB colours beyond the last vertex
    ReadFinding unreadable_paint;    // #MRGB lines from the first malformed one on
    ReadFinding masked_vertices;     // vertices with a mask in their #MRGB entry

    std::string unknown_keyword;  // the first unknown keyword
    std::string likely_keyword;   // what it should be; empty if that cannot be guessed

    // Not dropped: the axis that points upwards, where comments of the file say or imply it.
    std::optional<UpAxis> up_axis{};

    bool operator==(const ReadReport&) const = default;
};

}  // namespace pectin
