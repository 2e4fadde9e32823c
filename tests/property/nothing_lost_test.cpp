// Sculpting preserves everything that a model contains: random meshes with seams, creases, groups,
// colours and cuts are read from a file and dragged at random, with undo and redo in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <utility>
#include <variant>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

const std::vector<std::string> kValid;

// The data of the first mesh, with which every later one is compared.
class Original {
  public:
    explicit Original(const TriMesh& mesh) : mesh_(mesh), text_(format_obj(mesh)) {
        for (FaceId f : test::live_faces(mesh)) parts_.push_back(mesh.part(f));
    }

    const std::string& text() const { return text_; }
    bool has_cuts() const {
        const auto edges = test::live_edges(mesh_);
        return std::any_of(edges.begin(), edges.end(),
                           [this](EdgeId e) { return mesh_.sibling(e) != e; });
    }

    void expect_kept_in(const TriMesh& mesh) const {
        ASSERT_EQ(mesh.validate(), kValid);
        ASSERT_EQ(mesh.base_vertex_count(), mesh_.base_vertex_count());
        expect_parts_and_uvs_kept(mesh);
        expect_cuts_closed(mesh);
    }

  private:
    // No face changes its part. Texture coordinates stay within those of their base face, so none
    // crosses a seam.
    void expect_parts_and_uvs_kept(const TriMesh& mesh) const {
        for (FaceId f : test::live_faces(mesh)) {
            const FaceId base = mesh.base_face(f);
            ASSERT_TRUE(mesh.part(f) == parts_[index(base)]);
            if (!mesh.has_uvs()) continue;
            Vec2f low{1e30f}, high{-1e30f};
            bool has_none = false;
            for (int c = 0; c < 3; ++c) {
                const Vec2f uv = mesh_.uv(mesh_.wedge(TriMesh::half_edge(base, c)));
                has_none |= std::isnan(uv.x);
                low = glm::min(low, uv);
                high = glm::max(high, uv);
            }
            for (int c = 0; c < 3 && !has_none; ++c) {
                const Vec2f uv = mesh.uv(mesh.wedge(TriMesh::half_edge(f, c)));
                ASSERT_TRUE(glm::all(glm::greaterThanEqual(uv, low)) &&
                            glm::all(glm::lessThanEqual(uv, high)))
                    << "face " << index(f);
            }
        }
    }

    // All sheets have the same vertices along a cut.
    void expect_cuts_closed(const TriMesh& mesh) const {
        std::map<std::pair<FaceId, VertexId>, HalfEdgeId> boundary;
        for (FaceId f : test::live_faces(mesh)) {
            for (int c = 0; c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                if (!exists(mesh.twin(h))) boundary[{mesh.base_face(f), mesh.origin(h)}] = h;
            }
        }
        const auto along = [&](HalfEdgeId base) {  // the vertices from its origin to its target
            std::vector<VertexId> path{mesh_.origin(base)};
            while (path.back() != mesh_.target(base) && path.size() < mesh.vertex_slots()) {
                const auto next = boundary.find({TriMesh::face(base), path.back()});
                if (next == boundary.end()) break;
                path.push_back(mesh.target(next->second));
            }
            return path;
        };
        for (EdgeId e : test::live_edges(mesh_)) {
            if (mesh_.sibling(e) == e) continue;
            const HalfEdgeId h = mesh_.half_edge(e), other = mesh_.half_edge(mesh_.sibling(e));
            const std::vector<VertexId> path = along(h);
            std::vector<VertexId> beside = along(other);
            if (mesh_.origin(h) != mesh_.origin(other)) std::reverse(beside.begin(), beside.end());
            ASSERT_EQ(path.back(), mesh_.target(h));
            ASSERT_TRUE(path == beside) << "a crack along base edge " << index(e);
        }
    }

    TriMesh mesh_;
    std::string text_;
    std::vector<Part> parts_;
};

Vec3 random_vertex(const TriMesh& mesh, Random& random) {
    while (true) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        if (mesh.is_live(v) && exists(mesh.half_edge(v))) return mesh.position(v);
    }
}

Command random_edit(const TriMesh& mesh, double size, Random& random) {
    if (random.chance(0.15)) return command::Undo{.count = random.integer(1, 3)};
    if (random.chance(0.15)) return command::Redo{.count = random.integer(1, 2)};
    if (random.chance(0.1)) return command::Brush{.radius = size * random.scale(0.05, 0.6)};
    const Vec3 from = random_vertex(mesh, random);
    const Vec3 to = from + size * random.scale(0.005, 0.2) * random.direction();
    return command::Drag{.moves = {{from, to}}};
}

