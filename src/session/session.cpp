#include "session/session.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "command/json.h"
#include "geometry/decimal.h"
#include "io/atomic_file.h"
#include "mesh/shapes.h"
#include "session/input_summary.h"
#include "session/session_state.h"

namespace pectin {
namespace {

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

}  // namespace

// The new object starts a new history; settings stay.
void Session::State::adopt(LoadedModel model) {
    active = std::move(model.active);
    mesh = std::move(model.mesh);
    tree = std::move(model.tree);
    history.clear();
    input_report = model.report;
    material_folders = std::move(model.material_folders);
    diagonal = model.box.diagonal();
    const Vec3 farthest = glm::max(glm::abs(model.box.min), glm::abs(model.box.max));
    largest_coordinate = glm::max(farthest.x, glm::max(farthest.y, farthest.z));
    lattice_in_use.reset();
    zones_in_use.clear();
    last = {};
    folded = 0;
    outcome = {};
    dirty = {};
    dirty.everything = true;
}

// The folder in which all was put together last is the likeliest to have it.
void Session::State::note_saved(const std::string& path) {
    const std::string folder = material_folder(path);
    std::erase(material_folders, folder);
    material_folders.insert(material_folders.begin(), folder);
}

const FaceTree& Session::State::face_tree() {
    if (!tree) tree = std::make_unique<FaceTree>(*mesh);
    return *tree;
}

void Session::State::follow(std::span<const FaceId> faces) {
    if (tree) tree->update(faces, *mesh);
    show(faces);
}

void Session::State::show(std::span<const FaceId> faces) {
    // Nobody has looked for so long that a picture is better drawn from scratch.
    if (dirty.faces.size() > 2 * std::size_t{mesh->face_slots()}) {
        dirty = {};
        dirty.everything = true;
    }
    if (dirty.everything) return;
    dirty.faces.insert(dirty.faces.end(), faces.begin(), faces.end());
    for (FaceId f : faces) {
        if (index(f) >= mesh->face_slots() || !mesh->is_live(f)) continue;
        for (int corner = 0; corner < 3; ++corner) {
            dirty.wedges.push_back(mesh->wedge(TriMesh::half_edge(f, corner)));
        }
    }
}

void Session::State::note(const Frame& frame) {
    last.splits = frame.splits;
    last.unsplits = frame.unsplits;
    last.seconds.deform = frame.deform_seconds;
    last.seconds.refine = frame.refine_seconds;
    last.seconds.decimate = frame.decimate_seconds;
    outcome.floor_hit = frame.floor_hit;
    outcome.budget_hit = frame.budget_hit;
    std::vector<EdgeId>& blocked = outcome.blocked;
    blocked.insert(blocked.end(), frame.blocked.begin(), frame.blocked.end());
    std::erase_if(blocked,
                  [this](EdgeId e) { return index(e) >= mesh->edge_slots() || !mesh->is_live(e); });
    std::sort(blocked.begin(), blocked.end());
    blocked.erase(std::unique(blocked.begin(), blocked.end()), blocked.end());
}

Refusal Session::State::run(const command::Open& open) {
    adopt(load_model(open));
    remark = input_summary(open.path, input_report);
    return std::nullopt;
}

Refusal Session::State::run(const command::Shape& shape) {
    const ShapeKind kind = shape_kind(shape.kind);
    const int least = kind == ShapeKind::sphere ? 0 : 1, most = max_resolution(kind);
    if (shape.resolution < least || shape.resolution > most) {
        return "resolution " + std::to_string(shape.resolution) + " must be from " +
               std::to_string(least) + " to " + std::to_string(most) + " for this shape";
    }
    adopt(make_model(build_mesh(make_shape(kind, shape.resolution))));
    return std::nullopt;
}

Refusal Session::State::run(const command::Adapt& adapt) {
    const auto changed = adapt_settings.with(adapt);
    if (const auto* refusal = std::get_if<std::string>(&changed)) return *refusal;
    adapt_settings = std::get<AdaptSettings>(changed);
    outcome = {};
    history.forget_outcomes();
    return std::nullopt;
}

Refusal Session::State::run(const command::Brush& brush) {
    if (brush.radius && !(*brush.radius > 0.0 && std::isfinite(*brush.radius))) {
        return "the radius " + decimal(*brush.radius) + " must be a number above 0";
    }
    if (brush.span && (*brush.span < kMinDeformable || *brush.span > kMaxDeformable)) {
        return "the span " + std::to_string(*brush.span) + " must be from " +
               std::to_string(kMinDeformable) + " to " + std::to_string(kMaxDeformable);
    }
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
        lattice.deformable = std::get<command::Cage::Fit>(cage.lattice).deformable;
        if (lattice.is_valid()) lattice = fit_lattice(mesh->bounding_box(), lattice.deformable);
    }
    if (!lattice.is_valid()) {
        return "the cage must be finite, with cells above 0 and from " +
               std::to_string(kMinDeformable) + " to " + std::to_string(kMaxDeformable) +
               " deformable control points an axis";
    }
    lattice_settings.cage = lattice;
    return std::nullopt;
}

