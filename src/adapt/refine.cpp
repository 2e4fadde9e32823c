#include "adapt/refine.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "adapt/parallel.h"
#include "adapt/propagation.h"
#include "adapt/refinement_queue.h"
#include "mesh/first_of_siblings.h"

namespace pectin {
namespace {

// Edges that are split before those round the new vertices are looked at. Their surroundings stay
// in the cache; of 32 to 8192, 1024 was fastest.
constexpr std::size_t kBatch = 1024;
// A smaller batch has its memory before another thread has come to it.
constexpr std::size_t kWorthReadying = 256;
// Splits that room is made for at a time: a batch with what goes before its edges.
constexpr std::uint32_t kRoom = 2 * kBatch;

class Refiner {
  public:
    Refiner(ActiveSet& active, Embedding& embedding, const Criteria& criteria)
        : active_(active),
          embedding_(embedding),
          criteria_(criteria),
          propagation_(active, criteria.limits(), [this](EdgeId e) { return may_split(e); }) {}

    Refinement run() {
        push_all_needed();
        split_queued();
        return result_;
    }

    Refinement run_at(std::span<const EdgeId> edges) {
        for (EdgeId e : edges) {
            const bool below = criteria_.is_below_floor(active_.mesh(), e);
            result_.floor_hit |= below;
            if (!below) batch_.push_back({e, faces_at(e)});
        }
        split_batch();
        split_queued();
        return result_;
    }

  private:
    // The end of an edge and the corners of its faces that lie across it. Splits of the edge or of
    // its faces change them.
    struct FacesAt {
        VertexId end = kNone<VertexId>;
        std::array<VertexId, 2> across{kNone<VertexId>, kNone<VertexId>};
        bool operator==(const FacesAt&) const = default;
    };
    // An edge as the batch found it. Without an end it need not be split any more.
    struct Waiting {
        EdgeId edge;
        FacesAt faces;
        bool is_longest = false;  // of these faces
    };
    // Of the edges round an inserted vertex, what the queue is to know.
    static constexpr std::uint16_t kFine = 0xffff, kBelowFloor = 0xfffe;
    using Octaves = std::array<std::uint16_t, 4>;

    void split_queued() {
        while (!result_.budget_hit) {
            const RefinementQueue::Entries next = queue_.take(kBatch);
            if (next.edges.empty()) break;
            look_again(next);
            split_batch();
        }
    }

    // Some have been split since, or lie outside the zone now.
    void look_again(const RefinementQueue::Entries& next) {
        batch_.resize(next.edges.size());
        const auto count = static_cast<std::uint32_t>(batch_.size());
        const auto look = [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) {
                const EdgeId e = next.edges[i];
                batch_[i] = {e, {}};
                const double length = active_.mesh().squared_length(e);
                if (RefinementQueue::octave_of(length) != next.octave) continue;
                if (criteria_.is_below_floor(length))
                    continue;  // a half, bent as long as the whole
                if (!criteria_.needs_refinement(active_, e)) continue;
                batch_[i] = {e, faces_at(e), propagation_.is_longest(e)};
            }
        };
        for_pieces(0, count, look, kPieceOfSplits);
    }

    void split_batch() {
        if (batch_.size() >= kWorthReadying) make_room();
        for (const Waiting& next : batch_) {
            if (result_.budget_hit) break;
            split_waiting(next);
        }
        batch_.clear();
        place_inserted();
    }

    void split_waiting(const Waiting& next) {
        if (!exists(next.faces.end)) return;
        const FacesAt now = faces_at(next.edge);
        if (now.end != next.faces.end) return;  // its shorter half now: that has been looked at
        if (next.is_longest && now == next.faces && active_.mesh().may_split(next.edge)) {
            split(next.edge);
        } else {
            split_with_propagation(next.edge);
        }
    }

    FacesAt faces_at(EdgeId e) const {
        const TriMesh& mesh = active_.mesh();
        const HalfEdgeId h = mesh.half_edge(e), twin = mesh.twin(h);
        FacesAt faces{mesh.target(h), {mesh.origin(TriMesh::prev(h)), kNone<VertexId>}};
        if (exists(twin)) faces.across[1] = mesh.origin(TriMesh::prev(twin));
        return faces;
    }

    // For the splits to come, and has another thread take the memory of those after them.
    void make_room() {
        touching_.wait();
        active_.reserve_splits(kRoom);
        embedding_.reserve_splits(kRoom);
        ahead_.start_again();
        active_.add_room(kRoom, kRoom, ahead_);
        embedding_.add_room(kRoom, kRoom, ahead_);
        touching_.run([this] { ahead_.touch(); });
        room_ = kRoom;
    }

