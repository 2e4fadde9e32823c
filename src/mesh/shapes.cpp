#include "mesh/shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace pectin {
namespace {

using Corner = IndexedFaceSet::Corner;
using Index = std::uint32_t;

void add_polygon(IndexedFaceSet& shape, std::initializer_list<Corner> corners) {
    shape.corners.insert(shape.corners.end(), corners);
    shape.polygon_end.push_back(static_cast<Index>(shape.corners.size()));
    shape.polygon_part.push_back(0);
}

void add_quad(IndexedFaceSet& shape, const std::array<Corner, 4>& q, bool reversed = false) {
    if (reversed) {
        add_polygon(shape, {q[0], q[3], q[2], q[1]});
    } else {
        add_polygon(shape, {q[0], q[1], q[2], q[3]});
    }
}

// Step i of n from -1 to 1, such that steps i and n - i mirror each other exactly.
double symmetric_step(Index i, Index n) { return (2.0 * i - n) / n; }

struct CirclePoint {
    double cos = 0.0, sin = 0.0;
};

// Cosine and sine of 2 pi i / n, mirrored from the first octant. They are exact on the axes, and
// mirror images are exact, too.
CirclePoint circle_point(Index i, Index n) {
    Index a = 4 * (i % n);  // in quarter turns / n
    const bool below = a > 2 * n;
    if (below) a = 4 * n - a;
    const bool left = a > n;
    if (left) a = 2 * n - a;
    const bool steep = 2 * a > n;
    if (steep) a = n - a;
    const double angle = std::numbers::pi / 2.0 * a / n;
    double x = std::cos(angle), y = std::sin(angle);
    if (steep) std::swap(x, y);
    return {left ? -x : x, below ? -y : y};
}

// --- Sphere: an icosahedron whose edges are halved and whose midpoints move to the unit sphere.

struct IcoEdge {
    Index a = 0, b = 0;
};

// Edge k runs between vertices k and k + 1 (modulo 3), in either direction.
struct IcoFace {
    std::array<Index, 3> vertices{};
    std::array<Index, 3> edges{};
};

struct Icosphere {
    std::vector<Vec3> vertices;
    std::vector<IcoEdge> edges;
    std::vector<IcoFace> faces;
};

Index find_or_add_edge(std::vector<IcoEdge>& edges, Index a, Index b) {
    const auto found = std::find_if(edges.begin(), edges.end(), [&](const IcoEdge& e) {
        return (e.a == a && e.b == b) || (e.a == b && e.b == a);
    });
    if (found != edges.end()) return static_cast<Index>(found - edges.begin());
    edges.push_back({a, b});
    return static_cast<Index>(edges.size() - 1);
}

// (+-1, +-phi, 0) and its cyclic permutations. Some edges cross the axes, and their normalised
// midpoints are exactly the axis points +-x, +-y, +-z.
Icosphere make_icosahedron() {
    constexpr double p = std::numbers::phi;
    static constexpr Index kFaces[20][3] = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    Icosphere ico;
    ico.vertices = {Vec3{-1, p, 0}, Vec3{1, p, 0}, Vec3{-1, -p, 0}, Vec3{1, -p, 0},
                    Vec3{0, -1, p}, Vec3{0, 1, p}, Vec3{0, -1, -p}, Vec3{0, 1, -p},
                    Vec3{p, 0, -1}, Vec3{p, 0, 1}, Vec3{-p, 0, -1}, Vec3{-p, 0, 1}};
    for (Vec3& v : ico.vertices) v = v / glm::length(v);
    for (const auto& f : kFaces) {
        IcoFace face;
        for (std::size_t k = 0; k < 3; ++k) {
            face.vertices[k] = f[k];
            face.edges[k] = find_or_add_edge(ico.edges, f[k], f[(k + 1) % 3]);
        }
        ico.faces.push_back(face);
    }
    return ico;
}

//         v2                  Edge e = ab becomes 2e = am and 2e + 1 = mb with m = V + e, and face
//         f
//        /  \                 gets three inner edges from 2E + 3f on, so no search is needed.
//     m2 ---- m1
//     /  \   /  \             .
//   v0 --- m0 --- v1
Icosphere subdivided(const Icosphere& coarse) {
    const Index n_vertices = static_cast<Index>(coarse.vertices.size());
    const Index n_edges = static_cast<Index>(coarse.edges.size());
    const auto half_at = [&](Index edge, Index end) {
        return 2 * edge + (coarse.edges[edge].a == end ? 0 : 1);
    };

    Icosphere fine;
    fine.vertices = coarse.vertices;
    fine.vertices.reserve(n_vertices + n_edges);
    fine.edges.reserve(2 * coarse.edges.size() + 3 * coarse.faces.size());
    fine.faces.reserve(4 * coarse.faces.size());
    for (Index e = 0; e < n_edges; ++e) {
        const auto [a, b] = coarse.edges[e];
        const Vec3 sum = coarse.vertices[a] + coarse.vertices[b];
        fine.vertices.push_back(sum / glm::length(sum));
        fine.edges.push_back({a, n_vertices + e});
        fine.edges.push_back({n_vertices + e, b});
    }
    for (const IcoFace& face : coarse.faces) {
        const auto& [v, e] = face;
        const Index m[3] = {n_vertices + e[0], n_vertices + e[1], n_vertices + e[2]};
        const Index inner = static_cast<Index>(fine.edges.size());  // m2 m0, m0 m1, m1 m2
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t before = (k + 2) % 3;
            fine.edges.push_back({m[before], m[k]});
            fine.faces.push_back(
                {{v[k], m[k], m[before]},
                 {half_at(e[k], v[k]), inner + static_cast<Index>(k), half_at(e[before], v[k])}});
        }
        fine.faces.push_back({{m[0], m[1], m[2]}, {inner + 1, inner + 2, inner}});
    }
    return fine;
}

