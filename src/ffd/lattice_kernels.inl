// The 4 × 4 × 4 sum at many points. lattice_evaluator.cpp includes this file once for each width of
// vector, inside a namespace: vectors of a compiler's own are cut to the width of the function that
// names them, so one function with several targets would not do.

// Four neighbours along i: two of SSE's vectors or one of AVX's.
using Vec4 [[gnu::vector_size(32)]] = double;

inline Vec4 all(double x) { return Vec4{x, x, x, x}; }
inline Vec4 load(const double* p) {
    Vec4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

// The four basis values of an axis, and their derivatives per cell, at t in a cell.
inline Vec4 values_at(double t) {
    const double s = 1.0 - t;
    return Vec4{(1.0 / 6.0) * s * s * s, 2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
            2.0 / 3.0 - s * s * (1.0 - 0.5 * s), (1.0 / 6.0) * t * t * t};
}
inline Vec4 derivatives_at(double t) {
    const double s = 1.0 - t;
    return Vec4{-0.5 * s * s, 0.5 * t * (3.0 * t - 4.0), 0.5 * s * (4.0 - 3.0 * s), 0.5 * t * t};
}

inline Vec4 sum(const Vec4& by, Vec4 p0, Vec4 p1, Vec4 p2, Vec4 p3) {
    return (all(by[0]) * p0 + all(by[1]) * p1) + (all(by[2]) * p2 + all(by[3]) * p3);
}

// The sums of the elements of x, of y and of z.
inline Vec3 sums(Vec4 x, Vec4 y, Vec4 z) {
    const Vec4 xy =
        __builtin_shufflevector(x, y, 0, 4, 2, 6) + __builtin_shufflevector(x, y, 1, 5, 3, 7);
    const Vec4 zz =
        __builtin_shufflevector(z, z, 0, 0, 2, 2) + __builtin_shufflevector(z, z, 1, 1, 3, 3);
    const Vec4 xyz =
        __builtin_shufflevector(xy, zz, 0, 1, 4, 5) + __builtin_shufflevector(xy, zz, 2, 3, 6, 7);
    return {xyz[0], xyz[1], xyz[2]};
}

struct Place {
    std::ptrdiff_t first;  // of the 4 × 4 × 4 control points
    Vec3 t;                // inside the cell
};

// Truncation after a shift by the two influenced cells is a floor: parameters exceed −2.
inline Place locate(const Grid& grid, const Vec3& x) {
    const Vec3 u = (x - grid.origin) * grid.inverse_cell;
    const auto i = static_cast<int>(u.x + 2.0), j = static_cast<int>(u.y + 2.0),
               k = static_cast<int>(u.z + 2.0);
    return {i + j * grid.row + k * grid.layer, {u.x - (i - 2), u.y - (j - 2), u.z - (k - 2)}};
}

// One component of equation 1, summed along k and j; the sum along i is left to the caller.
inline Vec4 partial_value(const double* first, const Grid& grid, const Vec4 bc[4]) {
    Vec4 layers[4];
    for (int k = 0; k < 4; ++k) {
        const double* const p = first + k * grid.layer;
        layers[k] =
            sum(bc[k], load(p), load(p + grid.row), load(p + 2 * grid.row), load(p + 3 * grid.row));
    }
    return (layers[0] + layers[1]) + (layers[2] + layers[3]);
}

inline Vec3 displacement(const Grid& grid, const Vec3& x) {
    const auto [first, t] = locate(grid, x);
    const Vec4 a = values_at(t.x), b = values_at(t.y), c = values_at(t.z);
    const Vec4 bc[4] = {all(c[0]) * b, all(c[1]) * b, all(c[2]) * b, all(c[3]) * b};
    return sums(a * partial_value(grid.x + first, grid, bc),
                a * partial_value(grid.y + first, grid, bc),
                a * partial_value(grid.z + first, grid, bc));
}

// Equations 4–7 beside it: one component's value, and its derivatives along j and k per cell.
struct Partial {
    Vec4 value, dv, dw;
};
inline Partial partial_expansion(const double* first, const Grid& grid, const Vec4& b,
                                 const Vec4& db, const Vec4& c, const Vec4& dc) {
    Vec4 rows[4], rows_dw[4];
    for (int j = 0; j < 4; ++j) {
        const double* const p = first + j * grid.row;
        const Vec4 p0 = load(p), p1 = load(p + grid.layer), p2 = load(p + 2 * grid.layer),
                   p3 = load(p + 3 * grid.layer);
        rows[j] = sum(c, p0, p1, p2, p3);
        rows_dw[j] = sum(dc, p0, p1, p2, p3);
    }
    return {sum(b, rows[0], rows[1], rows[2], rows[3]), sum(db, rows[0], rows[1], rows[2], rows[3]),
            sum(b, rows_dw[0], rows_dw[1], rows_dw[2], rows_dw[3])};
}

struct Expansion {
    Vec3 value, du, dv, dw;  // derivatives per cell
};
inline Expansion expand(const Grid& grid, const Vec3& x) {
    const auto [first, t] = locate(grid, x);
    const Vec4 b = values_at(t.y), db = derivatives_at(t.y);
    const Vec4 c = values_at(t.z), dc = derivatives_at(t.z);
    const Partial px = partial_expansion(grid.x + first, grid, b, db, c, dc);
    const Partial py = partial_expansion(grid.y + first, grid, b, db, c, dc);
    const Partial pz = partial_expansion(grid.z + first, grid, b, db, c, dc);
    const Vec4 a = values_at(t.x), da = derivatives_at(t.x);
    return {sums(a * px.value, a * py.value, a * pz.value),
            sums(da * px.value, da * py.value, da * pz.value),
            sums(a * px.dv, a * py.dv, a * pz.dv), sums(a * px.dw, a * py.dw, a * pz.dw)};
}

void displace_all(const Grid grid, const Vec3* __restrict points, Vec3* __restrict to,
                  std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
        const Vec3 x = points[n];
        if (grid.zone.contains_strictly(x)) {
            to[n] = x + displacement(grid, x);
        } else {
            to[n] = x;
        }
    }
}

void transform_all(const Grid grid, const Vec3* __restrict points, const Vec3f* __restrict normals,
                   Vec3* __restrict to, Vec3f* __restrict turned, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
        const Vec3 x = points[n];
        if (!grid.zone.contains_strictly(x)) {
            to[n] = x;
            turned[n] = normals[n];
            continue;
        }
        const auto [value, du, dv, dw] = expand(grid, x);
        to[n] = x + value;
        const Vec3& h = grid.inverse_cell;
        const Mat3 jacobian(1.0 + du[0] * h.x, du[1] * h.x, du[2] * h.x,  //
                            dv[0] * h.y, 1.0 + dv[1] * h.y, dv[2] * h.y,  //
                            dw[0] * h.z, dw[1] * h.z, 1.0 + dw[2] * h.z);
        turned[n] = covariant(jacobian, normals[n]);
    }
}
