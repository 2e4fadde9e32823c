#include "app/detail_preview.h"

#include <algorithm>

namespace pectin {
namespace {

constexpr Colour kEdge{255, 190, 60, 235};
constexpr float kWidth = 1.8f;

}  // namespace

void DetailPreview::set(const std::optional<command::Adapt>& change) {
    if (change == change_) return;
    change_ = change;
    remaining_ = blocks_.size();
    is_new_ = true;
    if (change) return;
    blocks_.clear();
    next_ = remaining_ = count_ = 0;
}

void DetailPreview::advance(const Session& session, std::chrono::steady_clock::duration time) {
    if (!is_active()) return;
    is_new_ = false;
    const std::size_t blocks = (session.mesh().edge_slots() + kBlock - 1) / kBlock;
    if (blocks != blocks_.size()) {  // the preview begins, or the object is another one
        blocks_.assign(blocks, {});
        remaining_ = blocks;
        next_ = count_ = 0;
    }
    const auto end = std::chrono::steady_clock::now() + time;
    while (remaining_ > 0) {
        examine(session, next_);
        next_ = (next_ + 1) % blocks_.size();
        --remaining_;
        if (std::chrono::steady_clock::now() >= end) return;
    }
}

void DetailPreview::examine(const Session& session, std::size_t index) {
    const TriMesh& mesh = session.mesh();
    const std::vector<EdgeId> found =
        session.edges_to_refine(*change_, static_cast<std::uint32_t>(index) * kBlock, kBlock);
    Block& block = blocks_[index];
    count_ += found.size() - block.count;
    block.count = found.size();
    block.shown.clear();
    // Each block shows its share, evenly chosen.
    const std::size_t most = std::max<std::size_t>(kMostShown / blocks_.size(), 1);
    const std::size_t step = std::max<std::size_t>((found.size() + most - 1) / most, 1);
    for (std::size_t i = 0; i < found.size(); i += step) {
        const HalfEdgeId h = mesh.half_edge(found[i]);
        block.shown.emplace_back(mesh.position(mesh.origin(h)), mesh.position(mesh.target(h)));
    }
}

void DetailPreview::add_to(Overlay& overlay) const {
    for (const Block& block : blocks_) {
        for (const auto& [from, to] : block.shown) {
            overlay.lines.push_back({from, to, kEdge, kWidth});
        }
    }
}

}  // namespace pectin
