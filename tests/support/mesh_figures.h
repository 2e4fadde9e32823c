// Small meshes from OBJ text, real ones from the models folder, and figures of any.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin::test {

// crease_angle: degrees, as build_mesh has it.
TriMesh mesh_of(const std::string& obj_text, double crease_angle = 45.0);

// Paths of the real models; empty where the folder is absent.
std::vector<std::string> real_models();

std::vector<EdgeId> live_edges(const TriMesh& mesh);
std::vector<FaceId> live_faces(const TriMesh& mesh);

// V - E + F, counting also vertices without a face, except those that a seam has joined to others;
// edges that a cut has laid along each other are
// one.
int euler_characteristic(const TriMesh& mesh);
double area(const TriMesh& mesh);

// The edge between two vertices; the mesh has it.
EdgeId edge_between(const TriMesh& mesh, std::uint32_t v, std::uint32_t w);

// Edges that pass through a face they share no corner with, and those faces: how many pairs.
std::size_t crossings(const TriMesh& mesh);

// The farthest that the image of a vertex or of the middle of an edge, mirrored at x = 0, is from
// the nearest of them.
double asymmetry(const TriMesh& mesh);

// How many sides of the polygons have no other side with the same two positions, in either
// direction; the vertices need not be shared. A crack or an open border has such sides.
std::size_t open_sides(const IndexedFaceSet& set);
// Edges with one face and no siblings.
std::size_t open_edges(const TriMesh& mesh);

// How many faces have no mirror image: one whose corners lie within `tolerance` of the images of
// its corners in the plane where the axis (0 to 2) has the value `middle`.
std::size_t faces_without_image(const TriMesh& mesh, int axis, double tolerance,
                                double middle = 0.0);

// Whether `mesh` has the faces, corners and positions of `base`, in the same slots, and no others.
bool has_the_faces_of(const TriMesh& mesh, const TriMesh& base);

}  // namespace pectin::test
