#include "command/reference.h"

#include <array>
#include <variant>

#include "command/command.h"

namespace pectin {

namespace {

constexpr std::array kOpen{
    FieldReference{"path", "an OBJ file"},
    FieldReference{"crease_angle",
                   "0 to 180 (45); where the file has no normals or smoothing groups"}};

constexpr std::array kShape{
    FieldReference{"kind", "sphere, cube, plane, torus or cylinder"},
    FieldReference{"resolution", "a whole number; the sphere has 20 * 4^resolution faces"}};

constexpr std::array kAdapt{
    FieldReference{"enabled", "true or false"},
    FieldReference{
        "theta_max",
        "angle above which an edge is refined (180/7), or null: off; a drag leaves edges "
        "alone that were nearly as rough before it"},
    FieldReference{
        "theta_min",
        "angle below which it may be decimated, \"auto\" (7/9 of theta_max) or null: off"},
    FieldReference{"l_max", "longest edge, \"auto\" (smallest cell extent) or null: off"},
    FieldReference{"flatness",
                   "bump that decimation may remove, relative to its edge, \"auto\" or null: off"},
    FieldReference{"floor",
                   "no edge shorter than twice this is split; \"auto\": 1e-4 of the diagonal"},
    FieldReference{"budget", "most triangles (4000000)"},
    FieldReference{"drag_budget",
                   "most triangles that a drag, control or readapt may add, \"auto\" (200000, or "
                   "four times the faces that it works on if that is more) or null: off"},
    FieldReference{"propagation",
                   "1 to below 1.5 (1): a face may have an edge this much longer than one that "
                   "is split"}};

constexpr std::array kBrush{
    FieldReference{"radius", "its reach (a quarter of the box diagonal)"},
    FieldReference{"span", "1 to 16 (3): deformable control points per axis"}};

constexpr std::array kCage{
    FieldReference{"origin", "[x, y, z] of its control point [0, 0, 0]"},
    FieldReference{"cell", "[x, y, z]: its cell extents"},
    FieldReference{"deformable", "[l, m, n], each 1 to 256: its deformable control points"},
    FieldReference{"margin",
                   "[i, j, k], each 0 to 2 (0): layers of control points beyond these on each "
                   "side"},
    FieldReference{
        "fit", "[l, m, n], each 1 to 254: control points on the object's box, one layer beyond"}};

constexpr std::array kSymmetry{
    FieldReference{"plane", "\"x\", \"y\", \"z\": the axis it is perpendicular to, or null: off"},
    FieldReference{"through", "[x, y, z]: a point on it ([0, 0, 0])"}};

constexpr std::array kDrag{
    FieldReference{
        "moves",
        "[{\"from\": [x, y, z], \"to\": [x, y, z]}, ...]; with twist {\"axis\": [x, y, z], "
        "\"degrees\": up to 3600 either way}, scale (1; 0.001 to 1000)"},
    FieldReference{"pins", "[[x, y, z], ...]: points that stay"},
    FieldReference{"connected",
                   "true: only the parts of the surface that are connected to the points (false); "
                   "other parts that it passes through are reported"},
    FieldReference{"fold_free",
                   "true: in steps that do not fold space, and without self-intersections (false)"},
    FieldReference{"via", "[[x, y, z], ...]: waypoints of the first move"}};

constexpr std::array kControl{
    FieldReference{"points", "[{\"index\": [i, j, k], \"to\": [x, y, z]}, ...]"}};

constexpr std::array kCount{FieldReference{"count", "how many (1)"}};

constexpr std::array kHistory{FieldReference{
    "megabytes", "above 0 (1000), or null: no limit; the oldest steps are dropped first"}};

constexpr std::array kSave{FieldReference{"path", "an OBJ file"}};

constexpr std::array kStats{FieldReference{"path", "a JSON file"}};

constexpr std::array kScreenshot{
    FieldReference{"path", "a PNG file"},
    FieldReference{"size", "[width, height] in pixels, each 16 to 8192 ([1280, 960])"},
    FieldReference{"camera",
                   "\"fit\", or {\"eye\": [x, y, z], \"target\": [x, y, z]} with up and fov"},
    FieldReference{"show", "any of [\"wireframe\", \"lattice\", \"levels\"]"}};

constexpr std::array kCommands{
    CommandReference{"open", "reads a model", kOpen},
    CommandReference{"shape", "makes a model", kShape},
    CommandReference{"adapt", "sets when the mesh is refined and decimated", kAdapt},
    CommandReference{"brush", "drags use a lattice around the grabbed point", kBrush},
    CommandReference{"cage", "drags use this lattice: origin, cell, deformable; or fit", kCage},
    CommandReference{"symmetry", "drags happen on both sides of a plane", kSymmetry},
    CommandReference{"drag", "drags points; the object follows", kDrag},
    CommandReference{"control", "moves control points of the cage", kControl},
    CommandReference{"undo", "undoes edits", kCount},
    CommandReference{"redo", "does undone edits again", kCount},
    CommandReference{"history", "sets how much memory undo and redo may take", kHistory},
    CommandReference{
        "readapt",
        "refines and decimates the whole object once, also what was rough before drags moved it",
        {}},
    CommandReference{"bake", "makes the refined mesh the base mesh", {}},
    CommandReference{"save", "writes the model, and copies material files that are not there yet",
                     kSave},
    CommandReference{"stats", "writes figures of the object, its input and the last edit", kStats},
    CommandReference{"screenshot", "draws the object", kScreenshot}};

static_assert(kCommands.size() == std::variant_size_v<Command>);

}  // namespace

std::span<const CommandReference> command_reference() { return kCommands; }

}  // namespace pectin
