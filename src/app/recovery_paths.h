// Names and locks of the files for recovery, which RecoveryFile writes and find_lost_sessions()
// reads.
//
// All of them are in the state folder:
//   recovery-PID-N.jsonl             commands of a session; its window holds a lock on the file
//   recovery-PID-N-model-WORD.obj    copy of a model with the fingerprint WORD
//   recovery-PID-N.jsonl.incomplete  commands that could not be restored, kept for the user
#pragma once

#include <string>

#include "io/file_descriptor.h"

namespace pectin {

// Begins the comment before a command that opens a model. The model's fingerprint follows.
inline constexpr const char* kFingerprintComment = "fingerprint: ";

// Returns $XDG_STATE_HOME/pectin, or ~/.local/state/pectin. The result is empty if the environment
// names neither folder.
std::string recovery_folder();

// The path of this process's recovery file with this number.
std::string recovery_path(const std::string& folder, int number);
bool is_recovery_path(const std::string& path);
std::string set_aside_path(const std::string& recovery_path);
// Where the copy of the model at a path is kept. It is read again in the format of that path.
std::string model_copy_path(const std::string& recovery_path, const std::string& model,
                            const std::string& fingerprint);

// Tries to lock the open recovery file without waiting. Returns false if another window holds the
// lock, or if the path no longer leads to this file.
bool lock_recovery_file(const std::string& recovery_path, const FileDescriptor& file);

// Removes a recovery file and the model copies that belong to it.
void remove_recovery_files(const std::string& recovery_path);

}  // namespace pectin
