// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDAppendedPolygons.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

vtkSmartPointer<vtkPolyData> vtkAHDAppendPolygons(
  const std::vector<vtkSmartPointer<vtkDataObject>>& parts)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkDoubleArray> numbers;
  bool hasNumbers = false;
  for (const auto& part : parts)
  {
    auto* const data = vtkPolyData::SafeDownCast(part);
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(data->GetPoint(i));
    }
    vtkDataArray* const given = data->GetCellData()->GetArray(0);
    hasNumbers = hasNumbers || given;
    vtkNew<vtkIdList> ids;
    for (vtkIdType k = 0; k < data->GetNumberOfPolys(); ++k)
    {
      data->GetPolys()->GetCellAtId(k, ids);
      polygons->InsertNextCell(ids->GetNumberOfIds());
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        const vtkIdType id = ids->GetId(i);
        const bool isOwn = id >= 0 && id < data->GetNumberOfPoints();
        polygons->InsertCellPoint(isOwn ? first + id : -1); // no other part's
      }
      numbers->InsertNextValue(given ? given->GetComponent(k, 0) : 0.0);
    }
  }
  auto appended = vtkSmartPointer<vtkPolyData>::New();
  appended->SetPoints(points);
  appended->SetPolys(polygons);
  if (hasNumbers)
  {
    appended->GetCellData()->AddArray(numbers);
  }
  return appended;
}
