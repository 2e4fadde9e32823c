// Symmetry about a plane: drags and pins are met on both sides in one solve.
//
// Let M mirror the plane, L be the lattice of a drag and M(L) its mirror image. The field is
// D(x) = D_L(x) + M D_L(Mx), the sum of both lattices' with mirrored displacements. It is symmetric
// whatever the lattice, keeps the brush local (two brushes where the points are far apart, one
// where they meet) and covers a symmetric cage, where both lattices are the same.
//
// Within the plane D_L(x) and D_L(Mx) add up, across it they subtract. So a constraint at q has an
// even row, b(q) + b(Mq), for the components within the plane, and an odd one, b(q) − b(Mq), for
// the component across it: two independent minimum-norm problems with half the unknowns, each
// solved exactly. On the plane the odd row and every odd weight vanish, to the bit: it stays where
// it is.
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
    // M J M.
    Mat3 image_of_jacobian(Mat3 j) const;
    // How far a point lies beyond the plane, with a sign.
    double offset(const Vec3& point) const { return point[axis] - at; }
    Vec3 onto(Vec3 point) const {
        point[axis] = at;
        return point;
    }
    bool operator==(const MirrorPlane&) const = default;
};

// What makes a drag field symmetric: the plane, and of every move whether its weights add up (+1,
// within the plane) or subtract (−1, across it).
struct Symmetry {
    MirrorPlane plane;
    std::vector<double> parity;  // field.weight_count()
};

// w(x) = f(x) ± f(Mx) and its gradient, in double until the end. out: field.weight_count(). A point
// and its image get mirrored weights, to the bit.
void symmetric_weights(const DragField& field, const Symmetry& symmetry, const Vec3& x,
                       std::span<DragWeight> out);

Lattice mirror_image(const MirrorPlane& plane, const Lattice& lattice);
LatticeField mirror_image(const MirrorPlane& plane, const LatticeField& field);

// Points nearer to the plane than this share of a cell lie on it: they are far below what a hand
// places, and as a pair the lattice could not tell them apart.
inline constexpr double kOnPlaneFraction = 1e-6;

}  // namespace pectin
