#include "io/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "io/file_error.h"
#include "io/file_kind.h"
#include "io/obj_attributes.h"
#include "io/obj_corners.h"
#include "io/obj_keywords.h"
#include "io/obj_parts.h"
#include "io/obj_polypaint.h"
#include "io/obj_statements.h"
#include "io/read_file.h"
#include "io/up_axis_hint.h"

namespace pectin {
namespace {

using Index = std::uint32_t;

constexpr std::uint32_t kNoIndex = IndexedFaceSet::kNoIndex;
constexpr std::size_t kMaxName = 4096;
// Each part stores the names of its object, group and material, so a short statement can copy a
// long name. This limits the memory that a malicious text can take. Real models stay far below it.
constexpr std::size_t kMaxPartBytesPerByte = 16;
constexpr std::size_t kFreePartBytes = std::size_t{1} << 20;
// Bytes of text between two reports of progress.
constexpr std::size_t kProgressBytes = std::size_t{64} << 10;

class ObjParser {
  public:
    ObjParser(std::string_view text, const std::string& name, const Progress& progress,
              const ObjLimits& limits, ReadReport& report)
        : statements_(text),
          name_(name),
          progress_(progress),
          limits_(limits),
          report_(report),
          size_(text.size()),
          bytes_left_at_report_(text.size()) {}

    IndexedFaceSet parse();

  private:
    using Corner = IndexedFaceSet::Corner;
    using Element = IndexedFaceSet::Element;

    void report_progress();
    void read_statement();
    void read_vertex();
    void read_face();
    void read_element(Element::Kind kind);
    void read_uv();
    void read_normal();
    bool read_state();
    void record_unknown();
    std::array<double, 3> take_position(std::string_view& rest) const;
    std::string read_name() const;
    std::string read_group_names() const;
    Index read_smoothing_group() const;
    std::size_t append_corners(std::vector<Corner>& corners);
    bool take_corner(std::string_view& rest, ObjCorner& corner);
    Corner resolve(const ObjCorner& raw);
    Index current_part();
    void check_positions() const;
    [[noreturn]] void fail_without_faces() const;
    [[noreturn]] void fail(const std::string& message) const {
        throw FileError(name_, statements_.line(), message);
    }

    ObjStatements statements_;
    const std::string& name_;
    const Progress& progress_;
    const ObjLimits& limits_;
    ReadReport& report_;
    std::size_t size_;  // of the text, in bytes
    std::size_t bytes_left_at_report_;

