// Splits and unsplits of an active set that may run concurrently.
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "mesh/active_set.h"
#include "support/test_run.h"
#include "unit/mesh_active_set_random.h"

namespace pectin {
namespace {

using test::begin;
using test::edit_at_random;
using test::expect_same;
using test::kValid;
using test::Random;
using test::random_edge;
using test::random_zone;

// Marks the corners as taken and returns true if none of them was taken.
bool takes_corners(std::initializer_list<VertexId> corners, std::set<VertexId>& taken) {
    if (std::ranges::any_of(corners, [&](VertexId v) { return taken.contains(v); })) return false;
    taken.insert(corners);
    return true;
}

// Smooth active edges whose stencils share no vertex.
std::vector<EdgeId> independent_edges(const ActiveSet& active, Random& random) {
    const TriMesh& mesh = active.mesh();
    std::set<VertexId> taken;
    std::vector<EdgeId> concurrent;
    for (int i = 0; i < 100; ++i) {
        const EdgeId e = random_edge(mesh, random);
        if (!active.entry_of(e) || !mesh.is_smooth(e)) continue;
        const HalfEdgeId h = mesh.half_edge(e), twin = mesh.twin(h);
        if (takes_corners({mesh.origin(h), mesh.target(h), mesh.origin(TriMesh::prev(h)),
                           mesh.origin(TriMesh::prev(twin))},
                          taken)) {
            concurrent.push_back(e);
        }
    }
    return concurrent;
}

// Removable vertices whose stencils share no vertex but the midpoint's own.
std::vector<VertexId> independent_vertices(const ActiveSet& active) {
    std::set<VertexId> taken;
    std::vector<VertexId> concurrent;
    for (VertexId m : active.vertices()) {
        if (!exists(m)) continue;
        const auto star = active.mesh().removable(m);
        if (star && active.may_unsplit_concurrently(*star) &&
            takes_corners({star->a, star->b, star->c, star->d}, taken)) {
            concurrent.push_back(m);
        }
    }
    return concurrent;
}

// Logs the unsplits in two groups, the second group first.
void log_in_parts(ActiveSet& active, std::span<const ActiveSet::Unsplit> done) {
    active.reserve_unsplits(done.size());
    const auto first = done.first(done.size() / 3), second = done.subspan(done.size() / 3);
    const auto first_at = active.allocate_unsplits(active.count(first));
    const auto second_at = active.allocate_unsplits(active.count(second));
    active.log_unsplits(second, {}, second_at);
    active.log_unsplits(first, {}, first_at);
}

// Edits whose stencils share no vertex may be made in any order, and hence concurrently. Mesh,
// entries and log must equal those of serial edits, in new slots as well as in reused ones.
TEST(ActiveSet, ConcurrentEditsMatchSerialOnesInAnyOrder) {
    std::size_t splits = 0, unsplits = 0;
    const int cases = test::case_count(200);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 7000 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        for (int split = 0; split < 20; ++split) mesh.split(random_edge(mesh, random));
        const TriMesh before = mesh;
        TriMesh other = mesh;
        ActiveSet concurrent(mesh), in_turn(other);
        const Box zone = random_zone(mesh, random);
        begin(concurrent, zone);
        begin(in_turn, zone);
        for (int round = 0; round < 3; ++round) {
            const std::vector<EdgeId> edges = independent_edges(concurrent, random);
            ActiveSet::ReservedSlots slots;
            concurrent.allocate_splits(static_cast<std::uint32_t>(edges.size()), slots);
            for (std::size_t k = edges.size(); k-- > 0;) {
                const ActiveSet::Inserted made = concurrent.concurrent_split(edges[k], slots, k);
                EXPECT_EQ(made.vertex_entry, slots.entries[k].vertex);
            }
            for (EdgeId e : edges) in_turn.split(e);
            EXPECT_TRUE(mesh == other);
            expect_same(concurrent, in_turn);
            EXPECT_EQ(concurrent.longest_rest_length(), in_turn.longest_rest_length());

            const std::vector<VertexId> vertices = independent_vertices(concurrent);
            std::vector<ActiveSet::Unsplit> done(vertices.size());
            for (std::size_t k = vertices.size(); k-- > 0;) {
                done[k] = concurrent.concurrent_unsplit(*mesh.removable(vertices[k]), nullptr);
            }
            log_in_parts(concurrent, done);
            for (VertexId m : vertices) in_turn.unsplit(*other.removable(m));
            EXPECT_TRUE(mesh == other);
            EXPECT_EQ(mesh.validate(), kValid);
            expect_same(concurrent, in_turn);
            splits += edges.size();
            unsplits += vertices.size();
            Random same(seed);
            edit_at_random(concurrent, same, 20);
            same = Random(seed);
            edit_at_random(in_turn, same, 20);
        }
        concurrent.roll_back();
        EXPECT_TRUE(mesh == before);
        concurrent.finish();
    }
    EXPECT_GT(splits, 5 * static_cast<std::size_t>(cases));
    EXPECT_GT(unsplits, 5 * static_cast<std::size_t>(cases));
}

}  // namespace
}  // namespace pectin
