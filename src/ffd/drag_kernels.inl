// The loops of a frame over many elements, as drag_field.h has them for one, to the bit.
// drag_stream.cpp includes this file once for each width of vector, inside a namespace: vectors of
// a compiler's own are cut to the width of the function that names them.
//
// Elements lie one after the other (three numbers a point or normal, four a weight); vectors hold
// one number each of several elements. What is left over at the end is done one by one.

using Vec4f [[gnu::vector_size(16)]] = float;
using Vec8f [[gnu::vector_size(32)]] = float;
using Vec8i [[gnu::vector_size(32)]] = std::int32_t;
using Vec4d [[gnu::vector_size(32)]] = double;

template <typename Vector, typename Number>
Vector load(const Number* p) {
    Vector v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <typename Vector, typename Number>
void store(Number* p, const Vector& v) {
    std::memcpy(p, &v, sizeof v);
}

// w of four weights.
inline Vec4d four_shares(const DragWeight* weights) {
    const float* const p = &weights->w;
    const Vec4f a = load<Vec4f>(p), b = load<Vec4f>(p + 4), c = load<Vec4f>(p + 8),
                d = load<Vec4f>(p + 12);
    const Vec4f ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Vec4f cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    return __builtin_convertvector(__builtin_shufflevector(ab, cd, 0, 1, 4, 5), Vec4d);
}

inline Vec4d magnitude(const Vec4d& v) { return v < 0.0 ? -v : v; }
inline Vec4d greater(const Vec4d& a, const Vec4d& b) { return a > b ? a : b; }

// Of many points: the least |w|, and the size of the greatest coordinate.
struct Extremes {
    double least_share = std::numeric_limits<double>::infinity(), greatest_coordinate = 0.0;
};

inline Extremes displace_all(const Vec3* __restrict rest, const DragWeight* __restrict weights,
                             const Vec3 d, Vec3* __restrict to, std::size_t count) {
    const Vec4d d0{d.x, d.y, d.z, d.x}, d1{d.y, d.z, d.x, d.y}, d2{d.z, d.x, d.y, d.z};
    Vec4d least = Vec4d{} + std::numeric_limits<double>::infinity(), greatest{};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
        const Vec4d w = four_shares(weights + i);
        const double* const p = &rest[i].x;
        const Vec4d p0 = load<Vec4d>(p), p1 = load<Vec4d>(p + 4), p2 = load<Vec4d>(p + 8);
        double* const q = &to[i].x;
        store(q, p0 + __builtin_shufflevector(w, w, 0, 0, 0, 1) * d0);
        store(q + 4, p1 + __builtin_shufflevector(w, w, 1, 1, 2, 2) * d1);
        store(q + 8, p2 + __builtin_shufflevector(w, w, 2, 3, 3, 3) * d2);
        least = -greater(-least, -magnitude(w));
        greatest = greater(greatest, greater(greater(magnitude(p0), magnitude(p1)), magnitude(p2)));
    }
    Extremes found;
    for (int lane = 0; lane < 4; ++lane) {
        found.least_share = std::min(found.least_share, least[lane]);
        found.greatest_coordinate = std::max(found.greatest_coordinate, greatest[lane]);
    }
    for (; i < count; ++i) {
        to[i] = displaced(rest[i], weights[i], d);
        const Vec3 size = glm::abs(rest[i]);
        found.least_share =
            std::min(found.least_share, std::abs(static_cast<double>(weights[i].w)));
        found.greatest_coordinate = std::max({found.greatest_coordinate, size.x, size.y, size.z});
    }
    return found;
}

// One coordinate of eight elements each.
struct Eight {
    Vec8f x, y, z;
};

// Blends first, which cost next to nothing, then one permutation a coordinate.
inline Eight eight_normals(const Vec3f* normals) {
    const float* const p = &normals->x;
    const Vec8f a = load<Vec8f>(p), b = load<Vec8f>(p + 8), c = load<Vec8f>(p + 16);
    const Vec8f ab_x = __builtin_shufflevector(a, b, 0, 9, 2, 3, 12, 5, 6, 15);
    const Vec8f ab_y = __builtin_shufflevector(a, b, 0, 1, 10, 3, 4, 13, 6, 7);
    const Vec8f ab_z = __builtin_shufflevector(a, b, 8, 1, 2, 11, 4, 5, 14, 7);
    const Vec8f x = __builtin_shufflevector(ab_x, c, 0, 1, 10, 3, 4, 13, 6, 7);
    const Vec8f y = __builtin_shufflevector(ab_y, c, 8, 1, 2, 11, 4, 5, 14, 7);
    const Vec8f z = __builtin_shufflevector(ab_z, c, 0, 9, 2, 3, 12, 5, 6, 15);
    return {__builtin_shufflevector(x, x, 0, 3, 6, 1, 4, 7, 2, 5),
            __builtin_shufflevector(y, y, 1, 4, 7, 2, 5, 0, 3, 6),
            __builtin_shufflevector(z, z, 2, 5, 0, 3, 6, 1, 4, 7)};
}

