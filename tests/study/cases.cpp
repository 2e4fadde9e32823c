#include "study/cases.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "ffd/drag_plan.h"
#include "io/model_format.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"

namespace pectin::study {
namespace {

Warp planned(const DragPlan& plan) {
    std::variant<PlannedDrag, DragRefusal> planned = plan_drag(plan);
    if (auto* const drag = std::get_if<PlannedDrag>(&planned)) return std::move(drag->warp);
    throw std::runtime_error("a drag of the study is refused");
}

// Control points of a cage around the whole object, each displaced by a function of where it rests.
// at: in the box of the object, from -1 to 1 on each axis.
Warp cage(const TriMesh& mesh, const IVec3& counts, const std::function<Vec3(const Vec3& at)>& by) {
    const Box box = mesh.bounding_box();
    const Lattice lattice = fit_lattice(box, counts);
    std::vector<Vec3> displacements(lattice.control_count(), Vec3{0.0});
    for (int k = 0; k < lattice.deformable.z; ++k) {
        for (int j = 0; j < lattice.deformable.y; ++j) {
            for (int i = 0; i < lattice.deformable.x; ++i) {
                const IVec3 control{i, j, k};
                const Vec3 at = 2.0 * (lattice.rest(control) - box.centre()) / box.extent();
                displacements[lattice.control_index(control)] = by(at);
            }
        }
    }
    return {.steps = {LatticeField(lattice, std::move(displacements))}};
}

Warp several_handles(const std::vector<Move>& moves, const Lattice& lattice) {
    return planned({.moves = moves, .lattice = lattice});
}

// A drag of the object's farthest vertex in a direction. by: in diagonals of its box, as is radius.
Warp pull(const TriMesh& mesh, const Vec3& direction, const Vec3& by, double radius,
          bool fold_free = false) {
    const double diagonal = mesh.bounding_box().diagonal();
    const Vec3 from = extreme_point(mesh, direction);
    return brush_drag({.from = from, .to = from + diagonal * by}, radius * diagonal, 3, fold_free);
}

Warp twist(const TriMesh& mesh, const Vec3& direction, double degrees, double radius) {
    const Vec3 from = extreme_point(mesh, direction);
    return brush_drag({.from = from, .to = from, .twist = Twist{direction, degrees}},
                      radius * mesh.bounding_box().diagonal());
}

Vec3 bend(const Vec3& at) { return {0.35 * at.y * at.y, 0.0, 0.1 * at.y * at.y * at.y}; }

// Irregular, but the same in each run.
Vec3 ripple(const Vec3& at) {
    return 0.1 * Vec3{std::sin(5.0 * at.y + 2.0 * at.z), std::sin(4.0 * at.z + 3.0 * at.x),
                      std::sin(6.0 * at.x + at.y)};
}

class Collector {
  public:
    explicit Collector(std::string models) : models_(std::move(models)) {}

    template <typename MakeWarp>
    void add(std::string object, TriMesh mesh, std::string drag, MakeWarp make_warp) {
        Warp warp = make_warp(std::as_const(mesh));
        result.cases.push_back(
            {std::move(object), std::move(drag), std::move(mesh), std::move(warp)});
    }
    // The model of this name, or the shape.
    template <typename MakeWarp>
    void add_model(const std::string& name, const std::string& shape_name, TriMesh shape,
                   std::string drag, MakeWarp make_warp) {
        const std::filesystem::path path = std::filesystem::path(models_) / (name + ".obj");
        if (models_.empty() || !std::filesystem::exists(path)) {
            add(shape_name, std::move(shape), std::move(drag), make_warp);
            return;
        }
        result.has_models = true;
        add(name, build_mesh(read_model(path.string())).mesh, std::move(drag), make_warp);
    }

    Cases result;

