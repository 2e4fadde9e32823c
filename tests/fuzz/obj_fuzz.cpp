// Reads arbitrary bytes as an OBJ file. They must be refused or become a valid mesh, whose save
// contains everything that was read.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/expect.h"
#include "io/file_error.h"
#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"

namespace {

using namespace pectin;
using fuzz::expect;

constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;

std::string save(const IndexedFaceSet& faces) {
    const TriMesh mesh = build_mesh(faces).mesh;
    const std::vector<std::string> violations = mesh.validate();
    expect(violations.empty(), "a mesh is valid: " + (violations.empty() ? "" : violations[0]));
    return format_obj(mesh);
}

bool is_same_color(const Vec3f& x, const Vec3f& y) {
    return x == y || (std::isnan(x.x) && std::isnan(y.x));
}

// Compares values, not indices, because a save contains each value only once.
void expect_same_corner(const IndexedFaceSet& in, const IndexedFaceSet::Corner& x,
                        const IndexedFaceSet& out, const IndexedFaceSet::Corner& y) {
    expect(x.position == y.position, "a corner keeps its vertex");
    expect((x.uv == kNoIndex) == (y.uv == kNoIndex), "a corner has a UV where it had one");
    expect(x.uv == kNoIndex || in.uvs[x.uv] == out.uvs[y.uv], "a corner keeps its UV");
}

void expect_same_vertices(const IndexedFaceSet& in, const IndexedFaceSet& out) {
    expect(in.positions == out.positions, "vertices keep their positions");
    // A file in which no vertex has a colour has none.
    for (std::size_t v = 0; v < in.colors.size(); ++v) {
        expect(is_same_color(in.colors[v], out.colors[v]), "vertices keep their colours");
    }
    expect(in.colors.size() == out.colors.size(), "colours stay where there are any");
}

void expect_same_polygons(const IndexedFaceSet& in, const IndexedFaceSet& out) {
    expect(in.polygon_end == out.polygon_end, "polygons keep their corners");
    for (std::size_t i = 0; i < in.corners.size(); ++i) {
        expect_same_corner(in, in.corners[i], out, out.corners[i]);
        const std::uint32_t given = in.corners[i].normal;
        expect(given == kNoIndex || in.normals[given] == out.normals[out.corners[i].normal],
               "a corner keeps its normal");
    }
    for (std::size_t p = 0; p < in.polygon_count(); ++p) {
        expect(in.parts[in.polygon_part[p]] == out.parts[out.polygon_part[p]],
               "a polygon keeps its part");
    }
}

void expect_same_elements(const IndexedFaceSet& in, const IndexedFaceSet& out) {
    expect(in.elements.size() == out.elements.size(), "lines and points stay");
    for (std::size_t i = 0; i < in.elements.size(); ++i) {
        const IndexedFaceSet::Element &x = in.elements[i], &y = out.elements[i];
        expect(x.kind == y.kind && x.before_polygon == y.before_polygon &&
                   x.corners_end == y.corners_end && in.parts[x.part] == out.parts[y.part],
               "a line or points stay what and where they were");
    }
    for (std::size_t i = 0; i < in.element_corners.size(); ++i) {
        expect_same_corner(in, in.element_corners[i], out, out.element_corners[i]);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    IndexedFaceSet in;
    try {
        in = parse_obj({reinterpret_cast<const char*>(data), size}, "fuzz.obj");
    } catch (const FileError&) {
        return 0;
    }
    const std::string text = save(in);
    const IndexedFaceSet out = parse_obj(text, "saved.obj");
    expect_same_vertices(in, out);
    expect_same_polygons(in, out);
    expect_same_elements(in, out);
    expect(in.material_libraries == out.material_libraries, "material libraries keep their names");
    expect(save(out) == text, "a save of a save is the same bytes");
    return 0;
}
