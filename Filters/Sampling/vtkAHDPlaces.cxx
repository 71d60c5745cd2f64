// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/vtkAHDPlaces.h"

#include "Input/vtkAHDProjection.h"

#include "vtkDataSet.h"
#include "vtkPointSet.h"

#include <algorithm>

vtkAHDPlaces::vtkAHDPlaces(vtkDataSet* places)
  : Set(places)
  , Count(static_cast<std::size_t>(places->GetNumberOfPoints()))
{
  if (auto* points = vtkPointSet::SafeDownCast(places))
  {
    this->View = std::make_unique<vtkAHDPointsView>(points->GetPoints());
  }
}

std::size_t vtkAHDPlaces::EstimateBytes(bool isProjected) const
{
  const std::size_t copy = 3 * sizeof(double) * this->Count;
  const std::size_t inPython = 2 * sizeof(double) * this->Count; // x and y in a copy, always
  return inPython + (this->View ? this->View->EstimateBytes() : 0) +
    (!this->View || isProjected ? copy : 0);
}

ahd::PointView vtkAHDPlaces::Open(
  const vtkAHDSettings& settings, const ahd::PreparedInput& points, const vtkAHDContext& context)
{
  if (this->Count == 0)
  {
    return ahd::PointView();
  }
  ahd::PointView view;
  if (this->View)
  {
    view = this->View->Open(context);
  }
  else
  {
    this->Read(context);
    view = ahd::PointView(this->Copy.data(), this->Count, 3);
  }
  if (settings.isProjected())
  {
    this->Move(view, settings, points, context);
    view = ahd::PointView(this->Copy.data(), this->Count, 3);
  }
  return view;
}

/// Points that the data set computes.
void vtkAHDPlaces::Read(const vtkAHDContext& context)
{
  this->Copy.resize(3 * this->Count);
  double* const xyz = this->Copy.data();
  this->Set->GetPoint(0, xyz); // by several threads only after this one
  context.ForRange(this->Count,
    [this, xyz](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Set->GetPoint(static_cast<vtkIdType>(i), xyz + 3 * i);
      }
    });
}

/// `from` may be the copy itself.
void vtkAHDPlaces::Move(const ahd::PointView& from, const vtkAHDSettings& settings,
  const ahd::PreparedInput& points, const vtkAHDContext& context)
{
  this->Copy.resize(3 * this->Count);
  double* const xyz = this->Copy.data();
  if (settings.Transform)
  {
    vtkAHDProjection projection(settings.Transform);
    projection.SetContext(context);
    if (!projection.project(from, xyz, context))
    {
      throw vtkAHDStop{ ahd::Status::Cancelled };
    }
    return;
  }
  context.ForRange(this->Count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const ahd::Vector3 moved = points.plane().project(from.place(i));
        std::copy(moved.begin(), moved.end(), xyz + 3 * i);
      }
    });
}
