#include "adapt/refine.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "adapt/concurrent/splits.h"
#include "adapt/edge_classifier.h"
#include "adapt/propagation.h"
#include "adapt/refinement_queue.h"
#include "geometry/parallel.h"
#include "mesh/first_of_siblings.h"

namespace pectin {
namespace {

// A test of a face takes some microseconds.
constexpr std::uint32_t kFacesOfAPiece = 256;

class Refiner {
  public:
    Refiner(ActiveSet& active, Embedding& embedding, const Criteria& criteria)
        : active_(active),
          embedding_(embedding),
          criteria_(criteria),
          classifier_(active, criteria),
          propagation_(active, criteria.limits(), [this](EdgeId e) { return may_split(e); }),
          concurrent_splits_(active, embedding, classifier_, criteria.limits()),
          queue_(criteria.limits().partitioning, criteria.curvature_depends_on_faces()
                                                     ? RefinementQueue::kWholeClass
                                                     : RefinementQueue::kSerialBatch) {}

    Refinement refine(const StopToken& stop) {
        criteria_.update();
        if (criteria_.curvature_tests_faces()) queue_curved_faces();
        if (!criteria_.curvature_tests_faces() || criteria_.length().is_on()) queue_needed_edges();
        split_queued_edges(stop);
        return result();
    }

    Refinement refine_at(std::span<const EdgeId> edges, const StopToken& stop) {
        criteria_.update();
        for (EdgeId e : edges) {
            const bool is_below = criteria_.is_below_floor(active_.mesh(), e);
            result_.floor_hit |= is_below;
            if (!is_below) pending_.splits.push_back({e, end_of(e)});
        }
        split_one_by_one(pending_.splits, pending_.partition);
        split_queued_edges(stop);
        return result();
    }

  private:
    void split_queued_edges(const StopToken& stop) {
        while (!result_.budget_hit && !result_.was_stopped && !queue_.is_empty()) {
            const RefinementQueue::Batch batch = queue_.take();
            if (batch.is_serial) {
                test_again(batch);
                split_pending(stop);
            } else {
                split_concurrently(batch);
                ask_whether_to_stop(stop, !queue_.is_empty());
            }
        }
    }

    // more: edges are left to split. A batch of edges that may not be split changes nothing, and
    // the next call would begin with it again.
    void ask_whether_to_stop(const StopToken& stop, bool more) {
        result_.was_stopped =
            result_.splits > 0 && !result_.budget_hit && more && stop.stop_requested();
    }

    // All these edges have been tested before one of them is split, but a batch may be long.
    void split_pending(const StopToken& stop) {
        const std::span<const PendingSplit> all = pending_.splits;
        std::size_t done = 0;
        do {
            const std::size_t count = std::min(RefinementQueue::kSerialBatch, all.size() - done);
            split_one_by_one(all.subspan(done, count), pending_.partition);
            done += count;
            ask_whether_to_stop(stop, done < all.size() || !queue_.is_empty());
        } while (done < all.size() && !result_.budget_hit && !result_.was_stopped);
    }

    void test_again(const RefinementQueue::Batch& batch) {
        pending_.partition = batch.partition;
        pending_.splits.clear();
        for (EdgeId e : batch.serial_edges()) {
            if (classifier_.still_needs_split(e, batch.length_class))
                pending_.splits.push_back({e, end_of(e)});
        }
    }

    // Splits all edges before it embeds and tests what they have inserted, so that each phase finds
    // its surroundings in the cache.
    void split_one_by_one(std::span<const PendingSplit> splits, std::size_t partition) {
        partition_ = partition;
        for (const PendingSplit& next : splits) {
            if (result_.budget_hit) break;
            // Another chain may have split the edge since then. Its halves are tested when their
            // new end is embedded.
            if (end_of(next.edge) == next.end) split_with_propagation(next.edge);
        }
        embed_inserted();
    }

