#include "io/obj_writer.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <string_view>
#include <vector>

#include "io/atomic_file.h"
#include "io/polygon_outline.h"

namespace pectin {
namespace {

// Text in large pieces to wherever it goes.
class TextBuffer {
  public:
    explicit TextBuffer(std::function<void(std::string_view)> sink)
        : sink_(std::move(sink)), bytes_(kSize, '\0') {}

    TextBuffer& operator<<(std::string_view text) {
        if (text.size() > kSize - used_) flush();
        if (text.size() > kSize) {
            sink_(text);
        } else {
            text.copy(bytes_.data() + used_, text.size());
            used_ += text.size();
        }
        return *this;
    }
    TextBuffer& operator<<(char c) {
        if (used_ == kSize) flush();
        bytes_[used_++] = c;
        return *this;
    }
    // The shortest decimal that reads back the same.
    template <typename Number>
    TextBuffer& number(Number n) {
        constexpr std::size_t kLongestNumber = 32;
        if (kLongestNumber > kSize - used_) flush();
        char* const begin = bytes_.data() + used_;
        used_ +=
            static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, n).ptr - begin);
        return *this;
    }
    void flush() {
        sink_(std::string_view(bytes_).substr(0, used_));
        used_ = 0;
    }

  private:
    static constexpr std::size_t kSize = std::size_t{1} << 20;
    std::function<void(std::string_view)> sink_;
    std::string bytes_;
    std::size_t used_ = 0;
};

// Numbers values (float vectors, by their bits) from 1 in the order they first come.
template <typename Value>
class UniqueValues {
  public:
    explicit UniqueValues(std::size_t most)
        : slots_(std::bit_ceil(2 * most + 2), 0), shift_(64 - std::countr_zero(slots_.size())) {}

    std::uint32_t number(const Value& value) {
        std::size_t slot = hash(value);
        while (slots_[slot] != 0) {
            if (bits(values_[slots_[slot] - 1]) == bits(value)) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        values_.push_back(value);
        return slots_[slot] = static_cast<std::uint32_t>(values_.size());
    }
    const std::vector<Value>& values() const { return values_; }

  private:
    using Bits = std::array<std::uint32_t, sizeof(Value) / sizeof(std::uint32_t)>;
    static Bits bits(const Value& value) { return std::bit_cast<Bits>(value); }
    std::size_t hash(const Value& value) const {
        std::uint64_t h = 0;
        for (std::uint32_t word : bits(value)) h = (h ^ word) * 0x9E3779B97F4A7C15u;  // Fibonacci
        return h >> shift_;
    }

    std::vector<std::uint32_t> slots_;  // numbers, 0 where empty
    int shift_;
    std::vector<Value> values_;
};

class ObjWriter {
  public:
    ObjWriter(const TriMesh& mesh, std::function<void(std::string_view)> sink)
        : mesh_(mesh), outline_(mesh), text_(std::move(sink)) {}

    void write() {
        order_faces();
        for (const std::string& name : mesh_.material_libraries()) write_name("mtllib", name);
        write_positions();
        write_wedges();
        write_faces();
        text_.flush();
    }

  private:
    void order_faces();
    void write_positions();
    void write_wedges();
    void write_faces();
    void write_polygon(FaceId first, FaceId last);
    void write_face(std::span<const HalfEdgeId> corners);
    void write_part(const Part& part);
    void write_name(std::string_view keyword, std::string_view name);
    std::span<const FaceId> pieces(FaceId first, FaceId last) const {
        return std::span(faces_).subspan(
            first_piece_[index(first)], first_piece_[index(last) + 1] - first_piece_[index(first)]);
    }
    template <typename Vector>
    void write_vector(std::string_view keyword, const Vector& v) {
        text_ << keyword;
        for (int i = 0; i < v.length(); ++i) (text_ << ' ').number(v[i]);
        text_ << '\n';
    }

    const TriMesh& mesh_;
    PolygonOutline outline_;
    TextBuffer text_;
    std::vector<FaceId> faces_;               // live ones in the order they are written
    std::vector<std::uint32_t> first_piece_;  // n_base_faces + 1; into faces_
    std::vector<std::uint32_t> vertices_;     // n_vertex_slots; from 1
    std::vector<std::uint32_t> uvs_;          // n_wedge_slots, or empty; from 1, 0 where none
    std::vector<std::uint32_t> normals_;      // n_wedge_slots; from 1, 0 where unused
    Part part_;                               // that of the last face written
};

// By base face, then by id: a counting sort.
void ObjWriter::order_faces() {
    first_piece_.assign(mesh_.base_face_count() + std::size_t{1}, 0);
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
        if (mesh_.is_live(FaceId{i})) ++first_piece_[index(mesh_.base_face(FaceId{i})) + 1];
    }
    std::partial_sum(first_piece_.begin(), first_piece_.end(), first_piece_.begin());
    faces_.resize(first_piece_.back());
    std::vector<std::uint32_t> at(first_piece_.begin(), first_piece_.end() - 1);
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
        const FaceId f{i};
        if (mesh_.is_live(f)) faces_[at[index(mesh_.base_face(f))]++] = f;
    }
}

