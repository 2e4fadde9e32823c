// The session of one object: executes commands and drags, and reports what they change. Window,
// scripts and tests all use this one interface.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command/command.h"
#include "command/result.h"
#include "command/statistics.h"
#include "ffd/lattice.h"
#include "ffd/lattice_field.h"
#include "ffd/symmetry.h"
#include "geometry/move.h"
#include "geometry/ray.h"
#include "geometry/stop_token.h"
#include "mesh/tri_mesh.h"
#include "session/gesture.h"
#include "session/history.h"
#include "session/model_file.h"
#include "session/settings.h"
#include "session/viewport.h"

namespace pectin {

// The elements that a renderer must update. Gestures, undo and redo collect them
// (Session::State::update_frame, update_faces and mark_dirty), and app/object_view.cpp uploads
// them.
struct DirtyElements {
    // The object is another one, or much of it has changed; the lists below mean nothing then.
    bool everything = false;
    // Slots of wedges that moved or whose normals changed. Sorted, without duplicates.
    std::vector<WedgeId> wedges{};
    // Slots of faces that appeared, disappeared or have other corners. Sorted, without duplicates.
    std::vector<FaceId> faces{};

    void clear() {  // keeps the memory of the lists
        everything = false;
        wedges.clear();
        faces.clear();
    }
};

// A point of the surface.
struct Pick {
    FaceId face = kNone<FaceId>;
    Vec3 point{0.0};
    Vec3 normal{0.0};  // of the face: unit length, outwards
};

struct DragOptions {
    bool connected = false;  // moves only the part of the surface that is connected to the handles
    bool fold_free = false;  // goes in steps that are proven one to one
};

// Everything is in world space. What is refused (Done) leaves the object unchanged.
class Session {
  public:
    Session();
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    // --- Commands and files

    // Executes a command. Refused while a gesture is active. Paths are used as they are given.
    // Throws what io throws for files (FileError); the object is then unchanged, too. The same
    // holds for Stopped, which drag, control, readapt, bake and redo throw where `stop` asks for
    // it.
    Done execute(const Command& command, const StopToken& stop = {});

    // Makes the model the object of the session, as opening its file does. The history is cleared,
    // and the settings stay. Precondition: no gesture is active. Cost: O(1), and the time to free
    // the object before it.
    void adopt(LoadedModel model) noexcept;
    // For callers of save_model(): the folders in which material files are searched, and a record
    // of the path of a saved model. The save command uses both itself.
    const std::vector<std::string>& material_folders() const;
    void record_saved(const std::string& path);
    // What the last command or drag has to report although it has succeeded: findings in the input,
    // which material files were copied, remaining self-intersections, how many steps the limit of
    // the history has dropped. Often empty.
    const std::string& remark() const;
    // Whether the remark reports a failure: the model is saved, but a material file could not be
    // copied to its folder.
    bool has_failed_partly() const;

    // --- A drag that follows the mouse: begin it, move it, then end or cancel it. No command is
    // executed meanwhile. Ending it gives byte for byte the mesh of the Drag command that it
    // returns, whatever frames came before. With symmetry everything happens on both sides.

    // points: at least one handle. pins: points to hold.
    Done begin_drag(std::span<const Vec3> points, std::span<const Vec3> pins,
                    const DragOptions& options = {});
    // Shows a frame in which the handles are at these targets, one for each point of begin_drag().
    // A refusal keeps the frame before. Cost: O(active set). If a fold-free drag needs another
    // step, the object is embedded anew, O(active set) for each step, and the drag gets a waypoint.
    Done drag_to(std::span<const Vec3> targets);
    // The same with twist and scale. Precondition: `from` of each move is the point of
    // begin_drag().
    Done drag_to(std::span<const Move> moves);
    // How long adaptive meshing of one frame may take, in drags of points and of control points; by
    // default as long as it needs. What is left is done by continue_frame(), or at the end.
    void set_frame_time(std::optional<std::chrono::steady_clock::duration> time);
    // Whether a drag is active and adaptive meshing was stopped in its last frame.
    bool has_unfinished_frame() const;
    // Goes on with such a frame. Returns whether there was one.
    bool continue_frame();
    // The Drag command so far, with the waypoints that it has got.
    const command::Drag& active_drag() const;
    const Frame& last_frame() const;
    // Ends the drag and returns the command that it amounts to, or nothing if all targets are the
    // points where it began. It is a step in the history if it has changed the object. Throws
    // Stopped where `stop` asks for it; the drag is cancelled then.
    std::optional<command::Drag> end_drag(const StopToken& stop = {});
    // Restores the object byte for byte. Also cancels a drag of control points.
    void cancel_drag();
    // Whether a gesture is active, of points or of control points.
    bool is_dragging() const;
    bool is_dragging_control_points() const;

    // --- A drag of control points of the cage, in the same way. indices: at least one, each once,
    // as users count them (Lattice::user_index).
    Done begin_control(std::span<const IVec3> indices);
    Done control_to(std::span<const Vec3> targets);
    std::optional<command::Control> end_control(const StopToken& stop = {});

    // --- Queries

    const TriMesh& mesh() const;
    // Returns the first point of the surface on the ray; nothing during a gesture. Cost: O(log n);
    // O(n log n) for the first pick of an object.
    std::optional<Pick> pick(const Ray& ray);
    // Returns the distance of a point from the surface; nothing without an object and during a
    // gesture. Cost: that of pick().
    std::optional<double> distance_to_surface(const Vec3& point);
    // Does now what the next pick and the first drag would have to do first, as far as there is
    // memory for it: builds the face tree, and takes memory for kPreparedSplits splits from the
    // system. Cost: O(n log n) where the object is another one since the last call, else less than
    // a millisecond.
    void prepare_for_drags() noexcept;
    // The lattice of the active gesture, or of the last drag.
    std::optional<Lattice> lattice_in_use() const;
    // Displaced lattices whose fields add up to the last step of the active gesture: one, or two if
    // symmetry is on and the mirror image is a different lattice. Cost: O(control points).
    std::vector<LatticeField> active_lattices() const;
    // Returns and forgets what has changed since the last call. Cost: O(changed).
    DirtyElements take_dirty();
    // The same; `taken` gets the elements, and the session its memory for the next ones.
    void take_dirty(DirtyElements& taken);
    Statistics statistics() const;  // O(n)
    // The edges that readapt would split first if the settings were changed so: of the `count`
    // edges from the slot `first` on, those that need refinement and that the floor does not hold
    // back. None during a gesture, and none if the change would be refused. Cost: O(count).
    std::vector<EdgeId> edges_to_refine(const command::Adapt& change, std::uint32_t first,
                                        std::uint32_t count) const;
    // What was found in the input of the object; see input_summary().
    const BuildReport& input_report() const;
    const ReadReport& read_report() const;

    const AdaptSettings& adapt_settings() const;
    const LatticeSettings& lattice_settings() const;
    const std::optional<MirrorPlane>& symmetry() const;
    // Where adaptive meshing of the present mesh has stopped short.
    const AdaptOutcome& outcome() const;
    // Statistics::folded_vertices of the last drag or control command.
    std::uint64_t folded_vertices() const;
    const History& history() const;
    std::size_t undo_count() const { return history().undo_count(); }
    std::size_t redo_count() const { return history().redo_count(); }

    // Sets what draws screenshots, which are refused while it is null. The viewport must outlive
    // the session or be set to null before it ends.
    void set_viewport(Viewport* viewport);

  private:
    struct State;
    template <typename Work>
    auto stoppable(const StopToken& stop, Work work);

    std::unique_ptr<State> state_;
};

}  // namespace pectin
