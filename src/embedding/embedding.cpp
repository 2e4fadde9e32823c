#include "embedding/embedding.h"

#include <algorithm>
#include <limits>

#include "embedding/deform_pass.h"
#include "embedding/lattice_pass.h"
#include "geometry/parallel.h"

namespace pectin {
namespace {

// What rounding at the two ends may add to the length of an edge: rounding of weights to float, and
// of coordinates to double. Fractions of the reach of the drag and of the largest coordinate.
constexpr double kWeightRounding = 2.0 * std::numeric_limits<float>::epsilon();
constexpr double kCoordinateRounding = 8.0 * std::numeric_limits<double>::epsilon();

// Calls visit(wedge entry) for each wedge entry of the sheets.
template <typename Visit>
void for_each_wedge(std::span<const ActiveSet::Inserted> sheets, Visit visit) {
    for (const ActiveSet::Inserted& sheet : sheets) {
        for (std::uint32_t w : sheet.wedge_entries) {
            if (w != ActiveSet::kNoEntry) visit(w);
        }
    }
}

}  // namespace

void Embedding::embed(const StopToken& stop) {
    step_starts_.assign(warp_.steps.size(), {});
    normals_.clear();
    has_folded_.clear();
    for (std::size_t step = 0; step < step_starts_.size(); ++step) {
        step_starts_[step].zones = zones_of(warp_.steps[step]);
    }
    evaluator_.reset();
    weights_.clear();
    if (step_starts_.empty()) return;
    weight_count_ = weight_count(warp_.steps.back());
    if (const LatticeField* field = streamed_lattice(warp_.steps.back())) {
        evaluator_.emplace(*field);
    }
    if (weight_count_ == 1) runs_ = lasting_runs(active_);
    fit_to_entries();
    if (step_starts_.size() > 1) normals_.assign(active_.rest_normals());
    for (std::size_t step = 0; step + 1 < step_starts_.size(); ++step) {
        stop.throw_if_requested();
        dispatch(warp_.steps[step],
                 [&](const auto& deformation) { embed_before_last(deformation, step); });
    }
    if (weight_count_ == 0) return;
    dispatch(warp_.steps.back(), [&](const auto& deformation) {
        const auto vertices = static_cast<std::uint32_t>(active_.vertex_entries());
        for_pieces(0, vertices, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) {
                if (i < active_.influenced_at_begin()) {
                    weights_at(deformation, start_position(last(), i), weights_of(i));
                } else {
                    std::ranges::fill(weights_of(i), DragWeight{});
                }
            }
        });
    });
}

void Embedding::fit_to_entries() {
    if (step_starts_.empty()) return;
    const std::size_t count = active_.vertex_entries() * weight_count_;
    if (weights_.size() < count) weights_.grow(count - weights_.size());
    if (step_starts_.size() < 2) return;
    for (std::size_t step = 1; step < step_starts_.size(); ++step) {
        step_starts_[step].positions.resize(active_.vertex_entries());
    }
    normals_.resize(active_.wedge_entries());
    has_folded_.resize(active_.vertex_entries());
}

void Embedding::reserve_splits(std::uint32_t count) {
    if (step_starts_.empty()) return;
    const auto reserve = [](auto& values, std::size_t size) {
        if (size > values.size()) values.reserve_additional(size - values.size());
    };
    const std::size_t vertices = active_.vertex_entries() + std::size_t{count};
    reserve(weights_, vertices * weight_count_);
    if (step_starts_.size() < 2) return;
    for (std::size_t step = 1; step < step_starts_.size(); ++step) {
        reserve(step_starts_[step].positions, vertices);
    }
    reserve(normals_, active_.wedge_entries() + std::size_t{count});
    reserve(has_folded_, vertices);
}

const Vec3& Embedding::start_position(std::size_t step, std::uint32_t entry) const {
    return step == 0 ? active_.rest_position_at(entry) : step_starts_[step].positions[entry];
}

std::span<const Vec3> Embedding::start_positions() const {
    return step_starts_.size() < 2 ? active_.rest_positions() : step_starts_.back().positions;
}

std::span<const Vec3f> Embedding::start_normals() const {
    return step_starts_.size() < 2 ? active_.rest_normals() : normals_;
}

std::span<DragWeight> Embedding::weights_of(std::uint32_t entry) {
    return std::span(weights_).subspan(entry * weight_count_, weight_count_);
}

std::span<const DragWeight> Embedding::weights(std::uint32_t entry) const {
    return std::span(weights_).subspan(entry * weight_count_, weight_count_);
}

// --- A step before the last

