// The session's object in graphics memory. This class decides what is uploaded before a picture is
// drawn: the session says which elements have changed (DirtyElements), and GpuMesh writes them.
#pragma once

#include "render/gpu_mesh.h"
#include "session/session.h"

namespace pectin {

class ObjectView {
  public:
    explicit ObjectView(const Gl& gl) : mesh_(gl) {}

    // Uploads what has changed since the last call. If the last call threw, uploads everything.
    GpuMesh::Upload update(Session& session);

    const GpuMesh& mesh() const { return mesh_; }

  private:
    GpuMesh mesh_;
    DirtyElements dirty_;  // of the last update
    bool is_stale_ = false;
};

}  // namespace pectin
