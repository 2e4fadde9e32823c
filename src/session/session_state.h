// The state of a Session, shared by the files that implement it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "command/result.h"
#include "ffd/drag_plan.h"
#include "ffd/drag_solver.h"
#include "ffd/fold_guard.h"
#include "session/gesture.h"
#include "session/history.h"
#include "session/model_file.h"
#include "session/session.h"
#include "session/settings.h"

namespace pectin {

inline Refusal no_object() {
    return {"there is no object yet; use the open or shape command first"};
}

class Stopwatch {
  public:
    // Returns the seconds since the last lap and starts a new one.
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

struct Session::State {
    // A drag of points or of control points that has begun and not ended.
    struct ActiveGesture {
        command::Drag drag{};                // with the targets of the last frame
        command::Control control{};          // likewise for control points; empty in a drag
        Lattice lattice{};                   // of the last step
        double reach = 0.0;                  // diagonal of the zone of the first step
        std::optional<DragSolver> solver{};  // of the last step
        std::unique_ptr<FoldGuard> guard{};  // for the solver; null unless the drag is fold-free
        bool is_one_step_left = true;        // the last step is the whole last segment
        // What a frame works with. All of it is kept, so that a frame allocates nothing.
        std::vector<Move> asked{};
        DragPlan plan{};  // of the drag, with the moves that were asked for last
        std::vector<HandleMotion> motions{};  // of the last step
        std::optional<DragStep> last_step{};  // of the solver
        std::vector<Vec3> displacements{};    // of the last step, where it is not last_step
        std::vector<FaceId> staying{};  // in the zones, but not connected to the handles; sorted
        Statistics::Last measured{};    // up to now
        std::unique_ptr<Gesture> gesture{};  // null if memory ran out; refers to the active set

        bool is_control() const { return !control.points.empty(); }
    };

    // On the heap, since the active set refers to the mesh, also after the session was moved.
    std::unique_ptr<TriMesh> mesh = std::make_unique<TriMesh>();
    std::unique_ptr<ActiveSet> active = std::make_unique<ActiveSet>(*mesh);
    std::unique_ptr<FaceTree> tree;  // built when first needed
    std::unique_ptr<ActiveGesture> active_gesture;
    History history;
    AdaptSettings adapt_settings;
    LatticeSettings lattice_settings;
    std::optional<MirrorPlane> symmetry;
    DirtyElements dirty;
    Viewport* viewport = nullptr;
    std::optional<std::chrono::steady_clock::duration> frame_time;  // none: as long as it needs
    StopToken stop;                         // of the command or release that is being done
    double diagonal = 0.0;                  // of the object's box when it was opened
    std::optional<Lattice> lattice_in_use;  // of the last step of the last drag
    std::vector<Box> zones_in_use;          // of all its steps, if edges there are limited to L_max
    Statistics::Last last;
    std::uint64_t folded = 0;
    AdaptOutcome outcome;                       // of the present mesh
    BuildReport input_report;                   // what opening the object has found
    ReadReport read_report;                     // what opening the object has dropped
    double largest_coordinate = 0.0;            // of the object when it was opened
    std::string remark;                         // of the last command
    bool has_failed_partly = false;             // whether the remark reports a failure
    std::vector<std::string> material_folders;  // see LoadedModel

