#include "session/session.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <new>
#include <utility>

#include "adapt/accumulated_error.h"
#include "command/check.h"
#include "geometry/parallel.h"
#include "session/session_state.h"

namespace pectin {
void Session::State::adopt(LoadedModel model) noexcept {
    active = std::move(model.active);
    mesh = std::move(model.mesh);
    tree = std::move(model.tree);
    history.clear();
    input_report = model.report;
    read_report = std::move(model.read_report);
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

// The folder of the last save is the most likely one to contain all material files.
void Session::State::record_saved(const std::string& path) {
    const std::string folder = material_folder(path);
    std::erase(material_folders, folder);
    material_folders.insert(material_folders.begin(), folder);
}

const FaceTree& Session::State::face_tree() {
    if (!tree) tree = std::make_unique<FaceTree>(*mesh);
    return *tree;
}

void Session::State::update_faces(std::span<const FaceId> faces) noexcept {
    try {
        if (tree) tree->update(faces, *mesh);
        mark_dirty(faces);
    } catch (const std::bad_alloc&) {
        update_everything();
    }
}

void Session::State::update_everything() noexcept {
    tree.reset();  // built again when it is needed
    dirty = {};
    dirty.everything = true;
}

void Session::State::mark_dirty(std::span<const FaceId> faces) {
    // Beyond an eighth of the faces, redrawing everything is faster than sorting what has changed.
    if (dirty.faces.size() + faces.size() > mesh->face_slots() / 8) {
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

void Session::State::record(const Frame& frame) {
    last.splits = frame.splits;
    last.unsplits = frame.unsplits;
    last.seconds.deform = frame.deform_seconds;
    last.seconds.refine = frame.refine_seconds;
    last.seconds.decimate = frame.decimate_seconds;
    outcome.floor_hit = frame.floor_hit;
    outcome.budget_hit = frame.budget_hit;
    // What an earlier drag has left coarse stays so.
    outcome.drag_budget_hit |= frame.drag_budget_hit;
    outcome.assessment = frame.assessment;
    // A gesture without a bound leaves an unknown error, whatever follows.
    const bool is_known = frame.error && outcome.error.total;
    outcome.error.last = frame.error;
    outcome.error.total = is_known ? std::optional(largest_error(*mesh)) : std::nullopt;
    if (!outcome.has_ended_at_budget()) return;
    outcome.assessment.held_back += outcome.assessment.needing_refinement;
    outcome.assessment.needing_refinement = 0;
}

Session::Session() : state_(std::make_unique<State>()) { prepare_parallel_loops(); }
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

// Calls work(), which this token may stop. A drag that is stopped is cancelled.
template <typename Work>
auto Session::stoppable(const StopToken& stop, Work work) {
    state_->stop = stop;
    try {
        auto done = work();
        state_->stop = {};
        state_->report_dropped_steps();
        return done;
    } catch (const Stopped&) {
        state_->stop = {};
        if (is_dragging()) cancel_drag();
        throw;
    } catch (...) {
        state_->stop = {};
        throw;
    }
}

Done Session::execute(const Command& command, const StopToken& stop) {
    if (is_dragging()) return Refusal{"a drag is active; end or cancel it first"};
    state_->remark.clear();
    state_->has_failed_partly = false;
    if (Done done = check(command); !done) return done;
    return stoppable(stop, [&] { return state_->execute(command); });
}

void Session::adopt(LoadedModel model) noexcept {
    assert(!is_dragging());
    state_->adopt(std::move(model));
}

const std::string& Session::remark() const { return state_->remark; }

bool Session::has_failed_partly() const { return state_->has_failed_partly; }

const std::vector<std::string>& Session::material_folders() const {
    return state_->material_folders;
}

void Session::record_saved(const std::string& path) { state_->record_saved(path); }

void Session::set_viewport(Viewport* viewport) { state_->viewport = viewport; }

Done Session::begin_drag(std::span<const Vec3> points, std::span<const Vec3> pins,
                         const DragOptions& options) {
    command::Drag drag{.pins = {pins.begin(), pins.end()},
                       .connected = options.connected,
                       .fold_free = options.fold_free};
    for (const Vec3& point : points) drag.moves.push_back({.from = point, .to = point});
    return state_->begin_drag(drag);
}

Done Session::drag_to(std::span<const Vec3> targets) {
    std::vector<Move>& asked = state_->active_gesture->asked;
    asked = state_->active_gesture->drag.moves;
    for (std::size_t i = 0; i < asked.size(); ++i) asked[i].to = targets[i];
    return state_->drag_to(asked);
}

Done Session::drag_to(std::span<const Move> moves) {
    assert(std::ranges::equal(state_->active_gesture->drag.moves, moves, {}, &Move::from,
                              &Move::from));
    return state_->drag_to(moves);
}

const command::Drag& Session::active_drag() const { return state_->active_gesture->drag; }

Done Session::begin_control(std::span<const IVec3> indices) {
    return state_->begin_control(indices);
}

Done Session::control_to(std::span<const Vec3> targets) { return state_->control_to(targets); }

std::optional<command::Control> Session::end_control(const StopToken& stop) {
    return stoppable(stop, [this] { return state_->end_control(); });
}

void Session::set_frame_time(std::optional<std::chrono::steady_clock::duration> time) {
    state_->frame_time = time;
}

bool Session::has_unfinished_frame() const { return state_->has_unfinished_frame(); }

bool Session::continue_frame() { return state_->continue_frame(); }

const Frame& Session::last_frame() const { return state_->active_gesture->gesture->last_frame(); }

std::optional<command::Drag> Session::end_drag(const StopToken& stop) {
    return stoppable(stop, [this] { return state_->end_drag(); });
}

void Session::cancel_drag() { state_->cancel_drag(); }

bool Session::is_dragging() const { return state_->active_gesture != nullptr; }

bool Session::is_dragging_control_points() const {
    return is_dragging() && state_->active_gesture->is_control();
}

const TriMesh& Session::mesh() const { return *state_->mesh; }

std::optional<Lattice> Session::lattice_in_use() const {
    return is_dragging() ? state_->active_gesture->lattice : state_->lattice_in_use;
}

std::vector<LatticeField> Session::active_lattices() const {
    assert(is_dragging());
    if (!state_->active_gesture->gesture) return {};
    return merged_lattices(state_->active_gesture->gesture->warp().steps.back());
}

std::optional<Pick> Session::pick(const Ray& ray) {
    if (!state_->has_object() || is_dragging()) return {};
    const auto first = state_->face_tree().first_hit(ray, mesh());
    if (!first) return {};
    const Vec3 area_normal = mesh().area_normal(first->face);
    const auto corner = [&](int i) {
        return mesh().position(mesh().origin(TriMesh::half_edge(first->face, i)));
    };
    return Pick{first->face,
                first->hit.u * corner(0) + first->hit.v * corner(1) + first->hit.w * corner(2),
                area_normal / glm::length(area_normal)};
}

std::optional<double> Session::distance_to_surface(const Vec3& point) {
    if (!state_->has_object() || is_dragging()) return {};
    const std::optional<FaceId> face = state_->face_tree().nearest(point, mesh());
    if (!face) return {};
    const auto corner = [&](int i) {
        return mesh().position(mesh().origin(TriMesh::half_edge(*face, i)));
    };
    return glm::distance(point, nearest_on_triangle(point, corner(0), corner(1), corner(2)));
}

void Session::prepare_for_drags() noexcept {
    if (!state_->has_object() || is_dragging()) return;
    try {
        state_->face_tree();
        state_->active->prepare_splits(kPreparedSplits);
    } catch (const std::bad_alloc&) {
        // The drag does so itself, if there is memory by then.
    }
}

DirtyElements Session::take_dirty() {
    DirtyElements taken;
    take_dirty(taken);
    return taken;
}

void Session::take_dirty(DirtyElements& taken) {
    taken.clear();
    std::swap(taken, state_->dirty);
    // Slots that no longer exist have nothing to draw.
    const auto tidy = [](auto& ids, auto end) {
        // A frame without edits lists what it moves in order, without duplicates, and then what
        // earlier frames have inserted.
        const auto last = std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>());
        if (last != ids.end()) {
            std::sort(last + 1, ids.end());
            std::inplace_merge(ids.begin(), last + 1, ids.end());
            ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        }
        ids.erase(std::lower_bound(ids.begin(), ids.end(), end), ids.end());
    };
    tidy(taken.wedges, WedgeId{state_->mesh->wedge_slots()});
    tidy(taken.faces, FaceId{state_->mesh->face_slots()});
}

Statistics Session::statistics() const { return state_->statistics(); }

const std::optional<MirrorPlane>& Session::symmetry() const { return state_->symmetry; }

const History& Session::history() const { return state_->history; }

const BuildReport& Session::input_report() const { return state_->input_report; }

const ReadReport& Session::read_report() const { return state_->read_report; }

const AdaptSettings& Session::adapt_settings() const { return state_->adapt_settings; }

const LatticeSettings& Session::lattice_settings() const { return state_->lattice_settings; }

const AdaptOutcome& Session::outcome() const { return state_->outcome; }

std::uint64_t Session::folded_vertices() const { return state_->folded; }

}  // namespace pectin
