// The window's mind: mouse and keys in; commands, a camera and what there is to show out. Knows no
// window system and draws nothing.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/cage_points.h"
#include "app/file_browser.h"
#include "app/input_event.h"
#include "app/navigation.h"
#include "app/pins.h"
#include "app/restoration.h"
#include "app/sculptor.h"
#include "app/shortcuts.h"
#include "app/view.h"
#include "app/workspace.h"

namespace pectin {

struct Display {
    bool wireframe = false, levels = false;
    bool lattice = false;  // also while nothing is dragged; a cage can be taken hold of then
    bool symmetry_plane = true;
};

// The plane that symmetry gets when it is switched on.
struct MirrorChoice {
    command::Symmetry::Plane plane = command::Symmetry::Plane::x;
    bool through_centre = false;  // of the object as it was opened; else through the origin
};

// Of the last frame that changed the object by a drag.
struct FrameFigures {
    std::uint64_t splits = 0, unsplits = 0;
    double seconds = 0.0;  // all of the frame but the picture
    double deform_seconds = 0.0, refine_seconds = 0.0, decimate_seconds = 0.0;
    bool floor_hit = false, budget_hit = false;
    std::size_t steps = 1;              // that a fold-free drag is made of
    double degrees = 0.0, scale = 1.0;  // twist and scale at the grabbed point
    std::uint64_t folded = 0;           // vertices, once the drag is done
};

// What the user interface keeps for itself of what a person does.
struct UiClaims {
    bool mouse = false, keyboard = false;
};

class Editor {
  public:
    explicit Editor(std::optional<Recorder> recorder = {},
                    std::chrono::milliseconds patience = kPatience);

    // --- Input.
    void handle(const InputEvent& event, const UiClaims& claims = {});
    // Once a frame, after its events: moves the active drag, looks what has become of a file that
    // is under way, goes on restoring a session, or looks what is under the cursor.
    void advance();

    // There is no memory for something, such as "frame": gives up the active drag and says so.
    void give_up_for_memory(const char* what) noexcept;

    // --- What menus, panels and keys ask for. Nothing happens during a drag, nor while a file is
    // under way: all there is then is to cancel it.
    void perform(Action action);
    bool execute(const Command& command);  // whether it is done already
    // What the window begins with: the model or, where none is given or it cannot be opened, a
    // sphere.
    void begin(const std::string& model);
    // Those that would lose changes ask first.
    void open(const std::string& path);
    void new_shape(command::Shape::Kind kind, int resolution);
    void quit();                     // cancels a file that is under way first
    void set_radius(double radius);  // kept within sensible bounds
    // As far as the object's size goes.
    double least_radius() const;
    double most_radius() const;
    void set_symmetry(bool is_on);
    void choose_mirror(const MirrorChoice& choice);  // symmetry that is on follows
    // As a box with control points in it, whatever has been in use.
    void set_cage(const Box& box, const IVec3& counts);

    // --- What there is to show.
    Workspace& workspace() { return workspace_; }
    const Workspace& workspace() const { return workspace_; }
    const Session& session() const { return workspace_.session(); }
    const Camera& camera() const { return navigation_.camera(); }
    const Sculptor& sculptor() const { return sculptor_; }
    const CagePoints& cage_points() const { return cage_points_; }
    // The cage, while its control points can be taken hold of.
    std::optional<Lattice> editable_cage() const;
    const Pins& pins() const { return pins_; }
    const MirrorChoice& mirror_choice() const { return mirror_; }
    const std::optional<Pick>& hover() const { return hover_; }
    // Reach of the brush, also while it is being set.
    double radius() const;
    bool is_setting_radius() const { return radius_drag_.has_value(); }
    FrameFigures figures() const;
    const IVec2& size() const { return size_; }
    bool shows_hint() const { return shows_hint_; }
    bool wants_to_end() const { return wants_to_end_; }

