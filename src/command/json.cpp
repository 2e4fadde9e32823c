#include "command/json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "command/reference.h"
#include "command/spelling.h"

namespace pectin {

namespace {

using nlohmann::json;

// Thrown and caught in this file only.
struct Problem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

constexpr int kMaxInt = std::numeric_limits<int>::max();
constexpr int kMaxSpan = 16, kMaxDeformable = 256, kMaxFitted = 254, kMaxMargin = 2;
constexpr int kLeastPixels = 16, kMostPixels = 8192;  // of a picture, each way
constexpr double kMaxBudget = 9007199254740992.0;     // 2^53: a double counts no further
constexpr std::size_t kMostShown = 40;                // of a text that is quoted in an error
constexpr const char* kPathIsRight = "a file's path in quotes";
constexpr const char* kPointIsRight = "a point: an array of three numbers";

std::string in_quotes(std::string_view text) {
    std::string shown(text.substr(0, kMostShown));
    if (text.size() > kMostShown) shown += "...";
    // Control characters would break the message's line, a cut character its encoding.
    return json(shown).dump(-1, ' ', false, json::error_handler_t::replace);
}

// Never more than a few words, however large the value.
std::string describe(const json& value) {
    if (value == "") return "an empty string";
    if (value.is_string())
        return "a string (" + in_quotes(value.get_ref<const std::string&>()) + ")";
    if (value.is_array() && value.empty()) return "an empty array";
    if (value.is_array()) return "an array of length " + std::to_string(value.size());
    if (value.is_object()) return "an object";
    return value.dump();
}

[[noreturn]] void wrong(const std::string& where, const std::string& right, const json& given) {
    throw Problem(where + " must be " + right + ", not " + describe(given));
}

// ---- Text to JSON

// From nlohmann's "[json.exception.…] parse error at line 1, column 9: syntax error while parsing
// X - unexpected Y; last read: '…'; expected Z" to "unexpected Y; expected Z".
std::string reason(std::string text) {
    if (const auto dash = text.find(" - "); dash != text.npos) text.erase(0, dash + 3);
    if (const auto read = text.find("; last read: '"); read != text.npos) {
        const auto expected = text.rfind("'; expected ");
        text.erase(read,
                   expected == text.npos || expected < read ? text.npos : expected + 1 - read);
    }
    return text;
}

// Refuses objects with a field twice and passes over all else. A callback of json::parse could do
// so, too, but then each end of an object costs a pass over the array that it is in.
class RepeatedFields : public nlohmann::json_sax<json> {
  public:
    bool start_object(std::size_t) override {
        fields_.emplace_back();
        return true;
    }
    bool end_object() override {
        fields_.pop_back();
        return true;
    }
    bool key(string_t& name) override {
        if (fields_.back().insert(name).second) return true;
        throw Problem("the field " + in_quotes(name) + " is given twice; give it once");
    }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    // What is wrong is said by json::parse.
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
        return false;
    }

