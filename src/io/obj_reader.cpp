#include "io/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "io/file_error.h"
#include "io/obj_faces.h"
#include "io/obj_statements.h"
#include "io/read_file.h"

namespace pectin {
namespace {

using Index = std::uint32_t;

// Shorter texts hold fewer elements and corners than an int and an Index can count.
constexpr std::size_t kMostBytes = std::size_t{4} << 30;
// Each part names its object, group and material; longer names could take far more memory than
// the file does.
constexpr std::size_t kLongestName = 4096;

// The unit float normal in the direction of n, or 0. What is unit already, as floats can be,
// stays as it was read: a file that is read and written again keeps its numbers.
Vec3f unit_normal(const std::array<double, 3>& n) {
    const Vec3 direction{n[0], n[1], n[2]};
    const Vec3f as_read(direction);
    constexpr double kUnitTolerance = 1e-6;  // of the square: a few float roundings
    if (std::abs(glm::dot(Vec3(as_read), Vec3(as_read)) - 1.0) < kUnitTolerance) return as_read;

    const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
    if (largest == 0.0) return Vec3f{0.0f};
    const Vec3 scaled = direction / largest;  // its square neither overflows nor vanishes
    return Vec3f(scaled / glm::length(scaled));
}

// Indices of elements that come later in the file: which line asks for what, wherever a line asks
// for more than all lines before it. So the first line that asks too much is among them.
struct ForwardReferences {
    struct Entry {
        Index count;
        std::size_t line;
    };
    std::vector<Entry> entries;

    void add(Index count, std::size_t line) {
        if (entries.empty() || count > entries.back().count) entries.push_back({count, line});
    }
    std::optional<Entry> first_beyond(std::size_t count) const {
        const auto beyond = std::find_if(entries.begin(), entries.end(),
                                         [&](const Entry& e) { return e.count > count; });
        return beyond == entries.end() ? std::nullopt : std::optional(*beyond);
    }
};

class ObjParser {
  public:
    ObjParser(std::string_view text, const std::string& name) : statements_(text), name_(name) {}

    IndexedFaceSet parse();

  private:
    bool next_face(std::string& arguments);
    void read_statement();
    template <typename Real, std::size_t n>
    std::array<Real, n> read_numbers(std::size_t needed);
    std::string read_name() const;
    std::string read_group_names() const;
    Index read_smoothing_group() const;
    int check_corners(std::string& arguments) const;
    void check_corner(std::string_view corner) const;
    void add_face(std::span<const ObjCorner> corners);
    Index resolve(int raw, std::size_t count, std::string_view what, ForwardReferences& forward);
    Index present_part();
    void check_forward_references() const;
    [[noreturn]] void fail(const std::string& message) const {
        throw FileError(name_, statements_.line(), message);
    }

