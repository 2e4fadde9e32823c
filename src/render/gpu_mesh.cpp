#include "render/gpu_mesh.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace pectin {
namespace {

// A call costs about as much as uploading a kilobyte, so gaps between changed slots are uploaded up
// to this size.
constexpr std::uint32_t kVertexGap = 1024 / sizeof(GpuVertex);
constexpr std::uint32_t kTriangleGap = 1024 / sizeof(GpuTriangle);
// Whole meshes are uploaded in pieces of at most this many elements.
constexpr std::uint32_t kMaxStaged = 1u << 18;

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <class Id>
void sort_distinct(std::span<const Id> ids, std::vector<std::uint32_t>& sorted) {
    sorted.clear();
    for (const Id id : ids) sorted.push_back(index(id));
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
}

// Calls write(first, end) for runs of sorted ids below `slots`, joining runs with gaps up to `gap`.
template <class Write>
void for_each_range(std::span<const std::uint32_t> sorted, std::uint32_t slots, std::uint32_t gap,
                    const Write& write) {
    const auto last = std::lower_bound(sorted.begin(), sorted.end(), slots);
    for (auto at = sorted.begin(); at != last;) {
        const std::uint32_t first = *at;
        std::uint32_t end = first + 1;
        for (++at; at != last && *at - end <= gap && *at - first < kMaxStaged; ++at) end = *at + 1;
        write(first, end);
    }
}

template <class Write>
void for_all(std::uint32_t slots, const Write& write) {
    for (std::uint32_t first = 0; first < slots; first += kMaxStaged) {
        write(first, std::min(slots, first + kMaxStaged));
    }
}

}  // namespace

bool GrowingBuffer::reserve(std::size_t elements) {
    if (elements <= capacity_) return false;
    const std::size_t capacity = std::max(elements, capacity_ + capacity_ / 2);
    GlBuffer larger(*gl_);
    gl_->BindBuffer(GL_COPY_WRITE_BUFFER, larger.name());
    gl_->BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity * element_bytes_),
                    nullptr, GL_DYNAMIC_DRAW);
    check_errors(*gl_, "the model");
    if (capacity_ > 0) {
        gl_->BindBuffer(GL_COPY_READ_BUFFER, buffer_.name());
        gl_->CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                               static_cast<GLsizeiptr>(capacity_ * element_bytes_));
    }
    buffer_ = std::move(larger);
    capacity_ = capacity;
    return true;
}

void GrowingBuffer::clear(std::size_t elements) {
    capacity_ = elements;
    gl_->BindBuffer(GL_COPY_WRITE_BUFFER, buffer_.name());
    gl_->BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(elements * element_bytes_),
                    nullptr, GL_DYNAMIC_DRAW);
    check_errors(*gl_, "the model");
}

void GrowingBuffer::write(std::size_t first, std::size_t count, const void* data) {
    assert(first + count <= capacity_);
    gl_->BindBuffer(GL_COPY_WRITE_BUFFER, buffer_.name());
    gl_->BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first * element_bytes_),
                       static_cast<GLsizeiptr>(count * element_bytes_), data);
}

GpuMesh::GpuMesh(const Gl& gl)
    : gl_(&gl),
      vertex_array_(gl),
      vertices_(gl, sizeof(GpuVertex)),
      triangles_(gl, sizeof(GpuTriangle)) {}

GpuMesh::Upload GpuMesh::upload(const TriMesh& mesh, const Vec3& centre) {
    centre_ = centre;
    bounds_ = Box{};
    face_slots_ = mesh.face_slots();
    wedge_vertices_.assign(mesh.wedge_slots(), kNone<VertexId>);
    for (std::uint32_t i = 0; i < face_slots_; ++i) record_corners(mesh, FaceId{i});
    vertices_.clear(mesh.wedge_slots());
    triangles_.clear(face_slots_);
    bind_buffers();
    Upload upload;
    for_all(mesh.wedge_slots(), [&](std::uint32_t first, std::uint32_t end) {
        write_vertices(mesh, first, end, upload);
    });
    for_all(face_slots_, [&](std::uint32_t first, std::uint32_t end) {
        write_triangles(mesh, first, end, upload);
    });
    return upload;
}

GpuMesh::Upload GpuMesh::upload(const TriMesh& mesh) {
    const Box box = mesh.bounding_box();
    return upload(mesh, box.is_empty() ? Vec3{0.0} : box.centre());
}