  private:
    std::vector<std::set<std::string>> fields_;  // of the objects that are open
};

json parse_strictly(std::string_view text) {
    RepeatedFields repeated;
    json::sax_parse(text.begin(), text.end(), &repeated);
    try {
        return json::parse(text.begin(), text.end());
    } catch (const json::parse_error& error) {
        throw Problem("not valid JSON at column " + std::to_string(error.byte) + ": " +
                      reason(error.what()));
    } catch (const json::out_of_range& error) {
        // nlohmann's text ends in the number between single quotes.
        std::string digits = error.what();
        digits.erase(0, digits.find('\'') + 1);
        digits.erase(std::min(digits.find('\''), kMostShown));
        throw Problem("the number " + digits + " is too large; the largest is 1.797e308");
    }
}

// ---- JSON to values: `where` names the field, `right` says what it must be

double number(const json& value, const std::string& where, const std::string& right,
              bool (*accepted)(double)) {
    if (!value.is_number() || !accepted(value.get<double>())) wrong(where, right, value);
    return value.get<double>();
}

bool positive(double x) { return x > 0.0; }
bool not_negative(double x) { return x >= 0.0; }
bool any(double) { return true; }

// 5, 5.0 and 5e0 are the same number.
double whole(const json& value, const std::string& where, double least, double most) {
    const double x = value.is_number() ? value.get<double>() : least - 1.0;
    if (x == std::floor(x) && x >= least && x <= most) return x;
    wrong(where,
          "a whole number from " + json(static_cast<std::int64_t>(least)).dump() + " to " +
              json(static_cast<std::int64_t>(most)).dump(),
          value);
}

int integer(const json& value, const std::string& where, int least, int most) {
    return static_cast<int>(whole(value, where, least, most));
}

bool boolean(const json& value, const std::string& where) {
    if (!value.is_boolean()) wrong(where, "true or false", value);
    return value.get<bool>();
}

std::string path(const json& value, const std::string& where) {
    if (!value.is_string() || value.get_ref<const std::string&>().empty())
        wrong(where, kPathIsRight, value);
    const std::string text = value;
    if (text.find('\0') != text.npos)
        throw Problem(where + " must be a path without a NUL character");
    return text;
}

Vec3 point(const json& value, const std::string& where, const char* right = kPointIsRight,
           bool (*accepted)(double) = any) {
    if (!value.is_array() || value.size() != 3) wrong(where, right, value);
    Vec3 result(0.0);
    for (int axis = 0; axis < 3; ++axis)
        result[axis] =
            number(value[static_cast<std::size_t>(axis)], where + "[" + std::to_string(axis) + "]",
                   accepted == positive ? "a number above 0" : "a number", accepted);
    return result;
}

IVec3 whole_numbers(const json& value, const std::string& where, int least, int most) {
    if (!value.is_array() || value.size() != 3)
        wrong(where, "an array of three whole numbers", value);
    IVec3 result(0);
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = integer(value[static_cast<std::size_t>(axis)],
                               where + "[" + std::to_string(axis) + "]", least, most);
    return result;
}

enum : unsigned { kAllowAuto = 1, kAllowOff = 2 };

Setting setting(const json& value, const std::string& where, const std::string& right,
                bool (*accepted)(double), unsigned allowed) {
    if ((allowed & kAllowOff) && value.is_null()) return Setting::off();
    if ((allowed & kAllowAuto) && value == "auto") return Setting::automatic();
    return Setting::of(number(value, where, right, accepted));
}

// ---- Objects to commands

const json* find(const json& object, std::string_view key) {
    const auto found = object.find(std::string(key));
    return found == object.end() ? nullptr : &*found;
}

const json& require(const json& object, std::string_view key, std::string_view right,
                    std::string_view prefix = "") {
    if (const json* value = find(object, key)) return *value;
    std::string missing(prefix);
    missing.append(key).append(" is missing; it must be ").append(right);
    throw Problem(missing);
}

template <class Range>
std::string listed(const Range& names) {
    return std::accumulate(std::begin(names), std::end(names), std::string(),
                           [](const std::string& text, const auto& entry) {
                               return text.empty() ? std::string(entry.name)
                                                   : text + ", " + entry.name;
                           });
}

Command read_open(const json& object) {
    command::Open open{.path = path(require(object, "path", kPathIsRight), "path")};
    if (const json* value = find(object, "crease_angle"))
        open.crease_angle = number(*value, "crease_angle", "an angle from 0 to 180",
                                   [](double x) { return x >= 0.0 && x <= 180.0; });
    return open;
}

Command read_shape(const json& object) {
    const std::string right = "sphere, cube, plane, torus or cylinder";
    const json& kind = require(object, "kind", right);
    constexpr std::array kNames{"sphere", "cube", "plane", "torus", "cylinder"};
    const auto found = std::find_if(kNames.begin(), kNames.end(),
                                    [&kind](const char* known) { return kind == known; });
    if (found == kNames.end()) wrong("kind", right, kind);
    const json& resolution = require(object, "resolution", "a whole number");
    return command::Shape{.kind = static_cast<command::Shape::Kind>(found - kNames.begin()),
                          .resolution = integer(resolution, "resolution", 0, kMaxInt)};
}

Command read_adapt(const json& object) {
    command::Adapt adapt;
    const auto read = [&object](const char* key, const char* right, bool (*accepted)(double),
                                unsigned allowed, std::optional<Setting>& to) {
        if (const json* value = find(object, key))
            to = setting(*value, key, right, accepted, allowed);
    };
    if (const json* value = find(object, "enabled")) adapt.enabled = boolean(*value, "enabled");
    read("theta_max", "an angle above 0 or null", positive, kAllowOff, adapt.theta_max);
    read("theta_min", "an angle of at least 0, \"auto\" or null", not_negative,
         kAllowAuto | kAllowOff, adapt.theta_min);
    read("l_max", "a length above 0, \"auto\" or null", positive, kAllowAuto | kAllowOff,
         adapt.l_max);
    read("flatness", "a ratio of at least 0, \"auto\" or null", not_negative,
         kAllowAuto | kAllowOff, adapt.flatness);
    read("floor", "a length above 0 or \"auto\"", positive, kAllowAuto, adapt.floor);
    if (const json* value = find(object, "budget"))
        adapt.budget = static_cast<std::uint64_t>(whole(*value, "budget", 1.0, kMaxBudget));
    if (const json* value = find(object, "propagation"))
        adapt.propagation = number(*value, "propagation", "a number of at least 1 and below 1.5",
                                   [](double x) { return x >= 1.0 && x < 1.5; });
    const auto is_number = [](const std::optional<Setting>& s) {
        return s && s->kind == Setting::Kind::value;
    };
    if (is_number(adapt.theta_max) && is_number(adapt.theta_min) &&
        adapt.theta_min->value >= adapt.theta_max->value)
        throw Problem("theta_min must be below theta_max, but is " + object["theta_min"].dump() +
                      " against " + object["theta_max"].dump());
    return adapt;
}

Command read_brush(const json& object) {
    command::Brush brush;
    if (const json* value = find(object, "radius"))
        brush.radius = number(*value, "radius", "a number above 0", positive);
    if (const json* value = find(object, "span")) brush.span = integer(*value, "span", 1, kMaxSpan);
    return brush;
}

Command read_cage(const json& object) {
    const bool is_grid = object.contains("origin") || object.contains("cell") ||
                         object.contains("deformable") || object.contains("margin");
    if (is_grid == object.contains("fit"))
        throw Problem(std::string(is_grid ? "has both a lattice and fit" : "has no lattice") +
                      "; give either origin, cell and deformable, or fit");
    if (!is_grid) {
        return command::Cage{
            command::Cage::Fit{whole_numbers(object["fit"], "fit", 1, kMaxFitted)}};
    }
    const char* cell_is_right = "an array of three numbers above 0";
    command::Cage::Grid grid{
        .origin = point(require(object, "origin", kPointIsRight), "origin"),
        .cell = point(require(object, "cell", cell_is_right), "cell", cell_is_right, positive),
        .deformable =
            whole_numbers(require(object, "deformable", "an array of three whole numbers"),
                          "deformable", 1, kMaxDeformable)};
    if (const json* margin = find(object, "margin")) {
        grid.margin = whole_numbers(*margin, "margin", 0, kMaxMargin);
    }
    return command::Cage{grid};
}

// Refuses fields of a nested object that are not among `known`.
void refuse_unknown(const json& value, const std::string& where, const std::string& owner,
                    std::initializer_list<const char*> known) {
    std::string listing;
    for (const char* name : known) listing += (listing.empty() ? "" : ", ") + std::string(name);
    if (!value.is_object()) wrong(where, "an object with the fields " + listing, value);
    for (const auto& [key, unused] : value.items()) {
        const auto is_key = [&k = key](const char* name) { return k == name; };
        if (std::none_of(known.begin(), known.end(), is_key))
            throw Problem(where + " has the unknown field " + in_quotes(key) +
                          "; the fields of a " + owner + " are " + listing);
    }
}

command::Drag::Twist read_twist(const json& value, const std::string& where) {
    refuse_unknown(value, where, "twist", {"axis", "degrees"});
    command::Drag::Twist twist{
        .axis = point(require(value, "axis", kPointIsRight, where + "."), where + ".axis"),
        .degrees = number(require(value, "degrees", "an angle", where + "."), where + ".degrees",
                          "an angle", any)};
    if (twist.axis == Vec3(0.0)) throw Problem(where + ".axis must have a length above 0");
    return twist;
}

command::Drag::Move read_move(const json& value, const std::string& where) {
    refuse_unknown(value, where, "move", {"from", "to", "twist", "scale"});
    command::Drag::Move move{
        .from = point(require(value, "from", kPointIsRight, where + "."), where + ".from"),
        .to = point(require(value, "to", kPointIsRight, where + "."), where + ".to")};
    if (const json* twist = find(value, "twist")) move.twist = read_twist(*twist, where + ".twist");
    if (const json* scale = find(value, "scale"))
        move.scale = number(*scale, where + ".scale", "a number above 0", positive);
    return move;
}

std::vector<Vec3> points(const json& object, const char* key) {
    std::vector<Vec3> result;
    const json* array = find(object, key);
    if (!array) return result;
    if (!array->is_array()) wrong(key, "an array of points", *array);
    for (std::size_t i = 0; i < array->size(); ++i)
        result.push_back(point((*array)[i], std::string(key) + "[" + std::to_string(i) + "]"));
    return result;
}

Command read_symmetry(const json& object) {
    const std::string right = "\"x\", \"y\", \"z\" or null";
    const json& plane = require(object, "plane", right);
    command::Symmetry symmetry;
    constexpr std::array kNames{"x", "y", "z"};
    if (!plane.is_null()) {
        const auto found = std::find_if(kNames.begin(), kNames.end(),
                                        [&plane](const char* known) { return plane == known; });
        if (found == kNames.end()) wrong("plane", right, plane);
        symmetry.plane = static_cast<command::Symmetry::Plane>(found - kNames.begin());
    }
    if (const json* through = find(object, "through"))
        symmetry.through = point(*through, "through");
    return symmetry;
}

Command read_drag(const json& object) {
    const std::string right = "an array of at least one {\"from\": point, \"to\": point}";
    const json& moves = require(object, "moves", right);
    if (!moves.is_array() || moves.empty()) wrong("moves", right, moves);
    command::Drag drag;
    for (std::size_t i = 0; i < moves.size(); ++i)
        drag.moves.push_back(read_move(moves[i], "moves[" + std::to_string(i) + "]"));
    drag.pins = points(object, "pins");
    if (const json* value = find(object, "connected"))
        drag.connected = boolean(*value, "connected");
    if (const json* value = find(object, "fold_free"))
        drag.fold_free = boolean(*value, "fold_free");
    drag.via = points(object, "via");
    return drag;
}

Command read_control(const json& object) {
    const std::string right = "an array of at least one {\"index\": [i, j, k], \"to\": point}";
    const json& given = require(object, "points", right);
    if (!given.is_array() || given.empty()) wrong("points", right, given);
    command::Control control;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::string where = "points[" + std::to_string(i) + "]";
        refuse_unknown(given[i], where, "control point", {"index", "to"});
        const std::string index_is_right = "an array of three whole numbers";
        const json& index = require(given[i], "index", index_is_right, where + ".");
        if (!index.is_array() || index.size() != 3) wrong(where + ".index", index_is_right, index);
        command::Control::Point moved;
        for (int axis = 0; axis < 3; ++axis)
            moved.index[axis] = integer(index[static_cast<std::size_t>(axis)],
                                        where + ".index[" + std::to_string(axis) + "]", -kMaxMargin,
                                        kMaxDeformable - 1);
        moved.to = point(require(given[i], "to", kPointIsRight, where + "."), where + ".to");
        control.points.push_back(moved);
    }
    return control;
}