IndexedFaceSet make_sphere(int resolution) {
    Icosphere ico = make_icosahedron();
    for (int i = 0; i < resolution; ++i) ico = subdivided(ico);

    IndexedFaceSet shape;
    shape.positions = std::move(ico.vertices);
    shape.normals.assign(shape.positions.begin(), shape.positions.end());
    shape.corners.reserve(3 * ico.faces.size());
    for (const IcoFace& face : ico.faces) {
        const auto& v = face.vertices;
        add_polygon(shape, {Corner{v[0], v[0]}, Corner{v[1], v[1]}, Corner{v[2], v[2]}});
    }
    return shape;
}

// --- Cube: the surface points of a lattice of (n + 1)^3.

// Points are numbered layer by layer along z. The first and the last layer are full grids; those
// between are rings, counter-clockwise from (0, 0).
Index cube_point(const std::array<Index, 3>& at, Index n) {
    const auto [i, j, k] = at;
    const Index full = (n + 1) * (n + 1);
    if (k == 0) return j * (n + 1) + i;
    if (k == n) return full + (n - 1) * 4 * n + j * (n + 1) + i;
    const Index layer = full + (k - 1) * 4 * n;
    if (j == 0) return layer + i;
    if (i == n) return layer + n + j;
    if (j == n) return layer + 3 * n - i;
    return layer + 4 * n - j;
}

IndexedFaceSet make_cube(Index n) {
    IndexedFaceSet shape;
    shape.positions.resize(std::size_t{6} * n * n + 2);
    for (Index side = 0; side < 6; ++side) {
        const std::size_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        const bool negative = side % 2 == 1;
        Vec3f normal{0.0f};
        normal[static_cast<int>(axis)] = negative ? -1.0f : 1.0f;
        shape.normals.push_back(normal);

        std::array<Index, 3> at{};
        at[axis] = negative ? 0 : n;
        const auto corner = [&](Index i, Index j) {
            at[u] = i;
            at[v] = j;
            const Index point = cube_point(at, n);
            shape.positions[point] = {symmetric_step(at[0], n), symmetric_step(at[1], n),
                                      symmetric_step(at[2], n)};
            return Corner{point, side};
        };
        for (Index j = 0; j < n; ++j) {
            for (Index i = 0; i < n; ++i) {
                add_quad(shape,
                         {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)},
                         negative);
            }
        }
    }
    return shape;
}

