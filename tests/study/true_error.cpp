#include "study/true_error.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <variant>

#include "geometry/parallel.h"

namespace pectin::study {
namespace {

constexpr int kLeastIntervals = 8, kMostIntervals = 400;
constexpr double kIntervalsPerCell = 24.0;

using Corners = std::array<Vec3, 3>;

Vec3 image_by(const DragStep& drag, const Vec3& x) {
    if (drag.symmetry) {
        std::vector<DragWeight> weights(weight_count(drag));
        weights_at(drag, x, weights);
        return image(drag, x, weights);
    }
    std::vector<DragField::ExactWeight> weights(weight_count(drag));
    drag.field.exact_weights(x, 0, weights);
    Vec3 sum{0.0};
    for (std::size_t c = 0; c < weights.size(); ++c) sum += weights[c].w * drag.displacements[c];
    return x + sum;
}

template <typename Other>
Vec3 image_by(const Other& deformation, const Vec3& x) {
    return image(deformation, x, {});
}

Corners rest_corners(const ActiveSet& active, FaceId f) {
    Corners corners;
    for (int k = 0; k < 3; ++k) {
        const VertexId v = active.mesh().origin(TriMesh::half_edge(f, k));
        corners[static_cast<std::size_t>(k)] = active.rest_position(v);
    }
    return corners;
}

Corners present_corners(const TriMesh& mesh, FaceId f) {
    Corners corners;
    for (int k = 0; k < 3; ++k) {
        corners[static_cast<std::size_t>(k)] = mesh.position(mesh.origin(TriMesh::half_edge(f, k)));
    }
    return corners;
}

double longest_edge(const Corners& c) {
    return std::max(
        {glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
}

// The faces at each vertex, of some faces of a mesh.
class FacesAtVertices {
  public:
    FacesAtVertices(const TriMesh& mesh, const std::vector<FaceId>& faces)
        : mesh_(mesh), first_(mesh.vertex_slots() + 1) {
        const auto for_each = [&](auto visit) {
            for (const FaceId f : faces) {
                for (int k = 0; k < 3; ++k) visit(mesh.origin(TriMesh::half_edge(f, k)), f);
            }
        };
        for_each([&](VertexId v, FaceId) { ++first_[index(v) + 1]; });
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        faces_.resize(first_.back());
        std::vector<std::uint32_t> next(first_);
        for_each([&](VertexId v, FaceId f) { faces_[next[index(v)]++] = f; });
    }

    // The distance of a point from the nearest face that shares a corner with f.
    double distance_near(FaceId f, const Vec3& x) const {
        double squared = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t v = index(mesh_.origin(TriMesh::half_edge(f, k)));
            for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) {
                const Corners c = present_corners(mesh_, faces_[i]);
                const Vec3 to = nearest_on_triangle(x, c[0], c[1], c[2]) - x;
                squared = std::min(squared, glm::dot(to, to));
            }
        }
        return std::sqrt(squared);
    }

  private:
    const TriMesh& mesh_;
    std::vector<std::uint32_t> first_;  // into faces_, by vertex
    std::vector<FaceId> faces_;
};

// Sums over some faces.
struct Sums {
    double from_face = 0.0, from_interpolation = 0.0;
    double weighted_squares = 0.0, area = 0.0;
    std::uint64_t samples = 0;

    void add(const Sums& other) {
        from_face = std::max(from_face, other.from_face);
        from_interpolation = std::max(from_interpolation, other.from_interpolation);
        weighted_squares += other.weighted_squares;
        area += other.area;
        samples += other.samples;
    }
};

void raise(std::atomic<double>& largest, double value) {
    double before = largest;
    while (before < value && !largest.compare_exchange_weak(before, value)) {
    }
}

// Adds the errors of one face. from_mesh: the largest of all faces so far.
void add_errors(Sums& to, std::atomic<double>& from_mesh, const Scene& scene, FaceId f,
                const FacesAtVertices& around, double cell) {
    const Corners rest = rest_corners(scene.active(), f);
    const Corners present = present_corners(scene.active().mesh(), f);
    const int n = std::clamp(static_cast<int>(longest_edge(rest) / cell * kIntervalsPerCell),
                             kLeastIntervals, kMostIntervals);
    Sums sums;
    double squares = 0.0;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
            const auto at = [&](const Corners& c) {
                return (1.0 - u - v) * c[0] + u * c[1] + v * c[2];
            };
            const Vec3 image = exact_image(scene.warp(), at(rest));
            const double from_face = glm::distance(
                image, nearest_on_triangle(image, present[0], present[1], present[2]));
            sums.from_face = std::max(sums.from_face, from_face);
            // No neighbour can make it larger.
            if (from_face > from_mesh) {
                raise(from_mesh, around.distance_near(f, image));
            }
            sums.from_interpolation =
                std::max(sums.from_interpolation, glm::distance(image, at(present)));
            squares += from_face * from_face;
            ++sums.samples;
        }
    }
    sums.area = 0.5 * glm::length(glm::cross(rest[1] - rest[0], rest[2] - rest[0]));
    sums.weighted_squares = sums.area * squares / static_cast<double>(sums.samples);
    to.add(sums);
}

}  // namespace

Vec3 exact_image(const Warp& warp, const Vec3& x) {
    Vec3 image = x;
    for (const Deformation& step : warp.steps) {
        image = dispatch(step, [&](const auto& d) { return image_by(d, image); });
    }
    return image;
}

TrueError true_error(const Scene& scene, const std::vector<FaceId>& faces) {
    const double cell = scene.warp().smallest_feature_extent();
    const FacesAtVertices around(scene.active().mesh(), faces);
    Sums sums;
    std::atomic<double> from_mesh = 0.0;
    std::mutex adding;
    for_pieces(
        0, static_cast<std::uint32_t>(faces.size()),
        [&](std::uint32_t first, std::uint32_t end) {
            Sums some;
            for (std::uint32_t i = first; i < end; ++i) {
                add_errors(some, from_mesh, scene, faces[i], around, cell);
            }
            const std::lock_guard lock(adding);
            sums.add(some);
        },
        256);
    return {.from_mesh = from_mesh,
            .from_face = sums.from_face,
            .from_face_rms = sums.area > 0.0 ? std::sqrt(sums.weighted_squares / sums.area) : 0.0,
            .from_interpolation = sums.from_interpolation,
            .samples = sums.samples};
}

Angles smallest_angles(const Scene& scene, const std::vector<FaceId>& faces) {
    std::vector<double> angles;
    for (const FaceId f : faces) {
        const Corners c = rest_corners(scene.active(), f);
        double smallest = 180.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = c[(k + 1) % 3] - c[k], q = c[(k + 2) % 3] - c[k];
            const double angle = std::atan2(glm::length(glm::cross(p, q)), glm::dot(p, q));
            smallest = std::min(smallest, angle * 180.0 / std::numbers::pi);
        }
        angles.push_back(smallest);
    }
    if (angles.empty()) return {};
    return {.smallest = std::ranges::min(angles), .median = median(angles)};
}

}  // namespace pectin::study
