// Decimation by other libraries, for comparison. They are not part of the product.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace pectin::study {

struct IndexedTriangles {
    std::vector<Vec3> positions;         // those that no triangle uses are allowed
    std::vector<std::uint32_t> corners;  // three for each triangle
};

struct DecimatedTriangles {
    std::vector<std::uint32_t> corners;  // into the positions of the input
    double seconds = 0.0;                // for the decimation alone, without conversion
};

// Both remove vertices of the input until about so many triangles are left, whatever the error.

// vtkDecimatePro. Source: W. J. Schroeder, J. A. Zarge, W. E. Lorensen. Decimation of triangle
// meshes. SIGGRAPH 1992, with the priority queue that VTK adds. Topology is preserved.
DecimatedTriangles decimate_by_vtk(const IndexedTriangles& input, std::size_t triangles);

// meshopt_simplify: edge collapses by quadric errors.
DecimatedTriangles decimate_by_meshoptimizer(const IndexedTriangles& input, std::size_t triangles);

}  // namespace pectin::study
