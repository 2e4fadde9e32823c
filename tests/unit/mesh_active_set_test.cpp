// Active sets and the changes that they return. Roll back, undo and redo restore every byte.
#include "mesh/active_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "mesh/build_mesh.h"
#include "mesh/midpoint_normal.h"
#include "mesh/shapes.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/test_run.h"
#include "unit/mesh_active_set_random.h"

namespace pectin {
namespace {

using test::begin;
using test::deform_at_random;
using test::edge_between;
using test::edit_at_random;
using test::expect_same;
using test::kValid;
using test::Random;
using test::random_edge;
using test::random_zone;

TEST(ActiveSet, RollsBackUndoesAndRedoesAnyEditsToTheByte) {
    const int cases = test::case_count(300);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 500 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        ActiveSet active(mesh);
        for (int gesture = 0; gesture < 4; ++gesture) {
            const TriMesh before = mesh;
            begin(active, random_zone(mesh, random));
            for (int frame = 0; frame < 2; ++frame) {
                edit_at_random(active, random, 30);
                active.roll_back();
                ASSERT_TRUE(mesh == before) << "rolled back";
            }
            edit_at_random(active, random, 60);
            ASSERT_EQ(mesh.validate(), kValid);
            const MeshChange change = active.finish();
            const TriMesh after = mesh;
            undo(change, mesh);
            ASSERT_TRUE(mesh == before) << "undone";
            redo(change, mesh);
            ASSERT_TRUE(mesh == after) << "redone";
        }
    }
}

TEST(ActiveSet, MarksSmoothEdgesAndBoundsRestLengths) {
    for (unsigned seed = 4700; seed < 4760; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        ActiveSet active(mesh);
        begin(active, random_zone(mesh, random));
        edit_at_random(active, random, 60);
        std::set<EdgeId> with_discontinuity;
        EXPECT_EQ(std::set(active.edges().begin(), active.edges().end()).size(),
                  active.edges().size());
        for (std::size_t i = 0; i < active.edges().size(); ++i) {
            if (active.smooth_edges()[i] == 0) with_discontinuity.insert(active.edges()[i]);
        }
        for (EdgeId e : active.edges()) {
            if (!mesh.is_live(e)) continue;
            // Rest lengths are rounded to float.
            EXPECT_LE(active.rest_length(e), (1.0 + 1e-6) * active.longest_rest_length());
            std::set<std::pair<WedgeId, WedgeId>> sides;
            mesh.for_each_side(e, [&](HalfEdgeId h) {
                const WedgeId x = mesh.wedge(h), y = mesh.wedge(TriMesh::next(h));
                sides.insert({std::min(x, y), std::max(x, y)});
            });
            EXPECT_TRUE(sides.size() == 1 || with_discontinuity.count(e) == 1);
        }
    }
}

TEST(ActiveSet, AfterAGestureEqualsANewActiveSet) {
    const int cases = test::case_count(150);
    for (int i = 0; i < cases; ++i) {
        const auto seed = 900 + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        ActiveSet used(mesh);
        std::vector<MeshChange> done;
        for (int gesture = 0; gesture < 3; ++gesture) {
            begin(used, random_zone(mesh, random));
            edit_at_random(used, random, 40);
            if (random.chance(0.5)) used.roll_back();
            if (random.chance(0.5)) edit_at_random(used, random, 40);
            done.push_back(used.finish());
        }
        for (; !done.empty() && random.chance(0.5); done.pop_back()) undo(done.back(), mesh);
        TriMesh same = mesh;
        ActiveSet fresh(same);
        const Box zone = random_zone(mesh, random);
        Random again = random;
        begin(used, zone);
        begin(fresh, zone);
        edit_at_random(used, random, 40);
        edit_at_random(fresh, again, 40);
        expect_same(used, fresh);
        expect_same(used.finish(), fresh.finish());
        ASSERT_TRUE(mesh == same);
        if (HasFailure()) return;
    }
}

TEST(ActiveSet, AfterRollBackEqualsItsStateAfterBegin) {
    for (std::uint64_t seed = 1200; seed < 1260; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        {
            ActiveSet earlier(mesh);
            begin(earlier, random_zone(mesh, random));
            edit_at_random(earlier, random, 40);
            earlier.finish();
        }
        TriMesh same = mesh;
        ActiveSet rolled(mesh), begun(same);
        const Box zone = random_zone(mesh, random);
        begin(rolled, zone);
        begin(begun, zone);
        edit_at_random(rolled, random, 60);
        rolled.roll_back();
        expect_same(rolled, begun);
        if (HasFailure()) return;
    }
}

TEST(ActiveSet, ListsVerticesStrictlyInsideTheZoneFirstThenOtherCorners) {
    int few = 0, many = 0;  // active faces, among those of the mesh
    for (std::uint64_t seed = 1300; seed < 1400; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        Box zone = random_zone(mesh, random);
        // Sometimes a vertex lies exactly on the zone's border.
        if (random.chance(0.5)) {
            zone.max = mesh.position(VertexId{0});
            zone.min = glm::min(zone.min, zone.max - 0.1);
        }
        ActiveSet active(mesh);
        begin(active, zone);
        std::vector<VertexId> inside, corners;
        std::set<VertexId> of_active_faces;
        std::set<EdgeId> edges;
        std::set<WedgeId> wedges;
        const std::vector<FaceId> faces = FaceTree(mesh).faces_meeting(zone, mesh);
        ++(faces.size() <= mesh.face_slots() / 16 ? few : many);
        for (FaceId f : faces) {
            for (int c = 0; c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                of_active_faces.insert(mesh.origin(h));
                edges.insert(mesh.edge(h));
                wedges.insert(mesh.wedge(h));
            }
        }
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            if (!exists(mesh.half_edge(VertexId{v}))) continue;
            if (zone.contains_strictly(mesh.position(VertexId{v}))) {
                inside.push_back(VertexId{v});
                EXPECT_TRUE(of_active_faces.contains(VertexId{v}));
            } else if (of_active_faces.contains(VertexId{v})) {
                corners.push_back(VertexId{v});
            }
        }
        ASSERT_EQ(active.influenced_at_begin(), inside.size());
        std::vector<VertexId> entries = inside;
        entries.insert(entries.end(), corners.begin(), corners.end());
        ASSERT_EQ(active.vertex_entries(), entries.size());
        for (std::uint32_t i = 0; i < entries.size(); ++i) {
            EXPECT_EQ(active.vertex(i), entries[i]);
            EXPECT_EQ(active.is_influenced_at(i), i < inside.size());
        }
        for (std::uint32_t i = 0; i < active.wedge_entries(); ++i) {
            EXPECT_EQ(active.wedge_owner(i) < inside.size(),
                      i < active.influenced_wedges_at_begin());
        }
        EXPECT_TRUE(std::ranges::equal(active.edges(), edges));
        const auto moving = active.wedges().first(active.influenced_wedges_at_begin());
        const auto resting = active.wedges().subspan(moving.size());
        EXPECT_TRUE(std::ranges::is_sorted(moving));
        EXPECT_TRUE(std::ranges::is_sorted(resting));
        std::vector<WedgeId> all;
        std::ranges::merge(moving, resting, std::back_inserter(all));
        EXPECT_TRUE(std::ranges::equal(all, wedges));
        active.finish();
    }
    EXPECT_GT(few, 5);
    EXPECT_GT(many, 5);
}