  private:
    std::string models_;
};

void add_shapes(Collector& to) {
    to.add("sphere of 320 faces", shape(ShapeKind::sphere, 2), "pulled out",
           [](const TriMesh& mesh) {
               return pull(mesh, {0, 0, 1}, {0.0, 0.0, 0.2}, 0.4);
           });
    to.add("sphere of 1280 faces", shape(ShapeKind::sphere, 3), "pushed in",
           [](const TriMesh& mesh) {
               return pull(mesh, {0, 1, 0}, {0.05, -0.15, 0.0}, 0.3);
           });
    to.add("cube of 12 faces", shape(ShapeKind::cube, 1), "pulled within a face",
           [](const TriMesh&) {
               return brush_drag({.from = {0.1, 0.2, 1.0}, .to = {0.1, 0.2, 1.4}}, 0.75);
           });
    to.add("cube of 192 faces", shape(ShapeKind::cube, 4), "twisted by 70 degrees",
           [](const TriMesh&) {
               return brush_drag(
                   {.from = {0, 1, 0}, .to = {0, 1, 0}, .twist = Twist{{0, 1, 0}, 70.0}}, 1.8);
           });
    to.add("plane of 2 faces", shape(ShapeKind::plane, 1), "pulled up in the middle",
           [](const TriMesh&) {
               return brush_drag({.from = {0, 0, 0}, .to = {0, 0.35, 0}}, 0.7);
           });
    to.add("plane of 128 faces", shape(ShapeKind::plane, 8), "three points up and down",
           [](const TriMesh&) {
               return several_handles({{.from = {-0.5, 0, 0.1}, .to = {-0.5, 0.3, 0.1}},
                                       {.from = {0, 0, 0}, .to = {0, -0.3, 0}},
                                       {.from = {0.5, 0, -0.2}, .to = {0.5, 0.3, -0.2}}},
                                      brush_lattice({0, 0, 0}, 1.1, 5));
           });
    to.add("torus of 128 faces", shape(ShapeKind::torus, 4), "pulled far, fold-free",
           [](const TriMesh& mesh) {
               return pull(mesh, {1, 0, 0}, {0.35, 0.1, 0.0}, 0.3, true);
           });
    to.add("cylinder of 120 faces", shape(ShapeKind::cylinder, 3), "bent by a cage",
           [](const TriMesh& mesh) {
               return cage(mesh, {3, 4, 3}, bend);
           });
}

void add_models(Collector& to) {
    to.add_model("spot", "sphere of 5120 faces", shape(ShapeKind::sphere, 4), "pulled out",
                 [](const TriMesh& mesh) {
                     return pull(mesh, {0, 0, -1}, {0.0, 0.05, -0.2}, 0.25);
                 });
    to.add_model("suzanne", "cube of 1200 faces", shape(ShapeKind::cube, 10), "pushed in",
                 [](const TriMesh& mesh) {
                     return pull(mesh, {0, 0, 1}, {0.05, 0.0, -0.1}, 0.3);
                 });
    to.add_model(
        "fandisk", "cube of 108 faces", shape(ShapeKind::cube, 3), "rippled by a cage",
        [](const TriMesh& mesh) {
            const double size = 0.3 * mesh.bounding_box().diagonal();
            return cage(mesh, {4, 4, 4}, [size](const Vec3& at) { return size * ripple(at); });
        });
    to.add_model("rocker-arm", "torus of 512 faces", shape(ShapeKind::torus, 8),
                 "twisted by 60 degrees", [](const TriMesh& mesh) {
                     return twist(mesh, {1, 0, 0}, 60.0, 0.3);
                 });
}

}  // namespace

Vec3 extreme_point(const TriMesh& mesh, const Vec3& direction) {
    VertexId best = kNone<VertexId>;
    for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
        const VertexId candidate{v};
        if (!exists(mesh.half_edge(candidate))) continue;
        if (!exists(best) || glm::dot(mesh.position(candidate), direction) >
                                 glm::dot(mesh.position(best), direction)) {
            best = candidate;
        }
    }
    return mesh.position(best);
}

TriMesh shape(ShapeKind kind, int resolution) {
    return build_mesh(make_shape(kind, resolution)).mesh;
}

Warp brush_drag(const Move& move, double radius, int span, bool fold_free) {
    return planned({.moves = {move},
                    .fold_free = fold_free,
                    .lattice = brush_lattice(move.from, radius, span),
                    .is_centred_on_point = true});
}

Cases twelve_cases(const std::string& models) {
    Collector collector(models);
    add_shapes(collector);
    add_models(collector);
    return std::move(collector.result);
}

}  // namespace pectin::study
