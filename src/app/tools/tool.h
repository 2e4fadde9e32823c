// A tool: something that the mouse can do in the viewport, such as dragging the surface.
//
// All tools are ready at the same time. What is under the cursor, the modifiers and the settings
// decide which of them takes an event. A tool that has taken a press or a key may become active,
// until its gesture ends; while it is active it gets all events. Otherwise the editor asks the
// tools in the order of all_tools(), and navigation gets what no tool takes.
//
// If a function throws, the editor cancels the gesture and shows a message. During work in the
// background no input is passed on. What shows something is still called, also hover(), and may
// then use only settings of the session.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/input_event.h"
#include "app/input_reference.h"
#include "app/tool_context.h"
#include "app/tools/screen_box.h"
#include "render/overlay.h"

namespace pectin {

// The settings that matter to a tool, which the panels show.
struct ShownSettings {
    bool radius = false, mirror = false, connected = false, fold_free = false, pins = false,
         cage = false;

    ShownSettings& operator|=(const ShownSettings& other);
    bool operator==(const ShownSettings&) const = default;
};

class Tool {
  public:
    virtual ~Tool() = default;

    // --- Input. The results say whether the tool takes the event. An active tool gets presses,
    // keys and the wheel as well; its results do not matter.

    // Called once per frame unless a tool is active. context.hover() is the surface under the
    // cursor. is_free: whether the cursor is in the viewport and no tool before has taken it. A
    // tool that takes the cursor shows something of its own there.
    virtual bool hover(const ToolContext& context, bool is_free);
    // context.pointer() is where the button was pressed.
    virtual bool press(ToolContext& context, MouseButton button);
    virtual bool key(ToolContext& context, const event::KeyDown& key);
    // A character that was typed. Only an active tool gets it.
    virtual void character(ToolContext& context, unsigned int code);
    // notches: up is positive.
    virtual bool scroll(ToolContext& context, double notches);
    // The key Esc without a gesture: leaves a mode or a selection.
    virtual bool escape(ToolContext& context);

    // --- A gesture.
    virtual bool is_active() const { return false; }
    // Whether the gesture has begun to drag the object.
    virtual bool is_dragging() const { return false; }
    // context.pointer() has changed, or a modifier.
    virtual void move(ToolContext& context);
    virtual void release(ToolContext& context, MouseButton button);
    virtual void key_up(ToolContext& context, Key key);
    // The window has lost the focus. No key that is held will be reported as released.
    virtual void lose_focus(ToolContext& context);
    // Called once per frame, after the frame's events.
    virtual void advance(ToolContext& context);
    // The end of the drag, which was worked on in the background, has this outcome.
    virtual void finish(ToolContext& context, Workspace::Outcome outcome);
    // Ends the gesture and takes back what it has done. The session may no longer have its drag:
    // then the end of it has failed.
    virtual void cancel(ToolContext& context) noexcept;

    // --- State to display.
    // Adds what the tool shows in the viewport.
    virtual void overlay(const ToolContext& context, Overlay& overlay) const;
    // The box with which the tool selects.
    virtual std::optional<ScreenBox> selection_box() const { return std::nullopt; }
    // What the mouse does here and now, with the modifiers that are held: a sentence, and after it
    // what other keys do, separated by middle dots. Empty if the tool does nothing here.
    virtual std::string_view status_hint(const ToolContext& context) const;
    virtual ShownSettings settings() const { return {}; }
    // What mouse and keys do with this tool, for help. Whatever else the tool takes belongs here.
    virtual InputGroup inputs() const { return {}; }
};

using Tools = std::vector<std::unique_ptr<Tool>>;

// The tools in the order in which they are asked. The first has precedence where several would take
// an event.
Tools all_tools();

}  // namespace pectin
