// Interaction logic of the window: turns input events into commands and camera changes, and holds
// the state that panels and overlays display. Independent of the window system and of rendering.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/actions.h"
#include "app/cage_points.h"
#include "app/file_browser.h"
#include "app/input_event.h"
#include "app/navigation.h"
#include "app/pins.h"
#include "app/restoration.h"
#include "app/sculptor.h"
#include "app/view.h"
#include "app/workspace.h"

namespace pectin {

struct Display {
    bool wireframe = false, levels = false;
    // Whether the lattice is also shown between drags. The control points of a cage can then be
    // dragged.
    bool lattice = false;
    bool symmetry_plane = true;
};

// The plane that is used when symmetry is switched on.
struct MirrorChoice {
    command::Symmetry::Plane plane = command::Symmetry::Plane::x;
    // Whether the plane contains the centre of the object as it was opened, or else the origin.
    bool through_centre = false;
};

// Counts and timings of the most recent frame in which a drag changed the object.
struct FrameFigures {
    std::uint64_t splits = 0, unsplits = 0;
    double seconds = 0.0;  // without rendering
    double deform_seconds = 0.0, refine_seconds = 0.0, decimate_seconds = 0.0;
    bool floor_hit = false, budget_hit = false, drag_budget_hit = false;
    std::size_t steps = 1;              // number of steps of a fold-free drag
    double degrees = 0.0, scale = 1.0;  // twist and scale at the grabbed point
    std::uint64_t folded = 0;           // number of folded vertices after the drag
};

// The devices whose input belongs to the user interface at the moment.
struct UiClaims {
    bool mouse = false, keyboard = false;
};

class Editor {
  public:
    // max_blocking_time: as for Workspace.
    explicit Editor(std::optional<Recorder> recorder = {},
                    std::chrono::milliseconds max_blocking_time = kMaxBlockingTime);

    // --- Input.
    void handle(const InputEvent& input, const UiClaims& claims = {});
    // Updates the active drag, work in the background, a restoration and what is under the cursor.
    // To be called once per frame, after the frame's events.
    void advance();

    // Whether advance() has more to do for the active drag, although there is no further input.
    bool has_unfinished_frame() const;

    // Cancels the active drag and shows a message; does nothing during an edit in the background.
    // what: what needed the memory, such as "frame".
    void handle_out_of_memory(const char* what) noexcept;

    // --- Actions of menus, panels and keys. They do nothing during a drag, and during work in the
    // background.
    void perform(Action action);  // if it is enabled
    void perform_on_file(Action action);
    void undo();
    // Moves the camera so that it shows the whole object, from its present direction or another.
    void frame_all(const std::optional<Vec3>& direction = {});
    void toggle_pin();  // under the cursor
    void remove_pins() { pins_.clear(); }
    bool execute(const Command& command);  // returns whether the command is already done
    // Opens the window's first object: the model, or a sphere if `model` is empty or cannot be
    // opened.
    void begin(const std::string& model);
    // These three ask first if changes would be lost.
    void open(const std::string& path);
    void new_shape(command::Shape::Kind kind, int resolution);
    void quit();  // also cancels the work on a file
    // Sets the brush's radius, clamped to the range from min_radius() to max_radius(). The range
    // follows from the object's size.
    void set_radius(double radius);
    double min_radius() const;
    double max_radius() const;
    void set_symmetry(bool is_on);
    void choose_mirror(const MirrorChoice& choice);  // also changes the plane of active symmetry
    // Sets a cage that is fitted to this box. counts: control points per axis.
    void set_cage(const Box& box, const IVec3& counts);

    // --- State to display.
    Workspace& workspace() { return workspace_; }
    const Workspace& workspace() const { return workspace_; }
    const Session& session() const { return workspace_.session(); }
    const Camera& camera() const { return navigation_.camera(); }
    const Sculptor& sculptor() const { return sculptor_; }
    const CagePoints& cage_points() const { return cage_points_; }
    // The cage, if its control points are shown and can be dragged.
    std::optional<Lattice> editable_cage() const;
    const Pins& pins() const { return pins_; }
    const MirrorChoice& mirror_choice() const { return mirror_; }
    const std::optional<Pick>& hover() const { return hover_; }
    // The brush's radius, also while it is being set with the mouse.
    double radius() const;
    bool is_setting_radius() const { return radius_drag_.has_value(); }
    FrameFigures figures() const;
    const IVec2& size() const { return size_; }
    bool shows_hint() const { return shows_hint_; }
    bool wants_to_end() const { return wants_to_end_; }
    bool has_cursor_in_viewport() const { return cursor_in_viewport_; }

    Display display{};
    DragOptions drag_options{.connected = true, .fold_free = true};
    bool sets_pins = false;  // whether a click on the surface sets or removes a pin

    // --- Dialogs. A dialog that is open takes all input.
    bool has_dialog() const { return browser || question || offered_session() || is_working(); }

    // Work on a file, an edit that takes long, or a restoration. A dialog shows its progress. Only
    // settings of the session may be used meanwhile.
    bool is_working() const { return restoration_ || workspace_.is_working(); }
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

    // --- Drags and pins (editor_drag.cpp).
    template <typename Part>
    bool attempt(Part part);
    void press_on_surface(const Vec2& at, const Pick& pick);
    Pick handle_at(Pick pick, const Vec2& at) const;
    Pick snapped_to_symmetry_plane(Pick pick) const;
    void grab(const Pick& pick, const Ray& ray);
    void drag();
    void continue_frame();
    void update_point_drag();
    void update_control_drag();
    void reset_figures();
    void record_frame(std::chrono::duration<double> taken);
    void release_drag();
    void finish_drag(Workspace::Outcome outcome);
    void abandon_drag() noexcept;
    void report_drag();
    void cancel_drag();
    void rotate_or_scale(double notches);

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
    View view() const { return {camera(), size_}; }
    // Whether a drag follows the mouse, or its end is being worked on.
    bool has_drag() const { return sculptor_.is_dragging() || cage_points_.is_active(); }
    bool is_busy() const { return has_drag() || radius_drag_ || is_working(); }
    void poll_work();
    void update_hover();
    void begin_radius_drag();
    void end_radius_drag(bool keeps);
    command::Symmetry symmetry_command(bool is_on) const;

    // Setting the radius: F is held, and the radius follows the mouse.
    struct RadiusDrag {
        double start_x, start_radius, radius;
    };

    Workspace workspace_;
    Navigation navigation_;
    Sculptor sculptor_;
    CagePoints cage_points_;
    Pins pins_;
    MirrorChoice mirror_;
    IVec2 size_{1280, 800};
    Vec2 cursor_{0.0};
    Modifiers modifiers_{};
    bool cursor_in_viewport_ = false;  // over the window and not over its panels
    bool drag_is_stale_ = false;       // the active drag must be updated in the next frame
    std::vector<Vec2> cursor_path_;    // of the cursor since the drag was updated
    Vec2 last_cursor_{0.0};            // the cursor at that update
    std::optional<Pick> hover_;
    std::optional<RadiusDrag> radius_drag_;
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
