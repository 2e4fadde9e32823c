// What the window works on: the session, the files of its object and its commands, and the messages
// about them.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/command_log.h"
#include "app/edit_task.h"
#include "app/file_task.h"
#include "app/lost_sessions.h"
#include "app/messages.h"
#include "geometry/box.h"
#include "session/input_summary.h"
#include "session/session.h"

namespace pectin {

// The longest time for which reading or writing a file may block the window. Work that takes longer
// continues in the background.
inline constexpr std::chrono::milliseconds kMaxBlockingTime{200};

// What the window shows of the object and its history.
struct ObjectFigures {
    std::uint64_t faces = 0;
    bool is_refined = false;
    AdaptOutcome outcome{};
    std::size_t undo_steps = 0, redo_steps = 0;
    std::size_t lost_undo_steps = 0;  // that the limit has dropped
    std::size_t undo_bytes = 0;
    std::optional<std::size_t> undo_limit{};  // in bytes
};

class Workspace {
  public:
    // max_blocking_time: if 0, all work on files is done in the background.
    explicit Workspace(std::optional<Recorder> recorder = {},
                       std::chrono::milliseconds max_blocking_time = kMaxBlockingTime)
        : log_(std::move(recorder)), max_blocking_time_(max_blocking_time) {}

    // The path of the record; empty if nothing is recorded.
    std::string record_path() const { return log_.record_path(); }
    // Keeps all commands from now on in a recovery file in this folder. If that is not possible, a
    // notice says so.
    void begin_recovery(const std::string& folder) { log_.begin_recovery(folder, messages_); }
    // Removes the recovery file, since the session has ended normally.
    void end_recovery() { log_.end_recovery(); }
    // Whether all commands since begin_recovery() are kept.
    bool has_recovery() const { return log_.has_recovery(); }

    enum class Outcome { done, failed, in_progress };
    // Executes and records the command. If it fails, the message says why and nothing has changed.
    // Work on a file that takes longer than max_blocking_time, or an edit that takes longer than
    // the limit for edits, is in_progress: it continues in the background, and until poll() says
    // that it has ended all commands fail, and only settings of the session may be used.
    Outcome execute(const Command& command);
    // Ends the active drag of points or control points in the same way, and records it if it has
    // moved anything (has_moved()). If memory runs out, the drag may still be active afterwards.
    Outcome end_drag();
    bool has_moved() const { return has_moved_; }
    // How long an edit may block the window; by default as long as it takes.
    void set_max_edit_time(std::chrono::milliseconds time) { max_edit_time_ = time; }

    // --- Restoring another session.
    // Replaces the session by a new one with default settings and without an object. The commands
    // that reset the settings are recorded.
    void reset_session();
    // Opens a model as execute() does, with the contents that it had in the lost session.
    Outcome reopen(const command::Open& open, const LostSession& session,
                   const std::string& fingerprint);
    // Takes note that the lost session saved its object here. The file is not written.
    void skip_save(const command::Save& save);
    // Forgets the object's file, so that the next save asks for one. The object counts as modified.
    void clear_path();

    // --- Work in the background: a file that is being read or written, or an edit.
    // Null if there is none.
    const FileTask* file_task() const { return file_task_.get(); }
    const EditTask* edit_task() const { return edit_task_.get(); }
    bool is_working() const { return file_task_ || edit_task_; }
    // Waits for the work for at most this time. If it has ended, its command is finished and the
    // task is removed. Cancelled work fails without a message.
    // Precondition: is_working().
    Outcome poll(std::chrono::milliseconds longest_wait = {});
    // Precondition: is_working().
    void cancel_work();

    // As Session::set_viewport(), also for the session after reset_session().
    void set_viewport(Viewport* viewport);
    // The same for Session::set_frame_time().
    void set_frame_time(std::chrono::milliseconds time);
    // If a frame time is set: gives the next frame that time, or as little as possible if it will
    // not be shown.
    void limit_frame_time(bool is_shown);
    Session& session() { return session_; }
    const Session& session() const { return session_; }

    // --- Messages to the user; see Messages.
    void set_message(const std::string& message, Messages::Kind kind = Messages::Kind::warning) {
        messages_.set(message, kind);
    }
    const std::string& command_message() const { return messages_.command_message(); }
    Messages::Kind command_message_kind() const { return messages_.command_kind(); }
    void clear_command_message() { messages_.clear_command_message(); }
    void add_notice(const std::string& message) { messages_.add_notice(message); }
    std::string message() const { return messages_.text(); }
    bool message_is_confirmation() const { return messages_.is_confirmation(); }
    bool message_warns() const { return messages_.has_warning(); }
    void dismiss() { messages_.dismiss(); }

    // --- The object.
    // During an edit these are the figures before it.
    ObjectFigures object_figures() const;
    // The path of its file; empty if it is in none.
    const std::string& path() const { return path_; }
    // Its name for titles.
    std::string object_name() const;
    // Whether it is in another state than when it was last opened or saved, or made as a shape.
    // Undo and redo can return to that state. During an edit this is the answer before it.
    bool is_modified() const { return is_modified_; }
    // The bounding box, and its diagonal, of the object as it was opened.
    const Box& box() const { return box_; }
    double diagonal() const { return diagonal_; }
    // The brush's radius; if it is not set, it follows from the object's size.
    double radius() const;

  private:
    template <typename MakeWork>
    Outcome run(const Command& command, MakeWork make_work);
    template <typename... Arguments>
    Outcome begin_edit(const Arguments&... arguments);
    Outcome poll_file(std::chrono::milliseconds longest_wait);
    Outcome poll_edit(std::chrono::milliseconds longest_wait);
    void finish_edit(const EditTask& task, const EditResult& result);
    void confirm_save(const std::string& path, const SaveReport& report = {});
    void report_input(const InputFindings& findings);
    ObjectFigures figures_now() const;
    FileWork file_work(const Command& command) const;
    Outcome fail(const Refusal& refusal);
    void finish(const Command& command, const std::string& fingerprint = {});
    void begin_object(std::string path);
    void update_file_state(const Command& command);
    void set_saved_state(std::optional<std::uint64_t> state);
    void update_modified();
    void record(const Command& command, const std::string& fingerprint = {}) {
        log_.record(command, fingerprint, messages_);
    }

    Session session_;
    Viewport* viewport_ = nullptr;
    std::optional<std::chrono::milliseconds> frame_time_;
    CommandLog log_;
    Messages messages_;
    std::chrono::milliseconds max_blocking_time_;
    std::chrono::milliseconds max_edit_time_ = std::chrono::hours(24);
    ObjectFigures figures_before_edit_;
    bool has_moved_ = false;  // the last drag that ended
    std::string path_;
    std::string shape_name_ = "untitled";
    Box box_;
    double diagonal_ = 1.0;
    // History::state_id() of the state that was last opened, saved or made as a shape. Nothing if
    // the object may differ from its file in every state.
    std::optional<std::uint64_t> saved_state_ = session_.history().state_id();
    bool is_modified_ = false;  // kept, since an edit in the background uses the history
    // Last, so that they end before the mesh that they use.
    std::unique_ptr<FileTask> file_task_;
    std::unique_ptr<EditTask> edit_task_;
};

}  // namespace pectin
