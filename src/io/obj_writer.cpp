#include "io/obj_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "io/atomic_file.h"
#include "mesh/face_pieces.h"
#include "mesh/unshared_colors.h"
#include "mesh/unshared_vertices.h"

namespace pectin {
namespace {

// Passes text to a sink in large pieces.
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
    // Appends the shortest decimal that reads back the same.
    template <typename Number>
    TextBuffer& number(Number n) {
        constexpr std::size_t kMaxDigits = 32;
        if (kMaxDigits > kSize - used_) flush();
        char* const begin = bytes_.data() + used_;
        used_ += static_cast<std::size_t>(std::to_chars(begin, begin + kMaxDigits, n).ptr - begin);
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

// Numbers different float vectors, compared by their bits, from 1 in the order of their first use.
template <typename Value>
class UniqueValues {
  public:
    explicit UniqueValues(std::size_t max_values)
        : slots_(std::bit_ceil(2 * max_values + 2), 0),
          shift_(64 - std::countr_zero(slots_.size())) {}

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
        for (std::uint32_t word : bits(value))
            h = (h ^ word) * 0x9E3779B97F4A7C15u;  // Fibonacci hashing
        return h >> shift_;
    }

    std::vector<std::uint32_t> slots_;  // numbers of values; 0 if empty
    int shift_;
    std::vector<Value> values_;
};

// Reports progress every few thousand elements of a part of the work.
class Steps {
  public:
    Steps(const Progress& part, std::size_t elements)
        : part_(part), elements_(std::max<std::size_t>(elements, 1)) {}

    // done: the number of finished elements; must not decrease.
    void at(std::size_t done) {
        if (done < next_) return;
        constexpr std::size_t kElementsAStep = 4096;
        next_ = done + kElementsAStep;
        part_.advance(static_cast<double>(done) / static_cast<double>(elements_));
    }

  private:
    Progress part_;
    std::size_t elements_, next_ = 0;
};

class ObjWriter {
  public:
    ObjWriter(const TriMesh& mesh, const Progress& progress,
              std::function<void(std::string_view)> sink)
        : mesh_(mesh),
          progress_(progress),
          text_(std::move(sink)),
          pieces_(mesh),
          unshared_(mesh) {}

    void write() {
        for (const std::string& name : form().material_libraries) write_name("mtllib", name);
        write_positions();
        write_wedges();
        write_polygons();
        text_.flush();
    }

  private:
    struct Attributes {  // numbers from 1; 0 if there is none
        std::uint32_t uv = 0, normal = 0;
    };

    void write_positions();
    void write_wedges();
    void write_polygons();
    void write_polygon(const PolygonWalk& polygon);
    void write_outline(std::span<const OutlineCorner> corners);
    void write_triangle(FaceId f);
    void write_position(const Vec3& position, const Vec3f& color);
    void write_corner(std::uint32_t vertex, const Attributes& attributes);
    void write_corner(HalfEdgeId h);
    void write_elements_before(std::uint32_t polygon);
    void write_element(const InputForm::Element& element);
    void write_part(std::uint32_t id);
    void write_name(std::string_view keyword, std::string_view name);

    const InputForm& form() const { return mesh_.input_form(); }
    bool has_undefined_normals() const;
    bool is_written_as_outline(const PolygonWalk& polygon) const {
        return polygon.has_outline() && pieces_.are_whole(polygon.first_face(), polygon.end_face());
    }
    template <typename Vector>
    void write_vector(const Vector& v) {
        for (int i = 0; i < v.length(); ++i) (text_ << ' ').number(v[i]);
    }
    template <typename Vector>
    void write_values(std::string_view keyword, const std::vector<Vector>& values,
                      const Progress& part) {
        Steps steps(part, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            steps.at(i);
            text_ << keyword;
            write_vector(values[i]);
            text_ << '\n';
        }
    }

    // Where each part ends, as a fraction of the time that writing takes.
    static constexpr double kPositions = 0.35, kNumbered = 0.5, kUvs = 0.55, kNormals = 0.75;

