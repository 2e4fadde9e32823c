#include "app/tools/sculpt_tool.h"

#include <array>
#include <chrono>

#include "app/rounded_numbers.h"
#include "app/tools/brush_circle.h"
#include "app/tools/cursor_path.h"

namespace pectin {
namespace {

// Deviations of the cursor's path by fewer pixels are not meant by the user.
constexpr double kPathTolerance = 4.0;
constexpr double kDegreesPerNotch = 5.0;
constexpr Colour kCircle{255, 255, 255, 190};
constexpr std::array<InputReference, 6> kInputs{{
    {"Drag the surface", "Pulls it; the area around it follows."},
    {"Alt, while dragging", "Moves the point along the normal of the surface."},
    {"Wheel, while dragging", "Twists the area around the point about the normal."},
    {"Shift+wheel, while dragging", "Scales the area around the point."},
    {"Drag a pin", "Moves the point that it holds."},
    {"Esc, while dragging", "Takes the drag back."},
}};

// Returns what a press at the cursor grabs: the pin whose marker is there, or the surface point.
Pick handle_at_cursor(const ToolContext& context, Pick pick) {
    const auto marker =
        context.pins().at(context.view(), context.pointer().at, pick, context.session().symmetry());
    if (!marker) return context.snapped_to_symmetry_plane(pick);
    pick.point = marker->position;
    return pick;
}

void add_active_drag(Overlay& overlay, const ToolContext& context, const Sculptor& sculptor) {
    // After several steps, these are the lattices of the last step. While the drag is being
    // applied in the background, the session may not be asked for them.
    if (!context.is_working()) {
        for (const LatticeField& field : context.session().active_lattices()) {
            add_lattice(overlay, field.lattice(), field.displacements());
        }
    }
    add_drag(overlay, sculptor.from(), sculptor.to());
    const auto& plane = context.session().symmetry();
    if (plane && plane->offset(sculptor.from()) != 0.0) {
        add_drag(overlay, plane->image(sculptor.from()), plane->image(sculptor.to()), true);
    }
}

// Returns the lattice that a drag from here would use; without a point under the cursor, the one
// that was used last.
std::optional<Lattice> preview_lattice(const ToolContext& context) {
    const int span = context.session().lattice_settings().span;
    if (context.hover()) return brush_lattice(context.hover()->point, context.radius(), span);
    return context.is_working() ? std::nullopt : context.session().lattice_in_use();
}

}  // namespace

bool SculptTool::begin(ToolContext& context) {
    const std::optional<Pick> pick = context.pick_at_cursor();
    if (!pick) return false;
    Workspace& workspace = context.workspace();
    const Pick handle = handle_at_cursor(context, *pick);
    const Done done = sculptor_.grab(workspace.session(), handle, context.ray_through_cursor(),
                                     context.pins().points(), context.drag_options);
    if (!done) {
        workspace.set_message(rounded_numbers(done.refusal().reason));
        return true;
    }
    workspace.clear_command_message();
    cursor_path_.assign(1, context.pointer().at);
    context.drag_figures().reset_drag();
    return true;
}

void SculptTool::follow(const ToolContext& context) {
    cursor_path_.push_back(context.pointer().at);
}

// The steps of a fold-free drag depend on the path, so such a drag follows the cursor's path.
void SculptTool::find_positions(const ToolContext& context) {
    if (context.drag_options.fold_free && cursor_path_.size() > 1) {
        simplify_path(cursor_path_, kPathTolerance, positions_);
    } else {
        positions_.assign(1, context.pointer().at);
    }
    cursor_path_.assign(1, context.pointer().at);
}

void SculptTool::update(ToolContext& context) {
    const auto start = std::chrono::steady_clock::now();
    const bool is_along_normal = context.pointer().modifiers.alt;
    const DragPath path = is_along_normal ? DragPath::normal : DragPath::view_plane;
    find_positions(context);
    Workspace& workspace = context.workspace();
    const View view = context.view();
    bool has_moved = false;
    Done last;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        // Only the last position is shown.
        workspace.limit_frame_time(i + 1 == positions_.size());
        const Result<bool> moved =
            sculptor_.drag(workspace.session(), view.camera, view.ray_through(positions_[i]), path);
        // After a refusal the next position may be within reach again.
        last = moved ? Done{} : moved.refusal();
        has_moved = has_moved || (moved && *moved);
    }
    if (!last) return workspace.set_message(rounded_numbers(last.refusal().reason));
    workspace.clear_command_message();
    if (!has_moved) return;
    FrameFigures& figures = context.drag_figures();
    figures.record(workspace.session().last_frame(), std::chrono::steady_clock::now() - start);
    figures.steps = workspace.session().active_drag().via.size() + 1;
    figures.degrees = sculptor_.degrees();
    figures.scale = sculptor_.scale();
}

bool SculptTool::scroll(ToolContext& context, double notches) {
    if (!is_active()) return false;
    if (context.pointer().modifiers.shift) {
        sculptor_.scale_by_steps(notches);
    } else {
        sculptor_.rotate(kDegreesPerNotch * notches);
    }
    request_update();
    return true;
}

void SculptTool::overlay(const ToolContext& context, Overlay& overlay) const {
    if (is_active()) return add_active_drag(overlay, context, sculptor_);
    const bool has_cage = context.session().lattice_settings().cage.has_value();
    if (context.display.lattice && !has_cage) {
        if (const auto lattice = preview_lattice(context)) add_lattice(overlay, *lattice, {});
    }
    if (!context.is_setting_radius()) add_brush_circle(overlay, context, kCircle);
}

std::string_view SculptTool::status_hint(const ToolContext& context) const {
    const Modifiers& modifiers = context.pointer().modifiers;
    if (is_active()) {
        if (modifiers.alt) return "The point moves along the normal of the surface.";
        if (modifiers.shift) return "The wheel scales the surroundings of the point.";
        return "Alt moves the point along the normal, the wheel twists its surroundings, and with "
               "Shift it scales them.";
    }
    if (!context.hover()) return {};
    if (modifiers.alt) return "Drag the surface to move the point along the normal.";
    return "Drag the surface, and its surroundings follow.";
}

ShownSettings SculptTool::settings() const {
    return {.radius = true, .mirror = true, .connected = true, .fold_free = true, .pins = true};
}

InputGroup SculptTool::inputs() const { return {"Surface", kInputs, 0}; }

std::unique_ptr<Tool> make_sculpt_tool() { return std::make_unique<SculptTool>(); }

}  // namespace pectin
