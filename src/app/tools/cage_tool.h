// Selecting and dragging of a cage's control points, while they are shown.
#pragma once

#include <string>

#include "app/tools/cage_points.h"
#include "app/tools/drag_tool.h"

namespace pectin {

class CageTool final : public DragTool {
  public:
    bool hover(const ToolContext& context, bool is_free) override;
    bool key(ToolContext& context, const event::KeyDown& key) override;
    void character(ToolContext& context, unsigned int code) override;
    bool escape(ToolContext& context) override;
    bool is_active() const override { return points_.is_active(); }
    bool is_dragging() const override { return points_.is_dragging(); }

    void overlay(const ToolContext& context, Overlay& overlay) const override;
    std::optional<ScreenBox> selection_box() const override { return points_.box(); }
    std::string_view status_hint(const ToolContext& context) const override;
    ShownSettings settings() const override { return {.mirror = true, .cage = true}; }
    InputGroup inputs() const override;

    const CagePoints& points() const { return points_; }

  private:
    bool begin(ToolContext& context) override;
    void follow(const ToolContext& context) override { points_.move_to(context.pointer().at); }
    void update(ToolContext& context) override;
    void click(ToolContext& context) override {
        points_.release(context.session(), context.view());
    }
    void forget() noexcept override {
        points_.end();
        constraint_hint_.clear();
    }

    void update_constraint_hint();

    CagePoints points_;
    std::string constraint_hint_;  // empty without a constraint
};

}  // namespace pectin
