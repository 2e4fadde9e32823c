// Bounds the second derivative along the directions of a plane, from Bernstein coefficients.
//
// Let S_i be the coefficients of D²F, as quadratic forms of the plane, and S any form, such as
// their mean. Let |S| be the form whose matrix is the root of Σ_c S_c², the sum over the components
// c. For unit vectors e the matrix (Σ_c e_c S_c)² is no greater than Σ_c S_c², and the root
// preserves this order, so |S(u)| ≤ |S|(u). Hence
//
//     |D²F(u, u)| ≤ |S|(u) + max_i sup_v |(S_i − S)(v)|,    |u| = |v| = 1.
//
// The smaller the region, the nearer this is to the derivative, direction by direction, whereas one
// bound for all directions is that of the direction in which F bends most.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ffd/derivative_norms.h"
#include "ffd/plane_form.h"

namespace pectin {

// Upper bounds of |D²F(u, u)|, for u = x · p + y · q.
struct PlaneBend {
    double most = 0.0;  // where x² + y² = 1
    PlaneForm form;     // of (x, y)
};

// T: see derivative_norms::Cube.
template <typename T>
class PlaneBendBound {
  public:
    PlaneBendBound(const Vec3& p, const Vec3& q)
        : pp_(products(p, p)), pq_(products(p, q)), qq_(products(q, q)) {}

    // Takes account of one more piece of the region.
    void add(const std::array<derivative_norms::Cube<T>, 6>& second);
    PlaneBend bound() const;

  private:
    // In the direction cos t · p + sin t · q the form is a + b cos 2t + c sin 2t.
    struct Form {
        T a, b, c;
    };
    // The forms of the coefficients of a piece.
    struct Piece {
        derivative_norms::Cube<T> a, b, c;
    };
    // With more pieces, one bound has to do for all directions.
    static constexpr std::size_t kMostPieces = 8;
    // The error of square_root(), as a fraction of the largest value.
    static constexpr double kRootRounding = 1e-7;

    // The factors of xx, yy, zz, xy, yz and zx in the form of a and b.
    static std::array<double, 6> products(const Vec3& a, const Vec3& b) {
        return {a.x * b.x,
                a.y * b.y,
                a.z * b.z,
                a.x * b.y + a.y * b.x,
                a.y * b.z + a.z * b.y,
                a.z * b.x + a.x * b.z};
    }
    // Does not depend on which vectors p and q of the plane are taken.
    Form mean() const;

    std::array<double, 6> pp_, pq_, qq_;
    std::array<Piece, kMostPieces> pieces_;  // the first `count_`; then the last is overwritten
    std::size_t count_ = 0;
    double squared_most_ = 0.0;
};

template <typename T>
void PlaneBendBound<T>::add(const std::array<derivative_norms::Cube<T>, 6>& second) {
    Piece& piece = pieces_[std::min(count_++, kMostPieces - 1)];
    const auto combine = [&](derivative_norms::Cube<T>& to, const auto& factor) {
        for (std::size_t i = 0; i < 64; ++i) to[i] = factor(0) * second[0][i];
        for (std::size_t e = 1; e < 6; ++e) {
            for (std::size_t i = 0; i < 64; ++i) to[i] += factor(e) * second[e][i];
        }
    };
    combine(piece.a, [&](std::size_t e) { return 0.5 * (pp_[e] + qq_[e]); });
    combine(piece.b, [&](std::size_t e) { return 0.5 * (pp_[e] - qq_[e]); });
    combine(piece.c, [&](std::size_t e) { return pq_[e]; });
    for (std::size_t i = 0; i < 64; ++i) {
        squared_most_ = std::max(
            squared_most_, derivative_norms::squared_bound(piece.a[i], piece.b[i], piece.c[i]));
    }
}

template <typename T>
typename PlaneBendBound<T>::Form PlaneBendBound<T>::mean() const {
    Form sum{T{0.0}, T{0.0}, T{0.0}};
    for (std::size_t k = 0; k < count_; ++k) {
        for (std::size_t i = 0; i < 64; ++i) {
            sum.a += pieces_[k].a[i];
            sum.b += pieces_[k].b[i];
            sum.c += pieces_[k].c[i];
        }
    }
    const double factor = 1.0 / (64.0 * static_cast<double>(count_));
    return {factor * sum.a, factor * sum.b, factor * sum.c};
}

template <typename T>
PlaneBend PlaneBendBound<T>::bound() const {
    using derivative_norms::product;
    using derivative_norms::squared;
    PlaneBend result;
    if (count_ == 0) return result;
    result.most = std::sqrt(squared_most_) * derivative_norms::kRoundedUp;
    result.form = PlaneForm::circular(result.most);
    if (count_ > kMostPieces) return result;
    const Form mean = this->mean();
    double squared_deviation = 0.0;
    for (std::size_t k = 0; k < count_; ++k) {
        const Piece& piece = pieces_[k];
        for (std::size_t i = 0; i < 64; ++i) {
            squared_deviation =
                std::max(squared_deviation,
                         derivative_norms::squared_bound(piece.a[i] - mean.a, piece.b[i] - mean.b,
                                                         piece.c[i] - mean.c));
        }
    }
    const double cc = squared(mean.c);
    const PlaneForm square{squared(mean.a + mean.b) + cc, 2.0 * product(mean.a, mean.c),
                           squared(mean.a - mean.b) + cc};
    const double rounding = kRootRounding * std::sqrt(square.xx + square.yy);
    result.form = square_root(square);
    result.form += PlaneForm::circular(std::sqrt(squared_deviation) + rounding);
    result.form = derivative_norms::kRoundedUp * result.form;
    return result;
}

}  // namespace pectin
