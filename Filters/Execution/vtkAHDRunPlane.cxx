// SPDX-License-Identifier: BSD-3-Clause
//
// The steps of an execution that say where points lie in the plane of the triangulation.
#include "Execution/vtkAHDRun.h"

#include "Input/vtkAHDBounding.h"
#include "Input/vtkAHDPlane.h"
#include "Input/vtkAHDTransform.h"
#include "Pipeline/vtkAHDLoop.h"
#include "vtkAdaptiveHilbertDelaunay2D.h"

#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace
{
struct Box
{
  vtkAHDVector Low;
  vtkAHDVector High;

  Box()
  {
    this->Low.fill(std::numeric_limits<double>::infinity());
    this->High.fill(-std::numeric_limits<double>::infinity());
  }
  void Add(std::size_t k, double low, double high)
  {
    this->Low[k] = std::min(this->Low[k], low);
    this->High[k] = std::max(this->High[k], high);
  }
};

/// Around the points that take part; of their z those that are finite. Returns false if the filter
/// is to abort.
bool FindBox(
  const vtkAHDWorkingPoints& points, ahd::Executor& executor, vtkAHDProgress& progress, Box& box)
{
  std::mutex mutex;
  return vtkAHDLoop(points.View().count, executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      Box part;
      for (std::size_t i = begin; i < end; ++i)
      {
        const vtkAHDVector p = points.GetPoint(i);
        if (std::isfinite(p[0]) && std::isfinite(p[1]) && !points.View().skipped(i))
        {
          part.Add(0, p[0], p[0]);
          part.Add(1, p[1], p[1]);
          if (std::isfinite(p[2]))
          {
            part.Add(2, p[2], p[2]);
          }
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t k = 0; k < 3; ++k)
      {
        box.Add(k, part.Low[k], part.High[k]);
      }
    });
}
}

bool vtkAHDRun::IsProjected() const
{
  return this->Filter->ProjectionPlaneMode == VTK_BEST_FITTING_PLANE || this->Filter->Transform;
}

ahd::Status vtkAHDRun::Project()
{
  if (!this->IsProjected())
  {
    return ahd::Status::Ok;
  }
  vtkAHDPlane plane;
  const bool isFitted = this->Filter->ProjectionPlaneMode == VTK_BEST_FITTING_PLANE;
  ahd::PointView own = this->Points.View();
  own.count = static_cast<std::size_t>(this->Points.GetInputCount());
  if ((isFitted && !plane.Fit(own, this->Executor, this->Progress)) ||
    !this->Points.Copy(this->Executor, this->Progress))
  {
    return ahd::Status::Cancelled;
  }
  this->ToPlane = this->Filter->Transform;
  if (isFitted)
  {
    this->ToPlane = plane.MakeTransform();
  }
  const ahd::PointView& all = this->Points.View();
  double* places = this->Points.GetPlaces();
  const bool done = isFitted
    ? vtkAHDProject(all, plane, places, this->Executor, this->Progress)
    : vtkAHDProject(all, this->Filter->Transform, places, this->Executor, this->Progress);
  return done ? ahd::Status::Ok : ahd::Status::Cancelled;
}

ahd::Status vtkAHDRun::AddBounding()
{
  if (!this->Filter->BoundingTriangulation || this->IsProjected())
  {
    return ahd::Status::Ok;
  }
  Box box;
  if (!FindBox(this->Points, this->Executor, this->Progress, box))
  {
    return ahd::Status::Cancelled;
  }
  if (box.Low[0] > box.High[0])
  {
    return ahd::Status::Ok; // no point to put them around
  }
  if (box.Low[2] > box.High[2])
  {
    box.Low[2] = box.High[2] = 0.0;
  }
  if (!this->Points.Copy(this->Executor, this->Progress))
  {
    return ahd::Status::Cancelled;
  }
  const auto eight = vtkAHDMakeBounding(box.Low, box.High, this->Filter->Offset);
  double* places = this->Points.Add(eight.size());
  for (const vtkAHDVector& p : eight)
  {
    places = std::copy(p.begin(), p.end(), places);
  }
  return ahd::Status::Ok;
}

void vtkAHDRun::WarnOfPlane()
{
  if (this->Filter->ProjectionPlaneMode == VTK_SET_TRANSFORM_PLANE && !this->Filter->Transform)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "ProjectionPlaneMode asks for a Transform, but none is set: the points were triangulated in "
      "x and y.");
  }
  if (this->Filter->BoundingTriangulation && this->IsProjected())
  {
    vtkWarningWithObjectMacro(this->Filter,
      "There is no bounding triangulation, because the points are triangulated in another plane "
      "than x and y.");
  }
}
