#include "io/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "io/file_error.h"
#include "io/obj_corners.h"
#include "io/obj_statements.h"
#include "io/read_file.h"

namespace pectin {
namespace {

using Index = std::uint32_t;

constexpr std::size_t kLongestName = 4096;
// Parts name their object, group and material each for itself, so that a short statement makes
// another copy of a long name. Models stay far below this; it bounds what a hostile text can take.
constexpr std::size_t kMostPartBytesPerByte = 16;
constexpr std::size_t kLeastPartBytes = std::size_t{1} << 20;
// Of text, between two looks at whether the work is to go on.
constexpr std::size_t kProgressBytes = std::size_t{64} << 10;

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

// The parts that polygons and elements have asked for, each once.
class PartTable {
  public:
    PartTable() = default;
    PartTable(const PartTable&) = delete;  // sorted_ looks into parts_
    PartTable& operator=(const PartTable&) = delete;

    // Its index, and whether it is new.
    std::pair<Index, bool> find_or_add(const Part& part) {
        const auto found = sorted_.find(part);
        if (found != sorted_.end()) return {*found, false};
        const auto added = static_cast<Index>(parts_.size());
        parts_.push_back(part);
        sorted_.insert(added);
        bytes_ += sizeof(Part) + part.object.size() + part.group.size() + part.material.size();
        return {added, true};
    }
    std::size_t bytes() const { return bytes_; }
    std::vector<Part> take() { return std::move(parts_); }

  private:
    struct Less {
        using is_transparent = void;
        const std::vector<Part>& parts;

        static auto key(const Part& p) {
            return std::tie(p.smoothing_group, p.material, p.group, p.object);
        }
        const Part& part(Index i) const { return parts[i]; }
        const Part& part(const Part& p) const { return p; }
        bool operator()(const auto& x, const auto& y) const { return key(part(x)) < key(part(y)); }
    };
    std::vector<Part> parts_;
    std::set<Index, Less> sorted_{Less{parts_}};
    std::size_t bytes_ = 0;
};

class ObjParser {
  public:
    ObjParser(std::string_view text, const std::string& name, const Progress& progress,
              const ObjLimits& limits)
        : statements_(text),
          name_(name),
          progress_(progress),
          limits_(limits),
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
    bool read_state();
    template <typename Real, std::size_t n>
    std::array<Real, n> take_numbers(std::string_view& rest, std::size_t needed) const;
    std::size_t check_numbers(std::string_view rest) const;
    std::string read_name() const;
    std::string read_group_names() const;
    Index read_smoothing_group() const;
    std::size_t append_corners(std::vector<Corner>& corners);
    bool take_corner(std::string_view& rest, ObjCorner& corner);
    Corner resolve(const ObjCorner& raw);
    Index present_part();
    void check_references() const;
    [[noreturn]] void fail(const std::string& message) const {
        throw FileError(name_, statements_.line(), message);
    }

    ObjStatements statements_;
    const std::string& name_;
    const Progress& progress_;
    const ObjLimits& limits_;
    std::size_t size_;  // bytes of the text
    std::size_t bytes_left_at_report_;

