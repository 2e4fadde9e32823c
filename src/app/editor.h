// Interaction logic of the window: turns input events into commands and camera changes, and holds
// the state that panels and overlays display. Independent of the window system and of rendering.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/actions.h"
#include "app/detail_preview.h"
#include "app/document_controller.h"
#include "app/example_player.h"
#include "app/help_page.h"
#include "app/input_event.h"
#include "app/preferences.h"
#include "app/tool_context.h"
#include "app/tools/tool.h"
#include "app/view_control.h"

namespace pectin {

// The plane that is used when symmetry is switched on.
struct MirrorChoice {
    command::Symmetry::Plane plane = command::Symmetry::Plane::x;
    // Whether the plane contains the centre of the object as it was opened, or else the origin.
    bool through_centre = false;
};

// The devices whose input belongs to the user interface at the moment.
struct UiClaims {
    bool mouse = false, keyboard = false;
};

class Editor : public ToolContext, private DocumentController::Delegate {
  public:
    // max_blocking_time: as for Workspace. tools: in the order in which they are asked.
    explicit Editor(std::optional<Recorder> recorder = {},
                    std::chrono::milliseconds max_blocking_time = kMaxBlockingTime,
                    Tools tools = all_tools());
    ~Editor() override = default;
    Editor(const Editor&) = delete;  // its parts refer to each other
    Editor& operator=(const Editor&) = delete;

    // --- Input. It goes to the tools of the mouse (app/tools/), and to navigation if no tool takes
    // it.
    void handle(const InputEvent& input, const UiClaims& claims = {});
    // Updates the active tool, work in the background, a restoration and what is under the cursor.
    // To be called once per frame, after the frame's events.
    void advance();

    // Whether advance() has more to do for the active drag, the preview of the detail or an
    // example, although there is no further input.
    bool has_unfinished_frame() const;

    // Cancels what a tool is doing and shows a message; does nothing during an edit in the
    // background. what: what needed the memory, such as "frame".
    void handle_out_of_memory(const char* what) noexcept;

    // --- Actions of menus, panels and keys. They do nothing while a tool is active, and during
    // work in the background.
    // If the action is not enabled, a message says what it needs.
    void perform(Action action);
    void undo();
    void remove_pins() { pins_.clear(); }
    // As DocumentController::execute().
    bool execute(const Command& command) { return document_.execute(command); }
    // Opens the window's first object: the model, or a sphere if `model` is empty or cannot be
    // opened.
    void begin(const std::string& model);
    void set_radius(double radius) override;
    void set_radius_value(double value) override;
    void set_radius_unit(RadiusUnit unit) override;
    void use_radius_at(const Vec3& point) override;
    void set_symmetry(bool is_on);
    void choose_mirror(const MirrorChoice& choice);  // also changes the plane of active symmetry
    // Sets a cage that is fitted to this box. counts: control points per axis.
    void set_cage(const Box& box, const IVec3& counts);
    // Chooses the brush or the cage as the lattice of drags, and ends the setting of pins. A new
    // cage is fitted to the object.
    void use_brush();
    void use_cage();
    void fit_cage();
    // Gives the cage, which has this box, or else the next one other counts of control points.
    // Counts that the command does not allow are refused with a message.
    void choose_cage_counts(const Box& box, const IVec3& counts);

    // --- The view.
    ViewControl& view_control() { return view_control_; }
    const ViewControl& view_control() const { return view_control_; }
    // Sets the part of the window that no panel covers, in window coordinates. Framing and the axes
    // follow it. To be called after each layout. scale: of sizes, 1 on an ordinary screen.
    void set_free_area(const ScreenBox& area, double scale);

    // --- Files, dialogs about them, work in the background, and quitting.
    DocumentController& document() { return document_; }
    const DocumentController& document() const { return document_; }
    // Whether a dialog or a window of the menu Help is open. It takes all input.
    bool has_dialog() const { return document_.has_dialog() || help_page_.has_value(); }
    bool is_working() const override { return document_.is_working(); }

