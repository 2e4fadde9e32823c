#include "app/object_view.h"

#include <utility>

namespace pectin {

GpuMesh::Upload ObjectView::update(Session& session) {
    // Until the upload is complete, graphics memory may hold a part of it.
    const bool was_stale = std::exchange(is_stale_, true);
    const DirtyElements dirty = session.take_dirty();
    GpuMesh::Upload upload;
    if (dirty.everything || was_stale) {
        upload = mesh_.upload(session.mesh());
    } else if (!dirty.wedges.empty() || !dirty.faces.empty()) {
        upload = mesh_.update(session.mesh(), dirty.wedges, dirty.faces);
    }
    is_stale_ = false;
    return upload;
}

}  // namespace pectin
