// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAHDInput.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
template <typename Number>
vtkAHDInput::Oddities Find(const Number* xyz, const ahd::PointView& points)
{
  vtkAHDInput::Oddities odd;
  for (std::size_t i = 0; i < points.count; ++i, xyz += 3)
  {
    if (points.skipped(i))
    {
      continue;
    }
    if (!std::isfinite(xyz[0]) || !std::isfinite(xyz[1]))
    {
      odd.FirstRejected = odd.FirstRejected < 0 ? static_cast<vtkIdType>(i) : odd.FirstRejected;
    }
    else if (!std::isfinite(xyz[2]))
    {
      ++odd.OddZ;
    }
  }
  return odd;
}
}

vtkAHDInput::vtkAHDInput(vtkPointSet* points)
{
  if (points && points->GetPoints() && points->GetNumberOfPoints() > 0)
  {
    this->Coordinates = points->GetPoints()->GetData();
    this->Count = points->GetNumberOfPoints();
    vtkUnsignedCharArray* marks = points->GetPointGhostArray();
    this->MarksAreUnfit = marks &&
      (marks->GetNumberOfComponents() != 1 || marks->GetNumberOfTuples() != this->Count);
    if (marks && !this->MarksAreUnfit)
    {
      this->Points.skip = marks->GetPointer(0);
      this->Points.skipMask = vtkDataSetAttributes::DUPLICATEPOINT |
        vtkDataSetAttributes::HIDDENPOINT;
    }
  }
}

std::size_t vtkAHDInput::GetBytesToConvert() const
{
  const bool inPlace = !this->Coordinates || vtkArrayDownCast<vtkFloatArray>(this->Coordinates) ||
    vtkArrayDownCast<vtkDoubleArray>(this->Coordinates);
  return inPlace ? 0 : static_cast<std::size_t>(this->Count) * 3 * sizeof(double);
}

ahd::PointView vtkAHDInput::View()
{
  this->Points.count = static_cast<std::size_t>(this->Count);
  this->Points.stride = 3;
  if (auto* floats = vtkArrayDownCast<vtkFloatArray>(this->Coordinates))
  {
    this->Points.floats = floats->GetPointer(0);
  }
  else if (auto* doubles = vtkArrayDownCast<vtkDoubleArray>(this->Coordinates))
  {
    this->Points.doubles = doubles->GetPointer(0);
  }
  else if (this->Coordinates)
  {
    this->Converted.resize(this->Points.count * 3);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      this->Coordinates->GetTuple(i, this->Converted.data() + 3 * i);
    }
    this->Points.doubles = this->Converted.data();
  }
  return this->Points;
}

vtkAHDInput::Oddities vtkAHDInput::FindOddities() const
{
  return this->Points.floats ? Find(this->Points.floats, this->Points)
                             : Find(this->Points.doubles, this->Points);
}