// --- Plane: seen from above, with -z up, the texture is upright.
IndexedFaceSet make_plane(Index n) {
    IndexedFaceSet shape;
    shape.normals = {Vec3f{0.0f, 1.0f, 0.0f}};
    for (Index j = 0; j <= n; ++j) {
        for (Index i = 0; i <= n; ++i) {
            shape.positions.emplace_back(symmetric_step(i, n), 0.0, symmetric_step(j, n));
            shape.uvs.emplace_back(static_cast<double>(i) / n, static_cast<double>(n - j) / n);
        }
    }
    const auto corner = [n](Index i, Index j) {
        const Index point = j * (n + 1) + i;
        return Corner{point, 0, point};
    };
    for (Index j = 0; j < n; ++j) {
        for (Index i = 0; i < n; ++i) {
            add_quad(shape,
                     {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
        }
    }
    return shape;
}

// --- Torus.
IndexedFaceSet make_torus(Index resolution) {
    constexpr double kRadius = 1.0, kTubeRadius = 0.4;
    const Index n = std::max<Index>(resolution, 2);
    const Index around = 4 * n, tube = 2 * n;

    IndexedFaceSet shape;
    for (Index i = 0; i < around; ++i) {
        const CirclePoint u = circle_point(i, around);
        for (Index j = 0; j < tube; ++j) {
            const CirclePoint v = circle_point(j, tube);
            const double r = kRadius + kTubeRadius * v.cos;
            shape.positions.emplace_back(r * u.cos, kTubeRadius * v.sin, r * u.sin);
            shape.normals.emplace_back(v.cos * u.cos, v.sin, v.cos * u.sin);
        }
    }
    const auto corner = [=](Index i, Index j) {
        const Index point = i % around * tube + j % tube;
        return Corner{point, point};
    };
    for (Index i = 0; i < around; ++i) {
        for (Index j = 0; j < tube; ++j) {
            add_quad(shape,
                     {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
        }
    }
    return shape;
}

// --- Cylinder: normals 0 .. around - 1 point outwards, then one for each cap.

void add_side(IndexedFaceSet& shape, Index n) {
    const Index around = 4 * n;
    for (Index j = 0; j <= n; ++j) {
        for (Index i = 0; i < around; ++i) {
            const CirclePoint u = circle_point(i, around);
            shape.positions.emplace_back(u.cos, symmetric_step(j, n), u.sin);
            if (j == 0) shape.normals.emplace_back(u.cos, 0.0, u.sin);
        }
    }
    const auto corner = [=](Index i, Index j) {
        return Corner{j * around + i % around, i % around};
    };
    for (Index j = 0; j < n; ++j) {
        for (Index i = 0; i < around; ++i) {
            add_quad(shape,
                     {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
        }
    }
}

// Rings 1 .. n - 1 and the centre belong to the cap; ring n is the rim that it shares with the
// side.
void add_cap(IndexedFaceSet& shape, Index n, bool top) {
    const Index around = 4 * n;
    const double y = top ? 1.0 : -1.0;
    const Index normal = static_cast<Index>(shape.normals.size());
    const Index rim = top ? n * around : 0;
    const Index inside = static_cast<Index>(shape.positions.size());
    shape.normals.emplace_back(0.0, y, 0.0);
    for (Index k = 1; k < n; ++k) {
        for (Index i = 0; i < around; ++i) {
            const CirclePoint u = circle_point(i, around);
            const double r = static_cast<double>(k) / n;
            shape.positions.emplace_back(r * u.cos, y, r * u.sin);
        }
    }
    const Corner centre{static_cast<Index>(shape.positions.size()), normal};
    shape.positions.emplace_back(0.0, y, 0.0);

    const auto corner = [=](Index k, Index i) {
        return Corner{(k == n ? rim : inside + (k - 1) * around) + i % around, normal};
    };
    for (Index i = 0; i < around; ++i) {
        const Index first = top ? i + 1 : i, second = top ? i : i + 1;
        add_polygon(shape, {centre, corner(1, first), corner(1, second)});
    }
    for (Index k = 1; k < n; ++k) {
        for (Index i = 0; i < around; ++i) {
            add_quad(shape,
                     {corner(k, i), corner(k, i + 1), corner(k + 1, i + 1), corner(k + 1, i)},
                     !top);
        }
    }
}

IndexedFaceSet make_cylinder(Index n) {
    IndexedFaceSet shape;
    add_side(shape, n);
    add_cap(shape, n, false);
    add_cap(shape, n, true);
    return shape;
}

IndexedFaceSet make_faces(ShapeKind kind, int resolution) {
    const Index n = static_cast<Index>(resolution);
    switch (kind) {
        case ShapeKind::sphere:
            return make_sphere(resolution);
        case ShapeKind::cube:
            return make_cube(n);
        case ShapeKind::plane:
            return make_plane(n);
        case ShapeKind::torus:
            return make_torus(n);
        case ShapeKind::cylinder:
            return make_cylinder(n);
    }
    return {};
}

}  // namespace

int max_resolution(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::sphere:
            return 9;  // 20 * 4^n triangles
        case ShapeKind::cube:
            return 707;  // 12 n^2
        case ShapeKind::plane:
            return 1732;  // 2 n^2
        case ShapeKind::torus:
            return 612;  // 16 n^2
        case ShapeKind::cylinder:
            return 500;  // 24 n^2 - 8 n
    }
    return 0;
}

IndexedFaceSet make_shape(ShapeKind kind, int resolution) {
    assert(resolution >= (kind == ShapeKind::sphere ? 0 : 1));
    assert(resolution <= max_resolution(kind));
    IndexedFaceSet shape = make_faces(kind, resolution);
    shape.parts.emplace_back();
    return shape;
}

}  // namespace pectin
