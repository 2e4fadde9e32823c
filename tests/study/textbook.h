// The tests of an edge as a textbook writes them, in any number type: for counting their operations
// and for timing them all in the same style.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 4, point 2 and figure 5; equation 1.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pectin::study {

template <typename T>
using Point = std::array<T, 3>;

template <typename T>
Point<T> add(const Point<T>& a, const Point<T>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <typename T>
Point<T> subtract(const Point<T>& a, const Point<T>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename T>
Point<T> scale(T s, const Point<T>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
template <typename T>
T dot(const Point<T>& a, const Point<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename T>
Point<T> cross(const Point<T>& a, const Point<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
Point<T> midpoint(const Point<T>& a, const Point<T>& b) {
    return scale(T(0.5), add(a, b));
}

// A cubic B-spline hyperpatch whose control points have been displaced. Control point (i, j, k)
// rests at origin + (i, j, k) cell; a point in cell (i, j, k) depends on those from (i-1, …) to
// (i+2, …).
template <typename T>
struct Hyperpatch {
    Point<T> origin, cell;
    int count = 0;  // of control points on each axis
    std::vector<Point<T>> control_points;

    const Point<T>& at(int i, int j, int k) const {
        return control_points[static_cast<std::size_t>(i + count * (j + count * k))];
    }
};

// The four cubics at a parameter from 0 to 1 in the cell.
template <typename T>
std::array<T, 4> cubics(T t) {
    const T s = T(1.0) - t, t2 = t * t, t3 = t2 * t, s3 = s * s * s;
    const T sixth = T(1.0 / 6.0);
    const T first = sixth * s3, last = sixth * t3;
    const T second = T(0.5) * t3 - t2 + T(2.0 / 3.0);
    return {first, second, T(1.0) - first - second - last, last};
}

// Equation 1: one axis after the other, 16 rows, 4 sums of rows, and their sum.
template <typename T>
Point<T> image(const Hyperpatch<T>& patch, const Point<T>& x) {
    using std::floor;
    std::array<int, 3> first{};
    std::array<std::array<T, 4>, 3> basis;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const T u = (x[axis] - patch.origin[axis]) / patch.cell[axis];
        first[axis] = static_cast<int>(floor(u)) - 1;
        basis[axis] = cubics<T>(u - T(static_cast<double>(first[axis] + 1)));
    }
    const auto weighted = [](const std::array<T, 4>& b, const auto& term) {
        Point<T> sum = scale(b[0], term(0));
        for (int i = 1; i < 4; ++i) {
            sum = add(sum, scale(b[static_cast<std::size_t>(i)], term(i)));
        }
        return sum;
    };
    return weighted(basis[2], [&](int k) {
        return weighted(basis[1], [&](int j) {
            return weighted(basis[0], [&](int i) {
                return patch.at(first[0] + i, first[1] + j, first[2] + k);
            });
        });
    });
}

// What a test of an edge reads: its ends and the apexes of its faces, at rest and deformed.
template <typename T>
struct TestedEdge {
    Point<T> rest_b, rest_c;
    Point<T> a, b, c, d;
    Point<T> normal_b, normal_c;  // of unit length
};

// The paper's epsilon = 1 - n1.n2, which is compared with 1 - cos(theta_max).
template <typename T>
T endpoint_normals(const TestedEdge<T>& e) {
    return T(1.0) - dot(e.normal_b, e.normal_c);
}

// What a split needs after that: where the midpoint goes.
template <typename T>
Point<T> image_of_midpoint(const Hyperpatch<T>& patch, const TestedEdge<T>& e) {
    return image(patch, midpoint(e.rest_b, e.rest_c));
}

template <typename T>
Point<T> face_normal(const Point<T>& p, const Point<T>& q, const Point<T>& r) {
    using std::sqrt;
    const Point<T> n = cross(subtract(q, p), subtract(r, p));
    const T length = sqrt(dot(n, n));
    return {n[0] / length, n[1] / length, n[2] / length};
}

// Griessmair and Purgathofer's distance of the midpoint's image from the faces at the edge.
template <typename T>
T midpoint_distance(const Hyperpatch<T>& patch, const TestedEdge<T>& e) {
    using std::abs;
    const Point<T> delta = subtract(image_of_midpoint(patch, e), midpoint(e.b, e.c));
    const Point<T> f1 = face_normal(e.b, e.c, e.a), f2 = face_normal(e.c, e.b, e.d);
    return abs(dot(f1, delta)) + abs(dot(f2, delta));
}

}  // namespace pectin::study
