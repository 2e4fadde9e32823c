// Dragging of the surface: the grabbed point follows the cursor, and its surroundings follow it.
#pragma once

#include <string>
#include <vector>

#include "app/tools/drag_tool.h"
#include "app/tools/sculptor.h"

namespace pectin {

// A press on the surface grabs the point under the cursor, or the pin whose marker is there. The
// point moves parallel to the picture, with N or Alt along the normal. The wheel twists the
// surroundings of the point, with Shift it scales them. X, Y and Z keep the point to an axis, with
// Shift to the plane across it, and digits set the distance.
class SculptTool final : public DragTool {
  public:
    bool key(ToolContext& context, const event::KeyDown& key) override;
    void character(ToolContext& context, unsigned int code) override;
    bool scroll(ToolContext& context, double notches) override;
    bool is_active() const override { return sculptor_.is_dragging(); }
    bool is_dragging() const override { return sculptor_.is_dragging(); }

    // Shows the brush and, if that is switched on, the lattice of the drag, or between drags that
    // of the next one.
    void overlay(const ToolContext& context, Overlay& overlay) const override;
    std::string_view status_hint(const ToolContext& context) const override;
    ShownSettings settings() const override;
    InputGroup inputs() const override;

    const Sculptor& sculptor() const { return sculptor_; }

  private:
    bool begin(ToolContext& context) override;
    void follow(const ToolContext& context) override;
    void update(ToolContext& context) override;
    void forget() noexcept override {
        sculptor_.end();
        constraint_hint_.clear();
    }
    void before_end(const ToolContext& context) override;
    void after_end(ToolContext& context) override { context.last_drag = ended_; }
    void find_positions(const ToolContext& context);
    void update_constraint_hint();

    Sculptor sculptor_;
    std::vector<Vec2> cursor_path_;  // where the cursor was at the last update, and since then
    std::vector<Vec2> positions_;    // that the drag visits in this update
    std::string constraint_hint_;    // empty without a constraint
    std::optional<LastDrag> ended_;  // the drag that is being ended
};

}  // namespace pectin