    void split_concurrently(const RefinementQueue::Batch& batch) {
        const ConcurrentSplits::Result done = concurrent_splits_.split(batch, queue_);
        propagation_.mesh_has_changed();
        result_.splits += done.splits;
        result_.concurrent_splits += done.splits;
        result_.floor_hit |= done.floor_hit;
        for (const PendingSplits& deferred : done.deferred) {
            split_one_by_one(deferred.splits, deferred.partition);
        }
    }

    VertexId end_of(EdgeId e) const { return active_.mesh().target(active_.mesh().half_edge(e)); }

    Refinement result() {
        result_.chain_steps = propagation_.steps();
        return result_;
    }

    // --- The scan: all active edges are tested on all threads, then queued in their order.

    void queue_needed_edges() {
        const bool may_be_long = !(embedding_.longest_edge_bound() <= criteria_.limits().l_max);
        const std::span<std::uint8_t> needs = active_.scratch_of_edges();
        for_pieces(0, static_cast<std::uint32_t>(needs.size()),
                   [&](std::uint32_t first, std::uint32_t end) {
                       test_edges(first, end, may_be_long, needs);
                   });
        queue_edges_found(needs);
        if (!may_be_long) return;
        for_each_equal(needs, SplitNeed::neighbour,
                       [&](std::size_t i) { push_needed_neighbours(active_.edges()[i]); });
    }

    // Where refinement condition (a) is one for faces, they are tested on all threads, and their
    // edges queued in the order of the faces.
    void queue_curved_faces() {
        const std::vector<FaceId> faces = criteria_.faces_to_test(active_);
        std::vector<std::uint8_t> needs(faces.size());
        for_pieces(
            0, static_cast<std::uint32_t>(faces.size()),
            [&](std::uint32_t first, std::uint32_t end) {
                for (std::uint32_t i = first; i < end; ++i) {
                    needs[i] = exists(criteria_.curvature_needed_split(
                                   active_, TriMesh::half_edge(faces[i], 0)))
                                   ? 1
                                   : 0;
                }
            },
            kFacesOfAPiece);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (needs[i] == 0) continue;
            classifier_.visit_curved(
                TriMesh::half_edge(faces[i], 0),
                [this](EdgeId e, std::uint16_t length_class) { push(e, length_class); });
        }
    }

    // Writes a SplitNeed for each edge. An edge along a cut is only marked here, as `itself`, and
    // tested by queue_edges_found(), once for all its siblings.
    void test_edges(std::uint32_t first, std::uint32_t end, bool may_be_long,
                    std::span<std::uint8_t> needs) const {
        const TriMesh& mesh = active_.mesh();
        const std::span<const EdgeId> edges = active_.edges();
        const std::span<const std::uint8_t> smooth = active_.smooth_edges();
        const auto need = [&](std::uint32_t i) {
            const EdgeId e = edges[i];
            if (!mesh.is_live(e)) return SplitNeed::none;
            if (smooth[i] != 0 && criteria_.satisfies_criteria_fast(mesh, e, may_be_long)) {
                return SplitNeed::none;
            }
            return is_along_cut(e) ? SplitNeed::itself : criteria_.need(active_, e);
        };
        for (std::uint32_t i = first; i < end; ++i) {
            needs[i] = static_cast<std::uint8_t>(need(i));
        }
    }

    void queue_edges_found(std::span<const std::uint8_t> needs) {
        FirstOfSiblings is_first(active_.mesh());
        for_each_equal(needs, SplitNeed::itself, [&](std::size_t i) {
            const EdgeId e = active_.edges()[i];
            if (!is_first(e)) return;
            const SplitNeed need = is_along_cut(e) ? criteria_.need(active_, e) : SplitNeed::itself;
            if (need == SplitNeed::itself) push(e, classifier_.length_class_of(e));
            if (need == SplitNeed::neighbour) push_needed_neighbours(e);
        });
    }

    bool is_along_cut(EdgeId e) const { return active_.mesh().sibling(e) != e; }

    void push_needed_neighbours(EdgeId e) {
        classifier_.for_each_needed_neighbour(
            e, [this](EdgeId first, std::uint16_t length_class) { push(first, length_class); });
    }

