#include "session/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "command/json.h"
#include "ffd/drag_solver.h"
#include "geometry/decimal.h"
#include "io/atomic_file.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "session/gesture.h"
#include "session/history.h"
#include "session/measure.h"
#include "session/settings.h"

namespace pectin {
namespace {

using Refusal = std::optional<std::string>;

constexpr const char* kNoObject = "there is no object yet; use the open or shape command first";

// Beyond this many diagonals of object and zone a drag is a slip of the hand or of a script, and
// squares of lengths would lose all digits of what stays.
constexpr double kLargestDrag = 1e6;

class Stopwatch {
  public:
    // Seconds since the last lap.
    double lap() {
        const auto now = Clock::now();
        const std::chrono::duration<double> passed = now - last_;
        last_ = now;
        return passed.count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

ShapeKind shape_kind(command::Shape::Kind kind) {
    switch (kind) {
        case command::Shape::Kind::sphere:
            return ShapeKind::sphere;
        case command::Shape::Kind::cube:
            return ShapeKind::cube;
        case command::Shape::Kind::plane:
            return ShapeKind::plane;
        case command::Shape::Kind::torus:
            return ShapeKind::torus;
        case command::Shape::Kind::cylinder:
            return ShapeKind::cylinder;
    }
    return ShapeKind::sphere;
}

bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

// Everything a session holds; one `run` for each command.
struct Session::State {
    // Behind pointers: the active set refers to the mesh wherever the session goes.
    std::unique_ptr<TriMesh> mesh = std::make_unique<TriMesh>();
    std::unique_ptr<ActiveSet> active = std::make_unique<ActiveSet>(*mesh);
    std::unique_ptr<FaceTree> tree;  // made when first asked for
    History history;
    AdaptSettings adapt_settings;
    LatticeSettings lattice_settings;
    double diagonal = 0.0;                  // of the object's box as it was opened
    std::optional<Lattice> lattice_in_use;  // the last drag's
    Statistics::Last last;
    std::uint64_t folded = 0;
    bool floor_hit = false, budget_hit = false;
    std::vector<EdgeId> blocked_edges;  // sorted; what drags since the last readapt found blocked

    bool has_object() const { return mesh->face_slots() > 0; }

    AdaptLimits limits(const std::optional<Lattice>& lattice) const {
        return adapt_settings.limits(lattice ? lattice->smallest_cell_extent() : kOff, diagonal);
    }
    std::optional<Box> zone_in_use() const {
        if (!lattice_in_use) return std::nullopt;
        return lattice_in_use->influenced_zone();
    }

    void take(BuiltMesh built);
    const FaceTree& face_tree();
    void update_tree(const MeshChange& change);
    void note(const Frame& frame);
    void add_step(Command command, MeshChange change);

    Refusal run(const command::Open& open);
    Refusal run(const command::Shape& shape);
    Refusal run(const command::Adapt& adapt);
    Refusal run(const command::Brush& brush);
    Refusal run(const command::Cage& cage);
    Refusal run(const command::Drag& drag);
    Refusal run(const command::Undo& undo);
    Refusal run(const command::Redo& redo);
    Refusal run(const command::Readapt& readapt);
    Refusal run(const command::Save& save);
    Refusal run(const command::Stats& stats);

    Refusal check_size(const Lattice& lattice, const command::Drag& drag) const;
    void commit(const command::Drag& drag, const Lattice& lattice, const DragSolver& solver,
                std::span<const Vec3> displacements, Stopwatch& stopwatch);
    Statistics statistics() const;
};

// The new object starts a new history; settings stay.
void Session::State::take(BuiltMesh built) {
    *mesh = std::move(built.mesh);
    active = std::make_unique<ActiveSet>(*mesh);
    tree.reset();
    history.clear();
    diagonal = mesh->bounding_box().diagonal();
    lattice_in_use.reset();
    last = {};
    folded = 0;
    floor_hit = budget_hit = false;
    blocked_edges.clear();
}

const FaceTree& Session::State::face_tree() {
    if (!tree) tree = std::make_unique<FaceTree>(*mesh);
    return *tree;
}

void Session::State::update_tree(const MeshChange& change) {
    if (tree) tree->update(change.faces, *mesh);
}

void Session::State::note(const Frame& frame) {
    last.splits = frame.splits;
    last.unsplits = frame.unsplits;
    last.seconds.deform = frame.deform_seconds;
    last.seconds.refine = frame.refine_seconds;
    last.seconds.decimate = frame.decimate_seconds;
    floor_hit = frame.floor_hit;
    budget_hit = frame.budget_hit;
    blocked_edges.insert(blocked_edges.end(), frame.blocked.begin(), frame.blocked.end());
    std::sort(blocked_edges.begin(), blocked_edges.end());
}

void Session::State::add_step(Command command, MeshChange change) {
    update_tree(change);
    if (!change.is_empty()) history.add({std::move(command), std::move(change)});
}

Refusal Session::State::run(const command::Open& open) {
    const IndexedFaceSet input = read_obj(open.path);
    BuiltMesh built = build_mesh(input, {.crease_angle = open.crease_angle});
    if (built.mesh.face_slots() == 0) {
        return "'" + open.path +
               "' has no face with three different vertices; a model needs at "
               "least one";
    }
    take(std::move(built));
    return std::nullopt;
}

Refusal Session::State::run(const command::Shape& shape) {
    const ShapeKind kind = shape_kind(shape.kind);
    const int least = kind == ShapeKind::sphere ? 0 : 1, most = max_resolution(kind);
    if (shape.resolution < least || shape.resolution > most) {
        return "resolution " + std::to_string(shape.resolution) + " must be from " +
               std::to_string(least) + " to " + std::to_string(most) + " for this shape";
    }
    take(build_mesh(make_shape(kind, shape.resolution)));
    return std::nullopt;
}

Refusal Session::State::run(const command::Adapt& adapt) {
    const auto changed = adapt_settings.with(adapt);
    if (const auto* refusal = std::get_if<std::string>(&changed)) return *refusal;
    adapt_settings = std::get<AdaptSettings>(changed);
    budget_hit = floor_hit = false;
    return std::nullopt;
}

Refusal Session::State::run(const command::Brush& brush) {
    if (brush.radius) lattice_settings.radius = brush.radius;
    lattice_settings.span = brush.span.value_or(lattice_settings.span);
    lattice_settings.cage.reset();
    return std::nullopt;
}

Refusal Session::State::run(const command::Cage& cage) {
    Lattice lattice;
    if (const auto* grid = std::get_if<command::Cage::Grid>(&cage.lattice)) {
        lattice = {grid->origin, grid->cell, grid->deformable};
    } else {
        if (!has_object()) return kNoObject;
        lattice = fit_lattice(mesh->bounding_box(),
                              std::get<command::Cage::Fit>(cage.lattice).deformable);
    }
    if (!lattice.is_valid()) {
        return "the cage must be finite, with cells above 0 and from " +
               std::to_string(kMinDeformable) + " to " + std::to_string(kMaxDeformable) +
               " deformable control points an axis";
    }
    lattice_settings.cage = lattice;
    return std::nullopt;
}

Refusal Session::State::check_size(const Lattice& lattice, const command::Drag& drag) const {
    if (!lattice.is_valid() || !is_finite(lattice.influenced_zone().extent())) {
        return "the lattice has no usable size (radius or cells of 0, or beyond numbers); set the "
               "brush radius or the cage to about the size of what is to move";
    }
    const double most = kLargestDrag * (diagonal + lattice.influenced_zone().diagonal());
    for (const command::Drag::Move& move : drag.moves) {
        if (!(glm::length(move.to - move.from) <= most)) {
            return "the drag from " + decimal(move.from) + " to " + decimal(move.to) +
                   " goes more than a million times the size of the object; the most is " +
                   decimal(most);
        }
    }
    return std::nullopt;
}

Refusal Session::State::run(const command::Drag& drag) {
    if (!has_object()) return kNoObject;
    Stopwatch stopwatch;
    const Lattice lattice = lattice_settings.lattice(drag.moves.front().from, diagonal);
    if (Refusal refusal = check_size(lattice, drag)) return refusal;
    std::vector<Vec3> points, displacements;
    for (const command::Drag::Move& move : drag.moves) {
        points.push_back(move.from);
        displacements.push_back(move.to - move.from);
    }
    auto solved = DragSolver::create(lattice, points, drag.pins);
    if (const auto* refusal = std::get_if<DragRefusal>(&solved)) return refusal->what;
    const auto& solver = std::get<DragSolver>(solved);
    if (const auto refusal = solver.check(displacements)) return refusal->what;
    commit(drag, lattice, solver, displacements, stopwatch);
    return std::nullopt;
}

void Session::State::commit(const command::Drag& drag, const Lattice& lattice,
                            const DragSolver& solver, std::span<const Vec3> displacements,
                            Stopwatch& stopwatch) {
    last = {};
    last.seconds.solve = stopwatch.lap();
    lattice_in_use = lattice;
    folded = 0;
    floor_hit = budget_hit = false;
    const Box zone = lattice.influenced_zone();
    active->begin(face_tree().faces_meeting(zone, *mesh), zone);
    last.influenced_vertices = active->influenced_at_begin();
    if (std::all_of(displacements.begin(), displacements.end(),
                    [](const Vec3& d) { return d == Vec3{0.0}; })) {
        active->finish();  // a gesture that moves nothing does nothing
        return;
    }
    Warp warp{{{solver.field(), std::vector<Vec3>(displacements.size())}}};
    Gesture gesture(*active, std::move(warp),
                    adapt_settings.enabled ? std::optional(limits(lattice)) : std::nullopt);
    last.seconds.begin = stopwatch.lap();
    MeshChange change = gesture.commit(displacements);
    note(gesture.last_frame());
    folded = gesture.folded_vertices();
    add_step(drag, std::move(change));
    last.seconds.commit =
        stopwatch.lap() - last.seconds.deform - last.seconds.refine - last.seconds.decimate;
}

Refusal Session::State::run(const command::Undo& undo_command) {
    const auto count = static_cast<std::size_t>(undo_command.count);
    if (count > history.undo_count()) {
        return "there are only " + std::to_string(history.undo_count()) + " steps to undo, not " +
               std::to_string(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const MeshChange& change = history.step_back().change;
        undo(change, *mesh);
        update_tree(change);
    }
    return std::nullopt;
}

Refusal Session::State::run(const command::Redo& redo_command) {
    const auto count = static_cast<std::size_t>(redo_command.count);
    if (count > history.redo_count()) {
        return "there are only " + std::to_string(history.redo_count()) + " steps to redo, not " +
               std::to_string(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const MeshChange& change = history.step_forward().change;
        redo(change, *mesh);
        update_tree(change);
    }
    return std::nullopt;
}

Refusal Session::State::run(const command::Readapt& readapt) {
    if (!has_object()) return kNoObject;
    if (!adapt_settings.enabled) {
        return "adaptive meshing is switched off; use {\"cmd\": \"adapt\", \"enabled\": true} "
               "first";
    }
    Stopwatch stopwatch;
    std::vector<FaceId> faces;
    for (std::uint32_t i = 0; i < mesh->face_slots(); ++i) {
        if (mesh->is_live(FaceId{i})) faces.push_back(FaceId{i});
    }
    last = {};
    active->begin(faces, Box{});
    last.seconds.begin = stopwatch.lap();
    const Warp no_warp;
    Embedding embedding(*active, no_warp);
    AdaptLimits adapt_limits = limits(lattice_in_use);
    // At the budget, refinement rests until a drag or the settings change.
    if (budget_hit) adapt_limits.budget = 0;
    const bool was_hit = budget_hit;
    const Adaptation adaptation =
        adapt(*active, embedding, Criteria(adapt_limits, zone_in_use(), std::nullopt));
    MeshChange change = active->finish();
    Frame frame;
    frame.splits = adaptation.refinement.splits;
    frame.unsplits = adaptation.decimation.unsplits;
    frame.floor_hit = adaptation.refinement.floor_hit;
    frame.budget_hit = adaptation.refinement.budget_hit || was_hit;
    frame.blocked = adaptation.refinement.blocked;
    blocked_edges.clear();
    frame.refine_seconds = adaptation.refine_seconds;
    frame.decimate_seconds = adaptation.decimate_seconds;
    stopwatch.lap();
    note(frame);
    add_step(readapt, std::move(change));
    last.seconds.commit = stopwatch.lap();
    return std::nullopt;
}

Refusal Session::State::run(const command::Save& save) {
    if (!has_object()) return kNoObject;
    write_obj(*mesh, save.path);
    return std::nullopt;
}

Refusal Session::State::run(const command::Stats& stats) {
    if (!has_object()) return kNoObject;
    write_file_atomically(stats.path, format_statistics(statistics()));
    return std::nullopt;
}

Statistics Session::State::statistics() const {
    Statistics s;
    measure(*mesh, s);
    s.last = last;
    const Assessment assessment = assess(
        *active, Criteria(limits(lattice_in_use), zone_in_use(), std::nullopt), blocked_edges);
    s.divergence_max_deg = assessment.divergence_max_deg;
    s.needing_refinement = budget_hit ? 0 : assessment.needing_refinement;
    s.held_back = assessment.held_back + (budget_hit ? assessment.needing_refinement : 0);
    s.floor_hit = floor_hit;
    s.budget_hit = budget_hit;
    s.folded_vertices = folded;
    s.memory_bytes = mesh->memory_bytes() + active->memory_bytes() + history.memory_bytes() +
                     (tree ? tree->memory_bytes() : 0);
    return s;
}

Session::Session() : state_(std::make_unique<State>()) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

std::optional<std::string> Session::execute(const Command& command) {
    return std::visit([this](const auto& c) { return state_->run(c); }, command);
}

const TriMesh& Session::mesh() const { return *state_->mesh; }

Statistics Session::statistics() const { return state_->statistics(); }

}  // namespace pectin
