#include "command/reference.h"

namespace pectin {

namespace {

std::vector<CommandReference> make_reference() {
    return {
        {"open",
         "reads a model",
         {{"path", "an OBJ file"},
          {"crease_angle", "0 to 180 (45); where the file has no normals or smoothing groups"}}},
        {"shape",
         "makes a model",
         {{"kind", "sphere, cube, plane, torus or cylinder"},
          {"resolution", "a whole number; the sphere has 20 * 4^resolution faces"}}},
        {"adapt",
         "sets when the mesh is refined and decimated",
         {{"enabled", "true or false"},
          {"theta_max", "angle above which an edge is refined (180/7), or null: off"},
          {"theta_min",
           "angle below which it may be decimated, \"auto\" (7/9 of theta_max) or null"},
          {"l_max", "longest edge, \"auto\" (smallest cell extent) or null: off"},
          {"flatness", "bump that decimation may take, to its edge, \"auto\" or null: off"},
          {"floor", "no edge shorter than twice this is split; \"auto\": 1e-4 of the diagonal"},
          {"budget", "most triangles (4000000)"},
          {"propagation", "1 to below 1.5 (1): how much longer an edge may be that waits"}}},
        {"brush",
         "drags use a lattice about the grabbed point",
         {{"radius", "its reach (a quarter of the box diagonal)"},
          {"span", "1 to 16 (3): deformable control points an axis"}}},
        {"cage",
         "drags use this lattice: origin, cell, deformable; or fit",
         {{"origin", "[x, y, z] of its control point [0, 0, 0]"},
          {"cell", "[x, y, z]: its cell extents"},
          {"deformable", "[l, m, n], each 1 to 256: its deformable control points"},
          {"margin", "[i, j, k], each 0 to 2 (0): layers beyond these on each side, too"},
          {"fit", "[l, m, n], each 1 to 254: as many on the object's box, one layer beyond it"}}},
        {"symmetry",
         "drags happen on both sides of a plane",
         {{"plane", "\"x\", \"y\", \"z\": the axis it is perpendicular to, or null: off"},
          {"through", "[x, y, z]: a point on it ([0, 0, 0])"}}},
        {"drag",
         "drags points; the object follows",
         {{"moves",
           "[{\"from\": [x, y, z], \"to\": [x, y, z]}, ...]; with twist {\"axis\": [x, y, z], "
           "\"degrees\": up to 3600 either way}, scale (1; 0.001 to 1000)"},
          {"pins", "[[x, y, z], ...]: points that stay"},
          {"connected", "true: only the surface that is connected to the points (false)"},
          {"fold_free",
           "true: in steps, none of which folds space, and leaving no triangles that cut (false)"},
          {"via", "[[x, y, z], ...]: waypoints of the first move"}}},
        {"control",
         "moves control points of the cage",
         {{"points", "[{\"index\": [i, j, k], \"to\": [x, y, z]}, ...]"}}},
        {"undo", "takes edits back", {{"count", "how many (1)"}}},
        {"redo", "does undone edits again", {{"count", "how many (1)"}}},
        {"history",
         "sets how much memory undo and redo may take",
         {{"megabytes", "above 0 (1000), or null: no limit; the oldest steps are dropped first"}}},
        {"readapt", "refines and decimates the whole object once", {}},
        {"bake", "makes the refined mesh the base mesh", {}},
        {"save",
         "writes the model, with its material files where these are not there yet",
         {{"path", "an OBJ file"}}},
        {"stats",
         "writes figures of the object, its input and the last edit",
         {{"path", "a JSON file"}}},
        {"screenshot",
         "draws the object",
         {{"path", "a PNG file"},
          {"size", "[width, height] in pixels, each 16 to 8192 ([1280, 960])"},
          {"camera", "\"fit\", or {\"eye\": [x, y, z], \"target\": [x, y, z]} with up and fov"},
          {"show", "any of [\"wireframe\", \"lattice\", \"levels\"]"}}},
    };
}

}  // namespace

std::span<const CommandReference> command_reference() {
    static const std::vector<CommandReference> kReference = make_reference();
    return kReference;
}

}  // namespace pectin