    void push(EdgeId e, std::uint16_t length_class) {
        if (length_class == EdgeClassifier::kBelowFloor) {
            result_.floor_hit = true;
        } else {
            queue_.push(e, length_class, partition_);
        }
    }

    // Calls visit(i) for each needs[i] that has this value, in order.
    template <typename Visit>
    static void for_each_equal(std::span<const std::uint8_t> needs, SplitNeed need, Visit visit) {
        for (std::size_t i = 0; i < needs.size(); ++i) {
            const void* const next =
                std::memchr(needs.data() + i, static_cast<int>(need), needs.size() - i);
            if (!next) return;
            i = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - needs.data());
            visit(i);
        }
    }

    // --- One edge.

    // Splits e after all that precedes it. A split only changes what precedes the edge before it in
    // the chain, so the chain is extended from that edge and not from e again.
    void split_with_propagation(EdgeId e) {
        chain_.assign(1, e);
        while (!chain_.empty()) {
            const bool leaves_sliver = propagation_.extend(chain_);
            if (leaves_sliver) {
                report_blocked(e);
                return;
            }
            const EdgeId first = chain_.back();
            if (!active_.mesh().may_split(first) || !split(first)) return;
            chain_.pop_back();
        }
    }

    void report_blocked(EdgeId e) {
        const TriMesh& mesh = active_.mesh();
        mesh.for_each_side(e, [&](HalfEdgeId h) {
            // All siblings along a cut, but an edge with two sides once.
            if (mesh.half_edge(mesh.edge(h)) == h) result_.blocked.push_back(mesh.edge(h));
        });
        result_.floor_hit = true;
    }

    // The floor is compared with the deformed length, so both ends have to be embedded.
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

    //          a                  a
    //         / \                /|\        m is inserted at the midpoint of bc, with level
    //        /   \              / | \       max(a, b, c, d) + 1. On a boundary there is no d. Along
    //       b-----c    --->    b--m--c      a cut there is an a for each sheet.
    //        \   /              \ | /
    //         \ /                \|/
    //          d                  d
    bool split(EdgeId e) {
        const TriMesh& mesh = active_.mesh();
        std::uint32_t added = 0;
        mesh.for_each_side(e, [&](HalfEdgeId) { ++added; });
        if (mesh.face_count() + added > criteria_.limits().budget) {
            result_.budget_hit = true;
            return false;
        }
        // Whether m is deformed follows from its ends.
        if (has_end_not_embedded(e)) embed_inserted();
        active_.split(e, inserted_);
        propagation_.mesh_has_changed();
        const std::size_t entry = inserted_.back().vertex_entry;
        if (entry >= not_embedded_.size()) not_embedded_.resize(2 * (entry + 1));
        not_embedded_[entry] = 1;
        ++result_.splits;
        return true;
    }

    // Moves the inserted vertices to where the warp takes them, then tests the edges around them.
    void embed_inserted() {
        if (inserted_.empty()) return;
        embedding_.fit_to_entries();
        embedding_.embed_inserted(inserted_);
        for (const ActiveSet::Inserted& made : inserted_) {
            not_embedded_[made.vertex_entry] = 0;
            classifier_.classify_one_ring(
                made, [this](EdgeId e, std::uint16_t length_class) { push(e, length_class); });
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
    PendingSplits pending_;
    std::size_t partition_ = 0;  // the part of the queue that edges made now join
    std::vector<EdgeId> chain_;  // from an edge to what precedes it, and on from there
    std::vector<ActiveSet::Inserted> inserted_;  // not embedded yet
    std::vector<std::uint8_t> not_embedded_;     // vertex entries: 1 for those in inserted_
    Refinement result_;
};

}  // namespace

Refinement refine(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                  const StopToken& stop) {
    return Refiner(active, embedding, criteria).refine(stop);
}

Refinement refine_at(ActiveSet& active, Embedding& embedding, const Criteria& criteria,
                     std::span<const EdgeId> edges, const StopToken& stop) {
    return Refiner(active, embedding, criteria).refine_at(edges, stop);
}

}  // namespace pectin
