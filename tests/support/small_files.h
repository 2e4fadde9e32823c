// The contents of small files.
#pragma once

#include <string>

namespace pectin {

// The first bytes of every PNG file. A file that begins with them is recognised as a picture.
inline const std::string kPngSignature = "\x89PNG\r\n\x1a\n";

// Models as OBJ text.
inline const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
inline const std::string kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

}  // namespace pectin
