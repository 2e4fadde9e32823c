// Random commands of a session, executed as a script or as the mouse does.
#pragma once

#include <cstddef>
#include <functional>

#include "command/command.h"
#include "session/session.h"
#include "support/random_mesh.h"

namespace pectin::test {

// A random vertex of the mesh or a random point of a face.
Vec3 random_surface_point(const TriMesh& mesh, Random& random);

// A random command: a drag of a surface point or of control points, a setting, undo, redo, readapt
// or bake. `size`: half the object's extent; lengths are proportional to it. The budget is at most
// 5,000 triangles unless `budget` is larger.
Command random_command(const TriMesh& mesh, Random& random, double size = 1.0,
                       std::uint64_t budget = 5'000);

// Executes the command and returns whether it was accepted. Some drags are executed frame by frame,
// as by the mouse, and `each_frame` is called after every frame. Refused and cancelled commands do
// not change the mesh; this is checked for cancelled drags.
bool execute(Session& session, const Command& command, Random& random,
             const std::function<void()>& each_frame = {});

// Undoes all steps; returns their number.
std::size_t undo_everything(Session& session);

}  // namespace pectin::test
