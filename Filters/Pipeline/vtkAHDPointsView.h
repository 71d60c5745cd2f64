// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDPointsView_h
#define vtkAHDPointsView_h

#include "Engine/Points/Points.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

/// Points as the engine reads them, x, y, z each: in place if they are floats or doubles.
/// Points of other types must be converted.
class vtkAHDPointsView
{
public:
  /// Holds the current array of the points; null: none.
  explicit vtkAHDPointsView(vtkPoints* points)
    : Data(points && points->GetNumberOfPoints() > 0 ? points->GetData() : nullptr)
    , Count(this->Data ? static_cast<std::size_t>(points->GetNumberOfPoints()) : 0)
  {
  }

  std::size_t GetCount() const { return this->Count; }

  /// Null if there are no points.
  vtkDataArray* GetData() const { return this->Data; }

  /// Are they neither floats nor doubles, point after point in memory?
  bool MustBeConverted() const
  {
    return this->Data && !vtkArrayDownCast<vtkFloatArray>(this->GetData()) &&
      !vtkArrayDownCast<vtkDoubleArray>(this->GetData());
  }

  /// Bytes of the converted points.
  std::size_t EstimateBytes() const
  {
    return this->MustBeConverted() ? 3 * sizeof(double) * this->Count : 0;
  }

  /// The points, converted if they must be. Valid as long as this object exists
  /// and the array keeps its memory. Throws
  /// vtkAHDStop on an abort, and std::bad_alloc.
  ahd::PointView Open(const vtkAHDContext& context)
  {
    if (auto* floats = vtkArrayDownCast<vtkFloatArray>(this->GetData()))
    {
      return ahd::PointView(floats->GetPointer(0), this->Count, 3);
    }
    if (auto* doubles = vtkArrayDownCast<vtkDoubleArray>(this->GetData()))
    {
      return ahd::PointView(doubles->GetPointer(0), this->Count, 3);
    }
    this->Converted.resize(3 * this->Count);
    context.ForRange(this->Count,
      [this](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->Data->GetTuple(static_cast<vtkIdType>(i), this->Converted.data() + 3 * i);
        }
      });
    return ahd::PointView(this->Converted.data(), this->Count, 3);
  }

private:
  vtkSmartPointer<vtkDataArray> Data;
  std::size_t Count;
  std::vector<double> Converted;
};

#endif