template <typename D>
void Embedding::embed_before_last(const D& deformation, std::size_t step) {
    const std::size_t count = weight_count(deformation);
    std::vector<DragWeight> all(count * active_.vertex_entries());
    const auto of_entry = [&](std::uint32_t i) { return std::span(all).subspan(i * count, count); };
    const auto vertices = static_cast<std::uint32_t>(active_.vertex_entries());
    for_pieces(0, vertices, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
            if (i < active_.influenced_at_begin()) {
                weights_at(deformation, start_position(step, i), of_entry(i));
            }
            advance(deformation, step, i, of_entry(i));
        }
    });
    const std::uint32_t wedges = active_.influenced_wedges_at_begin();
    for_pieces(0, wedges, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t w = first; w < end; ++w) {
            transform_normal(deformation, step, w, of_entry(active_.wedge_owner(w)));
        }
    });
}

template <typename D>
void Embedding::advance(const D& deformation, std::size_t step, std::uint32_t entry,
                        std::span<const DragWeight> w) {
    const Vec3& from = start_position(step, entry);
    Vec3& to = step_starts_[step + 1].positions[entry];
    bool folds = false;
    if (!active_.is_influenced_at(entry)) {
        to = from;
    } else {
        to = pectin::image(deformation, from, w);
        folds = jacobian_determinant(deformation, from, w) <= 0.0;
    }
    // The first step overwrites the value, since an entry may be reused.
    has_folded_[entry] = folds || (step > 0 && has_folded_[entry] != 0) ? 1 : 0;
}

template <typename D>
void Embedding::transform_normal(const D& deformation, std::size_t step, std::uint32_t wedge,
                                 std::span<const DragWeight> w) {
    const Vec3& from = start_position(step, active_.wedge_owner(wedge));
    normals_[wedge] = covariant_normal(deformation, from, w, normals_[wedge]);
}

Vec3 Embedding::position_before(std::size_t step, VertexId v) const {
    const auto entry = active_.entry_of(v);
    const bool is_moved = entry && step < step_count();
    return is_moved ? start_position(step, *entry) : active_.mesh().position(v);
}

// --- The last step

void Embedding::deform() {
    if (step_starts_.empty()) return;
    const Deformation& last_step = warp_.steps.back();
    if (evaluator_) {
        evaluator_->update(*streamed_lattice(last_step));
        pectin::deform(active_, *evaluator_, start_positions(), start_normals());
        return;
    }
    if (weight_count_ == 1) {
        pectin::deform(active_, start_positions(), start_normals(), weights_, runs_,
                       displacements_of(last_step).front());
        return;
    }
    dispatch(last_step, [&](const auto& d) {
        for_pieces(0, active_.vertex_entries(),
                   [&](std::uint32_t first, std::uint32_t end) { deform_vertices(d, first, end); });
        for_pieces(0, active_.wedge_entries(),
                   [&](std::uint32_t first, std::uint32_t end) { deform_wedges(d, first, end); });
    });
}

template <typename D>
void Embedding::deform_vertices(const D& deformation, std::uint32_t first, std::uint32_t end) {
    if (evaluator_) {
        pectin::deform_vertices(active_, *evaluator_, start_positions(), first, end);
        return;
    }
    TriMesh& mesh = active_.mesh();
    for (std::uint32_t i = first; i < end; ++i) {
        const VertexId v = active_.vertex(i);
        if (!exists(v) || !active_.is_influenced_at(i)) continue;
        const Vec3 position = pectin::image(deformation, start_positions()[i], weights(i));
        mesh.set_position(v, position);
        mesh.set_deformed(v, active_.was_deformed_at(i) || position != active_.rest_position_at(i));
    }
}

template <typename D>
void Embedding::deform_wedges(const D& deformation, std::uint32_t first, std::uint32_t end) {
    if (evaluator_) {
        pectin::deform_wedges(active_, *evaluator_, start_positions(), start_normals(), first, end);
        return;
    }
    TriMesh& mesh = active_.mesh();
    for (std::uint32_t i = first; i < end; ++i) {
        const WedgeId w = active_.wedge(i);
        const std::uint32_t owner = active_.wedge_owner(i);
        if (!exists(w) || !active_.is_influenced_at(owner)) continue;
        mesh.set_normal(w, covariant_normal(deformation, start_positions()[owner], weights(owner),
                                            start_normals()[i]));
    }
}

// The largest number of weights per vertex in a step before the last.
std::size_t Embedding::scratch_size() const {
    std::size_t size = 0;
    for (std::size_t step = 0; step + 1 < step_starts_.size(); ++step) {
        size = std::max(size, weight_count(warp_.steps[step]));
    }
    return size;
}

void Embedding::embed_inserted(std::span<const ActiveSet::Inserted> inserted,
                               std::span<DragWeight> scratch) {
    if (step_starts_.empty()) return;
    dispatch(warp_.steps.back(), [&](const auto& deformation) {
        for (std::size_t i = 0, next = 0; i < inserted.size(); i = next) {
            next = i + 1;
            while (next < inserted.size() && !inserted[next].is_first_sheet) ++next;
            embed_vertex(deformation, inserted.subspan(i, next - i), scratch);
        }
    });
}

