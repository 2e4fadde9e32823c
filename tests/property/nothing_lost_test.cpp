// What a model brings along survives any sculpting: random meshes with seams, creases, groups,
// colours and cuts, opened from a file, dragged at random with undo and redo mixed in.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

#include "io/atomic_file.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "session/session.h"
#include "support/mesh_figures.h"
#include "support/random_mesh.h"

namespace pectin {
namespace {

using test::Random;

const std::vector<std::string> kValid;

// What every later state of a mesh is held against.
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
    // No face changes its part; no texture coordinate leaves its base face's, so none crosses a
    // seam.
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

    // All sheets run along a cut over the same vertices.
    void expect_cuts_closed(const TriMesh& mesh) const {
        std::map<std::pair<FaceId, VertexId>, HalfEdgeId> boundary;
        for (FaceId f : test::live_faces(mesh)) {
            for (int c = 0; c < 3; ++c) {
                const HalfEdgeId h = TriMesh::half_edge(f, c);
                if (!exists(mesh.twin(h))) boundary[{mesh.base_face(f), mesh.origin(h)}] = h;
            }
        }
        const auto along = [&](HalfEdgeId base) {  // from its origin to its target
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

class ScratchFile {
  public:
    ScratchFile()
        : path_(std::filesystem::temp_directory_path() /
                ("pectin-nothing-lost-" + std::to_string(::getpid()) + ".obj")) {}
    ~ScratchFile() { std::filesystem::remove(path_); }
    std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
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
    const ScratchFile file;
    const int cases = test::case_count(40);
    int drags = 0, cut = 0;
    std::uint64_t inserted = 0;
    for (int i = 0; i < cases; ++i) {
        const auto seed = 60'000 + static_cast<std::uint64_t>(i);
        Random random(seed);
        const auto [start, description] = test::random_mesh(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + description);
        write_file_atomically(file.path(), format_obj(start));
        Session session;
        ASSERT_FALSE(session.execute(command::Open{.path = file.path()}).has_value());
        const double size = session.mesh().bounding_box().diagonal();
        ASSERT_FALSE(
            session.execute(command::Adapt{.theta_max = Setting::of(random.scale(6.0, 30.0)),
                                           .floor = Setting::of(0.01 * size),
                                           .budget = 20'000}));
        const Original original(session.mesh());
        ASSERT_EQ(original.text(), format_obj(start));
        cut += original.has_cuts() ? 1 : 0;
        for (int k = 0; k < 40; ++k) {
            const Command edit = random_edit(session.mesh(), size, random);
            const bool done = !session.execute(edit).has_value();
            drags += done && std::holds_alternative<command::Drag>(edit) ? 1 : 0;
            SCOPED_TRACE("edit " + std::to_string(k));
            original.expect_kept_in(session.mesh());
            if (HasFailure()) return;
        }
        inserted += session.mesh().vertex_count() - session.mesh().base_vertex_count();
        while (!session.execute(command::Undo{})) {
        }
        ASSERT_EQ(format_obj(session.mesh()), original.text());
    }
    std::printf(
        "seeds 60000 to %d: %d of %d meshes cut, %d drags, %llu vertices inserted at the ends\n",
        60'000 + cases - 1, cut, cases, drags, static_cast<unsigned long long>(inserted));
    EXPECT_GT(cut, 0);
}

}  // namespace
}  // namespace pectin
