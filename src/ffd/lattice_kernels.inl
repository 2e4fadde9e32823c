// The 4 × 4 × 4 sum at many points. lattice_evaluator.cpp includes this file once for each
// instruction set, inside a namespace. One function for all of them would not do, since the
// compiler divides its vector types to suit the instruction set of the function that uses them.
//
// A block of points is handled in passes. The passes that locate points and evaluate the basis, and
// those that combine the sums, handle four points at once. The pass in between, which sums along k
// and j, handles one point at a time, with the four control points along i at once. The operations
// on each element and their order do not depend on the width of vectors or on other points.
//
// Along k and j the weights are divided by the second weight, which is between 1/6 and 2/3, so that
// the product with the second control point is no longer needed. On an axis with basis values c and
// derivatives c′ per cell
//
//     Σ cₖ pₖ  = c₁ R          R = p₁ + Σ (cₖ / c₁) pₖ       over k = 0, 2, 3
//     Σ c′ₖ pₖ = c′₁ R + e₂ S  S = p₂ + Σ (eₖ / e₂) pₖ       over k = 0, 3
//     eₖ = c′ₖ − c′₁ cₖ / c₁                                 with e₂ between 1/2 and 2
//
// R and S take 5 products and 5 sums, instead of the 8 and 6 on the left-hand side.

// Four control points along i, or four points: two SSE vectors or one AVX vector.
using Vec4 [[gnu::vector_size(32)]] = double;
using Mask4 [[gnu::vector_size(32)]] = std::int64_t;
using Cells4 [[gnu::vector_size(16)]] = std::int32_t;

