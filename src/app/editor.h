// Interaction logic of the window: turns input events into commands and camera changes, and holds
// the state that panels and overlays display. Independent of the window system and of rendering.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/actions.h"
#include "app/file_browser.h"
#include "app/input_event.h"
#include "app/navigation.h"
#include "app/restoration.h"
#include "app/tool_context.h"
#include "app/tools/tool.h"

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

class Editor final : public ToolContext {
  public:
    // max_blocking_time: as for Workspace. tools: in the order in which they are asked.
    explicit Editor(std::optional<Recorder> recorder = {},
                    std::chrono::milliseconds max_blocking_time = kMaxBlockingTime,
                    Tools tools = all_tools());

    // --- Input. It goes to the tools of the mouse (app/tools/), and to navigation if no tool takes
    // it.
    void handle(const InputEvent& input, const UiClaims& claims = {});
    // Updates the active tool, work in the background, a restoration and what is under the cursor.
    // To be called once per frame, after the frame's events.
    void advance();

    // Whether advance() has more to do for the active drag, although there is no further input.
    bool has_unfinished_frame() const;

    // Cancels what a tool is doing and shows a message; does nothing during an edit in the
    // background. what: what needed the memory, such as "frame".
    void handle_out_of_memory(const char* what) noexcept;

    // --- Actions of menus, panels and keys. They do nothing while a tool is active, and during
    // work in the background.
    void perform(Action action);  // if it is enabled
    void perform_on_file(Action action);
    void undo();
    // Moves the camera so that it shows the whole object, from its present direction or another.
    void frame_all(const std::optional<Vec3>& direction = {});
    void remove_pins() { pins_.clear(); }
    bool execute(const Command& command);  // returns whether the command is already done
    // Opens the window's first object: the model, or a sphere if `model` is empty or cannot be
    // opened.
    void begin(const std::string& model);
    // These three ask first if changes would be lost.
    void open(const std::string& path);
    void new_shape(command::Shape::Kind kind, int resolution);
    void quit();  // also cancels the work on a file
    void set_radius(double radius) override;
    void set_symmetry(bool is_on);
    void choose_mirror(const MirrorChoice& choice);  // also changes the plane of active symmetry
    // Sets a cage that is fitted to this box. counts: control points per axis.
    void set_cage(const Box& box, const IVec3& counts);

    // --- State to display.
    Workspace& workspace() override { return workspace_; }
    const Workspace& workspace() const override { return workspace_; }
    const Camera& camera() const { return navigation_.camera(); }
    View view() const override { return {camera(), size_}; }
    Pins& pins() override { return pins_; }
    const Pins& pins() const override { return pins_; }
    const MirrorChoice& mirror_choice() const { return mirror_; }
    const Pointer& pointer() const override { return pointer_; }
    const std::optional<Pick>& hover() const override { return hover_; }
    FrameFigures figures() const;
    const IVec2& size() const { return size_; }
    bool shows_hint() const { return shows_hint_; }
    bool wants_to_end() const { return wants_to_end_; }

    // --- The tools.
    const Tools& tools() const { return tools_; }
    bool is_dragging() const override;
    // Adds what the tools show in the viewport.
    void add_overlays(Overlay& overlay) const;
    std::optional<ScreenBox> selection_box() const;
    // One sentence about what the mouse does here and now.
    std::string_view status_hint() const;
    // The settings that matter to any of the tools.
    ShownSettings shown_settings() const;

    // --- Dialogs. A dialog that is open takes all input.
    bool has_dialog() const { return browser || question || offered_session() || is_working(); }

    // Work on a file, an edit that takes long, or a restoration. A dialog shows its progress. Only
    // settings of the session may be used meanwhile.
    bool is_working() const override { return restoration_ || workspace_.is_working(); }
    const Restoration* restoration() const { return restoration_ ? &*restoration_ : nullptr; }
    void cancel_work();  // the work ends soon afterwards; does nothing without any

    // The file browser.
    std::optional<FileBrowser> browser{};
    // Uses the file that is named in the browser and closes the browser. If this would replace
    // another file, the first call only sets file_to_replace(). Does nothing without a name.
    void accept_file();
    void close_browser();
    const std::string& file_to_replace() const { return file_to_replace_; }
    void keep_file() { file_to_replace_.clear(); }
    // Whether Enter was pressed in the open dialog since the last call.
    bool take_enter() { return std::exchange(enter_pressed_, false); }

    // The question whether to save the changes that an action would discard.
    struct Question {
        struct Quit {};
        std::variant<Quit, command::Open, command::Shape> then;
    };
    std::optional<Question> question{};
    enum class Answer { save, discard, cancel };
    void answer(Answer answer);

    // Sessions that may be restored.
    // Offers these, one after the other.
    void offer(std::vector<LostSession> sessions) { lost_sessions_ = std::move(sessions); }
    // The session that is being offered; null if there is none, and during work.
    const LostSession* offered_session() const {
        return lost_sessions_.empty() || workspace_.is_working() ? nullptr
                                                                 : &lost_sessions_.front();
    }
    // restore: begins to restore the session, which advance() continues.
    // later: this session and the remaining ones are offered again at the next start.
    enum class RecoveryAnswer { restore, discard, later };
    void answer_recovery(RecoveryAnswer answer);

  private:
    // The object of a new window.
    static constexpr command::Shape kFirstObject{command::Shape::Kind::sphere, 4};

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
    bool escape_dialog();
    void escape_state();

    // --- Tools (editor_input.cpp).
    FrameFigures& drag_figures() override { return figures_; }
    Tool* active_tool() const;
    template <typename Part>
    bool run(Part part);
    template <typename Offer>
    bool offer_to_tools(Offer offer);
    void cancel_gesture() noexcept;
    void poll_work();
    void update_hover();

    // --- Files (editor_files.cpp).
    bool finish_command(const Command& command, Workspace::Outcome outcome);
    void update_after(const Command& command);
    void reset_for_new_object();
    void reset_sizes();
    void execute_keeping_message(const Command& command);
    std::string path_to_propose() const;
    void begin_save(std::optional<Question> next);
    void save(const std::string& path, std::optional<Question> next);
    void use_chosen_file(FileBrowser::Purpose purpose, const std::string& path);
    void save_picture(const std::string& path);
    void ask_or_do(Question asked);
    void do_without_asking(const Question& asked);

    // --- Restoring (editor_recovery.cpp).
    void continue_restoring();
    std::string end_restoring(const Restoration& ended, Restoration::State state);

    // --- Everything else (editor.cpp).
    bool is_busy() const { return active_tool() || is_working(); }
    command::Symmetry symmetry_command(bool is_on) const;

    Workspace workspace_;
    Navigation navigation_;
    Tools tools_;
    Pins pins_;
    MirrorChoice mirror_;
    IVec2 size_{1280, 800};
    Pointer pointer_;
    std::optional<Pick> hover_;
    FrameFigures figures_;
    std::optional<Question> after_save_;  // to be done once a file to save to has been chosen
    std::optional<Question> next_;        // to be done once the present save is done
    bool quits_next_ = false;             // to quit once the work on a file has ended
    std::string file_to_replace_;
    std::vector<LostSession> lost_sessions_;
    std::optional<Restoration> restoration_;
    bool enter_pressed_ = false;
    bool shows_hint_ = true;
    bool wants_to_end_ = false;
};

}  // namespace pectin