Refusal Session::State::run(const command::Symmetry& symmetry_command) {
    symmetry.reset();
    if (!symmetry_command.plane) return std::nullopt;
    const int axis = static_cast<int>(*symmetry_command.plane);
    symmetry = MirrorPlane{axis, symmetry_command.through[axis]};
    return std::nullopt;
}

Refusal Session::State::run(const command::Readapt& readapt) {
    if (!has_object()) return kNoObject;
    Stopwatch stopwatch;
    std::vector<FaceId> faces;
    for (std::uint32_t i = 0; i < mesh->face_slots(); ++i) {
        if (mesh->is_live(FaceId{i})) faces.push_back(FaceId{i});
    }
    last = {};
    for (std::uint32_t i = 0; i < mesh->vertex_slots(); ++i) {
        const VertexId v{i};
        if (!mesh->is_live(v) || !exists(mesh->half_edge(v))) continue;
        const auto contains = [&](const Box& zone) {
            return zone.contains_strictly(mesh->position(v));
        };
        if (std::any_of(zones_in_use.begin(), zones_in_use.end(), contains)) {
            ++last.influenced_vertices;
        }
    }
    active->begin(faces, Box{});
    last.seconds.begin = stopwatch.lap();
    const Warp no_warp;
    Embedding embedding(*active, no_warp);
    AdaptLimits adapt_limits = limits(lattice_in_use);
    // At the budget, refinement rests until a drag or the settings change.
    const bool was_hit = outcome.budget_hit;
    if (was_hit) adapt_limits.budget = 0;
    const Adaptation adaptation =
        adapt(*active, embedding, Criteria(adapt_limits, zones_in_use, {}));
    MeshChange change = active->finish();
    Frame frame;
    frame.splits = adaptation.refinement.splits;
    frame.unsplits = adaptation.decimation.unsplits;
    frame.floor_hit = adaptation.refinement.floor_hit;
    frame.budget_hit = adaptation.refinement.budget_hit || was_hit;
    frame.blocked = adaptation.refinement.blocked;
    outcome.blocked.clear();
    frame.refine_seconds = adaptation.refine_seconds;
    frame.decimate_seconds = adaptation.decimate_seconds;
    stopwatch.lap();
    note(frame);
    add_step(readapt, std::move(change));
    last.seconds.commit = stopwatch.lap();
    return std::nullopt;
}

Refusal Session::State::run(const command::Bake& bake) {
    if (!has_object()) return kNoObject;
    if (mesh->vertex_count() == mesh->base_vertex_count()) return std::nullopt;
    Baked baked = mesh->baked();
    for (EdgeId& e : outcome.blocked) e = baked.edges[index(e)];
    std::sort(outcome.blocked.begin(), outcome.blocked.end());
    auto before = std::make_unique<TriMesh>(std::move(baked.mesh));
    exchange(*before);
    history.add({bake, {}, outcome, std::move(before)});
    last = {};
    return std::nullopt;
}

Refusal Session::State::run(const command::Save& save) {
    if (!has_object()) return kNoObject;
    remark = save_model(*mesh, save, {}, material_folders);
    note_saved(save.path);
    return std::nullopt;
}

Refusal Session::State::run(const command::Stats& stats) {
    if (!has_object()) return kNoObject;
    write_file_atomically(stats.path, format_statistics(statistics()));
    return std::nullopt;
}

Refusal Session::State::run(const command::Screenshot& screenshot) {
    if (!has_object()) return kNoObject;
    if (!viewport) return "there is nothing here to draw with; replay the script with pectin";
    const bool has_cage = lattice_settings.cage.has_value();
    return viewport->screenshot(*mesh, has_cage ? lattice_settings.cage : lattice_in_use,
                                screenshot);
}

Session::Session() : state_(std::make_unique<State>()) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

std::optional<std::string> Session::execute(const Command& command) {
    if (is_dragging()) return "a drag is in hand; end or cancel it first";
    state_->remark.clear();
    return std::visit([this](const auto& c) { return state_->run(c); }, command);
}

