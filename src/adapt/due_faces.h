// The faces that may need refinement, without looking at the others.
#pragma once

#include <cstdint>
#include <vector>

#include "ffd/interpolation_error.h"
#include "mesh/active_set.h"

namespace pectin {

// Of a drag of one step with one weight the bound of a face is the length of the drag times a
// number, its slope, that does not change during the gesture (InterpolationError::slope). So a face
// need not be examined before the drag is as long as its tolerance allows. Faces wait in a heap,
// the steepest on top. A slope is estimated first, from bounds over whole parts of cells, and
// computed when the face becomes due by the estimate.
//
// Faces that edits have made wait as well: the edits since the last call are read from the log of
// the active set, which also says if they were rolled back.
class DueFaces {
  public:
    using Corners = InterpolationError::Corners;

    // The live active faces whose bound is above the tolerance, sorted. error: is_proportional().
    // Cost: O(faces) the first time and after a rollback, else O(log faces) for each face that is
    // due or was edited.
    std::vector<FaceId> find(const ActiveSet& active, const InterpolationError& error,
                             double tolerance);

    // How many slopes were estimated and computed so far.
    std::uint64_t examined() const { return examined_; }

  private:
    struct Waiting {
        float slope;
        FaceId face;
        std::uint32_t edits;  // of the face so far
        bool operator<(const Waiting& other) const {
            return slope != other.slope ? slope < other.slope : face < other.face;
        }
    };

    void begin(const ActiveSet& active, const InterpolationError& error);
    void add_edited(const ActiveSet& active, const InterpolationError& error);
    Waiting estimated(const ActiveSet& active, const InterpolationError& error, FaceId f) const;
    bool is_up_to_date(const ActiveSet& active, const Waiting& waiting) const;
    void push(const Waiting& waiting);

    const ActiveSet* active_ = nullptr;
    std::uint64_t roll_backs_ = 0;
    std::size_t synced_upto_ = 0;  // of the edited faces
    double rounding_ = 0.0;        // at most, of all faces
    std::vector<Waiting> heap_;
    std::vector<std::uint32_t> edits_;  // for each face slot
    std::uint64_t examined_ = 0;
};

}  // namespace pectin
