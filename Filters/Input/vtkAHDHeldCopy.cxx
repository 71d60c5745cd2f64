// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDHeldCopy.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{
/// Points that leave the time of their array alone: vtkPoints::Modified(), which SetData() calls,
/// is the array's, too, so that all other owners of the array would execute again.
class SharingPoints : public vtkPoints
{
public:
  static SharingPoints* New() { VTK_STANDARD_NEW_BODY(SharingPoints); }
  vtkTypeMacro(SharingPoints, vtkPoints);
  void Modified() override { this->vtkObject::Modified(); }

protected:
  SharingPoints() = default;
};

/// Null for no cells: there VTK hands out an empty array that all share.
vtkSmartPointer<vtkCellArray> CopyOf(vtkCellArray* cells)
{
  vtkSmartPointer<vtkCellArray> copy;
  if (cells && cells->GetNumberOfCells() > 0)
  {
    copy = vtkSmartPointer<vtkCellArray>::New();
    copy->ShallowCopy(cells);
  }
  return copy;
}
}

vtkSmartPointer<vtkPolyData> vtkAHDHeldCopy(vtkPointSet* data)
{
  if (!data)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  if (auto* withCells = vtkPolyData::SafeDownCast(data))
  {
    copy->ShallowCopy(withCells);
    copy->SetVerts(CopyOf(withCells->GetVerts()));
    copy->SetLines(CopyOf(withCells->GetLines()));
    copy->SetPolys(CopyOf(withCells->GetPolys()));
    copy->SetStrips(CopyOf(withCells->GetStrips()));
  }
  else
  {
    copy->SetPoints(data->GetPoints());
    copy->GetPointData()->ShallowCopy(data->GetPointData());
  }
  vtkAHDOwnPoints(copy);
  return copy;
}

void vtkAHDOwnPoints(vtkPointSet* copy)
{
  if (vtkPoints* const shared = copy ? copy->GetPoints() : nullptr)
  {
    vtkNew<SharingPoints> points;
    points->SetData(shared->GetData());
    copy->SetPoints(points);
  }
}
