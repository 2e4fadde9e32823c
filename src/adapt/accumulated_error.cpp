#include "adapt/accumulated_error.h"

#include <algorithm>
#include <vector>

#include "adapt/face_pairs.h"
#include "geometry/parallel.h"

namespace pectin {
namespace {

// A bound takes some microseconds.
constexpr std::uint32_t kFacesOfAPiece = 256;

}  // namespace

std::optional<double> accumulate_errors(ActiveSet& active, const Criteria& criteria) {
    const CertifiedError* const trigger = criteria.certified_error();
    if (!trigger) return std::nullopt;
    criteria.update();
    const TriMesh& mesh = active.mesh();
    std::vector<FaceId> faces =
        face_pairs::live(mesh, {active.faces().begin(), active.faces().end()});
    std::vector<double> bounds(faces.size());
    std::vector<ErrorEllipsoid> errors(faces.size());
    const auto add = [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
            bounds[i] = trigger->bound(active, faces[i]);
            errors[i] = trigger->accumulated(active, faces[i], bounds[i]);
        }
    };
    for_pieces(0, static_cast<std::uint32_t>(faces.size()), add, kFacesOfAPiece);
    const double largest = bounds.empty() ? 0.0 : *std::ranges::max_element(bounds);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (errors[i] == mesh.error(faces[i])) continue;
        faces[changed] = faces[i];
        errors[changed++] = errors[i];
    }
    faces.resize(changed);
    errors.resize(changed);
    active.set_errors(faces, errors);
    return largest;
}

double largest_error(const TriMesh& mesh) {
    double largest = 0.0;
    for (std::uint32_t f = 0; f < mesh.face_slots() && mesh.tracks_errors(); ++f) {
        const ErrorEllipsoid error = mesh.error(FaceId{f});
        if (error.rough_radius() > largest) largest = std::max(largest, error.radius());
    }
    return largest;
}

}  // namespace pectin
