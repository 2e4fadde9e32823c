// The corners of OBJ faces, read by tinyobjloader.
#pragma once

#include <functional>
#include <span>
#include <string>

namespace pectin {

// A corner as the file has it: indices from 1, or from the end where negative; 0 where none.
struct ObjCorner {
    int position = 0, uv = 0, normal = 0;
};

// Asks `next` for the arguments of one `f` statement after another until it returns false, and
// gives what they say to `face` before it asks for the next.
// Precondition: well formed, for tinyobjloader's atoi takes anything: corners parted by blanks,
// at least one, each v, v/vt, v//vn or v/vt/vn with decimal indices that an int can hold.
// Whatever `next` and `face` throw comes through.
void read_faces(const std::function<bool(std::string& arguments)>& next,
                const std::function<void(std::span<const ObjCorner>)>& face);

}  // namespace pectin