TEST(ActiveSet, PutsInsertedVerticesAtTheMidpointOfTheRestState) {
    TriMesh mesh = build_mesh(make_shape(ShapeKind::cube, 1)).mesh;
    const TriMesh rest = mesh;
    ActiveSet active(mesh);
    const Box zone{.min = Vec3{-2.0}, .max = Vec3{2.0}};
    begin(active, zone);
    Random random(9);
    deform_at_random(active, random);
    for (EdgeId e : test::live_edges(rest)) {
        const float length = active.rest_length(e);
        std::vector<ActiveSet::Inserted> sheets;
        const Split s = active.split(e, sheets);
        ASSERT_EQ(sheets.size(), 1u);
        const ActiveSet::Inserted& inserted = sheets.front();
        EXPECT_TRUE(inserted.is_first_sheet);
        const Vec3 middle = 0.5 * rest.position(s.b) + 0.5 * rest.position(s.c);
        EXPECT_EQ(active.rest_position(s.m), middle);
        EXPECT_EQ(mesh.position(s.m), middle);
        EXPECT_EQ(active.vertex(inserted.vertex_entry), s.m);
        std::set<WedgeId> wedges;
        for (std::uint32_t entry : inserted.wedge_entries) {
            if (entry == ActiveSet::kNoEntry) continue;
            EXPECT_EQ(active.wedge_owner(entry), inserted.vertex_entry);
            wedges.insert(active.wedge(entry));
        }
        EXPECT_EQ(wedges, (std::set{s.left.m, s.right->m}));
        EXPECT_EQ(std::set(inserted.edges.begin(), inserted.edges.end()),
                  (std::set{s.bm, s.mc, s.am, s.dm}));
        for (const Split::Side& side : {s.left, *s.right}) {
            EXPECT_EQ(active.rest_normal(side.m),
                      midpoint_normal(rest.normal(side.b), rest.normal(side.c), Vec3{0.0}));
        }
        EXPECT_EQ(active.rest_length(s.bm), 0.5f * length);
        EXPECT_EQ(active.rest_length(s.mc), 0.5f * length);
        EXPECT_TRUE(active.is_influenced_at(inserted.vertex_entry));
        active.roll_back();
        deform_at_random(active, random);
    }
    active.roll_back();
    EXPECT_TRUE(mesh == rest);
    active.finish();
}

