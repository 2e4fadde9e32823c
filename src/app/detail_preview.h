// The edges that a change of the detail would split, found in the time between frames and shown on
// the surface.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "command/command.h"
#include "render/overlay.h"
#include "session/session.h"

namespace pectin {

// The edges are examined in blocks, one after the other and all around. When the change becomes
// another one, each block shows what it showed before until it has been examined again.
class DetailPreview {
  public:
    // How long advance() may take by default.
    static constexpr std::chrono::milliseconds kTime{6};
    // At most so many edges are shown; more are only counted.
    static constexpr std::size_t kMostShown = 40'000;

    // Shows the edges that this change of the settings would split, or none.
    void set(const std::optional<command::Adapt>& change);
    bool is_active() const { return change_.has_value(); }

    // Examines edges until the time is over or all have been examined, but at least one block.
    // Precondition: no gesture and no work in the background.
    void advance(const Session& session, std::chrono::steady_clock::duration time = kTime);
    bool has_more() const { return is_active() && (is_new_ || remaining_ > 0); }

    // How many edges have been found so far.
    std::size_t count() const { return count_; }
    void add_to(Overlay& overlay) const;

  private:
    static constexpr std::uint32_t kBlock = 1 << 14;  // edges
    struct Block {
        std::vector<std::pair<Vec3, Vec3>> shown{};  // ends of edges
        std::size_t count = 0;
    };
    void examine(const Session& session, std::size_t index);

    std::optional<command::Adapt> change_;
    std::vector<Block> blocks_;
    std::size_t next_ = 0, remaining_ = 0;  // blocks
    std::size_t count_ = 0;
    bool is_new_ = false;  // the change has not been looked at yet
};

}  // namespace pectin
