#include "study/scene.h"

#include <algorithm>

#include "mesh/face_tree.h"

namespace pectin::study {

double Case::largest_coordinate() const {
    const Box box = mesh.bounding_box();
    const Vec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    return std::max({farthest.x, farthest.y, farthest.z});
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Scene::Scene(const TriMesh& mesh, const Warp& warp) : mesh_(mesh), warp_(warp), active_(mesh_) {
    active_.begin(FaceTree(mesh_).faces_meeting(warp_.zone(), mesh_), warp_.zone());
    embedding_ = std::make_unique<Embedding>(active_, warp_);
    embedding_->embed();
    embedding_->deform();
}

Criteria Scene::criteria(const AdaptLimits& limits) const {
    return {limits, warp_.zones(), warp_.zones(), embedding_.get()};
}

std::vector<FaceId> Scene::faces() const {
    std::vector<FaceId> faces;
    for (const FaceId f : active_.faces()) {
        if (mesh_.is_live(f)) faces.push_back(f);
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

TriMesh Scene::finish() {
    active_.finish();
    return mesh_;
}

}  // namespace pectin::study
