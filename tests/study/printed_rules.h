// Refinement and decimation exactly as the paper prints them, without what pectin adds: no
// longest-edge propagation, no floor, no guards of removals, no allowance for roughness at rest.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4.
#pragma once

#include <cstddef>
#include <cstdint>

#include "adapt/criteria.h"
#include "study/scene.h"

namespace pectin::study {

enum class Order {
    longest_first,  // the paper's refinement heap
    first_come,     // edges are split in the order in which they were found
};

struct PrintedRules {
    CurvatureTrigger curvature{};  // conditions (a)
    // Conditions (b). The paper does not say where they hold. Here, as in the program, it is at the
    // edges of faces that meet the influenced zone at rest.
    double l_max = kOff;
    Order order = Order::longest_first;
    std::size_t most_faces = 40'000;  // of the mesh; the rules alone need not terminate
};

struct PrintedRefinement {
    std::uint64_t splits = 0, tests = 0;
    bool has_ended = true;  // false if most_faces was reached
};

// Puts the edges that need refinement on the heap, and repeatedly splits the first and tests the
// four new edges. With a trigger that depends on faces the four outer edges are tested as well.
PrintedRefinement refine_as_printed(Scene& scene, const PrintedRules& rules);

// Removes vertices with four (on a boundary three) edges that all pass the decimation test, and no
// neighbour of a higher level, in groups of descending level. Returns how many it has removed.
std::uint64_t decimate_as_printed(Scene& scene, const PrintedRules& rules);

}  // namespace pectin::study
