#include "adapt/refine.h"

#include <cstring>

#include "adapt/concurrent/splits.h"
#include "adapt/edge_classifier.h"
#include "adapt/propagation.h"
#include "adapt/refinement_queue.h"
#include "geometry/parallel.h"
#include "mesh/first_of_siblings.h"

namespace pectin {
namespace {

class Refiner {
  public:
    Refiner(ActiveSet& active, Embedding& embedding, const Criteria& criteria)
        : active_(active),
          embedding_(embedding),
          criteria_(criteria),
          classifier_(active, criteria),
          propagation_(active, criteria.limits(), [this](EdgeId e) { return may_split(e); }),
          concurrent_splits_(active, embedding, classifier_, criteria.limits()),
          queue_(criteria.limits().partition_batch) {}

    Refinement run() {
        push_all_needed();
        split_queued();
        result_.chain_steps = propagation_.steps();
        return result_;
    }

    Refinement run_at(std::span<const EdgeId> edges) {
        for (EdgeId e : edges) {
            const bool below = criteria_.is_below_floor(active_.mesh(), e);
            result_.floor_hit |= below;
            if (!below) batch_.push_back({e, end_of(e)});
        }
        split_batch();
        split_queued();
        result_.chain_steps = propagation_.steps();
        return result_;
    }

  private:
    // An edge to be split, where it ended when that was found, and the lane of what it makes.
    struct PendingSplit {
        EdgeId edge;
        VertexId end;
        std::size_t partition = 0;
    };

    // Edges that are split before those round the new vertices are looked at have their
    // surroundings in the cache.
    void split_queued() {
        while (!result_.budget_hit && !queue_.is_empty()) {
            const RefinementQueue::Entries next = queue_.take();
            if (next.is_one_partition) {
                append_to_batch(next);
            } else {
                split_concurrently(next);
            }
            split_batch();
        }
    }

    void append_to_batch(const RefinementQueue::Entries& next) {
        for (std::size_t partition = 0; partition < next.partitions.size(); ++partition) {
            for (EdgeId e : next.partitions[partition]) {
                if (classifier_.still_needs_split(e, next.octave))
                    batch_.push_back({e, end_of(e), partition});
            }
        }
    }

    // Takes what the lanes have split. What they have left over waits for its turn again, behind
    // those that it may have to wait for, as long as that is little; else it is split one by one.
    void split_concurrently(const RefinementQueue::Entries& next) {
        concurrent_splits_.split(next);
        result_.splits += concurrent_splits_.split_count();
        result_.concurrent_splits += concurrent_splits_.split_count();
        concurrent_splits_.for_each_new(
            [this](std::size_t partition, EdgeId e, std::uint16_t octave) {
                push(e, octave, partition);
            });
        const bool again = concurrent_splits_.accepted_most();
        concurrent_splits_.for_each_deferred([&](std::size_t partition, EdgeId e, VertexId end) {
            if (again) {
                queue_.push(e, next.octave, partition);
            } else {
                batch_.push_back({e, end, partition});
            }
        });
    }

    void split_batch() {
        for (const PendingSplit& next : batch_) {
            if (result_.budget_hit) break;
            if (end_of(next.edge) != next.end) continue;  // its half now: that has been looked at
            if (next.partition != partition_) embed_inserted();
            partition_ = next.partition;
            split_with_propagation(next.edge);
        }
        batch_.clear();
        embed_inserted();
    }

    VertexId end_of(EdgeId e) const { return active_.mesh().target(active_.mesh().half_edge(e)); }

    // Looks at the edges on all threads, then queues them in their order. Of those along one cut
    // only the first is looked at, since that looks at all of them.
    void push_all_needed() {
        const TriMesh& mesh = active_.mesh();
        const std::span<const EdgeId> edges = active_.edges();
        const std::span<const std::uint8_t> smooth = active_.smooth_edges();
        const auto count = static_cast<std::uint32_t>(edges.size());
        const auto is_along_cut = [&](EdgeId e) { return mesh.sibling(e) != e; };
        const bool may_be_long = !(embedding_.longest_edge_bound() <= criteria_.limits().l_max);
        const auto need = [&](std::uint32_t i) {
            const EdgeId e = edges[i];
            if (!mesh.is_live(e)) return EdgeClassifier::kNone;
            if (smooth[i] != 0 && criteria_.satisfies_criteria_fast(mesh, e, may_be_long)) {
                return EdgeClassifier::kNone;
            }
            return is_along_cut(e) ? EdgeClassifier::kItself : classifier_.classify(e);
        };
        const std::span<std::uint8_t> needs = active_.scratch_of_edges();
        for_pieces(0, count, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) needs[i] = need(i);
        });
        FirstOfSiblings is_first(mesh);
        for_each_equal(needs, EdgeClassifier::kItself, [&](std::size_t i) {
            const EdgeId e = edges[i];
            if (!is_first(e)) return;
            const EdgeClassifier::Need found =
                is_along_cut(e) ? classifier_.classify(e) : EdgeClassifier::kItself;
            if (found == EdgeClassifier::kItself) push(e, classifier_.octave_of(e), 0);
            if (found == EdgeClassifier::kAnother) push_needed_adjacent(e);
        });
        if (!may_be_long) return;
        for_each_equal(needs, EdgeClassifier::kAnother,
                       [&](std::size_t i) { push_needed_adjacent(edges[i]); });
    }

