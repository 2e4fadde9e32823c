// One drag from mouse down to mouse up: frames that follow the mouse, one commit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "adapt/adapt.h"
#include "embedding/embedding.h"
#include "ffd/warp.h"
#include "mesh/active_set.h"
#include "mesh/mesh_change.h"

namespace pectin {

// What a frame did to the mesh, and what it took.
struct Frame {
    std::uint64_t splits = 0, unsplits = 0;
    bool floor_hit = false, budget_hit = false;
    std::vector<EdgeId> blocked;  // see Refinement
    std::uint64_t self_intersections =
        0;  // left (Refinement::self_intersections); only a commit looks for them
    IntersectionLimit intersection_limit = IntersectionLimit::none;
    double deform_seconds = 0.0, refine_seconds = 0.0, decimate_seconds = 0.0;
};

// Begins the active set; cancel or commit ends it, the destructor cancels. What a
// commit does depends only on the mesh before the gesture, the displacements and the limits: the
// frames before it are rolled back first.
class Gesture {
  public:
    // faces: those that meet the warp's zone, sorted. limits: none to deform only. kept: vertices
    // that decimation does not remove. Cost: weights of the active set.
    Gesture(ActiveSet& active, std::span<const FaceId> faces, Warp warp,
            const std::optional<AdaptLimits>& limits, std::vector<VertexId> kept = {});
    ~Gesture();
    Gesture(const Gesture&) = delete;
    Gesture& operator=(const Gesture&) = delete;

    // The object as these displacements of the warp's last step have it: one for each of its
    // moves, or for each control point.
    // Cost: O(active set).
    const Frame& frame(std::span<const Vec3> displacements);
    // The same as a single frame from the rest state, for good. Self-intersections are looked for
    // here alone.
    MeshChange commit(std::span<const Vec3> displacements);
    // Gives everything back, to the byte, and allocates nothing for it. Returns the faces that it
    // had changed, or nothing where there is no memory for them.
    std::optional<std::vector<FaceId>> cancel() noexcept;

    // --- For who shows the frames.
    // Slots that edits have made, cut or freed since it was last asked, those that were rolled back
    // among them.
    std::vector<FaceId> take_edited_faces();
    // The live wedges that the last frame has placed. Cost: O(active set).
    void append_moved_wedges(std::vector<WedgeId>& wedges) const;
    std::size_t memory_bytes() const { return embedding_.memory_bytes(); }

    const Warp& warp() const { return warp_; }
    const Frame& last_frame() const { return last_; }
    std::uint64_t influenced_vertices() const { return influenced_; }
    std::uint64_t folded_vertices() const { return folded_; }  // of the commit

  private:
    using Adapt = Adaptation (*)(ActiveSet&, Embedding&, const Criteria&);

    const Frame& apply(std::span<const Vec3> displacements, Adapt adapt);
    void roll_back();

    ActiveSet& active_;
    Warp warp_;
    Embedding embedding_;
    std::optional<Criteria> criteria_;
    std::uint64_t influenced_ = 0, folded_ = 0;
    Frame last_;
    bool has_frames_ = false;
    std::vector<FaceId> rolled_back_faces_;
    std::size_t taken_faces_ = 0;  // of the active set's edited ones
};

}  // namespace pectin
