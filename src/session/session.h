// Commands in, mesh changes out: the one thing that window, script and tests talk to.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "command/command.h"
#include "command/statistics.h"
#include "mesh/tri_mesh.h"

namespace pectin {

class Session {
  public:
    Session();
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    // Does it, or says why not and leaves everything as it was. Paths are used as they are.
    // Throws what io throws (FileError) for files; the object is then as it was, too.
    std::optional<std::string> execute(const Command& command);

    const TriMesh& mesh() const;
    Statistics statistics() const;  // O(n)

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace pectin
