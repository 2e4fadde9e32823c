// How far a mesh is from the surface that it stands for.
//
// That surface is the warp's image of the flat faces at rest. Each face of the deformed mesh is a
// piece of a face at rest, and it is compared with the image of just that piece.
#pragma once

#include <cstdint>
#include <vector>

#include "ffd/warp.h"
#include "study/scene.h"

namespace pectin::study {

// The image of a point, in double throughout (an embedding rounds the weights of drags to float).
Vec3 exact_image(const Warp& warp, const Vec3& x);

// Three distances of the image F(x) of a point x of a face at rest, each at least as large as the
// one before it:
// - from the mesh near that face, that is from the nearest of all faces that share a corner with
//   it: what crosses the border of a face within a plane, as under a twist, does not count;
// - from the deformed face itself, from its nearest point;
// - from the point with the same barycentric coordinates on the deformed face: what linear
//   interpolation errs by. It counts what slides along the face, too.
struct TrueError {
    double from_mesh = 0.0;  // the largest of all samples
    double from_face = 0.0;
    double from_face_rms = 0.0;  // over the area at rest
    double from_interpolation = 0.0;
    std::uint64_t samples = 0;
};

// Samples each of these faces at the points of a regular grid in barycentric coordinates. Along the
// longest edge at rest there are at least 8 intervals, and at least 24 for each cell of the finest
// lattice. Cost: O(samples), on all threads.
TrueError true_error(const Scene& scene, const std::vector<FaceId>& faces);

// The smallest angles of faces at rest, in degrees: the smallest of all and the median.
struct Angles {
    double smallest = 0.0, median = 0.0;
};
Angles smallest_angles(const Scene& scene, const std::vector<FaceId>& faces);

}  // namespace pectin::study