    Display display{};
    DragOptions drag_options{.connected = true, .fold_free = true};
    bool sets_pins = false;  // a click on the surface sets or removes one, in place of a drag
    // --- Dialogs, while they are open; one more tells of a file that is under way.
    bool has_dialog() const { return browser || question || offered_session() || is_working(); }
    // Whether a file is under way or a session is being restored.
    bool is_working() const { return restoration_ || workspace_.file_task(); }
    const Restoration* restoration() const { return restoration_ ? &*restoration_ : nullptr; }
    void cancel_work();  // where there is some; it ends soon
    std::optional<FileBrowser> browser{};
    // Does with the file named in the browser what it is for and closes it; asks first where a
    // file would be replaced, and does nothing where no file is named.
    void accept_file();
    void close_browser();  // without a choice
    // The file that accept_file would replace, once it has been asked for.
    const std::string& file_to_replace() const { return file_to_replace_; }
    void keep_file() { file_to_replace_.clear(); }
    // Whether Enter was pressed since it was last asked, for the dialog that is open.
    bool take_enter() { return std::exchange(enter_, false); }
    // A thing to do that would lose changes.
    struct Question {
        struct Quit {};
        std::variant<Quit, command::Open, command::Shape> then;
    };
    std::optional<Question> question{};
    enum class Answer { save, discard, cancel };
    void answer(Answer answer);
    // Asks, for one after the other, whether these are to be restored.
    void offer(std::vector<LostSession> sessions) { lost_sessions_ = std::move(sessions); }
    // The one being asked for; null if none is, and while a file is under way.
    const LostSession* offered_session() const {
        return lost_sessions_.empty() || workspace_.file_task() ? nullptr : &lost_sessions_.front();
    }
    // restore: begins it; advance() goes on with it. later: it is offered again at the next start,
    // like all that were not asked for.
    enum class RecoveryAnswer { restore, discard, later };
    void answer_recovery(RecoveryAnswer answer);

  private:
    void on(const event::Press& press, bool is_claimed);
    void on(const event::Release& release);
    void on(const event::Move& move, bool is_claimed);
    void on(const event::Scroll& scroll);
    void on(const event::KeyDown& key, bool is_claimed);
    void on(const event::KeyUp& key);
    void on(const event::Drop& drop);

    View view() const { return {camera(), size_}; }
    // --- Of points of the surface and of control points (editor_drag.cpp).
    template <typename Part>
    bool attempt(Part part);
    void press_left(const Vec2& at, const Pick& pick);
    Pick handle_at(Pick pick, const Vec2& at) const;
    Pick onto_plane(Pick pick) const;
    void grab(const Pick& pick, const Ray& ray);
    void drag();
    void update_point_drag();
    void update_control_drag();
    void begin_figures();
    void record_frame(std::chrono::duration<double> taken);
    void release_drag();
    void end_drag(const Command& done, std::size_t steps_before);
    void cancel_drag();
    void rotate_or_scale(double notches);
    void toggle_pin();

    void update_hover();
    void begin_radius_drag();
    void end_radius_drag(bool keeps);
    void frame_all(const std::optional<Vec3>& direction = {});
    bool conclude(const Command& command, Workspace::Outcome outcome);
    void begin_object();
    void begin_save();
    void save(const std::string& path, std::optional<Question> next);
    bool escape_dialog();
    void go_on_restoring();
    void use_file(FileBrowser::Purpose purpose, const std::string& path);
    void ask_or_do(Question question);
    void carry_out(const Question& question);
    bool escape_gesture();
    void escape_state();
    void perform_on_file(Action action);
    void perform_on_view(Action action);
    bool is_busy() const {
        return sculptor_.is_dragging() || cage_points_.is_active() || radius_drag_ || is_working();
    }

    // F and a move of the mouse: the radius doubles over kPixelsPerDoubling.
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
    bool cursor_is_ours_ = false;  // over the window and not over its panels
    bool moved_ = false;           // the active drag has to follow
    std::vector<Vec2> path_;       // of the cursor, since it has followed last
    Vec2 last_cursor_{0.0};        // where the cursor was then
    std::optional<Pick> hover_;
    std::optional<RadiusDrag> radius_drag_;
    FrameFigures figures_;
    std::optional<Question> after_save_;  // once the browser has a file for it
    std::optional<Question> next_;        // once the save that is under way is done
    bool quits_next_ = false;             // once the file that is under way is gone
    std::string file_to_replace_;
    std::vector<LostSession> lost_sessions_;
    std::optional<Restoration> restoration_;
    bool enter_ = false;
    bool shows_hint_ = true;
    bool wants_to_end_ = false;
};

}  // namespace pectin
