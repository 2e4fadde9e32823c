#include "adapt/triggers/certified_error.h"

#include <algorithm>
#include <atomic>
#include <span>

#include "adapt/due_faces.h"
#include "adapt/face_pairs.h"
#include "adapt/sheets.h"
#include "embedding/embedding.h"
#include "ffd/interpolation_error.h"

namespace pectin {
namespace {

// Slack for bounds whose terms are summed in another order.
constexpr double kRoundedDown = 1.0 - 1e-9;

// Steps whose corners are kept on the stack. Longer warps are rare.
constexpr std::size_t kFewSteps = 16;

// Calls ask(the corners of a face before each step). They are sorted, so that the corner at which a
// face begins does not matter, not even by rounding.
template <typename Ask>
auto with_corners(const Embedding& embedding, std::array<VertexId, 3> face, const Ask& ask) {
    std::ranges::sort(face);
    std::array<InterpolationError::Corners, kFewSteps> few;
    std::vector<InterpolationError::Corners> many;
    const std::size_t steps = embedding.step_count();
    if (steps > few.size()) many.resize(steps);
    const std::span<InterpolationError::Corners> all =
        steps > few.size() ? std::span(many) : std::span(few).first(steps);
    for (std::size_t step = 0; step < steps; ++step) {
        for (std::size_t c = 0; c < 3; ++c) {
            all[step][c] = embedding.position_before(step, face[c]);
        }
    }
    return ask(std::span<const InterpolationError::Corners>(all));
}

}  // namespace

// What changes during a gesture though the trigger does not.
struct CertifiedError::State {
    explicit State(const Warp& warp) : error(warp) {}

    InterpolationError error;
    DueFaces due;
    std::atomic<std::uint64_t> examined = 0;
};

void CertifiedError::bind(const Embedding* embedding, const SplitOrder& order, const Floor& floor) {
    embedding_ = embedding;
    order_ = order;
    floor_ = floor;
    const bool is_on = embedding && tolerance_ < kOff;
    state_ = is_on ? std::make_shared<State>(embedding->warp()) : nullptr;
}

void CertifiedError::update() const {
    if (state_) state_->error.update();
}

CertifiedError::Face CertifiedError::face_of(const TriMesh& mesh, FaceId f) {
    const HalfEdgeId h = TriMesh::half_edge(f, 0);
    return {mesh.origin(h), mesh.target(h), mesh.origin(TriMesh::prev(h))};
}

double CertifiedError::bound(const Face& face) const {
    if (!state_) return 0.0;
    return with_corners(*embedding_, face,
                        [this](const auto& corners) { return state_->error.bound(corners); });
}

ErrorEllipsoid CertifiedError::accumulated(const ErrorEllipsoid& error, double own_bound,
                                           const Face& face) const {
    if (!state_) return error;
    return with_corners(*embedding_, face, [&](const auto& corners) {
        return state_->error.accumulated(error, own_bound, corners);
    });
}

double CertifiedError::bound(const ActiveSet& active, FaceId f) const {
    return active.stays(f) ? 0.0 : bound(face_of(active.mesh(), f));
}

ErrorEllipsoid CertifiedError::accumulated(const ActiveSet& active, FaceId f,
                                           double own_bound) const {
    const ErrorEllipsoid error = active.mesh().error(f);
    return active.stays(f) ? error : accumulated(error, own_bound, face_of(active.mesh(), f));
}

std::vector<FaceId> CertifiedError::faces_to_test(const ActiveSet& active) const {
    if (!state_) return {};
    if (search_ == Search::due && state_->error.is_proportional()) {
        return state_->due.find(active, state_->error, tolerance_);
    }
    return face_pairs::live(active.mesh(), {active.faces().begin(), active.faces().end()});
}

std::uint64_t CertifiedError::examined_faces() const {
    return state_ ? state_->examined.load() + state_->due.examined() : 0;
}

HalfEdgeId CertifiedError::needed_split(const ActiveSet& active, HalfEdgeId h) const {
    if (!state_) return kNone<HalfEdgeId>;
    state_->examined.fetch_add(1, std::memory_order_relaxed);
    const Face face = face_of(active.mesh(), TriMesh::face(h));
    const bool is_surely_fine =
        state_->error.rough_bound({active.rest_position(face[0]), active.rest_position(face[1]),
                                   active.rest_position(face[2])}) <= tolerance_;
    if (is_surely_fine || bound(active, TriMesh::face(h)) <= tolerance_) {
        return kNone<HalfEdgeId>;
    }
    return order_->first_edge(active, h, *floor_);
}

bool CertifiedError::needs_refinement(const ActiveSet& active, EdgeId e) const {
    if (!state_) return false;
    bool is_needed = false;
    active.mesh().for_each_side(
        e, [&](HalfEdgeId h) { is_needed = is_needed || needed_split(active, h) == h; });
    return is_needed;
}

//          a                  a
//         /|\                / \         Undoing the split of m restores the faces bca and, away
//        / | \              /   \        from a boundary, cbd.
//       b--m--c    --->    b-----c
//        \ | /              \   /
//         \|/                \ /
//          d                  d
bool CertifiedError::merged_edge_needs_refinement(const ActiveSet& active, const Star& star) const {
    if (tolerance_ == kOff) return false;
    return !all_sheets(active.mesh(), star, [&](const Star& sheet) {
        if (active.stays(TriMesh::face(sheet.bm))) return true;
        const bool is_exact = active.merges_exactly(sheet);
        const auto may = [&](HalfEdgeId h, const Face& face) {
            return may_restore(face, active.merged_error(sheet, h), is_exact);
        };
        return may(sheet.bm, {sheet.b, sheet.c, sheet.a}) &&
               (sheet.on_boundary() || may(sheet.mb, {sheet.c, sheet.b, sheet.d}));
    });
}

// error: of the face before this gesture. is_exact: that of its pieces was the same.
bool CertifiedError::may_restore(const Face& face, const ErrorEllipsoid& error,
                                 bool is_exact) const {
    const double most = kRoundedDown * tolerance_;
    const double own = bound(face);
    if (!(own <= most)) return false;
    return is_exact || accumulated(error, own, face).radius() <= most;
}

}  // namespace pectin
