// Commands in, mesh changes out: the one thing that window, script and tests talk to.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command/command.h"
#include "command/statistics.h"
#include "ffd/lattice.h"
#include "ffd/lattice_field.h"
#include "ffd/symmetry.h"
#include "geometry/ray.h"
#include "mesh/tri_mesh.h"
#include "session/gesture.h"
#include "session/history.h"
#include "session/model_file.h"
#include "session/settings.h"
#include "session/viewport.h"

namespace pectin {

// What a picture of the mesh has to learn anew.
struct DirtyElements {
    bool everything = false;        // another object: the lists below mean nothing
    std::vector<WedgeId> wedges{};  // slots that moved or turned; sorted, each once
    std::vector<FaceId> faces{};  // slots that came, went or have other corners; sorted, each once
};

// A point of the surface.
struct Pick {
    FaceId face = kNone<FaceId>;
    Vec3 point{0.0};
    Vec3 normal{0.0};  // of the face, unit, outwards
};

struct DragOptions {
    bool connected = false;  // only the surface that hangs together with the points follows
    bool fold_free = false;  // in steps that are proven one to one
};

// What is asked of a point that is being dragged.
struct DragTarget {
    Vec3 to{0.0};
    std::optional<command::Drag::Twist> twist{};
    double scale = 1.0;
};

class Session {
  public:
    Session();
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    // Does it, or says why not and leaves everything as it was. Paths are used as they are.
    // Throws what io throws (FileError) for files; the object is then as it was, too.
    std::optional<std::string> execute(const Command& command);

    // Makes it the object, as opening its file does. Precondition: no drag is in hand. Cost: O(1),
    // and that of freeing what was there.
    void adopt(LoadedModel model);
    // For save_model, and what follows it; the save command does both by itself.
    const std::vector<std::string>& material_folders() const;
    // What the last command or drag has to tell though it is done: what was found in the input,
    // what was copied along or not, where triangles cut each other, how many steps the limit of the
    // history has dropped. Mostly empty.
    const std::string& remark() const;
    // Whether that is a failure, though the command is done: a model is saved, but a material file
    // could not be copied along.
    bool has_failed_partly() const;
    void record_saved(const std::string& path);

    // --- A drag that follows the mouse: begin it, move it, then end or cancel it. No command is
    // executed meanwhile. Ending it does what the Drag command that it came to does, to the byte,
    // whatever the frames before. With symmetry on, all of it happens on both sides.
    std::optional<std::string> begin_drag(std::span<const Vec3> points, std::span<const Vec3> pins,
                                          const DragOptions& options = {});
    // One target for each point. Cost: O(active set), as long as a fold-free drag needs no further
    // step; where it does the object is embedded anew, O(active set) a step, and the drag gets a
    // waypoint. A refusal leaves the frame before.
    std::optional<std::string> drag_to(std::span<const Vec3> targets);
    std::optional<std::string> drag_to(std::span<const DragTarget> targets);
    // As it is now, with its waypoints so far.
    const command::Drag& active_drag() const;
    const Frame& last_frame() const;
    // The command it came to; none if its targets are its points. It is a step in the history if it
    // has changed anything.
    std::optional<command::Drag> end_drag();
    void cancel_drag();  // gives everything back, to the byte; also of control points
    bool is_dragging() const;

    // --- The same for control points of the cage, by the indices that users know
    // (Lattice::user_index). Several, each once.
    std::optional<std::string> begin_control(std::span<const IVec3> indices);
    std::optional<std::string> control_to(std::span<const Vec3> targets);
    std::optional<command::Control> end_control();

    // Draws screenshots from now on; none: they are refused. Must outlive the session or be taken
    // away.
    void set_viewport(Viewport* viewport);

    const TriMesh& mesh() const;
    // The surface point that a ray meets first. Not during a drag. Cost: O(log n), the first time
    // O(n log n).
    std::optional<Pick> pick(const Ray& ray);
    // Of the last drag, or of the one in hand.
    std::optional<Lattice> lattice_in_use() const;
    // What the last step of the drag in hand does, as displaced lattices whose fields add up: one,
    // or with symmetry that and its image where they are not the same. Cost: O(control points).
    std::vector<LatticeField> active_lattices() const;
    // What has changed since it was last asked. Cost: O(changed).
    DirtyElements take_dirty();
    Statistics statistics() const;  // O(n)
    // What was found in the input of the object; see input_summary.
    const BuildReport& input_report() const;
    const ReadReport& read_report() const;

    // --- For who shows them.
    const AdaptSettings& adapt_settings() const;
    const LatticeSettings& lattice_settings() const;
    const std::optional<MirrorPlane>& symmetry() const;
    const AdaptOutcome& outcome() const;  // of the mesh as it is
    // Of the last drag or control, as Statistics has it.
    std::uint64_t folded_vertices() const;
    const History& history() const;
    std::size_t undo_count() const { return history().undo_count(); }
    std::size_t redo_count() const { return history().redo_count(); }

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace pectin
