// Adaptive meshing of an active set: refinement, then decimation.
//
// With the triggers and guards of Criteria, and as long as the budget is not hit, it has these
// properties. It terminates (see refine.h). It is a fixed point: run again at once, it does
// nothing. It is reversible: with all limits off, it restores the base mesh. It leaves no edge that
// needs refinement and may be split.
#pragma once

#include <cstdint>
#include <vector>

#include "adapt/decimate.h"
#include "adapt/refine.h"
#include "adapt/self_intersections.h"

namespace pectin {

struct Adaptation {
    Refinement refinement;
    Decimation decimation;
    double refine_seconds = 0.0, decimate_seconds = 0.0;

    bool was_stopped() const { return refinement.was_stopped || decimation.was_stopped; }
};

// stop: ends the work early. There is no decimation before refinement is complete. Adapting again
// continues, and in the end gives a mesh with the properties above, though it may be another one
// than without a stop.
Adaptation adapt(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                 const StopToken& stop = {});

// The same for a warp that does not fold space. Afterwards no two active faces intersect, and no
// active face intersects one of the surroundings (SelfIntersections), unless the floor, the budget
// or the end of the search prevent it (Refinement::intersection_limit); decimation keeps it so.
// Without a step of the warp nothing can have come to intersect, so only decimation is guarded.
// Without a flatness limit decimation is not guarded: then positions do not matter to the user.
// Throws Stopped where `stop` asks for it. The mesh and the active set are valid then.
// Cost: that of adapt(), plus O(n log n) in the number of active faces, plus
// O(intersections * steps) for each of a few rounds.
Adaptation adapt_without_self_intersections(ActiveSet& active, Embedding& embedding,
                                            const Criteria& criteria,
                                            const Surroundings& surroundings = {},
                                            const StopToken& stop = {});

// What the criteria say about the active edges. Edges along a cut count as one.
struct Assessment {
    std::uint64_t needing_refinement = 0;  // edges that need refinement and may be split
    std::uint64_t held_back = 0;           // edges that need refinement but may not be split
};

// A scan without edits, on all threads. blocked: the edges that refinement found blocked
// (Refinement::blocked), in any order; those that still need refinement count as held back.
// Cost: O(active edges).
Assessment assess(const ActiveSet& active, const Criteria& criteria, std::vector<EdgeId> blocked);

// The largest divergence of end normals over all edges of the mesh with a deformed end, in degrees.
// Cost: O(edges).
double largest_divergence_degrees(const TriMesh& mesh);

}  // namespace pectin
