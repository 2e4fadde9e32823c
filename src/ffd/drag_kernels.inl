// The functions of drag_weight.h as loops over many elements, with the same results bit for bit.
// drag_stream.cpp includes this file once for each width of vectors, inside a namespace that
// defines the width in floats as kSimdWidth. One function for all widths would not do, since the
// compiler divides its vector types to suit the instruction set of the function that uses them.
//
// In memory the numbers of an element lie together (three of a point or normal, four of a weight).
// A vector holds one number of several elements. The elements that remain at the end of an array
// are handled one by one.

using Floats [[gnu::vector_size(kSimdWidth * 4)]] = float;
using Ints [[gnu::vector_size(kSimdWidth * 4)]] = std::int32_t;
using Doubles [[gnu::vector_size(kSimdWidth * 4)]] = double;
using HalfFloats [[gnu::vector_size(kSimdWidth * 2)]] = float;

constexpr std::size_t kDoubles = kSimdWidth / 2;

template <typename Vector, typename Number>
inline Vector load(const Number* p) {
    Vector v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <typename Vector, typename Number>
inline void store(Number* p, const Vector& v) {
    std::memcpy(p, &v, sizeof v);
}

// Lane i of the result is lane From::lane(i) of a and b together; the lanes of b follow those of a.
template <typename From, typename Vector, std::size_t... I>
inline auto shuffle(const Vector& a, const Vector& b, std::index_sequence<I...>) {
    return __builtin_shufflevector(a, b, From::lane(I)...);
}
template <typename From>
inline Floats shuffle(const Floats& a, const Floats& b) {
    return shuffle<From>(a, b, std::make_index_sequence<kSimdWidth>{});
}

// Prefetches what will be read or written kPrefetchDistance elements later. The machine itself
// would notice too late, since a pass changes from one array to the next every few elements. A
// prefetch past the end has no effect.
constexpr std::size_t kPrefetchDistance = 128, kCacheLine = 64;
enum class For { reading, writing };

template <For kFor, typename Element>
inline void prefetch(const Element* elements, std::size_t count) {
    const std::uintptr_t first =
        reinterpret_cast<std::uintptr_t>(elements) + kPrefetchDistance * sizeof *elements;
    for (std::size_t i = 0; i < count * sizeof *elements; i += kCacheLine) {
        __builtin_prefetch(reinterpret_cast<const void*>(first + i), kFor == For::writing);
    }
}

// --- Weights, four vectors at a time

// Four weights form a square in one quarter (16 bytes) of four vectors, and each square is
// transposed within its quarter. This gives the weights of four vectors the following order.
constexpr std::size_t weight_in(std::size_t lane) { return lane % 4 * (kSimdWidth / 4) + lane / 4; }
constexpr std::size_t lane_of(std::size_t weight) {
    return weight % (kSimdWidth / 4) * 4 + weight / (kSimdWidth / 4);
}

// Interleaves the numbers kFirst and kFirst + 1 of each quarter of two vectors.
template <std::size_t kFirst>
struct Interleaved {
    static constexpr std::size_t lane(std::size_t i) {
        return i / 4 * 4 + kFirst + i % 4 / 2 + i % 2 * kSimdWidth;
    }
};
// Puts the numbers kFirst and kFirst + 1 of each quarter of two vectors beside each other.
template <std::size_t kFirst>
struct Paired {
    static constexpr std::size_t lane(std::size_t i) {
        return i / 4 * 4 + kFirst + i % 2 + i % 4 / 2 * kSimdWidth;
    }
};

// The coordinates of kSimdWidth elements, in the order of weight_in().
struct Coordinates {
    Floats x, y, z;
};

inline Coordinates load_gradients(const DragWeight* weights) {
    const float* const p = &weights->w;
    const Floats a = load<Floats>(p), b = load<Floats>(p + kSimdWidth),
                 c = load<Floats>(p + 2 * kSimdWidth), d = load<Floats>(p + 3 * kSimdWidth);
    const Floats wx_ab = shuffle<Interleaved<0>>(a, b), wx_cd = shuffle<Interleaved<0>>(c, d);
    const Floats yz_ab = shuffle<Interleaved<2>>(a, b), yz_cd = shuffle<Interleaved<2>>(c, d);
    return {shuffle<Paired<2>>(wx_ab, wx_cd), shuffle<Paired<0>>(yz_ab, yz_cd),
            shuffle<Paired<2>>(yz_ab, yz_cd)};
}

// The w of kDoubles weights.
struct FirstOfFours {
    static constexpr std::size_t lane(std::size_t i) { return i * 4; }
};
inline Doubles load_weights(const DragWeight* weights) {
    const float* const p = &weights->w;
    const Floats a = load<Floats>(p), b = load<Floats>(p + kSimdWidth);
    const HalfFloats w = shuffle<FirstOfFours>(a, b, std::make_index_sequence<kDoubles>{});
    return __builtin_convertvector(w, Doubles);
}

// --- Points and normals, three vectors at a time

// Lane i of vector v holds coordinate (v kSimdWidth + i) % 3. kSimdWidth is not a multiple of 3, so
// each lane holds each coordinate in one of the three vectors. Two blends, which cost almost
// nothing, therefore gather one coordinate of all elements, and one permutation puts it in order.
constexpr std::size_t coordinate_in(std::size_t vector, std::size_t lane) {
    return (vector * kSimdWidth + lane) % 3;
}
constexpr std::size_t vector_with(std::size_t coordinate, std::size_t lane) {
    return coordinate_in(0, lane) == coordinate ? 0 : coordinate_in(1, lane) == coordinate ? 1 : 2;
}

// Takes the lanes of b in which the coordinate lies in vector kVector, and else those of a.
template <std::size_t kCoordinate, std::size_t kVector>
struct Gathered {
    static constexpr std::size_t lane(std::size_t i) {
        return vector_with(kCoordinate, i) == kVector ? kSimdWidth + i : i;
    }
};
template <std::size_t kCoordinate>
struct InOrder {
    static constexpr std::size_t lane(std::size_t i) {
        return (3 * weight_in(i) + kCoordinate) % kSimdWidth;
    }
};
template <std::size_t kCoordinate>
inline Floats coordinate(const Floats& a, const Floats& b, const Floats& c) {
    const Floats ab = shuffle<Gathered<kCoordinate, 1>>(a, b);
    const Floats abc = shuffle<Gathered<kCoordinate, 2>>(ab, c);
    return shuffle<InOrder<kCoordinate>>(abc, abc);
}
inline Coordinates load_normals(const Vec3f* normals) {
    const float* const p = &normals->x;
    const Floats a = load<Floats>(p), b = load<Floats>(p + kSimdWidth),
                 c = load<Floats>(p + 2 * kSimdWidth);
    return {coordinate<0>(a, b, c), coordinate<1>(a, b, c), coordinate<2>(a, b, c)};
}

// The inverse of Gathered and InOrder.
template <std::size_t kCoordinate>
struct Spread {
    static constexpr std::size_t lane(std::size_t i) {
        std::size_t element = 0;
        while ((3 * element + kCoordinate) % kSimdWidth != i) ++element;
        return lane_of(element);
    }
};
template <std::size_t kVector, std::size_t kCoordinate>
struct Scattered {
    static constexpr std::size_t lane(std::size_t i) {
        return coordinate_in(kVector, i) == kCoordinate ? kSimdWidth + i : i;
    }
};
template <std::size_t kVector>
inline Floats mixed(const Coordinates& spread) {
    const Floats xy = shuffle<Scattered<kVector, 1>>(spread.x, spread.y);
    return shuffle<Scattered<kVector, 2>>(xy, spread.z);
}
inline void store_normals(const Coordinates& v, Vec3f* normals) {
    const Coordinates spread{shuffle<Spread<0>>(v.x, v.x), shuffle<Spread<1>>(v.y, v.y),
                             shuffle<Spread<2>>(v.z, v.z)};
    float* const p = &normals->x;
    store(p, mixed<0>(spread));
    store(p + kSimdWidth, mixed<1>(spread));
    store(p + 2 * kSimdWidth, mixed<2>(spread));
}

// --- Positions

// Three vectors hold the coordinates of kDoubles points. Owner is the point of each lane.
template <std::size_t kVector>
struct Owner {
    static constexpr std::size_t lane(std::size_t i) { return (kVector * kDoubles + i) / 3; }
};
template <std::size_t kVector>
inline Doubles to_owners(const Doubles& w) {
    return shuffle<Owner<kVector>>(w, w, std::make_index_sequence<kDoubles>{});
}
inline Doubles coordinates_of(const Vec3& d, std::size_t vector) {
    Doubles v;
    for (std::size_t i = 0; i < kDoubles; ++i) {
        v[i] = d[static_cast<int>((vector * kDoubles + i) % 3)];
    }
    return v;
}

inline Doubles magnitude(const Doubles& v) { return v < 0.0 ? -v : v; }
inline Doubles greater(const Doubles& a, const Doubles& b) { return a > b ? a : b; }

// The least |w| and the largest |coordinate| of many points.
struct Extremes {
    double least_weight = std::numeric_limits<double>::infinity(), greatest_coordinate = 0.0;
};

inline Extremes displace_all(const Vec3* __restrict rest, const DragWeight* __restrict weights,
                             const Vec3 d, Vec3* __restrict to, std::size_t count) {
    const Doubles d0 = coordinates_of(d, 0), d1 = coordinates_of(d, 1), d2 = coordinates_of(d, 2);
    Doubles least = Doubles{} + std::numeric_limits<double>::infinity(), greatest{};
    std::size_t i = 0;
    for (; i + kDoubles <= count; i += kDoubles) {
        prefetch<For::reading>(rest + i, kDoubles);
        prefetch<For::reading>(weights + i, kDoubles);
        prefetch<For::writing>(to + i, kDoubles);
        const Doubles w = load_weights(weights + i);
        const double* const p = &rest[i].x;
        const Doubles p0 = load<Doubles>(p), p1 = load<Doubles>(p + kDoubles),
                      p2 = load<Doubles>(p + 2 * kDoubles);
        double* const q = &to[i].x;
        store(q, p0 + to_owners<0>(w) * d0);
        store(q + kDoubles, p1 + to_owners<1>(w) * d1);
        store(q + 2 * kDoubles, p2 + to_owners<2>(w) * d2);
        least = -greater(-least, -magnitude(w));
        greatest = greater(greatest, greater(greater(magnitude(p0), magnitude(p1)), magnitude(p2)));
    }
    Extremes found;
    for (std::size_t lane = 0; lane < kDoubles; ++lane) {
        found.least_weight = std::min(found.least_weight, least[lane]);
        found.greatest_coordinate = std::max(found.greatest_coordinate, greatest[lane]);
    }
    for (; i < count; ++i) {
        to[i] = displaced(rest[i], weights[i], d);
        const Vec3 size = glm::abs(rest[i]);
        found.least_weight =
            std::min(found.least_weight, std::abs(static_cast<double>(weights[i].w)));
        found.greatest_coordinate = std::max({found.greatest_coordinate, size.x, size.y, size.z});
    }
    return found;
}

// --- Normals

inline Floats square_root(Floats v) {
    for (std::size_t i = 0; i < kSimdWidth; ++i) v[i] = std::sqrt(v[i]);
    return v;
}

inline bool any(const Ints& lanes) {
    using Longs [[gnu::vector_size(kSimdWidth * 4)]] = std::int64_t;
    const Longs v = load<Longs>(&lanes);
    std::int64_t bits = 0;
    for (std::size_t i = 0; i < kDoubles; ++i) bits |= v[i];
    return bits != 0;
}

inline void transform_all_normals(const Vec3f* __restrict rest,
                                  const DragWeight* __restrict weights, const Vec3 d,
                                  Vec3f* __restrict to, std::size_t count) {
    const Vec3f e{d};
    std::size_t i = 0;
    for (; i + kSimdWidth <= count; i += kSimdWidth) {
        prefetch<For::reading>(rest + i, kSimdWidth);
        prefetch<For::writing>(to + i, kSimdWidth);
        const Coordinates n = load_normals(rest + i), g = load_gradients(weights + i);
        const Floats stretch = 1.0f + (g.x * e.x + g.y * e.y + g.z * e.z);
        const Floats along = e.x * n.x + e.y * n.y + e.z * n.z;
        const Floats x = stretch * n.x - along * g.x;
        const Floats y = stretch * n.y - along * g.y;
        const Floats z = stretch * n.z - along * g.z;
        const Floats squared = x * x + y * y + z * z;
        const Floats scale = 1.0f / square_root(squared);
        const Ints bent = (g.x != 0.0f) | (g.y != 0.0f) | (g.z != 0.0f);
        store_normals({bent ? x * scale : n.x, bent ? y * scale : n.y, bent ? z * scale : n.z},
                      to + i);
        const Ints is_exact = (squared >= kLeastSquare) & (squared <= kGreatestSquare) &
                              (squared >= kLeastSquare * (stretch * stretch));
        if (!any(bent & ~is_exact)) continue;
        for (std::size_t k = i; k < i + kSimdWidth; ++k) {
            to[k] = covariant_normal(rest[k], weights[k], d);
        }
    }
    for (; i < count; ++i) to[i] = covariant_normal(rest[i], weights[i], d);
}