    const TriMesh& mesh_;
    const Progress& progress_;
    TextBuffer text_;
    FacePieces pieces_;
    UnsharedVertices unshared_;
    std::vector<std::uint32_t>
        vertices_;  // numbers from 1 by vertex slot, then of those added along seams
    std::vector<Attributes> wedges_;  // by wedge slot
    std::vector<Attributes> loose_;   // by loose corner
    // For corners with an undefined normal: the number of the normal of the face, if it has area.
    std::map<HalfEdgeId, std::uint32_t> face_normals_;
    std::vector<std::uint32_t> element_uvs_;
    std::uint32_t elements_written_ = 0;
    Part part_;  // of the last face or element that was written
};

void ObjWriter::write_positions() {
    vertices_.assign(mesh_.vertex_slots(), 0);
    std::uint32_t number = 0;
    const std::optional<std::vector<Vec3f>> colors = unshared_colors(mesh_, unshared_);
    const auto color = [&](VertexId v) {
        constexpr Vec3f kNoColor{std::numeric_limits<float>::quiet_NaN()};
        if (colors) return (*colors)[index(v)];
        return mesh_.has_colors() ? mesh_.color(v) : kNoColor;
    };
    Steps steps(progress_.part(0.0, kPositions), mesh_.vertex_slots());
    for (std::uint32_t i = 0; i < mesh_.vertex_slots(); ++i) {
        steps.at(i);
        const VertexId v{i};
        if (!mesh_.is_live(v)) continue;
        vertices_[i] = ++number;
        write_position(unshared_.position(v), color(v));
    }
    for (const VertexId v : unshared_.added()) {
        const auto added = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(++number);
        write_position(mesh_.position(v), colors ? (*colors)[added] : color(v));
    }
}

void ObjWriter::write_position(const Vec3& position, const Vec3f& color) {
    text_ << 'v';
    write_vector(position);
    if (!std::isnan(color.x)) write_vector(color);
    text_ << '\n';
}

bool ObjWriter::has_undefined_normals() const {
    for (std::uint32_t i = 0; i < mesh_.wedge_slots(); ++i) {
        if (mesh_.normal(WedgeId{i}) == Vec3f{0.0f}) return true;
    }
    return false;
}

void ObjWriter::write_wedges() {
    const std::size_t loose = form().loose_corners.size() + form().element_corners.size();
    UniqueValues<Vec2f> uvs(mesh_.has_uvs() ? mesh_.wedge_slots() + loose : loose);
    // One normal per face can replace undefined normals of its corners.
    const std::size_t faces = has_undefined_normals() ? pieces_.all().size() : 0;
    UniqueValues<Vec3f> normals(mesh_.wedge_slots() + loose + faces);
    const auto number_of = [&](const Vec2f& uv) { return std::isnan(uv.x) ? 0 : uvs.number(uv); };
    const auto number_of_normal = [&](const Vec3f& normal) {
        return normal == Vec3f{0.0f} ? 0 : normals.number(normal);
    };
    const auto number_corner = [&](HalfEdgeId h) {
        const WedgeId w = mesh_.wedge(h);
        Attributes& wedge = wedges_[index(w)];
        if (wedge.normal != 0) return;
        wedge.normal = number_of_normal(mesh_.normal(w));
        if (mesh_.has_uvs()) wedge.uv = number_of(mesh_.uv(w));
        if (wedge.normal != 0) return;
        const Vec3f of_face{unit_or_zero(mesh_.area_normal(TriMesh::face(h)))};
        if (const std::uint32_t n = number_of_normal(of_face)) face_normals_.emplace(h, n);
    };
    wedges_.assign(mesh_.wedge_slots(), {});
    // Numbers follow the order in which corners are written, so they do not depend on the diagonals
    // of polygons. Corners that belong to no triangle come last.
    Steps steps(progress_.part(kPositions, kNumbered), mesh_.base_face_count());
    for (PolygonWalk polygon(mesh_); polygon.next();) {
        steps.at(polygon.first_face());
        if (is_written_as_outline(polygon)) {
            for (const OutlineCorner& corner : polygon.outline()) {
                if (!corner.is_loose()) number_corner(corner.half_edge());
            }
            continue;
        }
        for (FaceId f : pieces_.of(polygon.first_face(), polygon.end_face())) {
            for (int corner = 0; corner < 3; ++corner) number_corner(TriMesh::half_edge(f, corner));
        }
    }
    loose_.resize(form().loose_corners.size());
    for (PolygonWalk polygon(mesh_); polygon.next();) {
        if (!is_written_as_outline(polygon)) continue;
        for (const OutlineCorner& corner : polygon.outline()) {
            if (!corner.is_loose()) continue;
            const LooseCorner& loose_corner = form().loose_corners[corner.loose_index()];
            loose_[corner.loose_index()] = {number_of(loose_corner.uv),
                                            number_of_normal(loose_corner.normal)};
        }
    }
    for (const LooseCorner& corner : form().element_corners) {
        element_uvs_.push_back(number_of(corner.uv));
    }
    write_values("vt", uvs.values(), progress_.part(kNumbered, kUvs));
    write_values("vn", normals.values(), progress_.part(kUvs, kNormals));
}

void ObjWriter::write_polygons() {
    PolygonWalk polygon(mesh_);
    Steps steps(progress_.part(kNormals, 1.0), mesh_.base_face_count());
    while (polygon.next()) {
        steps.at(polygon.first_face());
        write_elements_before(polygon.polygon());
        write_part(polygon.part());
        write_polygon(polygon);
    }
    write_elements_before(std::numeric_limits<std::uint32_t>::max());
}

void ObjWriter::write_polygon(const PolygonWalk& polygon) {
    if (is_written_as_outline(polygon)) {
        write_outline(polygon.outline());
    } else {
        for (FaceId f : pieces_.of(polygon.first_face(), polygon.end_face())) write_triangle(f);
    }
}

void ObjWriter::write_outline(std::span<const OutlineCorner> corners) {
    text_ << 'f';
    for (const OutlineCorner& corner : corners) {
        if (corner.is_loose()) {
            const std::uint32_t i = corner.loose_index();
            write_corner(index(form().loose_corners[i].vertex), loose_[i]);
        } else {
            write_corner(corner.half_edge());
        }
    }
    text_ << '\n';
}

void ObjWriter::write_triangle(FaceId f) {
    text_ << 'f';
    for (int corner = 0; corner < 3; ++corner) write_corner(TriMesh::half_edge(f, corner));
    text_ << '\n';
}

void ObjWriter::write_corner(HalfEdgeId h) {
    Attributes attributes = wedges_[index(mesh_.wedge(h))];
    if (attributes.normal == 0) {
        const auto of_face = face_normals_.find(h);
        if (of_face != face_normals_.end()) attributes.normal = of_face->second;
    }
    write_corner(unshared_.of(h), attributes);
}

void ObjWriter::write_corner(std::uint32_t vertex, const Attributes& attributes) {
    (text_ << ' ').number(vertices_[vertex]);
    if (attributes.uv != 0 || attributes.normal != 0) text_ << '/';
    if (attributes.uv != 0) text_.number(attributes.uv);
    if (attributes.normal != 0) (text_ << '/').number(attributes.normal);
}

void ObjWriter::write_elements_before(std::uint32_t polygon) {
    const auto& elements = form().elements;
    while (elements_written_ < elements.size() &&
           elements[elements_written_].before_polygon <= polygon) {
        write_element(elements[elements_written_++]);
    }
}

void ObjWriter::write_element(const InputForm::Element& element) {
    write_part(element.part);
    text_ << (element.kind == InputForm::Element::Kind::line ? 'l' : 'p');
    const std::span<const LooseCorner> corners = form().corners(element);
    const std::size_t first =
        static_cast<std::size_t>(corners.data() - form().element_corners.data());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        (text_ << ' ').number(vertices_[index(corners[i].vertex)]);
        if (element_uvs_[first + i] != 0) (text_ << '/').number(element_uvs_[first + i]);
    }
    text_ << '\n';
}

void ObjWriter::write_part(std::uint32_t id) {
    const Part& part = form().parts[id];
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
    if (name.ends_with('\\')) text_ << ' ';  // a final backslash would continue the line
    text_ << '\n';
}

}  // namespace

std::string format_obj(const TriMesh& mesh) {
    std::string text;
    const Progress unseen;
    ObjWriter(mesh, unseen, [&text](std::string_view piece) { text.append(piece); }).write();
    return text;
}

void write_obj(const TriMesh& mesh, const std::string& path, const Progress& progress) {
    AtomicFile file(path);
    ObjWriter(mesh, progress, [&file](std::string_view piece) { file.write(piece); }).write();
    progress.advance(1.0);
    file.commit();
}

}  // namespace pectin
