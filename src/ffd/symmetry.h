// Symmetry about a plane: handles and pins are met on both sides in one solve.
//
// Let M be the reflection in the plane, L the lattice of a drag, and M(L) its mirror image. The
// field is D(x) = D_L(x) + M D_L(Mx), the sum of the fields of both lattices with mirrored
// displacements. It is symmetric for any lattice. A brush stays local: it is two brushes where the
// handle and its image are far apart, and one where they meet. A symmetric cage, for which both
// lattices are the same, needs no other treatment.
//
// Within the plane D_L(x) and D_L(Mx) add up, and across it they are subtracted. So a constraint at
// q has an even row, b(q) + b(Mq), for the components within the plane, and an odd row,
// b(q) − b(Mq), for the component across it. These are two independent minimum-norm problems with
// half the unknowns each, and both are solved exactly. On the plane the odd row and all odd weights
// are exactly zero, so points of the plane stay on it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ffd/drag_field.h"
#include "ffd/lattice_field.h"
#include "geometry/box.h"

namespace pectin {

// The plane where the coordinate `axis` has the value `at`, in world space.
struct MirrorPlane {
    int axis = 0;
    double at = 0.0;

    Vec3 image(Vec3 point) const {
        point[axis] = 2.0 * at - point[axis];
        return point;
    }
    Vec3 image_of_vector(Vec3 v) const {
        v[axis] = -v[axis];
        return v;
    }
    Box image(const Box& box) const {
        Box mirrored = box;
        mirrored.min[axis] = 2.0 * at - box.max[axis];
        mirrored.max[axis] = 2.0 * at - box.min[axis];
        return mirrored;
    }
    // Returns M J M.
    Mat3 image_of_jacobian(Mat3 j) const;
    // The signed distance of a point from the plane.
    double offset(const Vec3& point) const { return point[axis] - at; }
    Vec3 onto(Vec3 point) const {
        point[axis] = at;
        return point;
    }
    bool operator==(const MirrorPlane&) const = default;
};

// What makes a drag field symmetric: the plane, and for each weight whether the values on both
// sides add up (+1, within the plane) or are subtracted (−1, across it).
struct Symmetry {
    MirrorPlane plane;
    std::vector<double> parity;  // field.weight_count()
};

// Computes w(x) = f(x) ± f(Mx) and its gradient in double and rounds them once. out:
// field.weight_count(). A point and its image get mirrored weights bit for bit.
void symmetric_weights(const DragField& field, const Symmetry& symmetry, const Vec3& x,
                       std::span<DragWeight> out);

// The influenced zones of a lattice and of its mirror image; one box if they are equal.
std::vector<Box> symmetric_zones(const MirrorPlane& plane, const Lattice& lattice);

Lattice mirror_image(const MirrorPlane& plane, const Lattice& lattice);
LatticeField mirror_image(const MirrorPlane& plane, const LatticeField& field);

// Points that are nearer to the plane than this fraction of a cell count as on the plane. The
// distance is much less than a hand can aim for, and the lattice could not tell such a point from
// its image.
inline constexpr double kOnPlaneFraction = 1e-6;

}  // namespace pectin
