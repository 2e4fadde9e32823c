#include "bench/scenes.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"

namespace pectin::bench {

TriMesh sphere(int resolution) {
    return build_mesh(make_shape(ShapeKind::sphere, resolution)).mesh;
}

Scene::Scene(const TriMesh& mesh, const Vec3& grabbed, const Vec3& displacement, double radius,
             std::uint32_t prepared_splits)
    : mesh_(mesh), active_(mesh_) {
    if (prepared_splits > 0) active_.prepare_splits(prepared_splits);
    const Lattice lattice = brush_lattice(grabbed, radius, 3);
    const auto solver = std::get<DragSolver>(DragSolver::create(lattice, {&grabbed, 1}, {}));
    warp_.steps.push_back(DragStep{solver.field(), {displacement}});
    active_.begin(FaceTree(mesh_).faces_meeting(warp_.zone(), mesh_), warp_.zone());
    embedding_ = std::make_unique<Embedding>(active_, warp_);
    embedding_->embed();
    embedding_->deform();
}

void Scene::roll_back() {
    active_.roll_back();
    embedding_->deform();
}

TriMesh Scene::finish() {
    active_.finish();
    return mesh_;
}

namespace {
// Half the side of a box around the north pole that contains this many of the sphere's vertices,
// which are evenly distributed.
double radius_for(const TriMesh& mesh, double influenced) {
    double low = 0.0, high = 4.0;
    for (int i = 0; i < 20; ++i) {
        const double radius = 0.5 * (low + high);
        const Box box{Vec3{-radius, -radius, 1.0 - radius}, Vec3{radius, radius, 1.0 + radius}};
        double inside = 0.0;
        for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
            inside += box.contains_strictly(mesh.position(VertexId{v})) ? 1.0 : 0.0;
        }
        (inside < influenced ? low : high) = radius;
    }
    return high;
}

const Vec3 kPole{0.0, 0.0, 1.0};

}  // namespace

void must(const Done& done) {
    if (!done) throw std::runtime_error(done.refusal().reason);
}

BrushScene::BrushScene(int resolution, double influenced, double theta_max) {
    must(session_.execute(command::Shape{command::Shape::Kind::sphere, resolution}));
    must(session_.execute(command::Adapt{.theta_max = Setting::of(theta_max)}));
    radius_ = radius_for(session_.mesh(), influenced);
    must(session_.execute(command::Brush{.radius = radius_}));
}

BrushScene& BrushScene::kept(int resolution, double influenced, double theta_max) {
    using Wanted = std::tuple<int, double, double>;
    static std::optional<std::pair<Wanted, BrushScene>> last;
    const Wanted wanted{resolution, influenced, theta_max};
    if (!last || last->first != wanted) {
        last.reset();
        last.emplace(wanted, BrushScene(resolution, influenced, theta_max));
    }
    return last->second;
}

void BrushScene::begin() { must(session_.begin_drag({&kPole, 1}, {})); }

void BrushScene::frame() {
    const double phase = 0.1 * std::numbers::pi * ++frames_;
    const Vec3 target =
        kPole + radius_ * Vec3{0.05 * std::sin(phase), 0.0, 0.25 + 0.05 * std::cos(phase)};
    must(session_.drag_to({&target, 1}));
    benchmark::DoNotOptimize(session_.take_dirty());
}

MemoryCopy::MemoryCopy(std::size_t bytes, int threads)
    : from_(bytes, 1), to_(bytes, 2), threads_(static_cast<std::size_t>(threads)) {}

void MemoryCopy::run() {
    const std::size_t part = from_.size() / threads_;
    const auto copy = [&](std::size_t i) {
        std::memcpy(to_.data() + i * part, from_.data() + i * part, part);
    };
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < threads_; ++i) others.emplace_back(copy, i);
    copy(0);
    for (std::thread& other : others) other.join();
    benchmark::ClobberMemory();
}

}  // namespace pectin::bench
