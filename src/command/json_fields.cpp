#include "command/json_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "command/json_values.h"

namespace pectin::command_json {

namespace {

constexpr int kMaxSpan = 16, kMaxDeformable = 256, kMaxFitted = 254, kMaxMargin = 2;
constexpr int kMinPixels = 16, kMaxPixels = 8192;  // along each side of a picture
constexpr double kMaxBudget = 9007199254740992.0;  // 2^53; above it doubles skip whole numbers

bool is_budget(double x) { return x >= 1.0 && x <= kMaxBudget && x == std::floor(x); }

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
    read("drag_budget", "a whole number from 1 to 9007199254740992, \"auto\" or null", is_budget,
         kAllowAuto | kAllowOff, adapt.drag_budget);
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
        screenshot.width = integer((*size)[0], "size[0]", kMinPixels, kMaxPixels);
        screenshot.height = integer((*size)[1], "size[1]", kMinPixels, kMaxPixels);
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

// In the order of Command and of the reference.
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

}  // namespace

Command read_fields(std::size_t index, const json& object) { return kReaders[index](object); }

}  // namespace pectin::command_json