template <class UndoOrRedo>
Command read_count(const json& object) {
    UndoOrRedo result;
    if (const json* value = find(object, "count"))
        result.count = integer(*value, "count", 1, kMaxInt);
    return result;
}

Command read_history(const json& object) {
    command::History history;
    if (const json* value = find(object, "megabytes"))
        history.megabytes =
            setting(*value, "megabytes", "a number above 0 or null", positive, kAllowOff);
    return history;
}

template <class SaveOrStats>
Command read_path(const json& object) {
    return SaveOrStats{path(require(object, "path", kPathIsRight), "path")};
}

Camera read_camera(const json& value) {
    for (const auto& [key, unused] : value.items())
        if (key != "eye" && key != "target" && key != "up" && key != "fov")
            throw Problem("camera has the unknown field " + in_quotes(key) +
                          "; its fields are eye, target, up, fov");
    Camera camera{
        .eye = point(require(value, "eye", kPointIsRight, "camera."), "camera.eye"),
        .target = point(require(value, "target", kPointIsRight, "camera."), "camera.target")};
    if (const json* up = find(value, "up")) camera.up = point(*up, "camera.up");
    if (const json* fov = find(value, "fov"))
        camera.fov = number(*fov, "camera.fov", "an angle from 1 to 170",
                            [](double x) { return x >= 1.0 && x <= 170.0; });
    if (!camera.is_valid())
        throw Problem(
            "camera must look from eye to another point, target, with up at an angle to "
            "that");
    return camera;
}