    IndexedFaceSet faces_;
    std::size_t triangles_ = 0;
    Part state_;
    std::optional<Index> part_;  // of state_, once something has asked for it
    PartTable parts_;
    ObjReferences positions_{"vertex"}, uvs_{"texture coordinate"}, normals_{"normal"};
    std::string why_not_;
};

IndexedFaceSet ObjParser::parse() {
    while (statements_.next()) {
        report_progress();
        read_statement();
    }
    check_references();
    if (faces_.polygon_count() == 0) {
        throw FileError(name_, "holds no faces; a model has f statements of 3 corners or more");
    }
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
    std::string_view rest = statements_.arguments();
    if (keyword == "v") {
        read_vertex();
    } else if (keyword == "f") {
        read_face();
    } else if (keyword == "vt") {
        const auto [u, v] = take_numbers<float, 2>(rest, 1);
        check_numbers(rest);
        faces_.uvs.emplace_back(u, v);
    } else if (keyword == "vn") {
        faces_.normals.push_back(unit_normal(take_numbers<double, 3>(rest, 3)));
        check_numbers(rest);
    } else if (keyword == "l") {
        read_element(Element::Kind::line);
    } else if (keyword == "p") {
        read_element(Element::Kind::points);
    } else if (keyword == "mtllib") {
        if (!rest.empty()) faces_.material_libraries.emplace_back(rest);
    } else if (read_state()) {
        part_.reset();
    }
}

void ObjParser::read_vertex() {
    std::string_view rest = statements_.arguments();
    const auto [x, y, z] = take_numbers<double, 3>(rest, 3);
    faces_.positions.emplace_back(x, y, z);
    const bool is_colored = !rest.empty() && check_numbers(rest) >= 3;
    if (!is_colored && faces_.colors.empty()) return;
    // Of this vertex, and of all before the first that is coloured.
    faces_.colors.resize(faces_.positions.size(), Vec3f{std::numeric_limits<float>::quiet_NaN()});
    if (!is_colored) return;
    const auto [r, g, b] = take_numbers<float, 3>(rest, 3);
    faces_.colors.back() = {r, g, b};
}

void ObjParser::read_face() {
    const std::size_t count = append_corners(faces_.corners);
    if (count == 0) return;
    triangles_ += std::max(count, std::size_t{2}) - 2;
    if (triangles_ > limits_.triangles) {
        fail("more than " + std::to_string(limits_.triangles) +
             " triangles up to here; split the model into several files");
    }
    faces_.polygon_end.push_back(static_cast<Index>(faces_.corners.size()));
    faces_.polygon_part.push_back(present_part());
}

void ObjParser::read_element(Element::Kind kind) {
    if (append_corners(faces_.element_corners) == 0) return;
    faces_.elements.push_back({kind, static_cast<Index>(faces_.polygon_count()), present_part(),
                               static_cast<Index>(faces_.element_corners.size())});
}

// What holds for the faces, lines and points from here on; false for any other statement.
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

// Cuts the first n numbers off the front of `rest`; 0 where there are fewer, but at least `needed`.
template <typename Real, std::size_t n>
std::array<Real, n> ObjParser::take_numbers(std::string_view& rest, std::size_t needed) const {
    std::array<Real, n> numbers{};
    std::string why_not;
    for (std::size_t i = 0; i < n; ++i) {
        const auto token = take_token(rest);
        if (!token && i >= needed) break;
        if (!token) {
            fail("'" + std::string(statements_.keyword()) + "' needs " + std::to_string(needed) +
                 (needed == 1 ? " number" : " numbers") + (i == 1 ? ", here is " : ", here are ") +
                 std::to_string(i));
        }
        const std::optional<Real> number = parse_number<Real>(*token, why_not);
        if (!number) fail(why_not);
        numbers[i] = *number;
    }
    return numbers;
}

// How many there are.
std::size_t ObjParser::check_numbers(std::string_view rest) const {
    std::size_t count = 0;
    std::string why_not;
    while (const auto token = take_token(rest)) {
        if (!parse_number<double>(*token, why_not)) fail(why_not);
        ++count;
    }
    return count;
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

// The corners that the statement names; how many.
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

// The next corner, cut off the front of `rest`; false where there is none.
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

ObjParser::Corner ObjParser::resolve(const ObjCorner& raw) {
    const auto index_of = [this](std::int32_t number, std::size_t count, ObjReferences& kind) {
        const auto index = kind.resolve(number, count, statements_.line(), why_not_);
        if (!index) fail(why_not_);
        return *index;
    };
    Corner corner;
    corner.position = index_of(raw.position, faces_.positions.size(), positions_);
    if (raw.uv != 0) corner.uv = index_of(raw.uv, faces_.uvs.size(), uvs_);
    if (raw.normal != 0) corner.normal = index_of(raw.normal, faces_.normals.size(), normals_);
    return corner;
}

Index ObjParser::present_part() {
    if (part_) return *part_;
    const auto [index, is_new] = parts_.find_or_add(state_);
    if (is_new && parts_.bytes() > kLeastPartBytes + kMostPartBytesPerByte * size_) {
        fail("too many combinations of long object, group and material names up to here");
    }
    part_ = index;
    return index;
}

void ObjParser::check_references() const {
    std::optional<ObjReferences::Dangling> first;
    const auto check = [&](const ObjReferences& kind, std::size_t count) {
        auto dangling = kind.first_dangling(count);
        if (dangling && (!first || dangling->line < first->line)) first = std::move(dangling);
    };
    check(positions_, faces_.positions.size());
    check(uvs_, faces_.uvs.size());
    check(normals_, faces_.normals.size());
    if (first) throw FileError(name_, first->line, first->message);
}

}  // namespace

IndexedFaceSet read_obj(const std::string& path, const Progress& progress) {
    constexpr double kReading = 0.1;  // of the time; the rest is parsing
    const ObjLimits limits;
    const std::string text = read_whole_file(path, progress.part(0.0, kReading), limits.bytes);
    return parse_obj(text, path, progress.part(kReading, 1.0), limits);
}

IndexedFaceSet parse_obj(std::string_view text, const std::string& name, const Progress& progress,
                         const ObjLimits& limits) {
    if (text.size() > limits.bytes) {
        throw FileError(name, "is larger than " + std::to_string(limits.bytes >> 20) + " MB");
    }
    return ObjParser(text, name, progress, limits).parse();
}

}  // namespace pectin
