// Small meshes from OBJ text, real ones from the models folder, and measurements of any mesh.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/tri_mesh.h"

namespace pectin::test {

// crease_angle: in degrees, see BuildOptions.
TriMesh mesh_of(const std::string& obj_text, double crease_angle = 45.0);

// Paths of the real models; empty if the folder is absent.
std::vector<std::string> real_models();

std::vector<EdgeId> live_edges(const TriMesh& mesh);
std::vector<FaceId> live_faces(const TriMesh& mesh);

// V - E + F. Vertices without a face count, except those that a seam has joined to others; siblings
// along a cut count as one edge.
int euler_characteristic(const TriMesh& mesh);
double area(const TriMesh& mesh);
// The angle in degrees that the given fraction of the triangles' smallest angles are below.
double smallest_angle_quantile(const TriMesh& mesh, double fraction);

// The edge between two vertices. Precondition: it exists.
EdgeId edge_between(const TriMesh& mesh, std::uint32_t v, std::uint32_t w);

// The number of pairs of an edge and a face that intersect and share no corner.
std::size_t crossings(const TriMesh& mesh);

// Mirrors all vertices and edge midpoints at x = 0, and returns the largest distance from an image
// to the nearest original.
double asymmetry(const TriMesh& mesh);

// The number of polygon sides without another side between the same two positions, in either
// direction; the vertices need not be shared. Cracks and open borders have such sides.
std::size_t open_sides(const IndexedFaceSet& set);
// Edges with one face and no siblings.
std::size_t open_edges(const TriMesh& mesh);

// The number of faces without a mirror image across the plane where the axis (0 to 2) has the value
// `middle`. The corners of an image are within `tolerance` of the mirrored corners.
std::size_t faces_without_image(const TriMesh& mesh, int axis, double tolerance,
                                double middle = 0.0);

// Whether `mesh` has exactly the faces, corners and positions of `base`, in the same slots.
bool has_the_faces_of(const TriMesh& mesh, const TriMesh& base);

}  // namespace pectin::test
