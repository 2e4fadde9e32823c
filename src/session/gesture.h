// A gesture: frames of a deformation that changes, from mouse down to mouse up, and one commit.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "adapt/adapt.h"
#include "adapt/passed_faces.h"
#include "adapt/self_intersections.h"
#include "embedding/embedding.h"
#include "ffd/warp.h"
#include "mesh/active_set.h"
#include "mesh/mesh_change.h"

namespace pectin {

// What a frame has done to the mesh, and the time it took.
struct Frame {
    std::uint64_t splits = 0, unsplits = 0;
    bool floor_hit = false;
    bool budget_hit = false, drag_budget_hit = false;  // not both: the one that was reached first
    std::vector<EdgeId> blocked;                       // see Refinement
    Assessment assessment;                             // only a commit makes one
    std::uint64_t self_intersections = 0;  // that remain; see Refinement. Only a commit finds them.
    IntersectionLimit intersection_limit = IntersectionLimit::none;
    std::optional<double> error;  // see accumulate_errors(); only a commit finds it
    PassedFaces passed;           // of the faces that stay; only a commit searches for them
    bool is_complete = true;      // false if adaptive meshing was stopped and would continue
    double deform_seconds = 0.0, refine_seconds = 0.0, decimate_seconds = 0.0;

    bool is_budget_used_up() const { return budget_hit || drag_budget_hit; }
};

// The faces that meet the zone of a warp, sorted.
struct GestureFaces {
    std::vector<FaceId> moving;
    std::vector<FaceId> staying{};  // other parts of the surface, in a drag of a connected part
};

// What a commit tests for intersections with active faces.
struct SearchedFaces {
    // Of a warp without folds. Refinement resolves intersections.
    Surroundings surroundings{};
    // Faces of other parts of the surface that a drag of a connected part leaves alone, sorted.
    // Intersections are only reported.
    std::vector<FaceId> staying{};
};

// Begins the active set. commit() or cancel() ends it; the destructor cancels it. The result of a
// commit depends only on the mesh before the gesture, the displacements and the limits, since the
// frames before it are rolled back first.
class Gesture {
  public:
    // How the gesture adapts the mesh.
    struct Adaptivity {
        AdaptLimits limits;
        std::uint64_t drag_budget = kNoBudget;  // triangles that the gesture may add
        std::vector<VertexId> kept{};           // vertices that decimation does not remove
    };
    static constexpr std::uint64_t kNoBudget = std::numeric_limits<std::uint64_t>::max();

    // adaptivity: nothing for a gesture without adaptive meshing. Throws std::bad_alloc, and
    // Stopped where `stop` asks for it; the mesh is then unchanged. Cost: that of
    // Embedding::embed().
    Gesture(ActiveSet& active, const GestureFaces& faces, Warp warp,
            std::optional<Adaptivity> adaptivity, const StopToken& stop = {});
    ~Gesture();
    Gesture(const Gesture&) = delete;
    Gesture& operator=(const Gesture&) = delete;

    // Deforms and adapts the object by these displacements of the warp's last step; see
    // displacements_of(). time: how long adaptive meshing may take, if it is limited. Positions and
    // normals of the vertices that are there are right all the same, and another frame with these
    // displacements continues. Where the frames were rolled back, refinement begins anew. Cost:
    // O(active set).
    using Duration = std::chrono::steady_clock::duration;
    const Frame& frame(std::span<const Vec3> displacements, std::optional<Duration> time = {});
    // Boxes that everything is in which the gesture moves by these displacements.
    std::vector<Box> zones_with_reach(std::span<const Vec3> displacements);
    // Takes back what the frames have done.
    void return_to_rest();
    // Ends the gesture with a single frame from the rest state, and returns what it has changed.
    // Only this frame searches for intersections. Throws Stopped where `stop` asks for it; the
    // gesture can be cancelled then.
    MeshChange commit(std::span<const Vec3> displacements, const SearchedFaces& searched = {},
                      const StopToken& stop = {});
    // Restores the mesh byte for byte, without allocating. Returns the faces that the gesture had
    // changed, or nothing if there is no memory for the list.
    std::optional<std::vector<FaceId>> cancel() noexcept;

    // --- For the renderer

    // Returns the slots of faces that edits have inserted, split or freed since the last call, also
    // where they were rolled back.
    std::vector<FaceId> take_edited_faces();
    // Appends the live wedges whose positions or normals the last frame has set. Cost: O(active
    // set).
    void append_moved_wedges(std::vector<WedgeId>& wedges) const;
    std::size_t memory_bytes() const { return embedding_.memory_bytes(); }

    const Warp& warp() const { return warp_; }
    // Whether edges in the zones of the warp are refined if they are longer than L_max. True also
    // without adaptive meshing, so that it can be done later.
    bool limits_edge_length() const { return !criteria_ || criteria_->length().limits_result(); }
    const Frame& last_frame() const { return last_; }
    // What the last frame has left. Cost: O(active set).
    Assessment assessment() const;
    std::uint64_t influenced_vertices() const { return influenced_; }
    std::uint64_t folded_vertices() const { return folded_; }  // after the commit

  private:
    template <typename Adapt>
    const Frame& apply(std::span<const Vec3> displacements, Adapt adapt);
    void set_displacements(std::span<const Vec3> displacements);
    void roll_back();

    ActiveSet& active_;
    Warp warp_;
    Embedding embedding_;
    std::optional<Criteria> criteria_;
    bool is_drag_budget_less_ = false;  // than what the object's budget leaves
    std::uint64_t influenced_ = 0, folded_ = 0;
    Frame last_;
    bool has_frames_ = false;
    std::vector<FaceId> rolled_back_faces_;
    std::size_t taken_faces_ = 0;  // how many of the active set's edited faces were returned
};

}  // namespace pectin
