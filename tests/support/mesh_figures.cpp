#include "support/mesh_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "geometry/ray.h"
#include "io/obj_reader.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "support/paths.h"

namespace pectin::test {

TriMesh mesh_of(const std::string& obj_text, double crease_angle) {
    return build_mesh(parse_obj(obj_text, "literal.obj"), {.crease_angle = crease_angle}).mesh;
}

std::vector<std::string> real_models() {
    std::vector<std::string> paths;
    std::error_code absent;
    for (const auto& entry : std::filesystem::directory_iterator(test::models_folder(), absent)) {
        if (entry.path().extension() == ".obj") paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::vector<EdgeId> live_edges(const TriMesh& mesh) {
    std::vector<EdgeId> edges;
    for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
        if (mesh.is_live(EdgeId{i})) edges.push_back(EdgeId{i});
    }
    return edges;
}

std::vector<FaceId> live_faces(const TriMesh& mesh) {
    std::vector<FaceId> faces;
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
        if (mesh.is_live(FaceId{i})) faces.push_back(FaceId{i});
    }
    return faces;
}

int euler_characteristic(const TriMesh& mesh) {
    int edges = 0;
    for (EdgeId e : live_edges(mesh)) edges += mesh.representative(e) == e ? 1 : 0;
    const auto& representatives = mesh.input_form().seams.representatives;
    int joined = 0;
    for (std::uint32_t v = 0; v < representatives.size(); ++v) {
        joined += representatives[v] == VertexId{v} ? 0 : 1;
    }
    return static_cast<int>(mesh.vertex_count()) - joined - edges +
           static_cast<int>(mesh.face_count());
}

double area(const TriMesh& mesh) {
    double sum = 0.0;
    for (FaceId f : live_faces(mesh)) sum += 0.5 * glm::length(mesh.area_normal(f));
    return sum;
}

EdgeId edge_between(const TriMesh& mesh, std::uint32_t v, std::uint32_t w) {
    for (EdgeId e : live_edges(mesh)) {
        const HalfEdgeId h = mesh.half_edge(e);
        if (std::minmax(index(mesh.origin(h)), index(mesh.target(h))) == std::minmax(v, w)) {
            return e;
        }
    }
    return kNone<EdgeId>;
}

double smallest_angle_quantile(const TriMesh& mesh, double fraction) {
    std::vector<double> angles;
    for (FaceId f : live_faces(mesh)) {
        double smallest = 180.0;
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(f, corner);
            const Vec3& at = mesh.position(mesh.origin(h));
            const Vec3 u = mesh.position(mesh.target(h)) - at,
                       v = mesh.position(mesh.origin(TriMesh::prev(h))) - at;
            smallest = std::min(
                smallest, glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v))));
        }
        angles.push_back(smallest);
    }
    const auto at =
        angles.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(angles.size()));
    std::nth_element(angles.begin(), at, angles.end());
    return *at;
}

std::size_t crossings(const TriMesh& mesh) {
    const FaceTree tree(mesh);
    std::size_t found = 0;
    for (const EdgeId e : live_edges(mesh)) {
        const VertexId v = mesh.origin(mesh.half_edge(e)), w = mesh.target(mesh.half_edge(e));
        const Vec3 from = mesh.position(v), to = mesh.position(w);
        Box box;
        box.include(from);
        box.include(to);
        for (const FaceId f : tree.faces_meeting(box, mesh)) {
            const HalfEdgeId h = TriMesh::half_edge(f, 0);
            const VertexId a = mesh.origin(h), b = mesh.target(h);
            const VertexId c = mesh.origin(TriMesh::prev(h));
            if (a == v || b == v || c == v || a == w || b == w || c == w) continue;
            const auto hit = intersect(Ray{from, to - from}, mesh.position(a), mesh.position(b),
                                       mesh.position(c));
            if (hit && hit->t <= 1.0) ++found;
        }
    }
    return found;
}

