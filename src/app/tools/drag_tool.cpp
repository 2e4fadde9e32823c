#include "app/tools/drag_tool.h"

#include <chrono>
#include <string>
#include <utility>

#include "app/words.h"

namespace pectin {
namespace {

// Goes on with adaptive meshing for which the frame before had no time left.
void continue_frame(ToolContext& context) {
    if (!context.session().has_unfinished_frame()) return;
    const auto start = std::chrono::steady_clock::now();
    FrameFigures& figures = context.drag_figures();
    const FrameFigures before = figures;
    context.workspace().session().continue_frame();
    figures.record(context.session().last_frame(), std::chrono::steady_clock::now() - start);
    figures.splits += before.splits;
    figures.unsplits += before.unsplits;
}

}  // namespace

void report_drag(ToolContext& context) {
    const Session& session = context.session();
    const std::uint64_t folded = session.folded_vertices();
    context.drag_figures().folded = folded;
    std::string message;
    if (folded > 0) {
        message = "The surface is turned inside out at " + std::to_string(folded) +
                  (folded == 1 ? " vertex" : " vertices") +
                  ". Undo, or drag less far; Fold-free prevents this when the surface is dragged.";
    }
    if (const std::string& remark = session.remark(); !remark.empty()) {
        message += (message.empty() ? "" : " ") + sentences(remark);
    }
    if (!message.empty()) context.workspace().set_message(message);
}

bool DragTool::press(ToolContext& context, MouseButton button) {
    if (is_active()) return true;
    is_stale_ = false;
    return button == MouseButton::left && begin(context);
}

void DragTool::move(ToolContext& context) {
    follow(context);
    request_update();
}

void DragTool::advance(ToolContext& context) {
    if (std::exchange(is_stale_, false)) {
        update(context);
    } else {
        continue_frame(context);
    }
}

bool DragTool::key(ToolContext& context, const event::KeyDown& key) {
    if (!is_active() || key.key != Key::enter || key.is_repeat) return false;
    accept(context);
    return true;
}

void DragTool::release(ToolContext& context, MouseButton button) {
    if (button == MouseButton::left) accept(context);
}

// The button may be released while another window has the focus.
void DragTool::lose_focus(ToolContext& context) { accept(context); }

void DragTool::accept(ToolContext& context) {
    if (std::exchange(is_stale_, false)) update(context);
    if (context.session().is_dragging()) {
        before_end(context);
        finish(context, context.workspace().end_drag());
    } else {
        click(context);
    }
}

void DragTool::finish(ToolContext& context, Workspace::Outcome outcome) {
    if (outcome == Workspace::Outcome::in_progress) return;
    cancel(context);  // if the end has failed, the session may still have the drag
    if (outcome == Workspace::Outcome::done && context.workspace().has_moved()) {
        after_end(context);
        report_drag(context);
    }
}

void DragTool::cancel(ToolContext& context) noexcept {
    forget();
    if (context.session().is_dragging()) context.workspace().session().cancel_drag();
    context.drag_figures().reset_drag();
    is_stale_ = false;
}

}  // namespace pectin
