#include "app/tools/cage_tool.h"

#include <array>
#include <chrono>

#include "app/words.h"

namespace pectin {
namespace {

constexpr std::array<InputReference, 6> kInputs{{
    {"Drag a control point", "Moves it and all that are selected, parallel to the window."},
    {"Click a control point", "Selects it."},
    {"Shift+click a control point", "Adds it to the selection, or removes it."},
    {"Ctrl+drag a box", "Selects all control points in it, also behind the object."},
    {"Ctrl+Shift+drag a box", "Adds them to the selection."},
    {"Esc", "Takes the drag or box back, or else clears the selection."},
}};

}  // namespace

bool CageTool::hover(const ToolContext& context, bool is_free) {
    const std::optional<Lattice> cage = context.editable_cage();
    points_.reset_for(cage);
    std::optional<IVec3> found;
    if (is_free && cage) {
        found = points_.find_at(context.session(), context.view(), context.pointer().at,
                                context.hover());
    }
    points_.set_hovered(found);
    return found.has_value();
}

bool CageTool::begin(ToolContext& context) {
    if (!context.editable_cage()) return false;
    const Pointer& pointer = context.pointer();
    const std::optional<Pick> surface = context.pick_at_cursor();
    if (!points_.press(context.session(), context.view(), pointer.at, pointer.modifiers, surface)) {
        return false;
    }
    context.workspace().clear_command_message();
    return true;
}

void CageTool::update(ToolContext& context) {
    const auto start = std::chrono::steady_clock::now();
    const bool had_begun = points_.is_dragging();
    Workspace& workspace = context.workspace();
    workspace.limit_frame_time(true);  // a drag of a point may have ended in between
    const Done done = points_.update_drag(workspace.session(), context.view());
    update_constraint_hint();
    if (!done) return workspace.set_message(words_of(done.refusal()));
    if (!points_.is_dragging()) return;
    if (!had_begun) context.drag_figures().reset_drag();
    context.touch(points_.grabbed_position(workspace.session()));
    workspace.clear_command_message();
    context.drag_figures().record(workspace.session().last_frame(),
                                  std::chrono::steady_clock::now() - start);
}

bool CageTool::key(ToolContext& context, const event::KeyDown& key) {
    if (!is_active()) return false;
    if (!is_constraint_key(key) || !points_.press_key(key.key, key.modifiers.shift)) {
        return DragTool::key(context, key);
    }
    request_update();
    return true;
}

void CageTool::character(ToolContext&, unsigned int code) {
    if (points_.type(code)) request_update();
}

void CageTool::update_constraint_hint() {
    constraint_hint_.clear();
    if (!points_.is_dragging() || !points_.constraint().is_active()) return;
    constraint_hint_ = hint_of(points_.constraint(), points_.displacement());
}

bool CageTool::escape(ToolContext&) {
    if (points_.selected().empty()) return false;
    points_.clear_selection();
    return true;
}

void CageTool::overlay(const ToolContext& context, Overlay& overlay) const {
    // A drag of the surface shows the cage as it deforms it.
    const bool is_other_dragging = context.is_dragging() && !is_dragging();
    const std::optional<Lattice> cage = context.editable_cage();
    if (!cage || is_other_dragging) return;
    std::vector<Vec3> displacements;
    if (is_dragging()) displacements = points_.displacements(context.session());
    add_lattice(overlay, *cage, displacements);
    const auto position = [&](const IVec3& index) {
        const Vec3 rest = cage->rest(index);
        return displacements.empty() ? rest : rest + displacements[cage->control_index(index)];
    };
    for (const IVec3& index : points_.selected()) {
        add_control_point(overlay, position(index), true, false);
    }
    if (points_.hovered() && !is_dragging()) {
        add_control_point(overlay, position(*points_.hovered()), false, true);
    }
}

std::string_view CageTool::status_hint(const ToolContext& context) const {
    if (points_.box()) return "Release the button to select the control points in the box.";
    if (is_active() && !constraint_hint_.empty()) return constraint_hint_;
    if (is_active()) {
        return "The selected control points follow the cursor, X, Y or Z keeps an axis, digits set "
               "the distance.";
    }
    if (!context.editable_cage()) return {};
    const Modifiers& modifiers = context.pointer().modifiers;
    if (modifiers.control) return "Drag a box around control points to select them.";
    if (!points_.hovered()) return {};
    if (modifiers.shift) return "Click to add the control point to the selection or to remove it.";
    return "Drag the control point; all that are selected follow. · Shift+click: select more · "
           "Ctrl+drag: "
           "select in a box";
}

InputGroup CageTool::inputs() const { return {"Cage, while it is shown", kInputs, 4}; }

std::unique_ptr<Tool> make_cage_tool() { return std::make_unique<CageTool>(); }

}  // namespace pectin
