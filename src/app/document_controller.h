// What the window does with its document: opening and saving with their dialogs, the question
// whether to save changes, work in the background, restoring lost sessions, and quitting.
// Independent of the window system and of rendering.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/actions.h"
#include "app/example.h"
#include "app/file_browser.h"
#include "app/restoration.h"
#include "app/workspace.h"

namespace pectin {

// A dialog that is open takes all input of the window.
class DocumentController {
  public:
    // What a controller needs to know of its owner, and what it tells it.
    class Delegate {
      public:
        // Whether the mouse or a key holds something, such as a drag. No command may be executed
        // meanwhile.
        virtual bool has_gesture() const = 0;
        // Called after each command that is done, and before anything that follows it.
        virtual void command_done(const Command& command) = 0;
        // Called when a restoration has ended, however it did. There may be another object now.
        virtual void restoration_ended() = 0;
        // Shows an example. Changes of the object may be discarded.
        virtual void begin_example(Example example) = 0;
        // The command that saves a picture of what the window shows.
        virtual command::Screenshot picture_command(const std::string& path) const = 0;

      protected:
        ~Delegate() = default;
    };

    // Both must outlive the controller. The delegate is not used before the first command.
    DocumentController(Workspace& workspace, Delegate& delegate)
        : workspace_(workspace), delegate_(delegate) {}

    // --- Commands and actions. They do nothing during a gesture and during work.
    bool execute(const Command& command);  // returns whether the command is already done
    // The same for a command that is not the user's: it leaves the message as it is.
    void execute_keeping_message(const Command& command);
    // Performs an action of the menu File; ignores all others.
    void perform(Action action);
    // Makes the object of a window that was given no model, or one that cannot be opened.
    void make_first_object();
    // These four ask first if changes would be lost.
    void open(const std::string& path);
    void begin_example(Example example);
    void new_shape(command::Shape::Kind kind, int resolution);
    void quit();  // also cancels the work, and quits when it has ended
    bool wants_to_end() const { return wants_to_end_; }

    // --- Dialogs.
    bool has_dialog() const { return browser_ || question_ || offered_session() || is_working(); }
    // Tells the open dialog that Enter was pressed.
    void press_enter() { enter_pressed_ = browser_ || question_ || offered_session(); }
    // Whether Enter was pressed in the open dialog since the last call.
    bool take_enter() { return std::exchange(enter_pressed_, false); }
    // Closes the open dialog, or cancels the work. Returns whether there was one.
    bool escape();

    // The file browser; null if it is closed.
    FileBrowser* browser() { return browser_ ? &*browser_ : nullptr; }
    const FileBrowser* browser() const { return browser_ ? &*browser_ : nullptr; }
    // Uses the file that is named in the browser and closes the browser. If this would replace
    // another file, the first call only sets file_to_replace(). Does nothing without a name.
    // Precondition: the browser is open.
    void accept_file();
    void close_browser();
    const std::string& file_to_replace() const { return file_to_replace_; }
    void keep_file() { file_to_replace_.clear(); }

    // The question whether to save the changes that an action would discard.
    struct Question {
        struct Quit {};
        std::variant<Quit, command::Open, command::Shape, Example> then;
    };
    // Null if nothing is asked.
    const Question* question() const { return question_ ? &*question_ : nullptr; }
    enum class Answer { save, discard, cancel };
    // Precondition: a question is asked.
    void answer(Answer answer);

    // --- Work: on a file, an edit that takes long, or a restoration. A dialog shows its progress.
    // Only settings of the session may be used meanwhile.
    bool is_working() const { return restoration_ || workspace_.is_working(); }
    // Continues the work, which may end. To be called once per frame while is_working(), except
    // while a drag ends in the background, which its tool waits for.
    void advance();
    void cancel_work();  // the work ends soon afterwards; does nothing without any
    // Quits if the user has asked for it during work. Called when a drag has ended in the
    // background.
    void continue_quitting();

    // --- Sessions that may be restored.
    // Offers these, one after the other.
    void offer(std::vector<LostSession> sessions) { lost_sessions_ = std::move(sessions); }
    // The session that is being offered; null if there is none, and during work on a file or edit.
    const LostSession* offered_session() const {
        return lost_sessions_.empty() || workspace_.is_working() ? nullptr
                                                                 : &lost_sessions_.front();
    }
    // restore: begins to restore the session, which advance() continues.
    // later: this session and the remaining ones are offered again at the next start.
    enum class RecoveryAnswer { restore, discard, later };
    // Precondition: a session is offered.
    void answer_recovery(RecoveryAnswer answer);
    const Restoration* restoration() const { return restoration_ ? &*restoration_ : nullptr; }

  private:
    bool is_busy() const { return delegate_.has_gesture() || is_working(); }
    bool has_object() const { return workspace_.session().mesh().face_slots() > 0; }
    bool finish_command(const Command& command, Workspace::Outcome outcome);

    std::string path_to_propose() const;
    void show_browser(FileBrowser::Purpose purpose, const std::string& path);
    void begin_save(std::optional<Question> next);
    void save(const std::string& path, std::optional<Question> next);
    void use_chosen_file(FileBrowser::Purpose purpose, const std::string& path);
    void ask_or_do(Question asked);
    void do_without_asking(const Question& asked);

    void continue_restoring();
    std::string end_restoring(const Restoration& ended, Restoration::State state);

    Workspace& workspace_;
    Delegate& delegate_;
    std::optional<FileBrowser> browser_;
    std::string file_to_replace_;
    std::optional<Question> question_;
    std::optional<Question> after_save_;  // to be done once a file to save to has been chosen
    std::optional<Question> next_;        // to be done once the present save is done
    bool quits_next_ = false;             // to quit once the work has ended
    std::vector<LostSession> lost_sessions_;
    std::optional<Restoration> restoration_;
    bool enter_pressed_ = false;
    bool wants_to_end_ = false;
};

}  // namespace pectin
