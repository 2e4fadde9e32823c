// The twelve objects and drags that meshes are compared on.
#pragma once

#include <string>
#include <vector>

#include "ffd/warp.h"
#include "geometry/move.h"
#include "mesh/shapes.h"
#include "study/scene.h"

namespace pectin::study {

struct Cases {
    std::vector<Case> cases;
    bool has_models = false;  // false: all objects are shapes that the program makes itself
};

// models: a folder with spot.obj, suzanne.obj, fandisk.obj and rocker-arm.obj. Where one is missing
// a shape takes its place.
Cases twelve_cases(const std::string& models);

TriMesh shape(ShapeKind kind, int resolution);

// The position of the vertex that is farthest in a direction.
Vec3 extreme_point(const TriMesh& mesh, const Vec3& direction);

// A drag of one point with a brush; Move has its twist and scale. fold_free: in several steps.
Warp brush_drag(const Move& move, double radius, int span = 3, bool fold_free = false);

}  // namespace pectin::study