void ObjWriter::write_positions() {
    vertices_.assign(mesh_.vertex_slots(), 0);
    std::uint32_t number = 0;
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
        if (!mesh_.is_live(VertexId{i})) continue;
        vertices_[i] = ++number;
        write_vector("v", mesh_.position(VertexId{i}));
    }
}

void ObjWriter::write_wedges() {
    UniqueValues<Vec2f> uvs(mesh_.has_uvs() ? mesh_.wedge_slots() : 0);
    UniqueValues<Vec3f> normals(mesh_.wedge_slots());
    uvs_.assign(mesh_.has_uvs() ? mesh_.wedge_slots() : 0, 0);
    normals_.assign(mesh_.wedge_slots(), 0);
    for (FaceId f : faces_) {
        for (int corner = 0; corner < 3; ++corner) {
            const WedgeId w = mesh_.wedge(TriMesh::half_edge(f, corner));
            if (normals_[index(w)] != 0) continue;
            normals_[index(w)] = normals.number(mesh_.normal(w));
            if (!mesh_.has_uvs() || std::isnan(mesh_.uv(w).x)) continue;
            uvs_[index(w)] = uvs.number(mesh_.uv(w));
        }
    }
    for (const Vec2f& uv : uvs.values()) write_vector("vt", uv);
    for (const Vec3f& normal : normals.values()) write_vector("vn", normal);
}

// Base faces that come from one polygon are neighbours.
void ObjWriter::write_faces() {
    const std::uint32_t count = mesh_.base_face_count();
    for (std::uint32_t first = 0, end = 0; first < count; first = end) {
        const std::uint32_t polygon = mesh_.polygon(FaceId{first});
        while (end < count && mesh_.polygon(FaceId{end}) == polygon) ++end;
        write_part(mesh_.part(FaceId{first}));
        write_polygon(FaceId{first}, FaceId{end - 1});
    }
}

void ObjWriter::write_polygon(FaceId first, FaceId last) {
    const std::span<const FaceId> faces = pieces(first, last);
    const std::size_t unsplit = index(last) - index(first) + std::size_t{1};
    if (unsplit > 1 && faces.size() == unsplit) {
        const std::span<const HalfEdgeId> corners = outline_.find(first, last);
        if (!corners.empty()) {
            write_face(corners);
            return;
        }
    }
    for (FaceId f : faces) {
        const std::array corners = {TriMesh::half_edge(f, 0), TriMesh::half_edge(f, 1),
                                    TriMesh::half_edge(f, 2)};
        write_face(corners);
    }
}

void ObjWriter::write_face(std::span<const HalfEdgeId> corners) {
    text_ << 'f';
    for (HalfEdgeId h : corners) {
        const std::uint32_t w = index(mesh_.wedge(h));
        (text_ << ' ').number(vertices_[index(mesh_.origin(h))]) << '/';
        if (!uvs_.empty() && uvs_[w] != 0) text_.number(uvs_[w]);
        (text_ << '/').number(normals_[w]);
    }
    text_ << '\n';
}

void ObjWriter::write_part(const Part& part) {
    if (part == part_) return;
    if (part.object != part_.object) write_name("o", part.object);
    if (part.group != part_.group) write_name("g", part.group);
    if (part.material != part_.material) write_name("usemtl", part.material);
    if (part.smoothing_group != part_.smoothing_group) {
        if (part.smoothing_group == 0) {
            text_ << "s off\n";
        } else {
            (text_ << "s ").number(part.smoothing_group) << '\n';
        }
    }
    part_ = part;
}

void ObjWriter::write_name(std::string_view keyword, std::string_view name) {
    text_ << keyword;
    if (!name.empty()) text_ << ' ' << name;
    if (name.ends_with('\\')) text_ << ' ';  // or it would continue the line
    text_ << '\n';
}

}  // namespace

std::string format_obj(const TriMesh& mesh) {
    std::string text;
    ObjWriter(mesh, [&text](std::string_view piece) { text.append(piece); }).write();
    return text;
}

void write_obj(const TriMesh& mesh, const std::string& path) {
    AtomicFile file(path);
    ObjWriter(mesh, [&file](std::string_view piece) { file.write(piece); }).write();
    file.commit();
}

}  // namespace pectin
