// The blocked pass over a frame of one drag, against the formulas element by element.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "embedding/embedding.h"
#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"

namespace pectin {
namespace {

const Vec3 kGrabbed{0, 0, 1}, kDisplacement{0.1, -0.05, 0.4};

// A drag that moves the grabbed point and its surroundings, but not all of the object.
DragStep drag_step() {
    const Lattice lattice = brush_lattice(kGrabbed, 1.4, 3);
    return {std::get<DragSolver>(DragSolver::create(lattice, {&kGrabbed, 1}, {})).field(),
            {kDisplacement}};
}

std::vector<FaceId> live_faces(const TriMesh& mesh) {
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
        if (mesh.is_live(FaceId{f})) faces.push_back(FaceId{f});
    }
    return faces;
}

// Live elements are where the drag takes them from rest; elements that are not live are unchanged.
void expect_deformed(const TriMesh& before, const ActiveSet& active, const DragStep& drag) {
    const TriMesh& after = active.mesh();
    std::size_t moved = 0;
    for (std::uint32_t i = 0; i < after.vertex_slots(); ++i) {
        const VertexId v{i};
        if (!after.is_live(v)) {
            ASSERT_EQ(after.position(v), before.position(v));
            ASSERT_EQ(after.is_deformed(v), before.is_deformed(v));
            continue;
        }
        DragWeight weight;
        drag.field.weights(active.rest_position(v), {&weight, 1});
        const Vec3 to = displaced(active.rest_position(v), weight, drag.displacements[0]);
        ASSERT_EQ(after.position(v), to);
        ASSERT_EQ(after.is_deformed(v), to != active.rest_position(v));
        moved += to != active.rest_position(v) ? 1 : 0;
    }
    EXPECT_GT(moved, 1000u);
    EXPECT_LT(moved, after.vertex_count() - 100u);
    std::vector<bool> is_used(after.wedge_slots(), false);
    for (const FaceId f : live_faces(after)) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(f, corner);
            const WedgeId w = after.wedge(h);
            is_used[index(w)] = true;
            DragWeight weight;
            drag.field.weights(active.rest_position(after.origin(h)), {&weight, 1});
            ASSERT_EQ(after.normal(w),
                      covariant_normal(active.rest_normal(w), weight, drag.displacements[0]));
        }
    }
    for (std::uint32_t w = 0; w < after.wedge_slots(); ++w) {
        if (is_used[w]) continue;
        ASSERT_EQ(after.normal(WedgeId{w}), before.normal(WedgeId{w}));
    }
}

// Splits every edge whose faces have not been split yet, which gives many removable vertices.
void split_many(TriMesh& mesh) {
    std::vector<bool> is_split(mesh.face_slots(), false);
    const std::uint32_t edges = mesh.edge_slots();
    for (std::uint32_t i = 0; i < edges; ++i) {
        bool is_free = true;
        mesh.for_each_side(EdgeId{i}, [&](HalfEdgeId h) {
            is_free = is_free && !is_split[index(TriMesh::face(h))];
        });
        if (!is_free) continue;
        mesh.for_each_side(EdgeId{i},
                           [&](HalfEdgeId h) { is_split[index(TriMesh::face(h))] = true; });
        is_split.resize(mesh.face_slots() + 2, true);
        mesh.split(EdgeId{i});
    }
}

std::size_t remove_every_third(ActiveSet& active) {
    const TriMesh& mesh = active.mesh();
    std::size_t removed = 0;
    for (std::uint32_t i = mesh.base_vertex_count(); i < mesh.vertex_slots(); i += 3) {
        if (const auto star = mesh.removable(VertexId{i})) {
            active.unsplit(*star);
            ++removed;
        }
    }
    return removed;
}

// A sphere has one normal for each vertex, so vertex and wedge entries correspond; at the creases
// of a cube there are several. Ids are consecutive until vertices of an earlier gesture are
// removed.
TEST(DeformPass, MatchesThePerVertexFormulasBitForBit) {
    for (const auto& [kind, resolution] :
         {std::pair{ShapeKind::sphere, 4}, std::pair{ShapeKind::cube, 25}}) {
        TriMesh mesh = build_mesh(make_shape(kind, resolution)).mesh;
        split_many(mesh);
        const TriMesh before = mesh;
        Warp warp{{drag_step()}};
        ActiveSet active(mesh);
        active.begin(live_faces(mesh), warp.zone());
        Embedding embedding(active, warp);
        embedding.embed();
        embedding.deform();
        expect_deformed(before, active, std::get<DragStep>(warp.steps[0]));

        EXPECT_GT(remove_every_third(active), 100u);
        const TriMesh decimated = mesh;
        std::get<DragStep>(warp.steps[0]).displacements[0] *= 0.5;
        embedding.deform();
        expect_deformed(decimated, active, std::get<DragStep>(warp.steps[0]));

        active.roll_back();
        embedding.deform();
        expect_deformed(before, active, std::get<DragStep>(warp.steps[0]));
        active.roll_back();
        active.finish();
        EXPECT_TRUE(mesh == before);
    }
}

}  // namespace
}  // namespace pectin
