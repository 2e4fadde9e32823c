// The instruction sets with which loops can be tested.
#pragma once

#include <vector>

#include "ffd/vectorised.h"

namespace pectin {

// All instruction sets that this machine has.
inline std::vector<Vectors> all_vectors() {
    std::vector<Vectors> all;
    for (const Vectors vectors : {Vectors::plain, Vectors::avx2, Vectors::avx512}) {
        if (vectors <= widest_vectors()) all.push_back(vectors);
    }
    return all;
}

}  // namespace pectin
