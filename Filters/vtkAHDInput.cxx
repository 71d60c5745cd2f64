// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAHDInput.h"

#include "vtkAHDLoop.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <atomic>
#include <cmath>

namespace
{
/// Is there anything in [begin, end) for FindOddities() to look at? Sums that become NaN with the
/// first number that is not finite: nothing to branch on, since there hardly ever is one.
template <typename Number>
bool AllFinite(const Number* begin, const Number* end)
{
  Number x = 0, y = 0, z = 0;
  for (const Number* p = begin; p != end; p += 3)
  {
    x += p[0] * 0;
    y += p[1] * 0;
    z += p[2] * 0;
  }
  return x + y + z == 0;
}

/// What the pieces of a loop find, each with few writes.
struct Found
{
  std::atomic<vtkIdType> FirstRejected{ VTK_ID_MAX };
  std::atomic<vtkIdType> OddZ{ 0 };

  void Reject(vtkIdType id)
  {
    vtkIdType least = this->FirstRejected;
    while (id < least && !this->FirstRejected.compare_exchange_weak(least, id))
    {
    }
  }
};

template <typename Number>
void Find(
  const Number* xyz, const ahd::PointView& points, std::size_t begin, std::size_t end, Found& found)
{
  if (AllFinite(xyz + 3 * begin, xyz + 3 * end))
  {
    return;
  }
  for (std::size_t i = begin; i < end; ++i)
  {
    const Number* p = xyz + 3 * i;
    if (points.skipped(i))
    {
      continue;
    }
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
    {
      found.Reject(static_cast<vtkIdType>(i));
    }
    else if (!std::isfinite(p[2]))
    {
      ++found.OddZ;
    }
  }
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

bool vtkAHDInput::Open(ahd::Executor& executor, vtkAHDProgress& progress)
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
    this->Converted.reset(new double[this->Points.count * 3]);
    this->Points.doubles = this->Converted.get();
    return vtkAHDLoop(this->Points.count, executor, progress,
      [this](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->Coordinates->GetTuple(static_cast<vtkIdType>(i), this->Converted.get() + 3 * i);
        }
      });
  }
  return true;
}

bool vtkAHDInput::FindOddities(
  ahd::Executor& executor, vtkAHDProgress& progress, Oddities& odd) const
{
  Found found;
  const bool all = vtkAHDLoop(this->Points.count, executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      if (this->Points.floats)
      {
        Find(this->Points.floats, this->Points, begin, end, found);
      }
      else
      {
        Find(this->Points.doubles, this->Points, begin, end, found);
      }
    });
  odd.FirstRejected = found.FirstRejected;
  odd.OddZ = found.OddZ;
  return all;
}