void Session::adopt(LoadedModel model) {
    assert(!is_dragging());
    state_->adopt(std::move(model));
}

const std::string& Session::remark() const { return state_->remark; }

const std::vector<std::string>& Session::material_folders() const {
    return state_->material_folders;
}

void Session::note_saved(const std::string& path) { state_->note_saved(path); }

void Session::set_viewport(Viewport* viewport) { state_->viewport = viewport; }

std::optional<std::string> Session::begin_drag(std::span<const Vec3> points,
                                               std::span<const Vec3> pins,
                                               const DragOptions& options) {
    command::Drag drag{.pins = {pins.begin(), pins.end()},
                       .connected = options.connected,
                       .fold_free = options.fold_free};
    for (const Vec3& point : points) drag.moves.push_back({.from = point, .to = point});
    return state_->begin_drag(drag);
}

std::optional<std::string> Session::drag_to(std::span<const Vec3> targets) {
    command::Drag drag = state_->in_hand->drag;
    for (std::size_t i = 0; i < drag.moves.size(); ++i) drag.moves[i].to = targets[i];
    return state_->drag_to(drag);
}

std::optional<std::string> Session::drag_to(std::span<const DragTarget> targets) {
    command::Drag drag = state_->in_hand->drag;
    for (std::size_t i = 0; i < drag.moves.size(); ++i) {
        drag.moves[i].to = targets[i].to;
        drag.moves[i].twist = targets[i].twist;
        drag.moves[i].scale = targets[i].scale;
    }
    return state_->drag_to(drag);
}

const command::Drag& Session::drag_in_hand() const { return state_->in_hand->drag; }

std::optional<std::string> Session::begin_control(std::span<const IVec3> indices) {
    return state_->begin_control(indices);
}

std::optional<std::string> Session::control_to(std::span<const Vec3> targets) {
    return state_->control_to(targets);
}

std::optional<command::Control> Session::end_control() { return state_->end_control(); }

const Frame& Session::last_frame() const { return state_->in_hand->gesture->last_frame(); }

std::optional<command::Drag> Session::end_drag() { return state_->end_drag(); }

void Session::cancel_drag() { state_->cancel_drag(); }

bool Session::is_dragging() const { return state_->in_hand != nullptr; }

const TriMesh& Session::mesh() const { return *state_->mesh; }

std::optional<Lattice> Session::lattice_in_use() const {
    return is_dragging() ? state_->in_hand->lattice : state_->lattice_in_use;
}

std::vector<LatticeField> Session::lattices_in_hand() const {
    assert(is_dragging());
    if (!state_->in_hand->gesture) return {};
    return lattice_fields(state_->in_hand->gesture->warp().steps.back());
}

std::optional<Pick> Session::pick(const Ray& ray) {
    if (!state_->has_object() || is_dragging()) return std::nullopt;
    const auto first = state_->face_tree().first_hit(ray, mesh());
    if (!first) return std::nullopt;
    const Vec3 area_normal = mesh().area_normal(first->face);
    const auto corner = [&](int i) {
        return mesh().position(mesh().origin(TriMesh::half_edge(first->face, i)));
    };
    return Pick{first->face,
                first->hit.u * corner(0) + first->hit.v * corner(1) + first->hit.w * corner(2),
                area_normal / glm::length(area_normal)};
}

DirtyElements Session::take_dirty() {
    DirtyElements taken = std::exchange(state_->dirty, {});
    // Slots that were cut off since have nothing to show.
    const auto tidy = [](auto& ids, auto end) {
        // A frame names what it moves in order, and what it inserted after that.
        const auto unsorted = std::is_sorted_until(ids.begin(), ids.end());
        std::sort(unsorted, ids.end());
        std::inplace_merge(ids.begin(), unsorted, ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        ids.erase(std::lower_bound(ids.begin(), ids.end(), end), ids.end());
    };
    tidy(taken.wedges, WedgeId{state_->mesh->wedge_slots()});
    tidy(taken.faces, FaceId{state_->mesh->face_slots()});
    return taken;
}

Statistics Session::statistics() const { return state_->statistics(); }

const std::optional<MirrorPlane>& Session::symmetry() const { return state_->symmetry; }

const History& Session::history() const { return state_->history; }

const BuildReport& Session::input_report() const { return state_->input_report; }

const AdaptSettings& Session::adapt_settings() const { return state_->adapt_settings; }

const LatticeSettings& Session::lattice_settings() const { return state_->lattice_settings; }

const AdaptOutcome& Session::outcome() const { return state_->outcome; }

std::uint64_t Session::folded_vertices() const { return state_->folded; }

}  // namespace pectin
