// Decimation: undoes splits where the surface has become flat.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4.
#pragma once

#include <cstdint>
#include <optional>

#include "adapt/criteria.h"
#include "geometry/stop_token.h"
#include "mesh/active_set.h"

namespace pectin {

class SelfIntersections;

struct Decimation {
    std::uint64_t unsplits = 0;
    std::uint64_t concurrent_unsplits = 0;  // those of `unsplits` that adapt/concurrent made
    bool was_stopped = false;               // vertices may be left that may be removed
};

// Removes vertices of the active set that refinement has inserted, level by level, highest level
// first, so that later refinements are undone before earlier ones (the paper's figure 6). Which
// vertices may be removed is said at removable_star().
//
// One pass is enough for a curvature trigger that depends on the ends of an edge. Two inserted
// vertices of the same level are never neighbours, since the level of a midpoint is above the
// levels of all its neighbours. So the order within a level does not matter, and the removal of a
// vertex does not change whether another one of its level or above may be removed. Levels with
// thousands of vertices are decimated on several threads (ConcurrentUnsplits).
//
// A trigger that depends on faces (Criteria::curvature_depends_on_faces) may allow a removal after
// another one has changed a face beside it. Then all vertices of a level are tested before the
// first of them is removed, and passes are repeated until one removes nothing. This ends, since
// every other pass removes at least one of finitely many inserted vertices.
//
// self_intersections: if given, no vertex is removed whose restored faces would intersect others.
// That depends on the order, so passes are repeated as long as a vertex was kept for this reason
// and others were removed. Cost: O(active vertices), and O(log n) for each vertex whose restored
// faces are tested for intersections.
//
// stop: asked each time about a thousand vertices have been removed, so that something is done in
// any case. Decimating again continues.
Decimation decimate(ActiveSet& active, const Criteria& criteria,
                    SelfIntersections* self_intersections = nullptr, const StopToken& stop = {});

// The star of m, if m may be removed; none otherwise. The paper's conditions (a) and (b) for a
// candidate vertex are called removal conditions here, to tell them from those for edges. Cost:
// O(1) for each sheet.
std::optional<Star> removable_star(const ActiveSet& active, const Criteria& criteria, VertexId m);

}  // namespace pectin
