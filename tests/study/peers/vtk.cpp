#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <map>
#include <stdexcept>

#include "study/peers/peers.h"
#include "study/scene.h"

namespace pectin::study {
namespace {

using Key = std::array<double, 3>;

}  // namespace

DecimatedTriangles decimate_by_vtk(const IndexedTriangles& input, std::size_t triangles) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    std::map<Key, std::uint32_t> index_at;  // the filter renumbers what it keeps
    for (std::size_t i = 0; i < input.positions.size(); ++i) {
        const Vec3& p = input.positions[i];
        points->InsertNextPoint(p.x, p.y, p.z);
        index_at.emplace(Key{p.x, p.y, p.z}, static_cast<std::uint32_t>(i));
    }
    vtkNew<vtkCellArray> cells;
    for (std::size_t i = 0; i < input.corners.size(); i += 3) {
        const vtkIdType corners[3] = {input.corners[i], input.corners[i + 1], input.corners[i + 2]};
        cells->InsertNextCell(3, corners);
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);

    vtkNew<vtkDecimatePro> filter;
    filter->SetInputData(mesh);
    filter->SetTargetReduction(1.0 - 3.0 * static_cast<double>(triangles) /
                                         static_cast<double>(input.corners.size()));
    filter->PreserveTopologyOn();
    filter->BoundaryVertexDeletionOff();
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    DecimatedTriangles result;
    result.seconds = seconds([&] { filter->Update(); });

    vtkPolyData* const output = filter->GetOutput();
    vtkNew<vtkIdList> corners;
    output->GetPolys()->InitTraversal();
    while (output->GetPolys()->GetNextCell(corners)) {
        for (vtkIdType k = 0; k < 3; ++k) {
            double p[3];
            output->GetPoint(corners->GetId(k), p);
            const auto found = index_at.find({p[0], p[1], p[2]});
            if (found == index_at.end()) throw std::runtime_error("vtkDecimatePro moved a point");
            result.corners.push_back(found->second);
        }
    }
    return result;
}

}  // namespace pectin::study
