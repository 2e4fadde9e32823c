// What the window works on: the session, the record of what is done to it, the file it is kept in
// and what there is to tell about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/recorder.h"
#include "geometry/box.h"
#include "session/session.h"

namespace pectin {

class Workspace {
  public:
    explicit Workspace(std::optional<Recorder> recorder = {}) : recorder_(std::move(recorder)) {}

    // Does and records it, or tells why not and leaves everything as it was.
    bool execute(const Command& command);
    // The same for a drag that the session has done already.
    void note_drag(const command::Drag& drag, bool has_changed);

    Session& session() { return session_; }
    const Session& session() const { return session_; }

    // Shown until dismissed or until the next command is done.
    void tell(std::string message) { message_ = std::move(message); }
    void dismiss() { message_.clear(); }
    const std::string& message() const { return message_; }

    // The file that is open; empty where the object is in none.
    const std::string& path() const { return path_; }
    // As a title shows it.
    std::string object_name() const;
    bool is_modified() const { return is_modified_; }
    // Of the object as it was opened.
    double diagonal() const { return diagonal_; }
    // Reach of the brush, whether it was set or follows from the object.
    double radius() const;

  private:
    void note(const Command& command);
    void record(const Command& command);

    Session session_;
    std::optional<Recorder> recorder_;
    std::string message_;
    std::string path_;
    std::string shape_name_ = "untitled";
    double diagonal_ = 1.0;
    bool is_modified_ = false;
};

}  // namespace pectin