TEST(ActiveSet, UsesTheFaceNormalForInsertedRestNormalsWhereEndNormalsCancel) {
    TriMesh mesh = test::mesh_of(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 0.5 -1\nvn 0 1 0\nvn 0 -1 0\nvt 0 0\nvt 1 1\n"
        "f 1/1/1 2/1/1 3/1/2\nf 3/2/2 2/2/1 4/2/1\n");
    TriMesh split = mesh;
    const EdgeId e = edge_between(mesh, 1, 2);
    const Split s = split.split(e);
    ActiveSet active(mesh);
    begin(active, {.min = Vec3{-5.0}, .max = Vec3{5.0}});
    mesh.set_position(VertexId{3}, {9, 9, 9});  // not the rest position
    const Split inserted = active.split(e);
    EXPECT_EQ(active.rest_normal(inserted.left.m), split.normal(s.left.m));
    EXPECT_EQ(active.rest_normal(inserted.right->m), split.normal(s.right->m));
    active.roll_back();
    active.finish();
}

TEST(ActiveSet, ReservesCapacityForSplits) {
    for (std::uint64_t seed = 100; seed < 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh, other = mesh;
        ActiveSet active(mesh), plain(other);
        const Box zone{.min = Vec3{-100.0}, .max = Vec3{100.0}};
        begin(active, zone);
        begin(plain, zone);
        active.reserve_splits(200);
        const void* const positions = active.rest_positions().data();
        const void* const edges = active.edges().data();
        std::vector<ActiveSet::Inserted> sheets;
        while (sheets.size() < 190) {
            const EdgeId e = random_edge(mesh, random);
            active.split(e, sheets);
            plain.split(e);
        }
        if (sheets.size() <= 200) {
            EXPECT_EQ(active.rest_positions().data(), positions);
            EXPECT_EQ(active.edges().data(), edges);
        }
        EXPECT_TRUE(mesh == other);
        EXPECT_EQ(mesh.validate(), std::vector<std::string>{});
        expect_same(active, plain);
        active.roll_back();
        plain.roll_back();
        active.finish();
        plain.finish();
    }
}

// The splits of the next gesture then take no further memory, and are the same.
TEST(ActiveSet, PreparesForSplits) {
    TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 3)).mesh, other = mesh;
    ActiveSet active(mesh), plain(other);
    active.prepare_splits(1000);
    active.prepare_splits(1000);
    const Box zone{.min = Vec3{-2.0}, .max = Vec3{2.0}};
    begin(active, zone);
    begin(plain, zone);
    const std::size_t prepared = mesh.memory_bytes();
    ASSERT_GT(prepared, other.memory_bytes());
    for (std::uint32_t e = 0; e < 300; ++e) {
        active.split(EdgeId{e});
        plain.split(EdgeId{e});
    }
    EXPECT_EQ(mesh.memory_bytes(), prepared);
    EXPECT_TRUE(mesh == other);
    expect_same(active, plain);
}

