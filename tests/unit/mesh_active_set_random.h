// Active sets of random meshes, edited at random, and compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mesh/active_set.h"
#include "mesh/face_tree.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin::test {

inline const std::vector<std::string> kValid;

inline Box random_zone(const TriMesh& mesh, Random& random) {
    const Box all = mesh.bounding_box();
    const Vec3 fraction{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    const Vec3 centre = all.min + fraction * all.extent();
    const double half = all.diagonal() * random.scale(0.05, 0.7);
    return {.min = centre - half, .max = centre + half};
}

inline void begin(ActiveSet& active, const Box& zone) {
    active.begin(FaceTree(active.mesh()).faces_meeting(zone, active.mesh()), zone);
}

// Moves random influenced vertices and marks them as deformed. Gives random influenced wedges new
// normals.
inline void deform_at_random(ActiveSet& active, Random& random) {
    TriMesh& mesh = active.mesh();
    for (std::uint32_t i = 0; i < active.vertex_entries(); ++i) {
        const VertexId v = active.vertex(i);
        const bool moves = random.chance(0.7);
        if (!moves || !exists(v) || !active.is_influenced_at(i)) continue;
        mesh.set_position(v, mesh.position(v) + 0.1 * random.direction());
        mesh.set_deformed(v, true);
    }
    for (std::uint32_t i = 0; i < active.wedge_entries(); ++i) {
        const WedgeId w = active.wedge(i);
        const bool turns = random.chance(0.7);
        if (!turns || !exists(w) || !active.is_influenced_at(active.wedge_owner(i))) continue;
        mesh.set_normal(w, Vec3f{random.direction()});
    }
}

inline EdgeId random_edge(const TriMesh& mesh, Random& random) {
    const auto edges = live_edges(mesh);
    const int last = static_cast<int>(edges.size()) - 1;
    return edges[static_cast<std::size_t>(random.integer(0, last))];
}

// Splits and measures random edges of the mesh, as propagation may. Unsplits only vertices that
// have an entry.
inline void edit_at_random(ActiveSet& active, Random& random, int edits) {
    for (int i = 0; i < edits; ++i) {
        if (random.chance(0.5)) active.rest_length(random_edge(active.mesh(), random));
        if (random.chance(0.55) || active.vertex_entries() == 0) {
            active.split(random_edge(active.mesh(), random));
        } else {
            const VertexId v = active.vertex(static_cast<std::uint32_t>(
                random.integer(0, static_cast<int>(active.vertex_entries()) - 1)));
            if (!exists(v)) continue;
            if (const auto star = active.mesh().removable(v)) active.unsplit(*star);
        }
        if (i % 7 == 0) deform_at_random(active, random);
    }
}

// Compares everything that the public interface of an active set shows.
inline void expect_same(ActiveSet& x, ActiveSet& y) {
    ASSERT_EQ(x.vertex_entries(), y.vertex_entries());
    ASSERT_EQ(x.wedge_entries(), y.wedge_entries());
    EXPECT_EQ(x.influenced_at_begin(), y.influenced_at_begin());
    EXPECT_EQ(x.influenced_wedges_at_begin(), y.influenced_wedges_at_begin());
    EXPECT_EQ(x.splits(), y.splits());
    EXPECT_EQ(x.unsplits(), y.unsplits());
    for (std::uint32_t i = 0; i < x.vertex_entries(); ++i) {
        EXPECT_EQ(x.vertex(i), y.vertex(i));
        EXPECT_EQ(x.rest_position_at(i), y.rest_position_at(i));
        EXPECT_EQ(x.was_deformed_at(i), y.was_deformed_at(i));
    }
    for (std::uint32_t i = 0; i < x.wedge_entries(); ++i) {
        EXPECT_EQ(x.wedge(i), y.wedge(i));
        EXPECT_EQ(x.rest_normal_at(i), y.rest_normal_at(i));
        EXPECT_EQ(x.wedge_owner(i), y.wedge_owner(i));
    }
    EXPECT_TRUE(std::ranges::equal(x.edges(), y.edges()));
    EXPECT_TRUE(std::ranges::equal(x.smooth_edges(), y.smooth_edges()));
    for (std::uint32_t v = 0; v < x.mesh().vertex_slots(); ++v) {
        EXPECT_EQ(x.rest_position(VertexId{v}), y.rest_position(VertexId{v}));
    }
    for (std::uint32_t w = 0; w < x.mesh().wedge_slots(); ++w) {
        EXPECT_EQ(x.rest_normal(WedgeId{w}), y.rest_normal(WedgeId{w}));
    }
    for (EdgeId e : live_edges(x.mesh())) EXPECT_EQ(x.rest_length(e), y.rest_length(e));
}

inline void expect_same(const MeshChange& x, const MeshChange& y) {
    EXPECT_EQ(x.slots_before, y.slots_before);
    EXPECT_EQ(x.faces, y.faces);
    ASSERT_EQ(x.edits.size(), y.edits.size());
    for (std::size_t i = 0; i < x.edits.size(); ++i) {
        EXPECT_EQ(x.edits[i].is_split(), y.edits[i].is_split());
        EXPECT_EQ(x.edits[i].edge(), y.edits[i].edge());
    }
    EXPECT_EQ(x.before.vertices, y.before.vertices);
    EXPECT_EQ(x.before.wedges, y.before.wedges);
    EXPECT_EQ(x.after.vertices, y.after.vertices);
    EXPECT_EQ(x.after.wedges, y.after.wedges);
}

}  // namespace pectin::test