    // Looks at the edges on all threads, then queues them in their order. Of those along one cut
    // only the first is looked at, since that looks at all of them.
    void push_all_needed() {
        const TriMesh& mesh = active_.mesh();
        const std::span<const EdgeId> edges = active_.edges();
        const std::span<const std::uint8_t> one_look = active_.one_look_edges();
        const auto count = static_cast<std::uint32_t>(edges.size());
        const auto is_along_cut = [&](EdgeId e) { return mesh.sibling(e) != e; };
        const bool may_be_long = !(embedding_.longest_edge_bound() <= criteria_.limits().l_max);
        const auto needs = [&](std::uint32_t i) {
            const EdgeId e = edges[i];
            if (!mesh.is_live(e)) return false;
            if (one_look[i] != 0 && criteria_.looks_fine(mesh, e, may_be_long)) return false;
            return is_along_cut(e) || criteria_.needs_refinement(active_, e);
        };
        const std::span<std::uint8_t> may_need = active_.scratch_of_edges();
        for_pieces(0, count, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) may_need[i] = needs(i) ? 1 : 0;
        });
        FirstOfSiblings is_first(mesh);
        for_each_set(may_need, [&](std::size_t i) {
            const EdgeId e = edges[i];
            if (!is_first(e)) return;
            if (is_along_cut(e)) {
                if (criteria_.needs_refinement(active_, e)) push(e);
            } else {
                push(e);
            }
        });
    }

    // visit(index of each byte that is 1), in order.
    template <typename Visit>
    static void for_each_set(std::span<const std::uint8_t> bytes, Visit visit) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const void* const next = std::memchr(bytes.data() + i, 1, bytes.size() - i);
            if (!next) return;
            i = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - bytes.data());
            visit(i);
        }
    }

    void push(EdgeId e) { push(e, octave_of(e)); }
    void push(EdgeId e, std::uint16_t octave) {
        if (octave == kBelowFloor) {
            result_.floor_hit = true;
        } else {
            queue_.push(e, octave);
        }
    }
    std::uint16_t octave_of(EdgeId e) const {
        const double length = active_.mesh().squared_length(e);
        if (criteria_.is_below_floor(length)) return kBelowFloor;
        return static_cast<std::uint16_t>(RefinementQueue::octave_of(length));
    }

    // Splits what has to go before e, then e.
    void split_with_propagation(EdgeId e) {
        while (true) {
            const auto [first, leaves_sliver] = propagation_.chain(e);
            if (leaves_sliver) {
                active_.mesh().for_each_side(e, [this](HalfEdgeId h) { block(h); });
                result_.floor_hit = true;
                return;
            }
            if (!active_.mesh().may_split(first) || !split(first) || first == e) return;
        }
    }

    // Once an edge, also where it has two sides.
    void block(HalfEdgeId h) {
        const EdgeId e = active_.mesh().edge(h);
        if (active_.mesh().half_edge(e) == h) result_.blocked.push_back(e);
    }

    // Goes by where its ends are.
    bool may_split(EdgeId e) {
        if (has_unplaced_end(e)) place_inserted();
        return !criteria_.is_below_floor(active_.mesh(), e) && active_.mesh().may_split(e);
    }

    bool has_unplaced_end(EdgeId e) const {
        const auto is_unplaced = [this](VertexId v) {
            const auto entry = active_.entry_of(v);
            return entry && *entry < unplaced_.size() && unplaced_[*entry] != 0;
        };
        const HalfEdgeId h = active_.mesh().half_edge(e);
        return is_unplaced(active_.mesh().origin(h)) || is_unplaced(active_.mesh().target(h));
    }

    bool split(EdgeId e) {
        const TriMesh& mesh = active_.mesh();
        std::uint32_t added = 0;
        mesh.for_each_side(e, [&](HalfEdgeId) { ++added; });
        if (mesh.face_count() + added > criteria_.limits().budget) {
            result_.budget_hit = true;
            return false;
        }
        if (has_unplaced_end(e)) place_inserted();  // the midpoint inherits the mark of its ends
        if (touching_.is_running() && room_ < added) make_room();
        room_ -= std::min(room_, added);
        active_.split(e, inserted_);
        const std::size_t entry = inserted_.back().vertex_entry;
        if (entry >= unplaced_.size()) unplaced_.resize(std::max(2 * entry, kBatch));
        unplaced_[entry] = 1;
        ++result_.splits;
        return true;
    }

    // Where the warp takes what has been inserted, then which edges round it wait now.
    void place_inserted() {
        touching_.wait();
        embedding_.place(inserted_);
        octaves_.resize(inserted_.size());
        const auto look = [this](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) {
                const ActiveSet::Inserted& made = inserted_[i];
                for (std::size_t k = 0; k < made.edges.size(); ++k) {
                    octaves_[i][k] = look_at_new(made.edges[k], k >= 2 || made.is_one_look);
                }
            }
        };
        for_pieces(0, static_cast<std::uint32_t>(inserted_.size()), look, kPieceOfSplits);
        for (std::size_t i = 0; i < inserted_.size(); ++i) {
            unplaced_[inserted_[i].vertex_entry] = 0;
            for (std::size_t k = 0; k < inserted_[i].edges.size(); ++k) {
                if (octaves_[i][k] != kFine) push(inserted_[i].edges[k], octaves_[i][k]);
            }
        }
        inserted_.clear();
    }

    // Of an edge that a split has made or halved, most of which look fine.
    std::uint16_t look_at_new(EdgeId e, bool is_one_look) const {
        if (!exists(e)) return kFine;
        if (is_one_look && criteria_.looks_fine(active_.mesh(), e, true)) return kFine;
        return criteria_.needs_refinement(active_, e) ? octave_of(e) : kFine;
    }

    ActiveSet& active_;
    Embedding& embedding_;
    const Criteria& criteria_;
    Propagation propagation_;
    RefinementQueue queue_;
    std::vector<Waiting> batch_;
    std::vector<ActiveSet::Inserted> inserted_;  // since the last place_inserted
    std::vector<Octaves> octaves_;               // of these
    std::vector<std::uint8_t> unplaced_;         // vertex entries: whether they are among these
    MemoryAhead ahead_;
    Meanwhile touching_;
    std::uint32_t room_ = 0;  // while it is: how many sides of edges may be split
    Refinement result_;
};

}  // namespace

Refinement refine(ActiveSet& active, Embedding& embedding, const Criteria& criteria) {
    return Refiner(active, embedding, criteria).run();
}

Refinement refine_at(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                     std::span<const EdgeId> edges) {
    return Refiner(active, embedding, criteria).run_at(edges);
}

}  // namespace pectin