    bool has_object() const { return mesh->face_slots() > 0; }
    // The limits of adaptive meshing for a drag. feature_extent: the smallest feature that the
    // deformation can give the surface, from which L_max follows.
    AdaptLimits drag_limits(double feature_extent) const {
        AdaptLimits limits =
            adapt_settings.drag_limits(feature_extent, diagonal, largest_coordinate);
        limits.symmetry = symmetry;
        return limits;
    }
    // The limits for readapt, with the present settings or others.
    AdaptLimits limits_in_use() const { return limits_of(adapt_settings); }
    AdaptLimits limits_of(const AdaptSettings& settings) const {
        const double cell = lattice_in_use ? lattice_in_use->smallest_cell_extent() : kOff;
        AdaptLimits limits = settings.limits(cell, diagonal, largest_coordinate);
        limits.symmetry = symmetry;
        return limits;
    }
    void adopt(LoadedModel model) noexcept;
    void record_saved(const std::string& path);
    const FaceTree& face_tree();
    void record(const Frame& frame);
    // Marks the faces and their wedges for the renderer; everything if they are many.
    void mark_dirty(std::span<const FaceId> faces);
    // Marks the faces and updates them in the tree.
    void update_faces(std::span<const FaceId> faces) noexcept;
    // Marks everything and drops the tree. Allocates nothing.
    void update_everything() noexcept;
    struct UpdateOutcomeAtExit;

    // --- Commands. execute() calls run() for the command. A specialisation in commands.cpp does
    // each of those that stand there; without one execute() does not compile.
    Done execute(const Command& command);
    template <typename C>
    Done run(const C&) = delete;
    // drag.cpp, control.cpp, undo.cpp
    Done run(const command::Drag& drag);
    Done run(const command::Control& control);
    Done run(const command::Undo& undo);
    Done run(const command::Redo& redo);
    Done run(const command::History& limit);
    void undo_steps(std::size_t count);
    Box box_to_fit() const;
    std::vector<Box> zones_of_readapt(const AdaptSettings& settings) const;
    std::vector<EdgeId> edges_to_refine(const command::Adapt& change, std::uint32_t first,
                                        std::uint32_t count) const;

    // --- Steps of the history (undo.cpp).
    // Moves the change into the history. Throws std::bad_alloc with the change unmodified.
    void add_step(Command command, MeshChange& change);
    // Adds to the remark how many steps the limit of the history has dropped, if any.
    void report_dropped_steps() noexcept;
    // Undoes or redoes a bake: exchanges the mesh for the one of its step.
    void exchange(TriMesh& other);

    // Refines and decimates the whole object once. Precondition: the active set has begun with all
    // faces.
    Frame adapt_everything();

    // --- Drags (drag.cpp, drag_faces.cpp).
    Done begin_drag(const command::Drag& drag);
    Done drag_to(std::span<const Move> asked);
    Done replan(std::span<const Move> asked);
    std::optional<command::Drag> end_drag();
    Done check_lattice(const Lattice& lattice) const;
    Done check_targets(std::span<const Move> moves, std::span<const Vec3> via, double reach) const;
    DragPlan plan_of(const command::Drag& drag) const;
    Done embed(ActiveGesture& begun);
    std::vector<Box> zones_on_both_sides(const Warp& warp) const;
    Result<GestureFaces> faces_of(const command::Drag& drag, std::span<const Box> zones);
    std::vector<FaceId> faces_meeting(std::span<const Box> zones);
    Box with_error_margin(Box zone) const;
    Surroundings surroundings();
    std::vector<FaceId> staying_faces(std::span<const Vec3> displacements);
    Result<bool> is_single_step(std::span<const Move> asked);
    bool is_past_half_way();
    std::span<const Vec3> last_displacements();
    std::vector<VertexId> vertices_at_handles(const command::Drag& drag);

    // --- Control points (control.cpp).
    Done begin_control(std::span<const IVec3> indices);
    Done control_to(std::span<const Vec3> targets);
    std::optional<command::Control> end_control();
    Result<std::vector<Vec3>> control_displacements(const command::Control& control) const;

    // --- Gestures of both kinds (active_gesture.cpp).
    void start_gesture(ActiveGesture& begun, const GestureFaces& faces, Warp warp);
    void update_frame(std::span<const Vec3> displacements);
    bool has_unfinished_frame() const;
    bool continue_frame();
    // Ends the gesture with these displacements of the last step and adds it to the history.
    void commit(std::span<const Vec3> displacements, bool is_noop);
    void finish_commit(MeshChange& change);
    void cancel_drag() noexcept;

    Statistics statistics() const;
};

}  // namespace pectin