inline Vec4 all(double x) { return Vec4{x, x, x, x}; }
inline Vec4 load(const double* p) {
    Vec4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
inline void store(double* p, const Vec4& v) { std::memcpy(p, &v, sizeof v); }

inline Vec4 sum(const Vec4 by[4], const Vec4 p[4]) {
    return (by[0] * p[0] + by[1] * p[1]) + (by[2] * p[2] + by[3] * p[3]);
}

// --- Along the axes, at four points

// The four basis values inside a cell, and their derivatives per cell: the value form of
// ffd/cubic_basis.h, factored for vectors. It rounds differently from basis_span().
template <bool kDerivatives>
inline void expand(const Vec4& t, Vec4 value[4], Vec4 derivative[4]) {
    const Vec4 s = 1.0 - t, tt = t * t, ss = s * s;
    value[0] = (1.0 / 6.0) * s * ss;
    value[1] = 2.0 / 3.0 - tt * (1.0 - 0.5 * t);
    value[2] = 2.0 / 3.0 - ss * (1.0 - 0.5 * s);
    value[3] = (1.0 / 6.0) * t * tt;
    if constexpr (kDerivatives) {
        derivative[0] = -0.5 * ss;
        derivative[1] = t * (1.5 * t - 2.0);
        derivative[2] = s * (2.0 - 1.5 * s);
        derivative[3] = 0.5 * tt;
    }
}

// The divided weights of one axis at the points of a block. r: those of p₀, p₂ and p₃ in R. s:
// those of p₀ and p₃ in S. value, derivative, rest: the factors c₁, c′₁ and e₂.
struct DividedAxis {
    double r[3][kBlock], s[2][kBlock];
    double value[kBlock], derivative[kBlock], rest[kBlock];
};

template <bool kDerivatives>
inline void divide(const Vec4& t, std::size_t n, DividedAxis& axis) {
    Vec4 value[4], derivative[4];
    expand<kDerivatives>(t, value, derivative);
    const Vec4 by = 1.0 / value[1];
    const Vec4 r0 = value[0] * by, r2 = value[2] * by, r3 = value[3] * by;
    store(axis.r[0] + n, r0);
    store(axis.r[1] + n, r2);
    store(axis.r[2] + n, r3);
    store(axis.value + n, value[1]);
    if constexpr (kDerivatives) {
        const Vec4 e0 = derivative[0] - derivative[1] * r0, e2 = derivative[2] - derivative[1] * r2,
                   e3 = derivative[3] - derivative[1] * r3;
        const Vec4 by_e2 = 1.0 / e2;
        store(axis.s[0] + n, e0 * by_e2);
        store(axis.s[1] + n, e3 * by_e2);
        store(axis.derivative + n, derivative[1]);
        store(axis.rest + n, e2);
    }
}

// --- A block of points

struct Block {
    double x[3][kBlock];                 // the points
    std::int64_t inside[kBlock];         // all bits set if strictly inside the zone, else 0
    std::int32_t first[kBlock];          // the first of the 4 × 4 × 4 control points
    double a[4][kBlock], da[4][kBlock];  // the basis along i and its derivatives per cell
    DividedAxis b, c;
    double to[3][kBlock];                                // the displaced points
    double du[3][kBlock], dv[3][kBlock], dw[3][kBlock];  // the derivatives of D per cell
};

// Parameters inside the zone exceed −2, so truncation after a shift by the two influenced cells is
// a floor. Outside the zone any cell serves; the cell is clamped so that rounding cannot leave the
// grid.
template <bool kDerivatives>
inline void locate(const Grid& grid, std::size_t n, Block& block) {
    Vec4 x[3];
    for (int axis = 0; axis < 3; ++axis) x[axis] = load(block.x[axis] + n);
    const Mask4 inside = (x[0] > grid.zone.min.x) & (x[0] < grid.zone.max.x) &
                         (x[1] > grid.zone.min.y) & (x[1] < grid.zone.max.y) &
                         (x[2] > grid.zone.min.z) & (x[2] < grid.zone.max.z);
    std::memcpy(block.inside + n, &inside, sizeof inside);
    Cells4 first{};
    Vec4 t[3];
    for (int axis = 0; axis < 3; ++axis) {
        Vec4 u = (x[axis] - grid.origin[axis]) * grid.inverse_cell[axis] + 2.0;
        u = (inside & (u > 0.0)) ? u : all(0.0);
        const Vec4 last = all(grid.last_cell[axis]);
        const Cells4 cell = __builtin_convertvector(u < last ? u : last, Cells4);
        t[axis] = u - __builtin_convertvector(cell, Vec4);
        first += cell * grid.stride[axis];
    }
    std::memcpy(block.first + n, &first, sizeof first);
    Vec4 a[4], da[4];
    expand<kDerivatives>(t[0], a, da);
    for (int i = 0; i < 4; ++i) {
        store(block.a[i] + n, a[i]);
        if constexpr (kDerivatives) store(block.da[i] + n, da[i]);
    }
    divide<kDerivatives>(t[1], n, block.b);
    divide<kDerivatives>(t[2], n, block.c);
}

// --- Along k and j, at one point

// Partial sums of one component at four points; each vector holds the four control points along i.
// rr: R along both axes. sr: S along j of R along k. rs: R along j of S along k.
struct Partial {
    Vec4 rr[4], sr[4], rs[4];
};

template <bool kDerivatives>
inline void contract(const Grid& grid, const Block& block, std::size_t n, int m,
                     Partial partial[3]) {
    const Vec4 b0 = all(block.b.r[0][n]), b2 = all(block.b.r[1][n]), b3 = all(block.b.r[2][n]);
    const Vec4 c0 = all(block.c.r[0][n]), c2 = all(block.c.r[1][n]), c3 = all(block.c.r[2][n]);
    Vec4 f0, f3, g0, g3;
    if constexpr (kDerivatives) {
        f0 = all(block.b.s[0][n]), f3 = all(block.b.s[1][n]);
        g0 = all(block.c.s[0][n]), g3 = all(block.c.s[1][n]);
    }
    for (std::size_t component = 0; component < 3; ++component) {
        const double* p = grid.components[component] + block.first[n];
        Vec4 rr, sr, rs;
        for (int j = 0; j < 4; ++j, p += grid.stride.y) {
            const Vec4 p0 = load(p), p1 = load(p + grid.stride.z), p2 = load(p + 2 * grid.stride.z),
                       p3 = load(p + 3 * grid.stride.z);
            const Vec4 r = (p1 + c0 * p0) + (c2 * p2 + c3 * p3);
            rr = j == 0 ? b0 * r : rr + (j == 1 ? r : j == 2 ? b2 * r : b3 * r);
            if constexpr (kDerivatives) {
                const Vec4 s = (p2 + g0 * p0) + g3 * p3;
                rs = j == 0 ? b0 * s : rs + (j == 1 ? s : j == 2 ? b2 * s : b3 * s);
                if (j != 1) sr = j == 0 ? f0 * r : sr + (j == 2 ? r : f3 * r);
            }
        }
        partial[component].rr[m] = rr;
        if constexpr (kDerivatives) {
            partial[component].sr[m] = sr;
            partial[component].rs[m] = rs;
        }
    }
}

// --- Along i, at four points

inline void transpose(Vec4 r[4]) {
    const Vec4 a = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6),
               b = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7),
               c = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6),
               d = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
    r[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    r[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    r[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    r[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

template <bool kDerivatives>
inline void sum_four(const Grid& grid, std::size_t n, Block& block) {
    Partial partial[3];
    for (int m = 0; m < 4; ++m) {
        contract<kDerivatives>(grid, block, n + static_cast<std::size_t>(m), m, partial);
    }
    const Vec4 b = load(block.b.value + n), c = load(block.c.value + n), bc = b * c;
    Mask4 inside;
    std::memcpy(&inside, block.inside + n, sizeof inside);
    Vec4 a[4], da[4];
    for (int i = 0; i < 4; ++i) {
        a[i] = load(block.a[i] + n);
        if constexpr (kDerivatives) da[i] = load(block.da[i] + n);
    }
    for (int component = 0; component < 3; ++component) {
        auto& [rr, sr, rs] = partial[component];
        transpose(rr);
        const Vec4 value = sum(a, rr), x = load(block.x[component] + n);
        store(block.to[component] + n, inside ? x + bc * value : x);
        if constexpr (kDerivatives) {
            transpose(sr);
            transpose(rs);
            const Vec4 db = load(block.b.derivative + n), dc = load(block.c.derivative + n);
            const Vec4 eb = load(block.b.rest + n), ec = load(block.c.rest + n);
            store(block.du[component] + n, bc * sum(da, rr));
            store(block.dv[component] + n, c * (db * value + eb * sum(a, sr)));
            store(block.dw[component] + n, b * (dc * value + ec * sum(a, rs)));
        }
    }
}

// The last group of four is filled up with copies of the first point.
template <bool kDerivatives>
inline void evaluate(const Grid& grid, const Vec3* points, std::size_t count, Block& block) {
    for (std::size_t n = 0; n < count; ++n) {
        block.x[0][n] = points[n].x;
        block.x[1][n] = points[n].y;
        block.x[2][n] = points[n].z;
    }
    for (std::size_t n = count; n % 4 != 0; ++n) {
        for (int axis = 0; axis < 3; ++axis) block.x[axis][n] = points[0][axis];
    }
    for (std::size_t n = 0; n < count; n += 4) locate<kDerivatives>(grid, n, block);
    for (std::size_t n = 0; n < count; n += 4) sum_four<kDerivatives>(grid, n, block);
}

inline void write_positions(const Block& block, std::size_t count, Vec3* to) {
    for (std::size_t n = 0; n < count; ++n) {
        to[n] = {block.to[0][n], block.to[1][n], block.to[2][n]};
    }
}

// Equation 3: cof(J)·n, normalised. The columns of cof(J) are the cross products of those of J. An
// image without a direction becomes zero. Where J is the identity and outside the zone, n is kept.
inline void write_normals(const Grid& grid, const Block& block, std::size_t count,
                          const float* __restrict normals, float* __restrict transformed) {
    const double hx = grid.inverse_cell.x, hy = grid.inverse_cell.y, hz = grid.inverse_cell.z;
    for (std::size_t n = 0; n < count; ++n) {
        const double ux = 1.0 + hx * block.du[0][n], uy = hx * block.du[1][n],
                     uz = hx * block.du[2][n];
        const double vx = hy * block.dv[0][n], vy = 1.0 + hy * block.dv[1][n],
                     vz = hy * block.dv[2][n];
        const double wx = hz * block.dw[0][n], wy = hz * block.dw[1][n],
                     wz = 1.0 + hz * block.dw[2][n];
        const float* const normal = normals + 3 * n;
        const double nx = normal[0], ny = normal[1], nz = normal[2];
        const double x =
            nx * (vy * wz - vz * wy) + ny * (wy * uz - wz * uy) + nz * (uy * vz - uz * vy);
        const double y =
            nx * (vz * wx - vx * wz) + ny * (wz * ux - wx * uz) + nz * (uz * vx - ux * vz);
        const double z =
            nx * (vx * wy - vy * wx) + ny * (wx * uy - wy * ux) + nz * (ux * vy - uy * vx);
        const double squared = x * x + y * y + z * z;
        // Infinite or NaN if the image has no direction: its square is 0 or overflows.
        const double scale = 1.0 / std::sqrt(squared);
        const bool has_direction = (squared > 0.0) & (squared <= kLargest);
        const bool is_identity = (ux == 1.0) & (uy == 0.0) & (uz == 0.0) & (vx == 0.0) &
                                 (vy == 1.0) & (vz == 0.0) & (wx == 0.0) & (wy == 0.0) &
                                 (wz == 1.0);
        const bool stays = is_identity | (block.inside[n] == 0);
        const float tx = static_cast<float>(has_direction ? x * scale : 0.0);
        const float ty = static_cast<float>(has_direction ? y * scale : 0.0);
        const float tz = static_cast<float>(has_direction ? z * scale : 0.0);
        transformed[3 * n] = stays ? normal[0] : tx;
        transformed[3 * n + 1] = stays ? normal[1] : ty;
        transformed[3 * n + 2] = stays ? normal[2] : tz;
    }
}

// --- All points

void displace_all(const Grid grid, const Vec3* points, Vec3* to, std::size_t count) {
    Block block;
    for (std::size_t first = 0; first < count; first += kBlock) {
        const std::size_t many = std::min(kBlock, count - first);
        evaluate<false>(grid, points + first, many, block);
        write_positions(block, many, to + first);
    }
}

void transform_all(const Grid grid, const Vec3* points, const Vec3f* normals, Vec3* to,
                   Vec3f* transformed, std::size_t count) {
    Block block;
    for (std::size_t first = 0; first < count; first += kBlock) {
        const std::size_t many = std::min(kBlock, count - first);
        evaluate<true>(grid, points + first, many, block);
        write_positions(block, many, to + first);
        write_normals(grid, block, many, &normals[first].x, &transformed[first].x);
    }
}
