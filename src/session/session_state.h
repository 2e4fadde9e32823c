// What a Session holds, shared by the files that implement it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "ffd/drag_solver.h"
#include "ffd/injective_steps.h"
#include "session/gesture.h"
#include "session/history.h"
#include "session/model_file.h"
#include "session/session.h"
#include "session/settings.h"

namespace pectin {

using Refusal = std::optional<std::string>;

inline constexpr const char* kNoObject =
    "there is no object yet; use the open or shape command first";

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

struct Session::State {
    // A drag of points or of control points between begin and end.
    struct ActiveGesture {
        command::Drag drag{};                // `to` is where the last frame put it
        command::Control control{};          // the same of control points; empty in a drag
        Lattice lattice{};                   // of the last step
        double reach = 0.0;                  // diagonal of the first step's zone
        std::optional<DragSolver> solver{};  // of the last step
        std::unique_ptr<FoldGuard> guard{};  // of the solver; null unless the drag is fold-free
        bool is_one_step_left = true;        // whether the last segment is the last step
        Statistics::Last measured{};         // so far
        std::unique_ptr<Gesture> gesture{};  // refers to the active set; none if memory gave out

        bool is_control() const { return !control.points.empty(); }
    };

    // Behind pointers: the active set refers to the mesh wherever the session goes.
    std::unique_ptr<TriMesh> mesh = std::make_unique<TriMesh>();
    std::unique_ptr<ActiveSet> active = std::make_unique<ActiveSet>(*mesh);
    std::unique_ptr<FaceTree> tree;  // made when first asked for
    std::unique_ptr<ActiveGesture> active_gesture;
    History history;
    AdaptSettings adapt_settings;
    LatticeSettings lattice_settings;
    std::optional<MirrorPlane> symmetry;
    DirtyElements dirty;
    Viewport* viewport = nullptr;
    double diagonal = 0.0;                  // of the object's box as it was opened
    std::optional<Lattice> lattice_in_use;  // the last step's of the last drag
    std::vector<Box> zones_in_use;          // all steps'; none after a connected drag
    Statistics::Last last;
    std::uint64_t folded = 0;
    AdaptOutcome outcome;                       // of the mesh as it is
    BuildReport input_report;                   // what opening the object took
    ReadReport read_report;                     // what opening it dropped
    double largest_coordinate = 0.0;            // of the object as it was opened
    std::string remark;                         // of the last command
    bool has_failed_partly = false;             // the last command, as the remark says
    std::vector<std::string> material_folders;  // as LoadedModel has them

    bool has_object() const { return mesh->face_slots() > 0; }
    AdaptLimits limits(const std::optional<Lattice>& lattice) const {
        AdaptLimits limits = adapt_settings.limits(lattice ? lattice->smallest_cell_extent() : kOff,
                                                   diagonal, largest_coordinate);
        limits.symmetry = symmetry;
        return limits;
    }
    void adopt(LoadedModel model);
    void record_saved(const std::string& path);
    const FaceTree& face_tree();
    void record(const Frame& frame);
    // The picture has to learn these faces and their corners anew.
    void mark_dirty(std::span<const FaceId> faces);
    // The same, and the tree has to follow.
    void update_faces(std::span<const FaceId> faces) noexcept;
    // The same for all faces. Allocates nothing.
    void update_everything() noexcept;
    struct OutcomeOfReachedStep;
    // Of the step that led to the mesh as it is.
    void take_outcome() noexcept;

    // --- One for each command.
    Refusal run(const command::Open& open);
    Refusal run(const command::Shape& shape);
    Refusal run(const command::Adapt& adapt);
    Refusal run(const command::Brush& brush);
    Refusal run(const command::Cage& cage);
    Refusal run(const command::Symmetry& symmetry_command);
    Refusal run(const command::Drag& drag);
    Refusal run(const command::Control& control);
    Refusal run(const command::Undo& undo);
    Refusal run(const command::Redo& redo);
    Refusal run(const command::History& limit);
    Refusal run(const command::Readapt& readapt);
    std::vector<Box> zones_of_readapt() const;
    Refusal run(const command::Bake& bake);
    Refusal run(const command::Save& save);
    Refusal run(const command::Stats& stats);
    Refusal run(const command::Screenshot& screenshot);

    // --- Steps (undo.cpp).
    // Takes over the change. Where there is no memory it throws, and the change is as it was.
    void add_step(Command command, MeshChange& change);
    // Refines and decimates the whole object once.
    Frame adapt_everything();
    // Adds to the remark how many steps the limit of the history has dropped, if any.
    void report_dropped_steps() noexcept;
    // Of a bake's step: the mesh on its one side for that on its other.
    void exchange(TriMesh& other);

    // --- Drags (drag.cpp).
    Refusal begin_drag(const command::Drag& drag);
    Refusal drag_to(const command::Drag& drag);
    std::optional<command::Drag> end_drag();
    Refusal check_lattice(const Lattice& lattice) const;
    Refusal check_targets(const command::Drag& drag, double reach) const;
    DragPlan plan_of(const command::Drag& drag) const;
    Refusal embed(ActiveGesture& begun);
    std::variant<std::vector<FaceId>, std::string> faces_of(const command::Drag& drag,
                                                            std::span<const Box> zones);
    bool is_single_step(const command::Drag& drag, Refusal& refusal) const;
    bool is_past_half_way() const;
    std::vector<Vec3> last_displacements() const;

    // --- Control points (control.cpp).
    Refusal begin_control(std::span<const IVec3> indices);
    Refusal control_to(std::span<const Vec3> targets);
    std::optional<command::Control> end_control();
    std::variant<std::vector<Vec3>, std::string> control_displacements(
        const command::Control& control) const;

    // --- Both.
    std::vector<VertexId> vertices_at_handles(const command::Drag& drag);
    void start_gesture(ActiveGesture& begun, std::span<const FaceId> faces, Warp warp);
    void update_frame(std::span<const Vec3> displacements);
    // Ends the gesture with these displacements of the last step; a step of the history.
    void commit(std::span<const Vec3> displacements, bool is_noop);
    void finish_commit(MeshChange& change);
    void cancel_drag() noexcept;

    Statistics statistics() const;
};

}  // namespace pectin
