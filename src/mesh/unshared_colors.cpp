#include "mesh/unshared_colors.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "mesh/array_bytes.h"

namespace pectin {
namespace {

bool differ_across_seams(const TriMesh& mesh) {
    const std::vector<VertexId>& representatives = mesh.input_form().seams.representatives;
    for (std::uint32_t v = 0; v < representatives.size(); ++v) {
        if (!same_bytes(mesh.color(VertexId{v}), mesh.color(representatives[v]))) return true;
    }
    return false;
}

// Undoes all splits in a copy to find the two ends of which each inserted vertex is the midpoint.
// Then computes the colours again in the order of the splits, separately for each base face.
class Recoloring {
  public:
    Recoloring(const TriMesh& mesh, const UnsharedVertices& vertices)
        : mesh_(mesh), vertices_(vertices) {}

    std::vector<Vec3f> run() {
        undo_splits();
        for (auto m = midpoints_.rbegin(); m != midpoints_.rend(); ++m) {
            for (const FaceId base : m->bases) {
                colors_[key(base, m->m)] =
                    0.5f * color(base, m->ends.first) + 0.5f * color(base, m->ends.second);
            }
        }
        return by_vertex();
    }

  private:
    struct Midpoint {
        VertexId m;
        std::pair<VertexId, VertexId> ends;
        std::vector<FaceId> bases;  // base faces with pieces at the midpoint
    };

    static std::uint64_t key(FaceId base, VertexId v) {
        return std::uint64_t{index(base)} << 32 | index(v);
    }

    // In the order of descending levels all midpoints can be removed.
    void undo_splits() {
        TriMesh copy = mesh_;
        std::vector<VertexId> inserted;
        for (std::uint32_t v = copy.base_vertex_count(); v < copy.vertex_slots(); ++v) {
            if (copy.is_live(VertexId{v})) inserted.push_back(VertexId{v});
        }
        std::stable_sort(inserted.begin(), inserted.end(),
                         [&](VertexId v, VertexId w) { return copy.level(v) > copy.level(w); });
        for (const VertexId m : inserted) {
            const std::optional<Star> star = copy.removable(m);
            if (!star) continue;
            Midpoint midpoint{m, {star->b, star->c}, {}};
            copy.for_each_sheet(*star, [&](const Star& sheet) {
                midpoint.bases.push_back(copy.base_face(TriMesh::face(sheet.mc)));
                if (sheet.on_boundary()) return;
                midpoint.bases.push_back(copy.base_face(TriMesh::face(sheet.mb)));
            });
            midpoints_.push_back(std::move(midpoint));
            copy.unsplit(*star);
        }
    }

    const Vec3f& color(FaceId base, VertexId v) const {
        if (!mesh_.is_base(v)) {
            const auto found = colors_.find(key(base, v));
            return found == colors_.end() ? mesh_.color(v) : found->second;
        }
        const UnsharedSeams& seams = mesh_.input_form().seams;
        const std::size_t first = 3 * std::size_t{index(base)};
        for (std::size_t i = first; i < first + 3; ++i) {
            const VertexId own = seams.corner_vertices[i];
            if (seams.representatives[index(own)] == v) return mesh_.color(own);
        }
        return mesh_.color(v);
    }

    std::vector<Vec3f> by_vertex() const {
        const std::uint32_t slots = mesh_.vertex_slots();
        std::vector<Vec3f> result;
        for (std::uint32_t v = 0; v < slots; ++v) result.push_back(mesh_.color(VertexId{v}));
        for (const VertexId v : vertices_.added()) result.push_back(mesh_.color(v));
        for (std::uint32_t h = 0; h < 3 * mesh_.face_slots(); ++h) {
            const HalfEdgeId corner{h};
            if (!mesh_.is_live(TriMesh::face(corner))) continue;
            const FaceId base = mesh_.base_face(TriMesh::face(corner));
            result[vertices_.of(corner)] = color(base, mesh_.origin(corner));
        }
        return result;
    }

    const TriMesh& mesh_;
    const UnsharedVertices& vertices_;
    std::vector<Midpoint> midpoints_;  // in the order in which their splits are undone
    std::unordered_map<std::uint64_t, Vec3f> colors_;  // of inserted vertices, by base face
};

}  // namespace

std::optional<std::vector<Vec3f>> unshared_colors(const TriMesh& mesh,
                                                  const UnsharedVertices& vertices) {
    if (!mesh.has_colors() || !differ_across_seams(mesh)) return std::nullopt;
    return Recoloring(mesh, vertices).run();
}

}  // namespace pectin