double asymmetry(const TriMesh& mesh) {
    // Sorts along a direction in which few points of a regular mesh coincide.
    using SortKey = std::pair<double, Vec3>;
    const auto sort_key = [](const Vec3& p) {
        return SortKey(glm::dot(p, Vec3{0.7390851, 0.4142135, 0.5671432}), p);
    };
    std::vector<SortKey> all;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        if (mesh.is_live(VertexId{v})) all.push_back(sort_key(mesh.position(VertexId{v})));
    }
    for (EdgeId e : live_edges(mesh)) {
        const HalfEdgeId h = mesh.half_edge(e);
        all.push_back(
            sort_key(0.5 * (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h)))));
    }
    std::ranges::sort(all, {}, &SortKey::first);
    double worst = 0.0;
    for (const auto& [key, p] : all) {
        const auto [at, image] = sort_key({-p.x, p.y, p.z});
        double nearest = std::numeric_limits<double>::infinity();
        const auto first = std::ranges::lower_bound(all, at - 1e-4, {}, &SortKey::first);
        for (auto q = first; q != all.end() && q->first <= at + 1e-4; ++q) {
            nearest = std::min(nearest, glm::distance(q->second, image));
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

std::size_t open_sides(const IndexedFaceSet& set) {
    using Point = std::array<double, 3>;
    std::map<std::pair<Point, Point>, std::size_t> sides;
    const auto point = [&](std::uint32_t corner) {
        const Vec3 p = set.positions[set.corners[corner].position] + Vec3{0.0};  // turns -0 into 0
        return Point{p.x, p.y, p.z};
    };
    for (std::size_t p = 0; p < set.polygon_count(); ++p) {
        const std::uint32_t begin = set.polygon_begin(p), end = set.polygon_end[p];
        for (std::uint32_t c = begin; c < end; ++c) {
            ++sides[std::minmax(point(c), point(c + 1 < end ? c + 1 : begin))];
        }
    }
    return static_cast<std::size_t>(std::count_if(
        sides.begin(), sides.end(), [](const auto& side) { return side.second == 1; }));
}

std::size_t open_edges(const TriMesh& mesh) {
    const std::vector<EdgeId> edges = live_edges(mesh);
    return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](EdgeId e) {
        return !exists(mesh.twin(mesh.half_edge(e))) && mesh.sibling(e) == e;
    }));
}

std::size_t faces_without_image(const TriMesh& mesh, int axis, double tolerance, double middle) {
    // Puts faces into cells by their centres; a search visits a cell and its neighbours.
    struct Corners {
        Vec3 at[3];
    };
    std::map<std::array<long long, 3>, std::vector<Corners>> by_cell;
    const double cell = 4.0 * tolerance;
    const auto cell_of = [cell](const Corners& c) {
        const Vec3 p = (c.at[0] + c.at[1] + c.at[2]) / (3.0 * cell);
        return std::array{std::llround(p.x), std::llround(p.y), std::llround(p.z)};
    };
    const auto corners_of = [&](FaceId f) {
        Corners c;
        for (int i = 0; i < 3; ++i) c.at[i] = mesh.position(mesh.origin(TriMesh::half_edge(f, i)));
        return c;
    };
    const auto is_near = [tolerance](const Corners& x, const Corners& y) {
        return std::all_of(std::begin(x.at), std::end(x.at), [&](const Vec3& p) {
            return std::any_of(std::begin(y.at), std::end(y.at),
                               [&](const Vec3& q) { return glm::distance(p, q) <= tolerance; });
        });
    };
    const std::vector<FaceId> faces = live_faces(mesh);
    for (FaceId f : faces) by_cell[cell_of(corners_of(f))].push_back(corners_of(f));
    return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](FaceId f) {
        Corners image = corners_of(f);
        for (Vec3& p : image.at) p[axis] = 2.0 * middle - p[axis];
        const auto around = cell_of(image);
        for (int k = 0; k < 27; ++k) {
            const auto found = by_cell.find(
                {around[0] + k % 3 - 1, around[1] + k / 3 % 3 - 1, around[2] + k / 9 - 1});
            if (found == by_cell.end()) continue;
            for (const Corners& c : found->second) {
                if (is_near(image, c)) return false;
            }
        }
        return true;
    }));
}

bool has_the_faces_of(const TriMesh& mesh, const TriMesh& base) {
    if (mesh.vertex_count() != base.vertex_count() || mesh.edge_count() != base.edge_count() ||
        mesh.face_count() != base.face_count()) {
        return false;
    }
    for (FaceId f : live_faces(base)) {
        for (int corner = 0; corner < 3; ++corner) {
            const HalfEdgeId h = TriMesh::half_edge(f, corner);
            if (mesh.half_edge(h) != base.half_edge(h)) return false;
            if (mesh.position(mesh.origin(h)) != base.position(base.origin(h))) return false;
        }
    }
    return true;
}

}  // namespace pectin::test
