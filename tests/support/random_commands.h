// Random commands of a session, carried out as a script or as a mouse would.
#pragma once

#include <cstddef>
#include <functional>

#include "command/command.h"
#include "session/session.h"
#include "support/random_mesh.h"

namespace pectin::test {

// A vertex of the mesh or a point within a face.
Vec3 random_surface_point(const TriMesh& mesh, Random& random);

// Drags of points of the surface, control points, settings, undo, redo, readapt and bake.
// `size`: half the length of the object's side; lengths are drawn in proportion to it. The budget
// stays at 5,000 triangles unless `budget` is larger.
Command random_command(const TriMesh& mesh, Random& random, double size = 1.0,
                       std::uint64_t budget = 5'000);

// Executes the command, a drag sometimes frame by frame as a mouse does it; `each_frame` is called
// after every such frame. Whether it was done; refused and cancelled commands leave the mesh as it
// was, which is checked for cancelled drags.
bool execute(Session& session, const Command& command, Random& random,
             const std::function<void()>& each_frame = {});

// Undoes steps until none is left. How many there were.
std::size_t undo_everything(Session& session);

}  // namespace pectin::test