GpuMesh::Upload GpuMesh::update(const TriMesh& mesh, std::span<const WedgeId> wedges,
                                std::span<const FaceId> faces) {
    face_slots_ = mesh.face_slots();
    wedge_vertices_.resize(mesh.wedge_slots(), kNone<VertexId>);
    for (const FaceId f : faces) {
        if (index(f) < face_slots_) record_corners(mesh, f);
    }
    const bool new_vertices = vertices_.reserve(mesh.wedge_slots());
    const bool new_triangles = triangles_.reserve(face_slots_);
    if (new_vertices || new_triangles) bind_buffers();
    Upload upload;
    sort_distinct(wedges, sorted_);
    for_each_range(
        sorted_, mesh.wedge_slots(), kVertexGap,
        [&](std::uint32_t first, std::uint32_t end) { write_vertices(mesh, first, end, upload); });
    sort_distinct(faces, sorted_);
    for_each_range(sorted_, face_slots_, kTriangleGap, [&](std::uint32_t first, std::uint32_t end) {
        write_triangles(mesh, first, end, upload);
    });
    return upload;
}

void GpuMesh::record_corners(const TriMesh& mesh, FaceId f) {
    if (!mesh.is_live(f)) return;
    for (int corner = 0; corner < 3; ++corner) {
        const HalfEdgeId h = TriMesh::half_edge(f, corner);
        wedge_vertices_[index(mesh.wedge(h))] = mesh.origin(h);
    }
}

GpuVertex GpuMesh::vertex(const TriMesh& mesh, WedgeId w) const {
    const VertexId v = wedge_vertices_[index(w)];
    if (!exists(v) || index(v) >= mesh.vertex_slots() || !mesh.is_live(v)) return {};
    return {.position = Vec3f(mesh.position(v) - centre_),
            .normal = mesh.normal(w),
            .level = mesh.level(v),
            .deformed = static_cast<std::uint16_t>(mesh.is_deformed(v) ? 1 : 0)};
}

void GpuMesh::write_vertices(const TriMesh& mesh, std::uint32_t first, std::uint32_t end,
                             Upload& upload) {
    staged_vertices_.clear();
    for (std::uint32_t i = first; i < end; ++i) {
        staged_vertices_.push_back(vertex(mesh, WedgeId{i}));
        bounds_.include(centre_ + Vec3(staged_vertices_.back().position));
    }
    vertices_.write(first, staged_vertices_.size(), staged_vertices_.data());
    upload.bytes += staged_vertices_.size() * sizeof(GpuVertex);
    ++upload.ranges;
}

void GpuMesh::write_triangles(const TriMesh& mesh, std::uint32_t first, std::uint32_t end,
                              Upload& upload) {
    staged_triangles_.clear();
    for (std::uint32_t i = first; i < end; ++i) {
        GpuTriangle triangle{0u};
        for (int corner = 0; corner < 3 && mesh.is_live(FaceId{i}); ++corner) {
            triangle[corner] = index(mesh.wedge(TriMesh::half_edge(FaceId{i}, corner)));
        }
        staged_triangles_.push_back(triangle);
    }
    triangles_.write(first, staged_triangles_.size(), staged_triangles_.data());
    upload.bytes += staged_triangles_.size() * sizeof(GpuTriangle);
    ++upload.ranges;
}

void GpuMesh::bind_buffers() const {
    constexpr GLsizei kStride = sizeof(GpuVertex);
    gl_->BindVertexArray(vertex_array_.name());
    gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl_->EnableVertexAttribArray(0);
    gl_->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                             offset(offsetof(GpuVertex, position)));
    gl_->EnableVertexAttribArray(1);
    gl_->VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride,
                             offset(offsetof(GpuVertex, normal)));
    gl_->EnableVertexAttribArray(2);
    gl_->VertexAttribPointer(2, 2, GL_UNSIGNED_SHORT, GL_FALSE, kStride,
                             offset(offsetof(GpuVertex, level)));
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
    gl_->BindVertexArray(0);
}

void GpuMesh::draw() const {
    if (face_slots_ == 0) return;
    gl_->BindVertexArray(vertex_array_.name());
    gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * face_slots_), GL_UNSIGNED_INT,
                      nullptr);
    gl_->BindVertexArray(0);
}

}  // namespace pectin