command::Screenshot::Show read_show(const json& value) {
    const std::string right = "wireframe, lattice, levels or ui";
    if (!value.is_array()) wrong("show", "an array of any of " + right, value);
    command::Screenshot::Show show;
    for (std::size_t i = 0; i < value.size(); ++i) {
        bool* const shown = value[i] == "wireframe" ? &show.wireframe
                            : value[i] == "lattice" ? &show.lattice
                            : value[i] == "levels"  ? &show.levels
                            : value[i] == "ui"      ? &show.ui
                                                    : nullptr;
        if (!shown) wrong("show[" + std::to_string(i) + "]", right, value[i]);
        *shown = true;
    }
    return show;
}

Command read_screenshot(const json& object) {
    command::Screenshot screenshot{.path = path(require(object, "path", kPathIsRight), "path")};
    if (!screenshot.path.ends_with(".png"))
        throw Problem("path must end in .png, as " + in_quotes("picture.png") + " does");
    if (const json* size = find(object, "size")) {
        if (!size->is_array() || size->size() != 2)
            wrong("size", "an array of two whole numbers", *size);
        screenshot.width = integer((*size)[0], "size[0]", kLeastPixels, kMostPixels);
        screenshot.height = integer((*size)[1], "size[1]", kLeastPixels, kMostPixels);
    }
    if (const json* camera = find(object, "camera"); camera && *camera != "fit") {
        if (!camera->is_object())
            wrong("camera", "\"fit\" or an object with the fields eye, target, up, fov", *camera);
        screenshot.camera = read_camera(*camera);
    }
    if (const json* show = find(object, "show")) screenshot.show = read_show(*show);
    return screenshot;
}

