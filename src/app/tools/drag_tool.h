// What the tools have in common that drag the object with the left button: movements of the mouse
// are handled once in a frame, Enter ends the drag like a release of the button, and the end of the
// drag may be worked on in the background.
#pragma once

#include "app/tools/tool.h"

namespace pectin {

class DragTool : public Tool {
  public:
    bool press(ToolContext& context, MouseButton button) final;
    bool key(ToolContext& context, const event::KeyDown& key) override;
    void move(ToolContext& context) final;
    void lose_focus(ToolContext& context) final;
    void release(ToolContext& context, MouseButton button) final;
    void advance(ToolContext& context) final;
    void finish(ToolContext& context, Workspace::Outcome outcome) final;
    void cancel(ToolContext& context) noexcept final;

  protected:
    // A press of the left button. Returns whether the tool takes it.
    virtual bool begin(ToolContext& context) = 0;
    // The cursor has moved. What that changes is left to update().
    virtual void follow(const ToolContext& context) = 0;
    // Moves what is dragged to the cursor.
    virtual void update(ToolContext& context) = 0;
    // The button was released before anything was dragged.
    virtual void click(ToolContext&) {}
    // The session's drag is about to end.
    virtual void before_end(const ToolContext&) {}
    // It has ended and has moved something.
    virtual void after_end(ToolContext&) {}
    // Ends the gesture; the session has ended or cancelled its drag.
    virtual void forget() noexcept = 0;

    // The next frame calls update().
    void request_update() { is_stale_ = true; }

  private:
    void accept(ToolContext& context);

    bool is_stale_ = false;
};

// Tells the user what is wrong with the result of the last drag, if anything is.
void report_drag(ToolContext& context);

}  // namespace pectin
