// What a reader found in a file that a model cannot take as it stands there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pectin {

// How often something was found, and where first.
struct ReadFinding {
    std::uint32_t count = 0;
    std::size_t line = 0;  // of the first; from 1, 0 where there is none

    void add(std::size_t at_line, std::uint32_t times = 1) {
        if (times == 0) return;
        if (count == 0 || at_line < line) line = at_line;
        count += times;
    }
    bool operator==(const ReadFinding&) const = default;
};

// All of this is dropped, and the rest of the file is read. What BuildReport counts is kept.
struct ReadReport {
    ReadFinding missing_uvs;         // corners that name a texture coordinate the file lacks
    ReadFinding missing_normals;     // corners that name a normal the file lacks
    ReadFinding undefined_uvs;       // corners whose `vt` is not made of finite numbers
    ReadFinding undefined_normals;   // corners whose `vn` is zero or not three finite numbers
    ReadFinding undefined_colors;    // vertices with a colour or weight that is no finite number
    ReadFinding empty_statements;    // f, l and p without corners
    ReadFinding unknown_statements;  // with a keyword that the format does not have
    ReadFinding unpainted_vertices;  // that the #MRGB colours of the file do not reach
    ReadFinding surplus_paint;       // #MRGB colours beyond the last vertex
    ReadFinding unreadable_paint;    // #MRGB lines from the first that is malformed on
    ReadFinding masked_vertices;     // with a mask in their #MRGB entry, which is not kept

    std::string unknown_keyword;  // the first one; what it should be, where that can be guessed
    std::string likely_keyword;

    bool operator==(const ReadReport&) const = default;
};

}  // namespace pectin
