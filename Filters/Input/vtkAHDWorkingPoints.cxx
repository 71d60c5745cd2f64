// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDWorkingPoints.h"

#include "Pipeline/vtkAHDLoop.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

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

vtkAHDWorkingPoints::vtkAHDWorkingPoints(vtkPointSet* input)
{
  if (input && input->GetPoints() && input->GetNumberOfPoints() > 0)
  {
    this->Coordinates = input->GetPoints()->GetData();
    this->InputCount = input->GetNumberOfPoints();
    vtkUnsignedCharArray* marks = input->GetPointGhostArray();
    const bool fit = marks && marks->GetNumberOfComponents() == 1 &&
      marks->GetNumberOfTuples() == this->InputCount;
    this->MarksAreUnfit = !fit &&
      input->GetPointData()->HasArray(vtkDataSetAttributes::GhostArrayName()) != 0;
    if (fit)
    {
      this->Points.skip = marks->GetPointer(0);
      this->Points.skipMask = vtkDataSetAttributes::DUPLICATEPOINT |
        vtkDataSetAttributes::HIDDENPOINT;
    }
  }
}

bool vtkAHDWorkingPoints::MustBeConverted() const
{
  return this->Coordinates && !vtkArrayDownCast<vtkFloatArray>(this->Coordinates) &&
    !vtkArrayDownCast<vtkDoubleArray>(this->Coordinates);
}

bool vtkAHDWorkingPoints::Open(ahd::Executor& executor, vtkAHDProgress& progress)
{
  this->Points.count = static_cast<std::size_t>(this->InputCount);
  this->Points.stride = 3;
  if (auto* floats = vtkArrayDownCast<vtkFloatArray>(this->Coordinates))
  {
    this->Points.floats = floats->GetPointer(0);
  }
  else if (auto* doubles = vtkArrayDownCast<vtkDoubleArray>(this->Coordinates))
  {
    this->Points.doubles = doubles->GetPointer(0);
  }
  return !this->MustBeConverted() || this->Copy(executor, progress);
}

bool vtkAHDWorkingPoints::Copy(ahd::Executor& executor, vtkAHDProgress& progress)
{
  if (!this->Places.empty())
  {
    return true;
  }
  this->Places.resize(3 * this->Points.count);
  const bool mustBeConverted = this->MustBeConverted();
  const bool all = vtkAHDLoop(this->Points.count, executor, progress,
    [this, mustBeConverted](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        double* place = this->Places.data() + 3 * i;
        if (mustBeConverted)
        {
          this->Coordinates->GetTuple(static_cast<vtkIdType>(i), place);
        }
        else
        {
          const std::array<double, 3> p = this->GetPoint(i);
          std::copy(p.begin(), p.end(), place);
        }
      }
    });
  this->Points.floats = nullptr;
  this->Points.doubles = this->Places.data();
  return all;
}

double* vtkAHDWorkingPoints::Add(std::size_t count)
{
  const std::size_t before = this->Points.count;
  if (this->Points.skip)
  {
    std::vector<unsigned char> skip(before + count);
    for (std::size_t i = 0; i < before; ++i)
    {
      skip[i] = this->Points.skipped(i);
    }
    this->SetSkipped(std::move(skip));
  }
  this->Places.resize(3 * (before + count));
  this->Added += count;
  this->Points.count = before + count;
  this->Points.doubles = this->Places.data();
  return this->Places.data() + 3 * before;
}

void vtkAHDWorkingPoints::SetSkipped(std::vector<unsigned char>&& skip)
{
  this->Skip = std::move(skip);
  this->Points.skip = this->Skip.data();
  this->Points.skipMask = 0xFF;
}

bool vtkAHDWorkingPoints::FindBounds(
  ahd::Executor& executor, vtkAHDProgress& progress, ahd::Bounds& bounds) const
{
  constexpr double kNone = std::numeric_limits<double>::infinity();
  ahd::Bounds whole{ kNone, -kNone, kNone, -kNone };
  std::mutex mutex;
  const bool all = vtkAHDLoop(this->Points.count, executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      ahd::Bounds piece{ kNone, -kNone, kNone, -kNone };
      for (std::size_t i = begin; i < end; ++i)
      {
        const ahd::Point p = this->Points[i];
        if (ahd::isFinite(p) && !this->Points.skipped(i))
        {
          piece = { std::min(piece.xmin, p.x), std::max(piece.xmax, p.x), std::min(piece.ymin, p.y),
            std::max(piece.ymax, p.y) };
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      whole = { std::min(whole.xmin, piece.xmin), std::max(whole.xmax, piece.xmax),
        std::min(whole.ymin, piece.ymin), std::max(whole.ymax, piece.ymax) };
    });
  bounds = whole;
  return all;
}

bool vtkAHDWorkingPoints::FindOddities(
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
