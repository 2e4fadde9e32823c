// What the window works on: the session, the record of what is done to it, the file it is kept in
// and what there is to tell about it.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "app/background_task.h"
#include "app/recorder.h"
#include "app/recovery.h"
#include "geometry/box.h"
#include "session/session.h"

namespace pectin {

// How long a file may keep everything waiting; what takes longer is done in the background.
inline constexpr std::chrono::milliseconds kPatience{200};

class Workspace {
  public:
    // patience: with 0 every file is under way first.
    explicit Workspace(std::optional<Recorder> recorder = {},
                       std::chrono::milliseconds patience = kPatience)
        : recorder_(std::move(recorder)), patience_(patience) {}

    // The file of the record; empty if nothing is recorded.
    std::string record_path() const { return recorder_ ? recorder_->path() : ""; }
    // Keeps a second record, of all that is done from now on, in this folder for recovery. Tells
    // if it cannot.
    void begin_recovery(const std::string& folder);
    // The session ends as it should: nothing of it has to be recovered.
    void end_recovery();
    // Whether all that is done is kept.
    bool has_recovery() const { return recovery_ && !recovery_->has_failed(); }

    enum class Outcome { done, failed, under_way };
    // Does and records it, or tells why not and leaves everything as it was. A file that takes
    // longer is under way then: it is read or written in the background, the object stays as it is
    // until poll() says otherwise, and all commands fail.
    Outcome execute(const Command& command);
    // The same for a drag, of points or of control points, that the session has done already.
    void record_drag(const Command& drag, bool has_changed);

    // --- Restoring another session.
    // Begins as a new window does, with default settings and without an object. The records get
    // the commands that reset the settings.
    void begin_anew();
    // Opens a model as execute() does, with the contents it had for that session.
    Outcome reopen(const command::Open& open, const LostSession& session,
                   const std::string& fingerprint);
    // The session saved here then: the file stays as it is, and is the one that the object is in.
    void pass_over(const command::Save& save);
    // The object is in no file any more, so that a save asks for one.
    void forget_path() { path_.clear(); }

    // --- A file that is under way.
    struct FileTask {
        struct Result {
            std::optional<LoadedModel> model{};  // that was read
            std::string fingerprint{};           // of its file; empty if nobody needs it
            std::string report{};                // on what was written
            std::string warning{};               // about recovery
        };
        FileTask(Command begun, std::function<Result(const Progress&)> how)
            : command(std::move(begun)), work(std::move(how)) {}

        Command command;  // open or save
        BackgroundTask<Result> work;
    };
    const FileTask* file_task() const { return file_task_.get(); }
    // What has become of it, waiting for that as long as this. Where it is done or has failed it
    // is there no more; that it was cancelled, which is a failure, too, is not told.
    // Precondition: there is one.
    Outcome poll(std::chrono::milliseconds longest_wait = {});
    void cancel_file_task() { file_task_->work.cancel(); }

    // As Session::set_viewport; also for the session of begin_anew().
    void set_viewport(Viewport* viewport);
    Session& session() { return session_; }
    const Session& session() const { return session_; }

    // --- Messages, as printable() text.
    // Stands until the next command is done or the next drag begins.
    void set_message(const std::string& message);
    const std::string& command_message() const { return command_message_; }
    void clear_command_message() { command_message_.clear(); }
    // Stands until it is dismissed.
    void add_notice(const std::string& message);
    // All of them, one a line.
    std::string message() const;
    void dismiss();

    // The file that is open; empty where the object is in none.
    const std::string& path() const { return path_; }
    // As a title shows it.
    std::string object_name() const;
    bool is_modified() const { return is_modified_; }
    // Of the object as it was opened.
    const Box& box() const { return box_; }
    double diagonal() const { return diagonal_; }
    // Reach of the brush, whether it was set or follows from the object.
    double radius() const;

  private:
    using FileWork = std::function<FileTask::Result(const Progress&)>;
    template <typename MakeWork>
    Outcome carry_out(const Command& command, MakeWork make_work);
    FileWork file_work(const Command& command) const;
    FileWork opening(const command::Open& open) const;
    FileWork saving(const command::Save& save) const;
    void finish(const Command& command, const std::string& fingerprint = {});
    void update_file_state(const Command& command);
    void record(const Command& command, const std::string& fingerprint = {});
    void keep(const Command& command, const std::string& fingerprint = {});

    Session session_;
    Viewport* viewport_ = nullptr;
    std::optional<Recorder> recorder_;
    std::optional<RecoveryFile> recovery_;
    std::chrono::milliseconds patience_;
    std::string command_message_, notices_;
    std::string path_;
    std::string shape_name_ = "untitled";
    Box box_;
    double diagonal_ = 1.0;
    bool is_modified_ = false;
    std::unique_ptr<FileTask> file_task_;  // last: it looks at the session's mesh
};

}  // namespace pectin