    ObjStatements statements_;
    const std::string& name_;
    IndexedFaceSet faces_;
    Part state_;
    std::optional<Index> part_;  // of state_, once a face has asked for it
    std::map<std::tuple<std::string, std::string, std::string, Index>, Index> parts_;
    int expected_corners_ = 0;  // of the `f` statement in hand; 0 between them
    ForwardReferences positions_, uvs_, normals_;
};

IndexedFaceSet ObjParser::parse() {
    read_faces([this](std::string& arguments) { return next_face(arguments); },
               [this](std::span<const ObjCorner> corners) { add_face(corners); });
    check_forward_references();
    if (faces_.polygon_count() == 0) {
        throw FileError(name_, "holds no faces; a model has f statements of 3 corners or more");
    }
    return std::move(faces_);
}

// Reads all statements up to the next face that has a surface.
bool ObjParser::next_face(std::string& arguments) {
    if (expected_corners_ != 0) fail("the face could not be read");
    while (statements_.next()) {
        if (statements_.keyword() != "f") {
            read_statement();
        } else if (const int corners = check_corners(arguments); corners >= 3) {
            expected_corners_ = corners;
            return true;
        }
    }
    return false;
}

void ObjParser::read_statement() {
    const std::string_view keyword = statements_.keyword();
    if (keyword == "v") {
        // What follows the third number, w or a colour, is checked but has no place yet.
        const auto [x, y, z] = read_numbers<double, 3>(3);
        faces_.positions.emplace_back(x, y, z);
    } else if (keyword == "vn") {
        faces_.normals.push_back(unit_normal(read_numbers<double, 3>(3)));
    } else if (keyword == "vt") {
        const auto [u, v] = read_numbers<float, 2>(1);
        faces_.uvs.emplace_back(u, v);
    } else if (keyword == "mtllib") {
        if (!statements_.arguments().empty()) {
            faces_.material_libraries.emplace_back(statements_.arguments());
        }
    } else {
        if (keyword == "o") {
            state_.object = read_name();
        } else if (keyword == "g") {
            state_.group = read_group_names();
        } else if (keyword == "usemtl") {
            state_.material = read_name();
        } else if (keyword == "s") {
            state_.smoothing_group = read_smoothing_group();
        } else {
            return;
        }
        part_.reset();
    }
}

// The first n numbers of the statement, 0 where there are fewer; all of them are checked.
template <typename Real, std::size_t n>
std::array<Real, n> ObjParser::read_numbers(std::size_t needed) {
    std::array<Real, n> numbers{};
    std::string_view rest = statements_.arguments();
    std::size_t count = 0;
    std::string why_not;
    while (const auto token = take_token(rest)) {
        const std::optional<Real> number = parse_number<Real>(*token, why_not);
        if (!number) fail(why_not);
        if (count < n) numbers[count] = *number;
        ++count;
    }
    if (count < needed) {
        fail("'" + std::string(statements_.keyword()) + "' needs " + std::to_string(needed) +
             (needed == 1 ? " number" : " numbers") + ", here are " + std::to_string(count));
    }
    return numbers;
}

std::string ObjParser::read_name() const {
    const std::string_view name = statements_.arguments();
    if (name.size() > kLongestName) {
        fail("the name is longer than " + std::to_string(kLongestName) + " bytes");
    }
    return std::string(name);
}

std::string ObjParser::read_group_names() const {
    std::string names;
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    for (char c : read_name()) {
        if (!is_blank(c)) {
            names.push_back(c);
        } else if (names.back() != ' ') {
            names.push_back(' ');
        }
    }
    return names;
}

// Anything but a number is off, as elsewhere; `on` is seen in files.
Index ObjParser::read_smoothing_group() const {
    std::string_view rest = statements_.arguments();
    const std::string_view token = take_token(rest).value_or("off");
    if (token == "on") return 1;
    Index group = 0;
    const auto read = std::from_chars(token.data(), token.data() + token.size(), group);
    return read.ec == std::errc{} ? group : 0;
}

// Checks the face's corners, writes them to `arguments` and counts them.
int ObjParser::check_corners(std::string& arguments) const {
    int count = 0;
    arguments.clear();
    std::string_view rest = statements_.arguments();
    while (const auto token = take_token(rest)) {
        check_corner(*token);
        // Without the slashes at its end: behind those, tinyobjloader reads the next corner's.
        arguments.append(token->substr(0, token->find_last_not_of('/') + 1)).push_back(' ');
        ++count;
    }
    return count;
}

// v, v/vt, v//vn or v/vt/vn. Slashes with nothing behind them are seen in files.
void ObjParser::check_corner(std::string_view corner) const {
    const char* at = corner.data();
    const char* const end = at + corner.size();
    for (int field = 0; field < 3; ++field) {
        if (field > 0) {
            if (at == end) return;
            if (*at != '/') break;
            ++at;
            if (at == end || *at == '/') continue;
        }
        int number = 0;
        const auto read = std::from_chars(at, end, number);
        if (read.ec == std::errc::invalid_argument) break;
        if (read.ec == std::errc::result_out_of_range) {
            fail("'" + std::string(corner) + "' has an index that is too large");
        }
        if (number == 0) fail("'" + std::string(corner) + "' has an index 0; they count from 1");
        at = read.ptr;
    }
    if (at != end) {
        fail("'" + std::string(corner) +
             "' is no face corner; corners look like 1, 1/2, 1//3 or 1/2/3");
    }
}

void ObjParser::add_face(std::span<const ObjCorner> corners) {
    if (static_cast<int>(corners.size()) != expected_corners_) fail("the face could not be read");
    expected_corners_ = 0;
    for (const ObjCorner& raw : corners) {
        IndexedFaceSet::Corner corner;
        corner.position = resolve(raw.position, faces_.positions.size(), "vertex", positions_);
        if (raw.uv != 0) {
            corner.uv = resolve(raw.uv, faces_.uvs.size(), "texture coordinate", uvs_);
        }
        if (raw.normal != 0) {
            corner.normal = resolve(raw.normal, faces_.normals.size(), "normal", normals_);
        }
        faces_.corners.push_back(corner);
    }
    faces_.polygon_end.push_back(static_cast<Index>(faces_.corners.size()));
    faces_.polygon_part.push_back(present_part());
}

// From the file's way of counting to ours; `count` elements have been read so far.
Index ObjParser::resolve(int raw, std::size_t count, std::string_view what,
                         ForwardReferences& forward) {
    if (raw > 0) {
        const Index wanted = static_cast<Index>(raw);
        if (wanted > count) forward.add(wanted, statements_.line());
        return wanted - 1;
    }
    const std::size_t back = static_cast<std::size_t>(-static_cast<std::int64_t>(raw));
    if (back > count) {
        fail(std::string(what) + " " + std::to_string(raw) + " does not exist; up to here are " +
             std::to_string(count));
    }
    return static_cast<Index>(count - back);
}

Index ObjParser::present_part() {
    if (!part_) {
        const Index next = static_cast<Index>(faces_.parts.size());
        const auto [found, is_new] = parts_.try_emplace(
            std::tuple(state_.object, state_.group, state_.material, state_.smoothing_group), next);
        if (is_new) faces_.parts.push_back(state_);
        part_ = found->second;
    }
    return *part_;
}

void ObjParser::check_forward_references() const {
    std::size_t first_line = 0;
    std::string message;
    const auto check = [&](const ForwardReferences& forward, std::size_t count, const char* what) {
        const auto beyond = forward.first_beyond(count);
        if (!beyond || (first_line != 0 && first_line <= beyond->line)) return;
        first_line = beyond->line;
        message = std::string(what) + " " + std::to_string(beyond->count) +
                  " does not exist; the file has " + std::to_string(count);
    };
    check(positions_, faces_.positions.size(), "vertex");
    check(uvs_, faces_.uvs.size(), "texture coordinate");
    check(normals_, faces_.normals.size(), "normal");
    if (first_line != 0) throw FileError(name_, first_line, message);
}

}  // namespace

IndexedFaceSet read_obj(const std::string& path) { return parse_obj(read_whole_file(path), path); }

IndexedFaceSet parse_obj(std::string_view text, const std::string& name) {
    if (text.size() >= kMostBytes) throw FileError(name, "is larger than 4 GB");
    return ObjParser(text, name).parse();
}

}  // namespace pectin
