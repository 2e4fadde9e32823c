// The commands: everything that a user can do. The mouse, scripts and tests send them to a Session.
//
// Angles are in degrees, lengths in the model's units, points in world space. An empty optional
// leaves the current setting unchanged. Members have initialisers so that designated initialisers
// may omit them. command/schema.h says what each field means and may be.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/camera.h"
#include "geometry/falloff.h"
#include "geometry/move.h"
#include "geometry/vec.h"

namespace pectin {

// A setting that is a number, off (`null` in a script) or derived from others (`"auto"`).
struct Setting {
    enum class Kind { automatic, off, value };
    Kind kind = Kind::automatic;
    double value = 0.0;

    static Setting automatic() { return {Kind::automatic, 0.0}; }
    static Setting off() { return {Kind::off, 0.0}; }
    static Setting of(double number) { return {Kind::value, number}; }
    bool is_automatic() const { return kind == Kind::automatic; }
    bool is_off() const { return kind == Kind::off; }
    bool operator==(const Setting&) const = default;
};

namespace command {

struct Open {
    std::string path{};
    double crease_angle = 45.0;  // used if the file has no normals or smoothing groups
    bool operator==(const Open&) const = default;
};

struct Shape {
    enum class Kind { sphere, cube, plane, torus, cylinder };
    Kind kind = Kind::sphere;
    int resolution = 0;
    bool operator==(const Shape&) const = default;
};

struct Adapt {
    enum class Trigger { normals, midpoint, certified };
    std::optional<bool> enabled{};
    std::optional<Trigger> trigger{};
    std::optional<Setting> theta_max{}, theta_min{};  // of normals
    std::optional<Setting> tolerance{};               // of midpoint and certified
    std::optional<Setting> l_max{};
    std::optional<Setting> flatness{};
    std::optional<Setting> floor{};
    std::optional<std::uint64_t> budget{};  // triangles of the object
    std::optional<Setting> drag_budget{};   // triangles that one drag may add
    std::optional<double> propagation{};
    bool operator==(const Adapt&) const = default;
};

struct Brush {
    std::optional<double> radius{};
    std::optional<int> span{};  // deformable control points per axis
    std::optional<Falloff> falloff{};
    bool operator==(const Brush&) const = default;
};

// Either origin, cell and deformable, or fit; see check().
struct Cage {
    std::optional<Vec3> origin{}, cell{};
    std::optional<IVec3> deformable{};
    IVec3 margin{0};             // further layers of control points on each side
    std::optional<IVec3> fit{};  // control points on the object's box
    bool operator==(const Cage&) const = default;
};

// Mirrors all later drags, pins and moves of control points in a plane.
struct Symmetry {
    enum class Plane { x, y, z };  // the axis that is normal to the plane
    std::optional<Plane> plane{};  // empty: no symmetry
    Vec3 through{0.0};             // a point on it
    bool operator==(const Symmetry&) const = default;
};

struct Drag {
    using Twist = pectin::Twist;
    using Move = pectin::Move;
    std::vector<Move> moves{};
    std::vector<Vec3> pins{};
    bool connected = false;   // only the surface connected to the moved points
    bool fold_free = false;   // in steps that are proven injective
    std::vector<Vec3> via{};  // waypoints of the first move
    bool operator==(const Drag&) const = default;
};

// Moves control points of the current cage.
struct Control {
    struct Point {
        IVec3 index{0};
        Vec3 to{0.0};
        bool operator==(const Point&) const = default;
    };
    std::vector<Point> points{};
    bool operator==(const Control&) const = default;
};

struct Undo {
    int count = 1;
    bool operator==(const Undo&) const = default;
};

struct Redo {
    int count = 1;
    bool operator==(const Redo&) const = default;
};

// Limits the memory of undo and redo. The oldest steps are dropped beyond it.
struct History {
    std::optional<Setting> megabytes{};  // 10^6 bytes each; number, or off: no limit
    bool operator==(const History&) const = default;
};

struct Readapt {
    bool operator==(const Readapt&) const = default;
};

// Makes the refined mesh the base mesh.
struct Bake {
    bool operator==(const Bake&) const = default;
};

struct Save {
    std::string path{};
    bool operator==(const Save&) const = default;
};

struct Stats {
    std::string path{};
    bool operator==(const Stats&) const = default;
};

// Draws a picture of the object. Makes no undo step.
struct Screenshot {
    struct Show {
        bool wireframe = false, lattice = false, levels = false, light = false;
        bool operator==(const Show&) const = default;
    };
    std::string path{};
    IVec2 size{1280, 960};           // pixels
    std::optional<Camera> camera{};  // empty: the whole object from the front
    Show show{};
    bool operator==(const Screenshot&) const = default;
};

}  // namespace command

using Command = std::variant<command::Open, command::Shape, command::Adapt, command::Brush,
                             command::Cage, command::Symmetry, command::Drag, command::Control,
                             command::Undo, command::Redo, command::History, command::Readapt,
                             command::Bake, command::Save, command::Stats, command::Screenshot>;

// The name of the command in scripts.
const char* name(const Command& command);

}  // namespace pectin
