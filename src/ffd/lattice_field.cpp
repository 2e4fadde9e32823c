#include "ffd/lattice_field.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "ffd/basis.h"
#include "ffd/cofactor.h"

namespace pectin {
namespace {

// Calls visit(index of a control point, position a, b, c in the three spans) for the deformable
// ones among the 4 × 4 × 4 control points that reach a point.
template <typename Visit>
void for_each_control(const Lattice& lattice, const std::array<BasisSpan, 3>& spans,
                      const Visit& visit) {
    std::array<int, 3> from{}, to{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int count = lattice.deformable[static_cast<int>(axis)];
        from[axis] = std::max(0, -spans[axis].first);
        to[axis] = std::min(4, count - spans[axis].first);
    }
    for (int c = from[2]; c < to[2]; ++c) {
        for (int b = from[1]; b < to[1]; ++b) {
            for (int a = from[0]; a < to[0]; ++a) {
                const IVec3 control{spans[0].first + a, spans[1].first + b, spans[2].first + c};
                visit(lattice.control_index(control), static_cast<std::size_t>(a),
                      static_cast<std::size_t>(b), static_cast<std::size_t>(c));
            }
        }
    }
}

std::array<BasisSpan, 3> spans_at(const Lattice& lattice, const Vec3& x) {
    const Vec3 u = lattice.parameter(x);
    return {basis_span(u.x), basis_span(u.y), basis_span(u.z)};
}

}  // namespace

LatticeField::LatticeField(const Lattice& lattice, std::vector<Vec3> displacements)
    : lattice_(lattice), displacements_(std::move(displacements)) {
    assert(lattice_.is_valid() && displacements_.size() == lattice_.control_count());
}

Vec3 LatticeField::displacement(const Vec3& x) const {
    Vec3 sum{0.0};
    if (!lattice_.influences(x)) return sum;
    const auto spans = spans_at(lattice_, x);
    for_each_control(
        lattice_, spans, [&](std::size_t control, std::size_t a, std::size_t b, std::size_t c) {
            sum +=
                spans[0].value[a] * spans[1].value[b] * spans[2].value[c] * displacements_[control];
        });
    return sum;
}

Mat3 LatticeField::jacobian(const Vec3& x) const {
    Mat3 sum{1.0};
    if (!lattice_.influences(x)) return sum;
    const auto spans = spans_at(lattice_, x);
    for_each_control(lattice_, spans,
                     [&](std::size_t control, std::size_t a, std::size_t b, std::size_t c) {
                         const auto& [u, v, w] = spans;
                         const Vec3 gradient = Vec3{u.derivative[a] * v.value[b] * w.value[c],
                                                    u.value[a] * v.derivative[b] * w.value[c],
                                                    u.value[a] * v.value[b] * w.derivative[c]} /
                                               lattice_.cell;
                         sum += glm::outerProduct(displacements_[control], gradient);
                     });
    return sum;
}

Vec3f covariant(const Mat3& jacobian, const Vec3f& n) {
    if (jacobian == Mat3{1.0}) return n;
    return Vec3f{unit_or_zero(cofactor_times(jacobian, Vec3{n}))};
}

Vec3 contravariant(const Mat3& jacobian, const Vec3& t) { return jacobian * t; }

}  // namespace pectin