TEST(ActiveSet, ReusesTheEntriesOfRemovedVertices) {
    TriMesh mesh = test::mesh_of(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 3/2 2/2 4/2\n");
    ActiveSet active(mesh);
    begin(active, {.min = Vec3{-2.0}, .max = Vec3{2.0}});
    const EdgeId seam = edge_between(mesh, 1, 2);
    const float length = active.rest_length(seam);
    for (int frame = 0; frame < 100; ++frame) {
        const Split s = active.split(seam);
        active.unsplit(*mesh.removable(s.m));
    }
    EXPECT_EQ(active.rest_length(seam), length);
    EXPECT_EQ(active.vertex_entries(), 5u);
    EXPECT_EQ(active.wedge_entries(), 8u);
    EXPECT_EQ(active.edges().size(), 8u);
    active.finish();
}

// A UV seam at the zone's border has wedges that only inactive faces use.
TEST(ActiveSet, RestoresWedgesOnTheSideWithoutActiveFaces) {
    TriMesh mesh = test::mesh_of(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 5 5\nvt 6 5\nvt 6 7\n"
        "f 1/1 2/2 3/3\nf 3/4 2/5 4/6\n");
    const Split s = mesh.split(edge_between(mesh, 1, 2));
    mesh.set_normal(s.right->m, {0, 1, 0});  // a normal that no split would compute
    mesh.set_normal(s.left.m, {1, 0, 0});
    const TriMesh before = mesh;
    std::vector<FaceId> left;
    for (FaceId f : test::live_faces(mesh)) {
        if (mesh.base_face(f) == FaceId{0}) left.push_back(f);
    }
    ActiveSet active(mesh);
    for (const bool refine_again : {false, true}) {
        active.begin(left, {.min = Vec3{-1.0}, .max = Vec3{0.1}});
        active.unsplit(*mesh.removable(s.m));
        EXPECT_EQ(mesh.validate(), kValid);
        if (refine_again) active.split(s.bm);
        active.roll_back();
        EXPECT_TRUE(mesh == before);
        active.unsplit(*mesh.removable(s.m));
        if (refine_again) active.split(s.bm);
        const MeshChange change = active.finish();
        const TriMesh after = mesh;
        undo(change, mesh);
        EXPECT_TRUE(mesh == before);
        redo(change, mesh);
        EXPECT_TRUE(mesh == after);
        undo(change, mesh);
    }
}

TEST(MeshChange, IsEmptyOnlyWhereNothingChangedAtAll) {
    TriMesh mesh = build_mesh(make_shape(ShapeKind::sphere, 1)).mesh;
    ActiveSet active(mesh);
    const Box zone{.min = Vec3{-2.0}, .max = Vec3{2.0}};
    const auto change_by = [&](auto edit) {
        begin(active, zone);
        edit();
        return active.finish();
    };
    EXPECT_TRUE(change_by([] {}).is_empty());
    EXPECT_FALSE(change_by([&] { mesh.set_position(VertexId{3}, {1, 1, 1}); }).is_empty());
    EXPECT_FALSE(change_by([&] { mesh.set_deformed(VertexId{4}, true); }).is_empty());
    EXPECT_FALSE(change_by([&] { active.split(EdgeId{5}); }).is_empty());
    // The normal of a pinned vertex may change while its position does not.
    const TriMesh before = mesh;
    const MeshChange changed = change_by([&] { mesh.set_normal(WedgeId{5}, {0, 0, 1}); });
    EXPECT_FALSE(changed.is_empty());
    undo(changed, mesh);
    EXPECT_TRUE(mesh == before);
}

TEST(MeshChange, ListsEveryFaceThatMovedAppearedOrDisappeared) {
    for (std::uint64_t seed = 1500; seed < 1550; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriMesh mesh = test::random_mesh(random).mesh;
        const TriMesh before = mesh;
        ActiveSet active(mesh);
        begin(active, random_zone(mesh, random));
        edit_at_random(active, random, 30);
        const MeshChange change = active.finish();
        EXPECT_TRUE(std::is_sorted(change.faces.begin(), change.faces.end()));
        for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
            const FaceId f{i};
            const bool was = i < before.face_slots() && before.is_live(f);
            bool differs = was != mesh.is_live(f);
            for (int c = 0; was && !differs && c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                differs = mesh.origin(h) != before.origin(h) || mesh.wedge(h) != before.wedge(h) ||
                          mesh.position(mesh.origin(h)) != before.position(before.origin(h));
            }
            if (!differs) continue;
            EXPECT_TRUE(std::binary_search(change.faces.begin(), change.faces.end(), f));
        }
    }
}

}  // namespace
}  // namespace pectin
