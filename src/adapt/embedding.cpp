#include "adapt/embedding.h"

#include <algorithm>

namespace pectin {

void Embedding::embed() {
    stages_.assign(warp_.steps.size(), {});
    resize();
    for (std::size_t step = 0; step < stages_.size(); ++step) {
        const Warp::Step& s = warp_.steps[step];
        for (std::uint32_t i = 0; i < active_.influenced_at_begin(); ++i) embed_entry(step, i);
        if (step + 1 == stages_.size()) break;
        // Where this step leaves them is where the next finds them.
        for (std::uint32_t i = 0; i < active_.influenced_at_begin(); ++i) {
            stages_[step + 1].positions[i] =
                displaced(start_position(step, i), weights(step, i), s.displacements);
        }
        for (std::uint32_t i = 0; i < active_.influenced_wedges_at_begin(); ++i) {
            stages_[step + 1].normals[i] = covariant_normal(
                start_normal(step, i), weights(step, active_.wedge_owner(i)), s.displacements);
        }
    }
}

void Embedding::resize() {
    for (std::size_t step = 0; step < stages_.size(); ++step) {
        Stage& stage = stages_[step];
        const std::size_t moves = warp_.steps[step].field.move_count();
        stage.weights.resize(active_.vertex_entries() * moves);
        if (step == 0) continue;
        stage.positions.resize(active_.vertex_entries());
        stage.normals.resize(active_.wedge_entries());
    }
}

const Vec3& Embedding::start_position(std::size_t step, std::uint32_t entry) const {
    return step == 0 ? active_.rest_position_at(entry) : stages_[step].positions[entry];
}

const Vec3f& Embedding::start_normal(std::size_t step, std::uint32_t entry) const {
    return step == 0 ? active_.rest_normal_at(entry) : stages_[step].normals[entry];
}

std::span<const DragWeight> Embedding::weights(std::size_t step, std::uint32_t entry) const {
    const std::size_t moves = warp_.steps[step].field.move_count();
    return std::span(stages_[step].weights).subspan(entry * moves, moves);
}

void Embedding::embed_entry(std::size_t step, std::uint32_t entry) {
    const DragField& field = warp_.steps[step].field;
    const std::size_t moves = field.move_count();
    field.weights(start_position(step, entry),
                  std::span(stages_[step].weights).subspan(entry * moves, moves));
}

void Embedding::deform() {
    if (stages_.empty()) return;
    const std::size_t last = stages_.size() - 1;
    deform_vertices(last, 0, active_.influenced_at_begin());
    deform_wedges(last, 0, active_.influenced_wedges_at_begin());
    // Those that earlier frames have inserted.
    resize();
    deform_vertices(last, active_.influenced_at_begin(), active_.vertex_entries());
    deform_wedges(last, active_.influenced_wedges_at_begin(), active_.wedge_entries());
}

void Embedding::deform_vertices(std::size_t step, std::uint32_t first, std::uint32_t last) {
    TriMesh& mesh = active_.mesh();
    const std::span<const Vec3> d(warp_.steps[step].displacements);
    for (std::uint32_t i = first; i < last; ++i) {
        const VertexId v = active_.vertex(i);
        if (!exists(v) || !active_.is_influenced_at(i)) continue;
        const Vec3 position = displaced(start_position(step, i), weights(step, i), d);
        mesh.set_position(v, position);
        mesh.set_deformed(v, active_.was_deformed_at(i) || position != active_.rest_position_at(i));
    }
}

void Embedding::deform_wedges(std::size_t step, std::uint32_t first, std::uint32_t last) {
    TriMesh& mesh = active_.mesh();
    const std::span<const Vec3> d(warp_.steps[step].displacements);
    for (std::uint32_t i = first; i < last; ++i) {
        const WedgeId w = active_.wedge(i);
        if (!exists(w) || !active_.is_influenced_at(active_.wedge_owner(i))) continue;
        mesh.set_normal(
            w, covariant_normal(start_normal(step, i), weights(step, active_.wedge_owner(i)), d));
    }
}

void Embedding::place(const ActiveSet::Inserted& inserted) {
    const std::uint32_t entry = inserted.vertex_entry;
    if (stages_.empty() || !active_.is_influenced_at(entry)) return;
    resize();
    for (std::size_t step = 0; step < stages_.size(); ++step) {
        embed_entry(step, entry);
        if (step + 1 == stages_.size()) break;
        const std::span<const Vec3> d(warp_.steps[step].displacements);
        Stage& next = stages_[step + 1];
        next.positions[entry] = displaced(start_position(step, entry), weights(step, entry), d);
        for (std::uint32_t w : inserted.wedge_entries) {
            next.normals[w] = covariant_normal(start_normal(step, w), weights(step, entry), d);
        }
    }
    const std::size_t last = stages_.size() - 1;
    deform_vertices(last, entry, entry + 1);
    for (std::uint32_t w : inserted.wedge_entries) deform_wedges(last, w, w + 1);
}

std::uint64_t Embedding::folded_vertices() const {
    std::uint64_t folded = 0;
    for (std::uint32_t i = 0; i < active_.vertex_entries(); ++i) {
        if (!exists(active_.vertex(i)) || !active_.is_influenced_at(i)) continue;
        for (std::size_t step = 0; step < stages_.size(); ++step) {
            if (jacobian_determinant(weights(step, i), warp_.steps[step].displacements) <= 0.0) {
                ++folded;
                break;
            }
        }
    }
    return folded;
}

std::size_t Embedding::memory_bytes() const {
    std::size_t bytes = 0;
    for (const Stage& stage : stages_) {
        bytes += stage.positions.capacity() * sizeof(Vec3) +
                 stage.normals.capacity() * sizeof(Vec3f) +
                 stage.weights.capacity() * sizeof(DragWeight);
    }
    return bytes;
}

}  // namespace pectin
