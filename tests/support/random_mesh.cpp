#include "support/random_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ffd/drag_solver.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"

namespace pectin::test {
namespace {

ShapeKind random_kind(Random& random) {
    constexpr ShapeKind kKinds[] = {ShapeKind::sphere, ShapeKind::cube, ShapeKind::plane,
                                    ShapeKind::torus, ShapeKind::cylinder};
    return kKinds[random.integer(0, 4)];
}

int random_resolution(ShapeKind kind, Random& random) {
    switch (kind) {
        case ShapeKind::sphere:
            return random.integer(0, 3);
        case ShapeKind::cube:
            return random.integer(1, 6);
        case ShapeKind::plane:
            return random.integer(1, 12);
        case ShapeKind::torus:
            return random.integer(2, 6);
        case ShapeKind::cylinder:
            return random.integer(1, 5);
    }
    return 1;
}

// Computes the normals that a file without normals would get.
void drop_normals(IndexedFaceSet& set) {
    set.normals.clear();
    for (auto& corner : set.corners) corner.normal = IndexedFaceSet::kNoIndex;
}

// Divides the texture coordinates into charts, so that seams run across the mesh.
void add_uvs(IndexedFaceSet& set, Random& random) {
    set.uvs.clear();
    const int charts = random.integer(1, 4);
    for (std::size_t p = 0; p < set.polygon_count(); ++p) {
        const float chart = static_cast<float>(random.integer(0, charts - 1));
        for (std::uint32_t c = set.polygon_begin(p); c < set.polygon_end[p]; ++c) {
            const Vec3& x = set.positions[set.corners[c].position];
            set.corners[c].uv = static_cast<std::uint32_t>(set.uvs.size());
            set.uvs.emplace_back(static_cast<float>(x.x) + 10.0f * chart, static_cast<float>(x.z));
        }
    }
}

void perturb(IndexedFaceSet& set, Random& random, double amount) {
    for (Vec3& p : set.positions) p += random.uniform(0.0, amount) * random.direction();
}

void stretch(IndexedFaceSet& set, Random& random) {
    const Vec3 scale{random.scale(0.05, 5.0), random.scale(0.2, 2.0), random.scale(0.2, 2.0)};
    for (Vec3& p : set.positions) p *= scale;
}

void add_polygon(IndexedFaceSet& set, std::vector<IndexedFaceSet::Corner> corners,
                 std::uint32_t part) {
    set.corners.insert(set.corners.end(), corners.begin(), corners.end());
    set.polygon_end.push_back(static_cast<std::uint32_t>(set.corners.size()));
    set.polygon_part.push_back(part);
}

// Damages some polygons: reverses or duplicates them, adds fins to edges, repeats corners, or makes
// them degenerate.
void damage(IndexedFaceSet& set, Random& random) {
    const double reversed = random.chance(0.5) ? 0.1 : 0.0,
                 doubled = random.chance(0.4) ? 0.1 : 0.0;
    const double finned = random.scale(0.02, 0.5), degenerate = random.chance(0.3) ? 0.1 : 0.0;
    const auto polygons = static_cast<std::uint32_t>(set.polygon_count());
    for (std::uint32_t p = 0; p < polygons; ++p) {
        const auto begin = set.corners.begin() + set.polygon_begin(p);
        const auto end = set.corners.begin() + set.polygon_end[p];
        if (random.chance(reversed)) std::reverse(begin, end);
        const std::vector<IndexedFaceSet::Corner> corners(begin, end);
        const std::uint32_t part = set.polygon_part[p];
        if (random.chance(doubled)) add_polygon(set, corners, part);
        if (random.chance(degenerate)) add_polygon(set, {corners[0], corners[0], corners[1]}, part);
        if (random.chance(degenerate)) {
            auto repeated = corners;
            repeated.push_back(corners[1]);
            add_polygon(set, repeated, part);
        }
        for (int fins = 0; fins < 3 && random.chance(finned); ++fins) {
            const Vec3 &a = set.positions[corners[0].position],
                       &b = set.positions[corners[1].position];
            const Vec3 tip = 0.5 * (a + b) + glm::distance(a, b) * random.direction();
            IndexedFaceSet::Corner at_tip = corners[0];
            at_tip.position = static_cast<std::uint32_t>(set.positions.size());
            set.positions.push_back(tip);
            if (random.chance(0.5)) {
                add_polygon(set, {corners[0], corners[1], at_tip}, part);
            } else {
                add_polygon(set, {corners[1], corners[0], at_tip}, part);
            }
        }
    }
}

void add_colors(IndexedFaceSet& set, Random& random) {
    for (std::size_t i = 0; i < set.positions.size(); ++i) {
        const auto component = [&] { return static_cast<float>(random.integer(0, 255)) / 255.0f; };
        set.colors.emplace_back(component(), component(), component());
        if (random.chance(0.02)) set.colors.back() = Vec3f{std::numeric_limits<float>::quiet_NaN()};
    }
}

// Assigns random groups and materials, and adds lines and points.
void add_parts(IndexedFaceSet& set, Random& random) {
    set.parts.clear();
    for (int i = 0; i < 4; ++i) {
        set.parts.push_back({.object = i < 2 ? "thing" : "other thing",
                             .group = "g" + std::to_string(i),
                             .material = i == 3 ? "" : "m" + std::to_string(i % 2),
                             .smoothing_group = 0});
    }
    const auto vertex = [&] {
        return IndexedFaceSet::Corner{.position = static_cast<std::uint32_t>(random.integer(
                                          0, static_cast<int>(set.positions.size()) - 1))};
    };
    for (std::uint32_t p = 0; p < set.polygon_count(); ++p) {
        set.polygon_part[p] = static_cast<std::uint32_t>(random.integer(0, 3));
        if (!random.chance(0.05)) continue;
        const bool is_line = random.chance(0.5);
        for (int i = random.integer(2, 4); i > 0; --i) set.element_corners.push_back(vertex());
        set.elements.push_back(
            {.kind = is_line ? IndexedFaceSet::Element::Kind::line
                             : IndexedFaceSet::Element::Kind::points,
             .before_polygon = p,
             .part = static_cast<std::uint32_t>(random.integer(0, 3)),
             .corners_end = static_cast<std::uint32_t>(set.element_corners.size())});
    }
}

}  // namespace

Vec3 Random::direction() {
    while (true) {
        const Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        const double length = glm::length(v);
        if (length > 0.1 && length < 1.0) return v / length;
    }
}

void unshare_vertices(IndexedFaceSet& set, Random& random, double fraction) {
    std::vector<bool> is_used(set.positions.size(), false);
    for (std::size_t p = 0; p < set.polygon_count(); ++p) {
        const bool has_own = random.chance(fraction);
        std::map<std::uint32_t, std::uint32_t> own;  // a polygon may use a vertex twice
        for (std::uint32_t c = set.polygon_begin(p); c < set.polygon_end[p]; ++c) {
            std::uint32_t& v = set.corners[c].position;
            if (!has_own || !is_used[v]) {
                is_used[v] = true;
                own[v] = v;
                continue;
            }
            const auto [found, is_new] =
                own.try_emplace(v, static_cast<std::uint32_t>(set.positions.size()));
            if (is_new) {
                set.positions.push_back(Vec3{set.positions[v]});
                if (!set.colors.empty()) set.colors.push_back(Vec3f{set.colors[v]});
            }
            v = found->second;
        }
    }
}

RandomMesh random_mesh(Random& random) {
    const ShapeKind kind = random_kind(random);
    const int resolution = random_resolution(kind, random);
    IndexedFaceSet set = make_shape(kind, resolution);
    std::string description = "shape " + std::to_string(static_cast<int>(kind)) + " resolution " +
                              std::to_string(resolution);
    if (random.chance(0.4)) {
        perturb(set, random, random.scale(0.005, 0.3) / std::max(1, resolution));
        drop_normals(set);
        description += ", perturbed";
    }
    if (random.chance(0.3)) {
        stretch(set, random);
        drop_normals(set);
        description += ", stretched";
    }
    if (random.chance(0.4)) {
        add_uvs(set, random);
        description += ", with uvs";
    }
    if (random.chance(0.3)) {
        damage(set, random);
        description += ", damaged";
    }
    if (random.chance(0.3)) add_colors(set, random);
    if (random.chance(0.3)) add_parts(set, random);
    // A copy of the generator, so that later random numbers stay the same.
    if (Random copy = random; copy.chance(0.25)) {
        unshare_vertices(set, copy, copy.chance(0.5) ? 1.0 : 0.2);
        description += ", vertices not shared";
    }
    const double crease_angle = random.chance(0.5) ? 45.0 : random.uniform(5.0, 170.0);
    return {build_mesh(set, {.crease_angle = crease_angle}).mesh, description};
}

Warp random_warp(const TriMesh& mesh, Random& random) {
    const Box box = mesh.bounding_box();
    const double size = box.diagonal();
    while (true) {
        const VertexId v{static_cast<std::uint32_t>(
            random.integer(0, static_cast<int>(mesh.vertex_slots()) - 1))};
        if (!mesh.is_live(v)) continue;
        const Vec3 grabbed = mesh.position(v);
        Lattice lattice =
            brush_lattice(grabbed, size * random.scale(0.05, 1.5), random.integer(1, 5));
        if (random.chance(0.5)) {  // a lattice with unequal cells
            lattice.deformable = {random.integer(1, 6), random.integer(1, 6), random.integer(1, 6)};
            lattice.cell = {size * random.scale(0.03, 0.5), size * random.scale(0.03, 0.5),
                            size * random.scale(0.03, 0.5)};
            const Vec3 inside{random.uniform(0, lattice.deformable.x - 0.9),
                              random.uniform(0, lattice.deformable.y - 0.9),
                              random.uniform(0, lattice.deformable.z - 0.9)};
            lattice.origin = grabbed - inside * lattice.cell;
        }
        std::vector<Vec3> points{grabbed}, pins, displacements;
        const double length = lattice.smallest_cell_extent() * random.scale(0.02, 3.0);
        displacements.push_back(length * random.direction());
        if (random.chance(0.3)) {
            pins.push_back(grabbed + lattice.cell * random.direction());
        }
        if (random.chance(0.2)) {
            points.push_back(grabbed + 0.7 * lattice.cell * random.direction());
            displacements.push_back(length * random.direction());
        }
        auto solved = DragSolver::create(lattice, points, pins);
        const auto* solver = std::get_if<DragSolver>(&solved);
        if (!solver || solver->check(displacements)) continue;
        return Warp{{DragStep{solver->field(), displacements}}};
    }
}

}  // namespace pectin::test
