#include "support/exact_surface.h"

#include <algorithm>

#include "adapt/decimate.h"
#include "mesh/active_set.h"
#include "support/mesh_figures.h"

namespace pectin::test {

void ExactImage::add(const Warp& warp) {
    for (const Deformation& step : warp.steps) steps_.push_back(merged_lattices(step));
}

Vec3 ExactImage::operator()(Vec3 point) const {
    for (const auto& fields : steps_) {
        Vec3 displacement{0.0};
        for (const LatticeField& field : fields) displacement += field.displacement(point);
        point += displacement;
    }
    return point;
}

double sampled_error(const ExactImage& image, const Corners& rest, const Corners& now, int count) {
    double farthest = 0.0;
    for_each_sample(count, [&](const Vec3& weights) {
        const double distance =
            glm::distance(image(point_of(rest, weights)), point_of(now, weights));
        farthest = std::max(farthest, distance);
    });
    return farthest;
}

Corners corners_of(const TriMesh& mesh, FaceId f) {
    Corners corners;
    for (int c = 0; c < 3; ++c) {
        corners[static_cast<std::size_t>(c)] = mesh.position(mesh.origin(TriMesh::half_edge(f, c)));
    }
    return corners;
}

TriMesh on_original_surface(const TriMesh& mesh, const TriMesh& base) {
    TriMesh original = mesh;
    ActiveSet active(original);
    active.begin(live_faces(original), Box{});
    decimate(active, Criteria(AdaptLimits{}, std::nullopt, std::nullopt));
    const MeshChange change = active.finish();
    for (std::uint32_t v = 0; v < base.vertex_slots(); ++v) {
        original.set_position(VertexId{v}, base.position(VertexId{v}));
    }
    for (std::size_t i = change.edits.size(); i-- > 0;) original.split(change.edits[i].edge());
    return original;
}

}  // namespace pectin::test