    void push_needed_adjacent(EdgeId e) {
        classifier_.for_each_needed_adjacent(
            e, [this](EdgeId first, std::uint16_t octave) { push(first, octave, 0); });
    }

    // visit(index of each byte that has this value), in order.
    template <typename Visit>
    static void for_each_equal(std::span<const std::uint8_t> bytes, std::uint8_t value,
                               Visit visit) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const void* const next = std::memchr(bytes.data() + i, value, bytes.size() - i);
            if (!next) return;
            i = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - bytes.data());
            visit(i);
        }
    }

    void push(EdgeId e, std::uint16_t octave, std::size_t partition) {
        if (octave == EdgeClassifier::kBelowFloor) {
            result_.floor_hit = true;
        } else {
            queue_.push(e, octave, partition);
        }
    }

    // Splits what precedes e, then e. A split changes only what precedes the edge before it in the
    // chain, so the chain is followed on from there and not from e again.
    void split_with_propagation(EdgeId e) {
        chain_.assign(1, e);
        while (!chain_.empty()) {
            const bool leaves_sliver = propagation_.extend(chain_);
            if (leaves_sliver) {
                active_.mesh().for_each_side(e, [this](HalfEdgeId h) { block(h); });
                result_.floor_hit = true;
                return;
            }
            const EdgeId first = chain_.back();
            if (!active_.mesh().may_split(first) || !split(first)) return;
            chain_.pop_back();
        }
    }

    // Once an edge, also where it has two sides.
    void block(HalfEdgeId h) {
        const EdgeId e = active_.mesh().edge(h);
        if (active_.mesh().half_edge(e) == h) result_.blocked.push_back(e);
    }

    // Goes by where its ends are.
    bool may_split(EdgeId e) {
        if (has_end_not_embedded(e)) embed_inserted();
        return !criteria_.is_below_floor(active_.mesh(), e) && active_.mesh().may_split(e);
    }

    bool has_end_not_embedded(EdgeId e) const {
        const auto is_not_embedded = [this](VertexId v) {
            const auto entry = active_.entry_of(v);
            return entry && *entry < not_embedded_.size() && not_embedded_[*entry] != 0;
        };
        const HalfEdgeId h = active_.mesh().half_edge(e);
        return is_not_embedded(active_.mesh().origin(h)) ||
               is_not_embedded(active_.mesh().target(h));
    }

    bool split(EdgeId e) {
        const TriMesh& mesh = active_.mesh();
        std::uint32_t added = 0;
        mesh.for_each_side(e, [&](HalfEdgeId) { ++added; });
        if (mesh.face_count() + added > criteria_.limits().budget) {
            result_.budget_hit = true;
            return false;
        }
        if (has_end_not_embedded(e))
            embed_inserted();  // the midpoint inherits the mark of its ends
        active_.split(e, inserted_);
        propagation_.mesh_has_changed();
        const std::size_t entry = inserted_.back().vertex_entry;
        if (entry >= not_embedded_.size()) not_embedded_.resize(2 * (entry + 1));
        not_embedded_[entry] = 1;
        ++result_.splits;
        return true;
    }

    // Where the warp takes what has been inserted, then which edges round it wait now.
    void embed_inserted() {
        if (inserted_.empty()) return;
        embedding_.fit_to_entries();
        embedding_.embed_inserted(inserted_);
        for (const ActiveSet::Inserted& made : inserted_) {
            not_embedded_[made.vertex_entry] = 0;
            classifier_.classify_one_ring(
                made, [this](EdgeId e, std::uint16_t octave) { push(e, octave, partition_); });
        }
        inserted_.clear();
    }

    ActiveSet& active_;
    Embedding& embedding_;
    const Criteria& criteria_;
    EdgeClassifier classifier_;
    Propagation propagation_;
    ConcurrentSplits concurrent_splits_;
    RefinementQueue queue_;
    std::vector<EdgeId> chain_;  // from an edge to what precedes it, and on
    std::vector<PendingSplit> batch_;
    std::size_t partition_ = 0;                  // of what is split now
    std::vector<ActiveSet::Inserted> inserted_;  // since the last embed_inserted
    std::vector<std::uint8_t> not_embedded_;     // vertex entries: whether they are among these
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
