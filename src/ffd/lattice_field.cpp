#include "ffd/lattice_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "ffd/cofactor.h"
#include "ffd/cubic_basis.h"
#include "ffd/injectivity.h"

namespace pectin {
namespace {

// Calls visit(control index, a, b, c) for each of the 4 × 4 × 4 control points around a point that
// is deformable; a, b and c are its positions in the three spans.
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

std::vector<Box> zones_of(const LatticeField& field) { return {field.lattice().influenced_zone()}; }

std::vector<LatticeField> merged_lattices(const LatticeField& field) { return {field}; }

double reach_bound(const LatticeField&) { return std::numeric_limits<double>::infinity(); }

double lipschitz_bound(const LatticeField&) { return std::numeric_limits<double>::infinity(); }

double injective_limit(const LatticeField& field, double most) {
    return injective_limit(std::span(&field, 1), most);
}

}  // namespace pectin
