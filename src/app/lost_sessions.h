// Sessions that ended unexpectedly, as the next window finds them in the state folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "command/command.h"
#include "io/file_descriptor.h"

namespace pectin {

struct LostSession {
    std::string path;               // of its recovery file
    std::string object;             // name of the model's file, or "untitled"
    std::vector<Command> commands;  // all that were done, in order
    // For each command that opens a model, the model's fingerprint. Empty for other commands, and
    // if the fingerprint is not known.
    std::vector<std::string> fingerprints;
    std::size_t unsaved = 0;  // number of commands that changed the object after the last save
    // The file is locked, so that no other window offers the session at the same time.
    FileDescriptor lock;
};

struct LostSessions {
    std::vector<LostSession> sessions;  // those with unsaved changes, the latest first
    // Files that could not be read. They have been set aside under these paths.
    std::vector<std::string> damaged;
};

// Reads the recovery files of the folder. Files without unsaved changes are removed, and those of
// running windows are left alone. An incomplete last line is ignored if the lines before it hold
// unsaved changes.
LostSessions find_lost_sessions(const std::string& folder);

// The path where the session keeps a copy of the model with this fingerprint, if it has one.
std::string copy_path(const LostSession& session, const std::string& model,
                      const std::string& fingerprint);

// Removes the session's files, after it was restored or discarded.
void remove_lost_session(const LostSession& session);

// Renames a recovery file, so that it is kept for the user and not found again. Returns its path.
std::string set_aside(const std::string& recovery_path);

}  // namespace pectin
