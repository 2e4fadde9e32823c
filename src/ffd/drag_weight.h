// The weight of one drag at one point, and the deformation of that point by weights.
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999: equation 3.
//
// A frame of a gesture calls these functions for every vertex and normal. Where one drag acts they
// do not branch on the data, and ffd/drag_stream.h has them as loops over arrays.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "ffd/cofactor.h"
#include "geometry/vec.h"

namespace pectin {

// The part of a drag's displacement that a point takes: the point moves by w·d.
struct DragWeight {
    float w = 0.0f;
    Vec3f gradient{0.0f};  // ∂w/∂x, per world unit
};
static_assert(sizeof(DragWeight) == 16);

// The rest position, displaced. weights and d have the same length.
inline Vec3 displaced(const Vec3& rest, const DragWeight& weight, const Vec3& d) {
    return rest + static_cast<double>(weight.w) * d;
}
inline Vec3 displaced(const Vec3& rest, std::span<const DragWeight> weights,
                      std::span<const Vec3> d) {
    if (weights.size() == 1) return displaced(rest, weights[0], d[0]);
    Vec3 sum{0.0};
    for (std::size_t c = 0; c < weights.size(); ++c) {
        sum += static_cast<double>(weights[c].w) * d[c];
    }
    return rest + sum;
}

// J = I + Σ d_c ∇w_cᵀ, in world units.
inline Mat3 jacobian(std::span<const DragWeight> weights, std::span<const Vec3> d) {
    Mat3 sum{1.0};
    for (std::size_t c = 0; c < weights.size(); ++c) {
        sum += glm::outerProduct(d[c], Vec3{weights[c].gradient});
    }
    return sum;
}

// det J, which is not positive where space folds. For one drag det(I + d ∇wᵀ) = 1 + ∇w·d.
inline double jacobian_determinant(const DragWeight& weight, const Vec3& d) {
    return 1.0 + glm::dot(Vec3{weight.gradient}, d);
}
inline double jacobian_determinant(std::span<const DragWeight> weights, std::span<const Vec3> d) {
    if (weights.size() == 1) return jacobian_determinant(weights[0], d[0]);
    return glm::determinant(jacobian(weights, d));
}

// Whether a drag changes directions at a point at all.
inline bool bends(const DragWeight& weight, const Vec3& d) {
    return weight.gradient != Vec3f{0.0f} && d != Vec3{0.0};
}

// If |image|² lies between these bounds, the image of a unit normal computed in float is accurate
// to some units in the last place. It is then neither out of range nor the small difference of
// larger terms.
inline constexpr float kLeastSquare = 0.0625f, kGreatestSquare = 1e30f;

// Equation 3: normalise(cof(J)·n). For one drag cof(I + d ∇wᵀ)·n = (1 + ∇w·d) n − (d·n) ∇w, so no
// matrix is formed. Where no drag bends anything, n is returned bit for bit. A zero n gives zero,
// and so does an n whose image has no direction. One drag is computed in float where that is
// accurate enough (the terms are about as large as the greater of 1 and |1 + ∇w·d|), else in
// double.
inline Vec3f covariant_normal(const Vec3f& n, const DragWeight& weight, const Vec3& d) {
    if (!bends(weight, d)) return n;
    const Vec3f& g = weight.gradient;
    const Vec3f e{d};
    const float stretch = 1.0f + glm::dot(g, e);
    const Vec3f image = stretch * n - glm::dot(e, n) * g;
    const float squared = glm::dot(image, image);
    if (squared >= kLeastSquare && squared <= kGreatestSquare &&
        squared >= kLeastSquare * (stretch * stretch)) {
        return (1.0f / std::sqrt(squared)) * image;
    }
    const Vec3 normal{n}, gradient{g};
    return Vec3f{
        unit_or_zero((1.0 + glm::dot(gradient, d)) * normal - glm::dot(d, normal) * gradient)};
}
inline Vec3f covariant_normal(const Vec3f& n, std::span<const DragWeight> weights,
                              std::span<const Vec3> d) {
    if (weights.size() == 1) return covariant_normal(n, weights[0], d[0]);
    bool any = false;
    for (std::size_t c = 0; c < weights.size() && !any; ++c) any = bends(weights[c], d[c]);
    return any ? Vec3f{unit_or_zero(cofactor_times(jacobian(weights, d), Vec3{n}))} : n;
}

}  // namespace pectin