using Reader = Command (*)(const json&);

// In the order of Command, as the reference is.
constexpr std::array<Reader, std::variant_size_v<Command>> kReaders{
    read_open,
    read_shape,
    read_adapt,
    read_brush,
    read_cage,
    read_symmetry,
    read_drag,
    read_control,
    read_count<command::Undo>,
    read_count<command::Redo>,
    read_history,
    [](const json&) -> Command { return command::Readapt{}; },
    [](const json&) -> Command { return command::Bake{}; },
    read_path<command::Save>,
    read_path<command::Stats>,
    read_screenshot};

// ---- Names

std::string unknown_command(std::string_view given) {
    const auto known = command_reference();
    const char* const meant = nearest_command(given);
    return (meant ? std::string("unknown command; did you mean ") + meant + "?"
                  : std::string("unknown command")) +
           "; known are " + listed(known);
}

void refuse_unknown_fields(const json& object, const CommandReference& reference) {
    for (const auto& [key, value] : object.items()) {
        const auto is_key = [&k = key](const FieldReference& field) { return k == field.name; };
        if (key == "cmd" || std::any_of(reference.fields.begin(), reference.fields.end(), is_key))
            continue;
        throw Problem(
            "unknown field " + in_quotes(key) + "; " + reference.name +
            (reference.fields.empty() ? " has no fields" : " has " + listed(reference.fields)));
    }
}

bool is_plain_name(std::string_view text) {
    return !text.empty() && text.size() <= kMostShown &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '_' || c == '-';
           });
}

// The command's name; `command` is what an error is to be headed with.
std::size_t command_index(const json& object, std::string& command) {
    const json& given = require(object, "cmd", "a command's name, as in {\"cmd\": \"undo\"}");
    if (!given.is_string()) wrong("cmd", "a command's name in quotes", given);
    const std::string text = given;
    const auto known = command_reference();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&text](const auto& entry) { return text == entry.name; });
    if (is_plain_name(text)) command = text;
    if (found == known.end())
        throw Problem((command == text ? "" : in_quotes(text) + " is an ") + unknown_command(text));
    return static_cast<std::size_t>(found - known.begin());
}

}  // namespace

std::variant<Command, CommandError> parse_command(std::string_view json_line) {
    std::string command = "script";
    try {
        const json object = parse_strictly(json_line);
        if (!object.is_object()) wrong("a line", "an object, {\"cmd\": ...}", object);
        const std::size_t index = command_index(object, command);
        refuse_unknown_fields(object, command_reference()[index]);
        return kReaders[index](object);
    } catch (const Problem& problem) {
        return CommandError{command, problem.what()};
    }
}

std::optional<std::string> check_header(std::string_view json_line) {
    const std::string right = "the first line of a script must be {\"pectin\": 1}";
    try {
        const json header = parse_strictly(json_line);
        if (!header.is_object() || header.size() != 1 || !header.contains("pectin")) return right;
        const json& version = header["pectin"];
        if (version == 1) return std::nullopt;
        if (version.is_number() && version > 1)
            return "the script is of version " + version.dump() +
                   ", but this pectin reads version 1, {\"pectin\": 1}";
        return right + ", not " + describe(version) + " for a version";
    } catch (const Problem&) {
        return right;
    }
}

}  // namespace pectin
