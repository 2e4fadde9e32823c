#include "app/tools/sculpt_tool.h"

#include <array>
#include <chrono>

#include "app/tools/brush_rings.h"
#include "app/tools/cursor_path.h"
#include "app/words.h"

namespace pectin {
namespace {

// Deviations of the cursor's path by fewer pixels are not meant by the user.
constexpr double kPathTolerance = 4.0;
constexpr double kDegreesPerNotch = 5.0;
constexpr Colour kRing{255, 255, 255, 190}, kDragRing{255, 214, 64, 200};
constexpr std::array<InputReference, 10> kInputs{{
    {"Drag the surface", "Pulls it; the area around it follows."},
    {"N or Alt, while dragging", "Moves the point along the normal of the surface."},
    {"Wheel, while dragging", "Twists the area around the point about the normal."},
    {"Shift+wheel, while dragging", "Scales the area around the point."},
    {"X, Y or Z, while dragging", "Keeps the point to this axis; once more frees it."},
    {"Shift+X, Y or Z, while dragging", "Keeps the point to the plane across this axis."},
    {"Digits, while dragging", "Set the distance, along the axis or the present direction."},
    {"Enter, while dragging", "Accepts the drag."},
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
    const bool shows_cage = context.display.lattice && context.has_cage();
    if (!context.is_working() && (context.display.drag_lattice || shows_cage)) {
        for (const LatticeField& field : context.session().active_lattices()) {
            add_lattice(overlay, field.lattice(), field.displacements());
        }
    }
    add_drag_rings(overlay, context, sculptor.normal(), sculptor.to(), kDragRing);
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
    context.use_radius_at(handle.point);
    const Done done = sculptor_.grab(workspace.session(), handle, context.ray_through_cursor(),
                                     context.pins().points(), context.drag_options);
    if (!done) {
        workspace.set_message(words_of(done.refusal()));
        return true;
    }
    workspace.clear_command_message();
    context.touch(handle.point);
    cursor_path_.assign(1, context.pointer().at);
    context.drag_figures().reset_drag();
    return true;
}

void SculptTool::follow(const ToolContext& context) {
    cursor_path_.push_back(context.pointer().at);
}

// The steps of a fold-free drag depend on the path, so such a drag follows the cursor's path. One
// with a typed distance goes straight.
void SculptTool::find_positions(const ToolContext& context) {
    if (context.drag_options.fold_free && cursor_path_.size() > 1 &&
        !sculptor_.constraint().distance()) {
        simplify_path(cursor_path_, kPathTolerance, positions_);
    } else {
        positions_.assign(1, context.pointer().at);
    }
    cursor_path_.assign(1, context.pointer().at);
}

void SculptTool::update(ToolContext& context) {
    const auto start = std::chrono::steady_clock::now();
    const DragPath path = context.pointer().along_normal ? DragPath::normal : DragPath::view_plane;
    find_positions(context);
    Workspace& workspace = context.workspace();
    const View view = context.view();
    bool has_moved = false;
    Done last;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        // Only the last position is shown.
        workspace.limit_frame_time(i + 1 == positions_.size());
        const Result<bool> moved =
            sculptor_.drag(workspace.session(), view.camera, view.ray_through(positions_[i]), path,
                           context.drag_strength);
        // After a refusal the next position may be within reach again.
        last = moved ? Done{} : moved.refusal();
        has_moved = has_moved || (moved && *moved);
    }
    update_constraint_hint();
    if (!last) return workspace.set_message(words_of(last.refusal()));
    workspace.clear_command_message();
    if (!has_moved) return;
    context.touch(sculptor_.to());
    FrameFigures& figures = context.drag_figures();
    figures.record(workspace.session().last_frame(), std::chrono::steady_clock::now() - start);
    figures.steps = workspace.session().active_drag().via.size() + 1;
    figures.degrees = sculptor_.degrees();
    figures.scale = sculptor_.scale();
}

bool SculptTool::key(ToolContext& context, const event::KeyDown& key) {
    if (!is_active()) return false;
    const bool is_constraint =
        is_constraint_key(key) &&
        sculptor_.press_key(context.workspace().session(), key.key, key.modifiers.shift);
    if (!is_constraint) return DragTool::key(context, key);
    request_update();
    return true;
}

void SculptTool::character(ToolContext& context, unsigned int code) {
    if (is_active() && sculptor_.type(context.workspace().session(), code)) request_update();
}

void SculptTool::update_constraint_hint() {
    constraint_hint_.clear();
    if (!sculptor_.is_dragging() || !sculptor_.constraint().is_active()) return;
    constraint_hint_ = hint_of(sculptor_.constraint(), sculptor_.to() - sculptor_.from());
}

void SculptTool::before_end(const ToolContext& context) {
    ended_ = LastDrag{context.session().active_drag(), sculptor_.normal()};
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
    if (context.display.lattice && !context.has_cage()) {
        if (const auto lattice = preview_lattice(context)) add_lattice(overlay, *lattice, {});
    }
    if (!context.radius_being_set) add_brush_rings(overlay, context, kRing);
}

std::string_view SculptTool::status_hint(const ToolContext& context) const {
    const Modifiers& modifiers = context.pointer().modifiers;
    const bool is_along_normal = context.pointer().along_normal;
    if (is_active()) {
        if (!constraint_hint_.empty()) return constraint_hint_;
        if (is_along_normal) return "The point moves along the normal of the surface.";
        if (modifiers.shift) return "Turn the wheel to scale the area around the point.";
        return "N: along the normal · Wheel: twist · Shift+wheel: scale · X, Y, Z: axis · Digits: "
               "distance · Esc: give up the drag";
    }
    if (!context.hover()) return {};
    if (is_along_normal) return "Drag the surface to pull it along its normal.";
    if (context.has_cage()) {
        return "Drag the surface to pull it; the cage decides what follows. · N or Alt: along the "
               "normal · P: pin";
    }
    return "Drag the surface to pull it; the area around it follows. · N or Alt: along the normal "
           "· F: radius · P: pin";
}

ShownSettings SculptTool::settings() const {
    return {.radius = true, .mirror = true, .connected = true, .fold_free = true, .pins = true};
}

InputGroup SculptTool::inputs() const { return {"Surface", kInputs, 0}; }

std::unique_ptr<Tool> make_sculpt_tool() { return std::make_unique<SculptTool>(); }

}  // namespace pectin
