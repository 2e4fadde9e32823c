#include "mesh/face_pieces.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pectin {

// Groups the faces by base face with a counting sort.
FacePieces::FacePieces(const TriMesh& mesh) : first_(mesh.base_face_count() + std::size_t{1}, 0) {
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_live(FaceId{i})) ++first_[index(mesh.base_face(FaceId{i})) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    faces_.resize(first_.back());
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        const FaceId f{i};
        if (mesh.is_live(f)) faces_[at[index(mesh.base_face(f))]++] = f;
    }
}

bool PolygonWalk::next() {
    constexpr std::uint32_t kPastAll = std::numeric_limits<std::uint32_t>::max();
    const auto& outlines = mesh_.input_form().outlines;
    first_face_ = end_face_;
    const bool faces_left = first_face_ < mesh_.base_face_count();
    const std::uint32_t of_face = faces_left ? mesh_.polygon(FaceId{first_face_}) : kPastAll;
    const bool outlines_left = outline_end_ < outlines.size();
    const std::uint32_t of_outline = outlines_left ? outlines[outline_end_].polygon : kPastAll;
    if (!faces_left && !outlines_left) return false;

    polygon_ = std::min(of_face, of_outline);
    has_outline_ = of_outline == polygon_;
    if (has_outline_) part_ = outlines[outline_end_++].part;
    if (of_face == polygon_) part_ = mesh_.part_index(FaceId{first_face_});
    while (end_face_ < mesh_.base_face_count() && mesh_.polygon(FaceId{end_face_}) == polygon_) {
        ++end_face_;
    }
    return true;
}

}  // namespace pectin