inline void store_eight(const Eight& v, Vec3f* normals) {
    const Vec8f x = __builtin_shufflevector(v.x, v.x, 0, 3, 6, 1, 4, 7, 2, 5);
    const Vec8f y = __builtin_shufflevector(v.y, v.y, 5, 0, 3, 6, 1, 4, 7, 2);
    const Vec8f z = __builtin_shufflevector(v.z, v.z, 2, 5, 0, 3, 6, 1, 4, 7);
    const Vec8f xy_a = __builtin_shufflevector(x, y, 0, 9, 2, 3, 12, 5, 6, 15);
    const Vec8f xy_b = __builtin_shufflevector(x, y, 0, 1, 10, 3, 4, 13, 6, 7);
    const Vec8f xy_c = __builtin_shufflevector(x, y, 8, 1, 2, 11, 4, 5, 14, 7);
    float* const p = &normals->x;
    store(p, __builtin_shufflevector(xy_a, z, 0, 1, 10, 3, 4, 13, 6, 7));
    store(p + 8, __builtin_shufflevector(xy_b, z, 8, 1, 2, 11, 4, 5, 14, 7));
    store(p + 16, __builtin_shufflevector(xy_c, z, 0, 9, 2, 3, 12, 5, 6, 15));
}

// ∇w of eight weights.
inline Eight eight_gradients(const DragWeight* weights) {
    const float* const p = &weights->w;
    const auto rows = [&](int i, int j) {
        return __builtin_shufflevector(load<Vec4f>(p + 4 * i), load<Vec4f>(p + 4 * j), 0, 1, 2, 3,
                                       4, 5, 6, 7);
    };
    const Vec8f r04 = rows(0, 4), r15 = rows(1, 5), r26 = rows(2, 6), r37 = rows(3, 7);
    const Vec8f low01 = __builtin_shufflevector(r04, r15, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vec8f low23 = __builtin_shufflevector(r26, r37, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vec8f high01 = __builtin_shufflevector(r04, r15, 2, 10, 3, 11, 6, 14, 7, 15);
    const Vec8f high23 = __builtin_shufflevector(r26, r37, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15)};
}

inline Vec8f square_root(Vec8f v) {
    for (int i = 0; i < 8; ++i) v[i] = std::sqrt(v[i]);
    return v;
}

inline bool any(const Vec8i& lanes) {
    using Vec4l [[gnu::vector_size(32)]] = std::int64_t;
    const Vec4l v = reinterpret_cast<const Vec4l&>(lanes);
    return (v[0] | v[1] | v[2] | v[3]) != 0;
}

inline void turn_all(const Vec3f* __restrict rest, const DragWeight* __restrict weights,
                     const Vec3 d, Vec3f* __restrict to, std::size_t count) {
    const Vec3f e{d};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        const Eight n = eight_normals(rest + i), g = eight_gradients(weights + i);
        const Vec8f stretch = 1.0f + (g.x * e.x + g.y * e.y + g.z * e.z);
        const Vec8f along = e.x * n.x + e.y * n.y + e.z * n.z;
        const Vec8f x = stretch * n.x - along * g.x;
        const Vec8f y = stretch * n.y - along * g.y;
        const Vec8f z = stretch * n.z - along * g.z;
        const Vec8f squared = x * x + y * y + z * z;
        const Vec8f scale = 1.0f / square_root(squared);
        const Vec8i bent = (g.x != 0.0f) | (g.y != 0.0f) | (g.z != 0.0f);
        store_eight({bent ? x * scale : n.x, bent ? y * scale : n.y, bent ? z * scale : n.z},
                    to + i);
        const Vec8i is_exact = (squared >= kLeastSquare) & (squared <= kGreatestSquare) &
                               (squared >= kLeastSquare * (stretch * stretch));
        if (!any(bent & ~is_exact)) continue;
        for (std::size_t k = i; k < i + 8; ++k) to[k] = covariant_normal(rest[k], weights[k], d);
    }
    for (; i < count; ++i) to[i] = covariant_normal(rest[i], weights[i], d);
}