    IndexedFaceSet faces_;
    std::size_t triangles_ = 0;
    Part state_;
    std::optional<Index> part_;  // index of state_; empty until an element needs it
    PartTable parts_;
    ObjReferences positions_{"vertex"}, uvs_{"texture coordinate"}, normals_{"normal"};
    AttributeLines lines_;
    ObjPolypaint polypaint_;
    UnknownKeywords unknown_;
    std::string why_not_;
};

IndexedFaceSet ObjParser::parse() {
    while (statements_.next()) {
        report_progress();
        read_statement();
    }
    check_positions();
    if (faces_.polygon_count() == 0) fail_without_faces();
    lines_.missing_uv = uvs_.first_line_beyond(faces_.uvs.size());
    lines_.missing_normal = normals_.first_line_beyond(faces_.normals.size());
    drop_attributes(faces_, lines_, report_);
    polypaint_.apply(faces_.colors, faces_.positions.size(), report_);
    faces_.parts = parts_.take();
    return std::move(faces_);
}

void ObjParser::report_progress() {
    const std::size_t left = statements_.bytes_left();
    if (bytes_left_at_report_ - left < kProgressBytes) return;
    bytes_left_at_report_ = left;
    progress_.advance(static_cast<double>(size_ - left) / static_cast<double>(size_));
}

void ObjParser::read_statement() {
    const std::string_view keyword = statements_.keyword();
    if (keyword == "v") {
        read_vertex();
    } else if (keyword == "f") {
        read_face();
    } else if (keyword == "vt") {
        read_uv();
    } else if (keyword == "vn") {
        read_normal();
    } else if (keyword == "l") {
        read_element(Element::Kind::line);
    } else if (keyword == "p") {
        read_element(Element::Kind::points);
    } else if (keyword == "mtllib") {
        const std::string_view names = statements_.arguments();
        if (!names.empty()) faces_.material_libraries.emplace_back(names);
    } else if (keyword == "#MRGB") {
        polypaint_.add(statements_.arguments(), statements_.line());
    } else if (read_state()) {
        part_.reset();
    } else if (!is_obj_keyword(keyword)) {
        record_unknown();
    }
}

void ObjParser::record_unknown() {
    const std::string_view keyword = statements_.keyword();
    unknown_.add(keyword, statements_.line());
    if (report_.unknown_statements.count == 0) {
        report_.unknown_keyword = unknown_.words().front().word;
        report_.likely_keyword = likely_obj_keyword(keyword);
    }
    report_.unknown_statements.add(statements_.line());
}

void ObjParser::read_vertex() {
    std::string_view rest = statements_.arguments();
    const auto [x, y, z] = take_position(rest);
    faces_.positions.emplace_back(x, y, z);
    std::array<float, 3> color{};
    bool is_colored = false;
    if (!rest.empty()) {
        const std::optional<std::size_t> count = read_numbers(rest, color);
        if (!count) report_.undefined_colors.add(statements_.line());
        is_colored = count.value_or(0) >= color.size();
    }
    if (!is_colored && faces_.colors.empty()) return;
    // This also marks all vertices before the first coloured one as having no colour.
    faces_.colors.resize(faces_.positions.size(), Vec3f{std::numeric_limits<float>::quiet_NaN()});
    if (is_colored) faces_.colors.back() = {color[0], color[1], color[2]};
}

// A texture coordinate that is not finite is stored, so that the indices of the others are right.
void ObjParser::read_uv() {
    std::array<float, 2> uv{};
    const std::optional<std::size_t> count = read_numbers(statements_.arguments(), uv);
    const bool is_defined = count && *count > 0;
    if (!is_defined && lines_.undefined_uv == 0) lines_.undefined_uv = statements_.line();
    faces_.uvs.push_back(is_defined ? Vec2f{uv[0], uv[1]} : kUndefinedUv);
}

// A normal that is not finite or zero is stored as zero for the same reason.
void ObjParser::read_normal() {
    std::array<double, 3> n{};
    const std::optional<std::size_t> count = read_numbers(statements_.arguments(), n);
    const Vec3f normal = count && *count >= n.size() ? unit_normal(n) : Vec3f{0.0f};
    if (normal == Vec3f{0.0f} && lines_.undefined_normal == 0) {
        lines_.undefined_normal = statements_.line();
    }
    faces_.normals.push_back(normal);
}

void ObjParser::read_face() {
    const std::size_t count = append_corners(faces_.corners);
    if (count == 0) return report_.empty_statements.add(statements_.line());
    triangles_ += std::max(count, std::size_t{2}) - 2;
    if (triangles_ > limits_.triangles) {
        fail("more than " + std::to_string(limits_.triangles) +
             " triangles up to here; split the model into several files");
    }
    faces_.polygon_end.push_back(static_cast<Index>(faces_.corners.size()));
    faces_.polygon_part.push_back(current_part());
}

void ObjParser::read_element(Element::Kind kind) {
    if (append_corners(faces_.element_corners) == 0) {
        return report_.empty_statements.add(statements_.line());
    }
    faces_.elements.push_back({kind, static_cast<Index>(faces_.polygon_count()), current_part(),
                               static_cast<Index>(faces_.element_corners.size())});
}

// Reads a statement that sets the part of the following faces, lines and points. Returns false for
// other statements.
bool ObjParser::read_state() {
    const std::string_view keyword = statements_.keyword();
    if (keyword == "o") {
        state_.object = read_name();
    } else if (keyword == "g") {
        state_.group = read_group_names();
    } else if (keyword == "usemtl") {
        state_.material = read_name();
    } else if (keyword == "s") {
        state_.smoothing_group = read_smoothing_group();
    } else {
        return false;
    }
    return true;
}

// Removes the coordinates from the front of `rest`.
std::array<double, 3> ObjParser::take_position(std::string_view& rest) const {
    std::array<double, 3> position{};
    std::string why_not;
    for (std::size_t i = 0; i < position.size(); ++i) {
        const auto token = take_token(rest);
        if (!token)
            fail(std::string("'v' needs 3 numbers, here ") + (i == 1 ? "is " : "are ") +
                 std::to_string(i));
        const std::optional<double> number = parse_number<double>(*token, why_not);
        if (!number) fail(why_not);
        position[i] = *number;
    }
    return position;
}

std::string ObjParser::read_name() const {
    const std::string_view name = statements_.arguments();
    if (name.size() > kMaxName) {
        fail("the name is longer than " + std::to_string(kMaxName) + " bytes");
    }
    return std::string(name);
}

std::string ObjParser::read_group_names() const {
    std::string names;
    for (char c : read_name()) {
        if (!is_blank(c)) {
            names.push_back(c);
        } else if (names.back() != ' ') {
            names.push_back(' ');
        }
    }
    return names;
}

// Anything but a number means off, as in other programs, except `on`, which some files have.
Index ObjParser::read_smoothing_group() const {
    std::string_view rest = statements_.arguments();
    const std::string_view token = take_token(rest).value_or("off");
    if (token == "on") return 1;
    Index group = 0;
    const auto read = std::from_chars(token.data(), token.data() + token.size(), group);
    return read.ec == std::errc{} ? group : 0;
}

// Appends the corners of the statement and returns their number.
std::size_t ObjParser::append_corners(std::vector<Corner>& corners) {
    std::size_t count = 0;
    std::string_view rest = statements_.arguments();
    ObjCorner raw;
    while (take_corner(rest, raw)) {
        corners.push_back(resolve(raw));
        ++count;
    }
    return count;
}

// Removes the next corner from the front of `rest`. Returns false if there is none.
bool ObjParser::take_corner(std::string_view& rest, ObjCorner& corner) {
    const char* const end = rest.data() + rest.size();
    const char* at = rest.data();
    while (at != end && *at == ' ') ++at;
    if (take_plain_corner(at, end, corner)) {
        rest = {at, end};
        return true;
    }
    const auto token = take_token(rest);
    if (!token) return false;
    const std::optional<ObjCorner> parsed = parse_corner(*token, why_not_);
    if (!parsed) fail(why_not_);
    corner = *parsed;
    return true;
}

// Positions are required; texture coordinates and normals are optional. So an index of one that
// does not exist is dropped: here if it counts back too far, otherwise at the end of the file.
ObjParser::Corner ObjParser::resolve(const ObjCorner& raw) {
    const std::size_t line = statements_.line();
    Corner corner;
    const auto position = positions_.resolve(raw.position, faces_.positions.size(), line, why_not_);
    if (!position) fail(why_not_);
    corner.position = *position;
    if (raw.uv != 0) {
        const auto uv = uvs_.resolve(raw.uv, faces_.uvs.size(), line, why_not_);
        if (!uv) report_.missing_uvs.add(line);
        corner.uv = uv.value_or(kNoIndex);
    }
    if (raw.normal != 0) {
        const auto normal = normals_.resolve(raw.normal, faces_.normals.size(), line, why_not_);
        if (!normal) report_.missing_normals.add(line);
        corner.normal = normal.value_or(kNoIndex);
    }
    return corner;
}

Index ObjParser::current_part() {
    if (part_) return *part_;
    const auto [index, is_new] = parts_.find_or_add(state_);
    if (is_new && parts_.bytes() > kFreePartBytes + kMaxPartBytesPerByte * size_) {
        fail("too many combinations of long object, group and material names up to here");
    }
    part_ = index;
    return index;
}

void ObjParser::check_positions() const {
    const auto dangling = positions_.first_dangling(faces_.positions.size());
    if (dangling) throw FileError(name_, dangling->line, dangling->message);
}

void ObjParser::fail_without_faces() const {
    const std::string explanation = unknown_.explanation();
    throw FileError(
        name_,
        "holds no faces; " +
            (explanation.empty() ? "a model has f statements of 3 corners or more" : explanation));
}

// Throws if the text is recognised as another kind of file. Its kind explains more than the line
// at which the reader failed.
void refuse_other_kind(std::string_view text, const std::string& name) {
    if (text.empty()) throw FileError(name, "holds no faces; it is empty");
    const FileKind kind = recognise_file(text.substr(0, kSignatureBytes), text.size());
    if (!kind.is_known()) return;
    // A picture is called a model only by mistake, and its name says what it is.
    const bool is_plain_picture = kind.is_image() && !name.ends_with(".obj");
    throw FileError(name, (is_plain_picture ? "is" : std::string(kind.is) + ",") +
                              std::string(" not an OBJ model") +
                              (kind.advice.empty() ? "" : "; " + std::string(kind.advice)));
}

}  // namespace

IndexedFaceSet read_obj(const std::string& path, const Progress& progress, ReadReport* report) {
    constexpr double kReading = 0.1;  // as a fraction of the time; the rest is parsing
    const ObjLimits limits;
    const std::string text = read_whole_file(path, progress.part(0.0, kReading), limits.bytes);
    return parse_obj(text, path, progress.part(kReading, 1.0), limits, report);
}

IndexedFaceSet parse_obj(std::string_view text, const std::string& name, const Progress& progress,
                         const ObjLimits& limits, ReadReport* report) {
    if (text.size() > limits.bytes) {
        throw FileError(name, "is larger than " + std::to_string(limits.bytes >> 20) + " MB");
    }
    ReadReport found;
    try {
        IndexedFaceSet faces = ObjParser(text, name, progress, limits, found).parse();
        found.up_axis = up_axis_hint(text);
        if (report != nullptr) *report = std::move(found);
        return faces;
    } catch (const FileError&) {
        refuse_other_kind(text, name);
        throw;
    }
}

}  // namespace pectin
