#include "app/object_view.h"

namespace pectin {

GpuMesh::Upload ObjectView::follow(Session& session) {
    const DirtyElements dirty = session.take_dirty();
    if (dirty.everything) return mesh_.upload(session.mesh());
    if (dirty.wedges.empty() && dirty.faces.empty()) return {};
    return mesh_.update(session.mesh(), dirty.wedges, dirty.faces);
}

}  // namespace pectin