TEST(NothingIsLost, OverAThousandRandomDragsWithUndoAndRedo) {
    const ScratchFolder folder;
    const int cases = test::case_count(40);
    int drags = 0, cut = 0;
    std::uint64_t inserted = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 60'000 + static_cast<std::uint64_t>(i);
        Random random(seed);
        const auto [start, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        folder.write("a.obj", format_obj(start));
        Session session;
        ASSERT_TRUE(session.execute(command::Open{.path = folder.path("a.obj")}));
        const double size = session.mesh().bounding_box().diagonal();
        ASSERT_TRUE(
            session.execute(command::Adapt{.theta_max = Setting::of(random.scale(6.0, 30.0)),
                                           .floor = Setting::of(0.01 * size),
                                           .budget = 20'000}));
        const Original original(session.mesh());
        ASSERT_EQ(original.text(), format_obj(start));
        cut += original.has_cuts() ? 1 : 0;
        for (int k = 0; k < 40; ++k) {
            const Command edit = random_edit(session.mesh(), size, random);
            const bool done{session.execute(edit)};
            drags += done && std::holds_alternative<command::Drag>(edit) ? 1 : 0;
            SCOPED_TRACE("edit " + std::to_string(k));
            original.expect_kept_in(session.mesh());
            if (HasFailure()) return;
        }
        inserted += session.mesh().vertex_count() - session.mesh().base_vertex_count();
        // A saved file that is read and saved again has the same bytes.
        const std::string refined = format_obj(session.mesh());
        ASSERT_EQ(format_obj(build_mesh(parse_obj(refined, "refined.obj")).mesh), refined);
        if (random.chance(0.5)) {
            ASSERT_TRUE(session.execute(command::Bake{}));
            ASSERT_EQ(session.mesh().validate(), kValid);
            ASSERT_EQ(format_obj(session.mesh()), refined);
            const Vec3 from = random_vertex(session.mesh(), random);
            std::ignore = session.execute(
                command::Drag{.moves = {{from, from + 0.1 * size * random.direction()}}});
            ASSERT_EQ(session.mesh().validate(), kValid);
        }
        while (session.execute(command::Undo{})) {
        }
        ASSERT_EQ(format_obj(session.mesh()), original.text());
    }
    std::printf(
        "seeds 60000 to %d: %d of %d meshes cut, %d drags, %llu vertices inserted at the ends\n",
        60'000 + cases - 1, cut, cases, drags, static_cast<unsigned long long>(inserted));
    EXPECT_GT(cut, 0);
    EXPECT_GE(drags, 20 * cases);
}

// Five sheets at one edge, some of them reversed, and a duplicate of one of them.
TriMesh book(Random& random) {
    constexpr std::uint32_t kPages = 5, kSteps = 6, kRow = kSteps + 1;
    IndexedFaceSet set;
    set.parts.emplace_back();
    for (std::uint32_t j = 0; j < kRow; ++j) set.positions.emplace_back(0.0, 0.2 * j, 0.0);
    const auto vertex = [&](std::uint32_t page, std::uint32_t i, std::uint32_t j) {
        return i == 0 ? j : kRow + (page * kSteps + i - 1) * kRow + j;
    };
    for (std::uint32_t page = 0; page < kPages; ++page) {
        const double angle = 1.1 * page;
        for (std::uint32_t i = 1; i <= kSteps; ++i) {
            for (std::uint32_t j = 0; j < kRow; ++j) {
                set.positions.emplace_back(0.2 * i * std::cos(angle), 0.2 * j,
                                           0.2 * i * std::sin(angle));
            }
        }
    }
    const auto add = [&](std::array<std::uint32_t, 4> corners, bool flipped) {
        if (flipped) std::reverse(corners.begin(), corners.end());
        for (std::uint32_t v : corners) set.corners.push_back({.position = v});
        set.polygon_end.push_back(static_cast<std::uint32_t>(set.corners.size()));
        set.polygon_part.push_back(0);
    };
    for (std::uint32_t page = 0; page < kPages; ++page) {
        const bool flipped = random.chance(0.5);
        for (std::uint32_t i = 0; i < kSteps; ++i) {
            for (std::uint32_t j = 0; j < kSteps; ++j) {
                const std::array corners = {vertex(page, i, j), vertex(page, i + 1, j),
                                            vertex(page, i + 1, j + 1), vertex(page, i, j + 1)};
                add(corners, flipped);
                if (page == 2) add(corners, !flipped);
            }
        }
    }
    return build_mesh(set).mesh;
}

TEST(NonManifoldCut, StaysClosedOverRandomDrags) {
    const ScratchFolder folder;
    for (std::uint64_t seed = 61'000; seed < 61'003; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        folder.write("a.obj", format_obj(book(random)));
        Session session;
        ASSERT_TRUE(session.execute(command::Open{.path = folder.path("a.obj")}));
        ASSERT_TRUE(session.execute(command::Adapt{
            .theta_max = Setting::of(15.0), .floor = Setting::of(0.02), .budget = 20'000}));
        const Original original(session.mesh());
        for (int drag = 0; drag < 100; ++drag) {
            ASSERT_TRUE(session.execute(command::Brush{.radius = random.scale(0.1, 1.0)}));
            const Vec3 from = random_vertex(session.mesh(), random);
            ASSERT_TRUE(session.execute(command::Drag{
                .moves = {{from, from + random.scale(0.01, 0.2) * random.direction()}}}));
            original.expect_kept_in(session.mesh());
            if (HasFailure()) return;
        }
        EXPECT_GT(session.mesh().vertex_count(), 2 * session.mesh().base_vertex_count());
        while (session.execute(command::Undo{})) {
        }
        ASSERT_EQ(format_obj(session.mesh()), original.text());
    }
}

}  // namespace
}  // namespace pectin