    // --- Help.
    // Opens a window of the menu Help in place of another one; closes it if it is open.
    void show_help(HelpPage page);
    void close_help() { help_page_.reset(); }
    const std::optional<HelpPage>& help_page() const { return help_page_; }
    ExamplePlayer& example() { return example_; }
    const ExamplePlayer& example() const { return example_; }

    // --- State to display.
    Workspace& workspace() override { return workspace_; }
    const Workspace& workspace() const override { return workspace_; }
    const Camera& camera() const { return view_control_.camera(); }
    View view() const override { return {camera(), size()}; }
    Pins& pins() override { return pins_; }
    const Pins& pins() const override { return pins_; }
    const MirrorChoice& mirror_choice() const { return mirror_; }
    const Pointer& pointer() const override { return pointer_; }
    const std::optional<Pick>& hover() const override { return hover_; }
    FrameFigures figures() const;
    const IVec2& size() const { return view_control_.size(); }
    bool shows_hint() const { return shows_hint_; }

    // --- State that panels and actions change.
    Preferences preferences{};
    IVec3 cage_counts{4};          // control points per axis of the next cage that is fitted
    bool menus_requested = false;  // to open the menus, so that the keyboard can be used there
    // What another detail would split; active while the user is choosing one.
    DetailPreview detail_preview{};

    // --- The tools.
    const Tools& tools() const { return tools_; }
    bool is_dragging() const override;
    // Adds what the tools show in the viewport.
    void add_overlays(Overlay& overlay) const;
    std::optional<ScreenBox> selection_box() const;
    // What the mouse does here and now; see Tool::status_hint().
    std::string_view status_hint() const;
    // The settings that matter to any of the tools.
    ShownSettings shown_settings() const;

  private:
    // --- Input (editor_input.cpp).
    void on(const event::Press& press, const UiClaims& claims);
    void on(const event::Release& release, const UiClaims& claims);
    void on(const event::MouseMove& move, const UiClaims& claims);
    void on(const event::Leave& leave, const UiClaims& claims);
    void on(const event::Scroll& scroll, const UiClaims& claims);
    void on(const event::KeyDown& key, const UiClaims& claims);
    void on(const event::KeyUp& key, const UiClaims& claims);
    void on(const event::Character& character, const UiClaims& claims);
    void on(const event::Drop& drop, const UiClaims& claims);
    void on(const event::Resize& resize, const UiClaims& claims);
    void on(const event::Focus& focus, const UiClaims& claims);
    void on(const event::Close& close, const UiClaims& claims);
    void escape(bool is_claimed);
    bool escape_gesture();
    void escape_state();
    void set_pointer(const Vec2& at, const Modifiers& modifiers, bool is_in_viewport);
    void hold(Key key, bool is_held);

    // --- Tools (editor_input.cpp).
    FrameFigures& drag_figures() override { return figures_; }
    void touch(const Vec3& point) override { view_control_.touch(point); }
    Tool* active_tool() const;
    template <typename Part>
    bool run(Part part);
    template <typename Offer>
    bool offer_to_tools(Offer offer);
    void cancel_gesture() noexcept;
    void advance_work();
    void update_hover();
    std::optional<Pick> pick_in_middle();

    // --- For the document controller (editor.cpp).
    bool has_gesture() const override { return active_tool() || example_.is_moving(); }
    void command_done(const Command& command) override;
    void restoration_ended() override;
    void begin_example(Example example) override;
    command::Screenshot picture_command(const std::string& path) const override;
    void reset_for_new_object();
    void reset_sizes();
    void update_radius_share();

    // --- Everything else (editor.cpp).
    bool is_busy() const { return has_gesture() || is_working(); }
    command::Symmetry symmetry_command(bool is_on) const;

    Workspace workspace_;
    DocumentController document_{workspace_, *this};
    ViewControl view_control_{workspace_, preferences};
    Tools tools_;
    Pins pins_;
    MirrorChoice mirror_;
    Pointer pointer_;
    bool holds_space_ = false, holds_normal_key_ = false;
    std::optional<Pick> hover_;
    FrameFigures figures_;
    bool shows_hint_ = true;
    std::optional<HelpPage> help_page_;
    ExamplePlayer example_{*this, [this](const Command& command) { return execute(command); }};
};

}  // namespace pectin
