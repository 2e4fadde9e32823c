// Keeps what is done in a window, so that it can be restored after a crash or a signal.
//
// Every window writes its commands, as they are done, to a file of its own in the state folder and
// holds a lock on that file. A window that is closed removes its file. So a file without a lock is
// of a session that did not end as it should, and the next window offers to restore it.
//
// The commands act on the model as it was when it was opened. The file therefore notes the
// fingerprint of each model, and a save that is about to replace one first puts a copy of it beside
// the file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/model_copy.h"
#include "app/recorder.h"
#include "command/command.h"
#include "io/file_descriptor.h"

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
    // Leaves out commands that restoring does not need. fingerprint: of the model, where the
    // command opens one. Throws FileError where the command cannot be kept; then the file keeps
    // what came before, and later calls do nothing.
    void record(const Command& command, const std::string& fingerprint = {});
    bool has_failed() const { return has_failed_; }
    // The copies to make before a file is saved at this path: of the models that it replaces.
    std::vector<ModelCopy> copies_before_save(const std::string& path) const;
    // Where the copy of the model at a path with this fingerprint is put.
    std::string copy_path(const std::string& model, const std::string& fingerprint) const;
    // With its copies.
    void remove();

  private:
    Recorder recorder_;
    std::vector<ModelCopy> opened_;
    bool has_failed_ = false;
};

// A session that did not end as it should.
struct LostSession {
    std::string path;               // of its file
    std::string object;             // name of the model's file, or "untitled"
    std::vector<Command> commands;  // all that was done, in order
    // Of the models that the commands open; empty for other commands and where it is not known.
    std::vector<std::string> fingerprints;
    std::size_t unsaved = 0;  // how many of them changed the object after the last save
    // Locked, so that no other window offers the session meanwhile.
    FileDescriptor lock;
};

struct LostSessions {
    std::vector<LostSession> sessions;  // with unsaved changes, the latest first
    // Files that could not be read to their end. Each has a name now that is not looked for again.
    std::vector<std::string> damaged;
};

// Files of sessions without unsaved changes are removed, those of running windows left alone.
// A last line that was not written to its end is left out where the lines before have something
// to restore.
LostSessions find_lost_sessions(const std::string& folder);

// Where the session keeps the copy of the model at a path with this fingerprint, if it has one.
std::string copy_path(const LostSession& session, const std::string& model,
                      const std::string& fingerprint);

// Forgets a lost session, once it is restored or is not wanted.
void remove_lost_session(const LostSession& session);

// Keeps its file for the user, under a name that is not looked for again, and returns that.
std::string set_aside(const std::string& session_path);

// Whether restoring a session does this command again: all that make the object what it was, and
// none that write a file.
bool is_restored(const Command& command);

}  // namespace pectin
