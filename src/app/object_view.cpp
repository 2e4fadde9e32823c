#include "app/object_view.h"

#include <utility>

namespace pectin {

GpuMesh::Upload ObjectView::update(Session& session) {
    // Until the upload is complete, graphics memory may hold a part of it.
    const bool was_stale = std::exchange(is_stale_, true);
    session.take_dirty(dirty_);
    GpuMesh::Upload upload;
    if (dirty_.everything || was_stale) {
        upload = mesh_.upload(session.mesh());
    } else if (!dirty_.wedges.empty() || !dirty_.faces.empty()) {
        upload = mesh_.update(session.mesh(), dirty_.wedges, dirty_.faces);
    }
    is_stale_ = false;
    return upload;
}

}  // namespace pectin
