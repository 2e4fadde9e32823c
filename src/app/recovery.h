// Keeps what is done in a window, so that it can be restored after a crash or a signal.
//
// Every window writes its commands, as they are done, to a file of its own in the state folder and
// holds a lock on that file. A window that is closed removes its file. So a file without a lock is
// of a session that did not end as it should, and the next window offers to restore it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/recorder.h"
#include "command/command.h"

namespace pectin {

// $XDG_STATE_HOME/pectin, or ~/.local/state/pectin; empty if the environment names neither folder.
std::string recovery_folder();

class RecoveryFile {
  public:
    // Creates the folder, if need be, and in it a locked file. Throws FileError.
    explicit RecoveryFile(const std::string& folder);
    // The file stays: only remove() says that the session has ended as it should.
    ~RecoveryFile() = default;
    RecoveryFile(RecoveryFile&&) = default;
    RecoveryFile& operator=(RecoveryFile&&) = default;

    const std::string& path() const { return recorder_.path(); }
    // Throws FileError, as Recorder::record() does.
    void record(const Command& command) { recorder_.record(command); }
    void remove();

  private:
    Recorder recorder_;
};

// A session that did not end as it should.
struct LostSession {
    std::string path;               // of its file
    std::string object;             // name of the model's file, or "untitled"
    std::vector<Command> commands;  // all that was done, in order
    std::size_t unsaved = 0;        // how many of them changed the object after the last save
};

// The lost sessions in the folder that have unsaved changes, the latest first. Files of those that
// have none are removed; files of running windows and files that are no scripts are left alone.
std::vector<LostSession> find_lost_sessions(const std::string& folder);

// Forgets a lost session, once it is restored or is not wanted.
void remove_lost_session(const LostSession& session);

// Whether restoring a session does this command again: all that make the object what it was, and
// none that write a file.
bool is_restored(const Command& command);

}  // namespace pectin
