// The time of the bound that the certified trigger asks for each face.
//
// THIS IS THE PART TO FILL IN where the bound gets another interface: the study leaves it out of
// its table if the header is absent, or if InterpolationError has no such members.
#include "study/certificate.h"

#include <array>
#include <span>
#include <vector>

#if __has_include("ffd/interpolation_error.h")
#include "ffd/interpolation_error.h"
#define PECTIN_HAS_CERTIFICATE
#endif

namespace pectin::study {

#ifdef PECTIN_HAS_CERTIFICATE

namespace {

using Corners = std::array<Vec3, 3>;

std::vector<Corners> rest_faces(const Scene& scene) {
    std::vector<Corners> faces;
    for (const FaceId f : scene.faces()) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const HalfEdgeId h = TriMesh::half_edge(f, static_cast<int>(k));
            corners[k] = scene.active().rest_position(scene.active().mesh().origin(h));
        }
        faces.push_back(corners);
    }
    return faces;
}

template <typename Ask>
Json row(const char* what, const std::vector<Corners>& faces, int repetitions, Ask ask) {
    double sum = 0.0;
    const double ns = median_of(static_cast<std::size_t>(repetitions), [&] {
        const double time = own_seconds([&] {
            for (const Corners& corners : faces) sum += ask(corners);
        });
        return 1e9 * time / static_cast<double>(faces.size());
    });
    return {{"what", what}, {"ns", ns}, {"sum", sum}};
}

template <typename Error>
Json rows(const Scene& scene, int repetitions) {
    Json result = Json::array();
    if constexpr (requires(Error & e, const Corners& c, std::span<const Corners> s) {
                      e.update();
                      e.bound(s);
                      e.slope_estimate(c);
                  }) {
        Error error(scene.warp());
        error.update();
        const std::vector<Corners> faces = rest_faces(scene);
        result.push_back(
            row("certified: the bound of a face", faces, repetitions, [&](const Corners& c) {
                return error.bound({&c, 1});
            }));
        if (error.is_proportional()) {
            result.push_back(row("certified: the estimate that says when a face is due", faces,
                                 repetitions,
                                 [&](const Corners& c) { return error.slope_estimate(c); }));
        }
    }
    return result;
}

}  // namespace

Json certificate_times(const Scene& scene, int repetitions) {
    return rows<InterpolationError>(scene, repetitions);
}

#else

Json certificate_times(const Scene&, int) { return Json::array(); }

#endif

}  // namespace pectin::study