template <typename D>
void Embedding::embed_vertex(const D& deformation, std::span<const ActiveSet::Inserted> sheets,
                             std::span<DragWeight> scratch) {
    const std::uint32_t entry = sheets.front().vertex_entry;
    const bool is_influenced = active_.is_influenced_at(entry);
    if (is_influenced && step_starts_.size() == 1 && weight_count_ == 1) {
        return embed_by_one_weight(deformation, sheets);
    }
    if (step_starts_.size() > 1) bring_to_last_step(sheets, scratch);
    if (!is_influenced) {
        std::ranges::fill(weights_of(entry), DragWeight{});
        return;
    }
    weights_at(deformation, start_position(last(), entry), weights_of(entry));
    deform_vertices(deformation, entry, entry + 1);
    for_each_wedge(sheets, [&](std::uint32_t w) { deform_wedges(deformation, w, w + 1); });
}

// The usual case, a last step with one weight per vertex, with everything in one function.
template <typename D>
void Embedding::embed_by_one_weight(const D& deformation,
                                    std::span<const ActiveSet::Inserted> sheets) {
    const std::uint32_t entry = sheets.front().vertex_entry;
    const Vec3& rest = active_.rest_position_at(entry);
    const Vec3& d = displacements_of(deformation).front();
    DragWeight& weight = weights_[entry];
    weights_at(deformation, rest, {&weight, 1});
    TriMesh& mesh = active_.mesh();
    const VertexId v = active_.vertex(entry);
    const Vec3 position = displaced(rest, weight, d);
    mesh.set_position(v, position);
    mesh.set_deformed(v, active_.was_deformed_at(entry) || position != rest);
    for_each_wedge(sheets, [&](std::uint32_t w) {
        mesh.set_normal(active_.wedge(w), covariant_normal(active_.rest_normal_at(w), weight, d));
    });
}

void Embedding::bring_to_last_step(std::span<const ActiveSet::Inserted> sheets,
                                   std::span<DragWeight> scratch) {
    const std::uint32_t entry = sheets.front().vertex_entry;
    for_each_wedge(sheets, [&](std::uint32_t w) { normals_[w] = active_.rest_normal_at(w); });
    const bool is_influenced = active_.is_influenced_at(entry);
    for (std::size_t step = 0; step + 1 < step_starts_.size(); ++step) {
        dispatch(warp_.steps[step], [&](const auto& deformation) {
            const std::span<DragWeight> weights = scratch.first(weight_count(deformation));
            if (is_influenced) {
                weights_at(deformation, start_position(step, entry), weights);
                for_each_wedge(sheets, [&](std::uint32_t w) {
                    transform_normal(deformation, step, w, weights);
                });
            }
            advance(deformation, step, entry, weights);
        });
    }
}

Vec3 Embedding::image(const Vec3& rest) const {
    Vec3 at = rest;
    for (const Deformation& step : warp_.steps) at = pectin::image(step, at);
    return at;
}

std::uint64_t Embedding::folded_vertices() const {
    if (step_starts_.empty()) return 0;
    return dispatch(warp_.steps.back(), [&](const auto& deformation) {
        std::uint64_t folded = 0;
        for (std::uint32_t i = 0; i < active_.vertex_entries(); ++i) {
            if (!exists(active_.vertex(i)) || !active_.is_influenced_at(i)) continue;
            const bool folds_last =
                jacobian_determinant(deformation, start_position(last(), i), weights(i)) <= 0.0;
            if (folds_last || (step_starts_.size() > 1 && has_folded_[i] != 0)) ++folded;
        }
        return folded;
    });
}

double Embedding::longest_edge_bound() const {
    if (step_starts_.empty()) return active_.longest_rest_length();
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    if (step_starts_.size() > 1) return kUnknown;
    const double reach = reach_bound(warp_.steps.back());
    const double stretch = lipschitz_bound(warp_.steps.back());
    if (reach == kUnknown || stretch == kUnknown) return kUnknown;
    const Box& zone = active_.zone();
    const Vec3 farthest = glm::max(glm::abs(zone.min), glm::abs(zone.max));
    return active_.longest_rest_length() * stretch + kWeightRounding * reach +
           kCoordinateRounding * std::max({farthest.x, farthest.y, farthest.z, reach});
}

std::size_t Embedding::memory_bytes() const {
    std::size_t bytes = normals_.capacity() * sizeof(Vec3f) +
                        weights_.capacity() * sizeof(DragWeight) + has_folded_.capacity() +
                        runs_.capacity() + (evaluator_ ? evaluator_->memory_bytes() : 0);
    for (const StepStart& start : step_starts_) bytes += start.positions.capacity() * sizeof(Vec3);
    return bytes;
}

}  // namespace pectin
