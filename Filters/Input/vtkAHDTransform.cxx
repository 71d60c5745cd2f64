// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDTransform.h"

#include "Input/vtkAHDPlane.h"
#include "Pipeline/vtkAHDLoop.h"

#include "vtkAbstractTransform.h"
#include "vtkHomogeneousTransform.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <limits>

namespace
{
using Xyz = std::array<double, 3>;

Xyz Read(const ahd::PointView& points, std::size_t i)
{
  if (points.doubles)
  {
    const double* p = points.doubles + 3 * i;
    return { { p[0], p[1], p[2] } };
  }
  const float* p = points.floats + 3 * i;
  return { { p[0], p[1], p[2] } };
}

/// A transform may make anything of a coordinate that is not finite, even a finite one.
void Write(const Xyz& from, const double* to, double* xyz)
{
  const bool isFinite = from[0] * 0 + from[1] * 0 + from[2] * 0 == 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    xyz[k] = isFinite ? to[k] : std::numeric_limits<double>::quiet_NaN();
  }
}

/// Through the method that takes many points: those that not every transform can do one by one.
bool ProjectInTurn(const ahd::PointView& points, vtkAbstractTransform* transform, double* xyz,
  vtkAHDProgress& progress)
{
  constexpr std::size_t kPiece = std::size_t(1) << 14;
  vtkNew<vtkPoints> from;
  vtkNew<vtkPoints> to;
  from->SetDataTypeToDouble();
  to->SetDataTypeToDouble();
  for (std::size_t begin = 0; begin < points.count; begin += kPiece)
  {
    if (progress.MustAbort())
    {
      return false;
    }
    const std::size_t end = std::min(points.count, begin + kPiece);
    from->SetNumberOfPoints(static_cast<vtkIdType>(end - begin));
    for (std::size_t i = begin; i < end; ++i)
    {
      from->SetPoint(static_cast<vtkIdType>(i - begin), Read(points, i).data());
    }
    from->Modified();
    to->Reset();
    transform->TransformPoints(from, to);
    for (std::size_t i = begin; i < end; ++i)
    {
      Xyz place;
      to->GetPoint(static_cast<vtkIdType>(i - begin), place.data());
      Write(Read(points, i), place.data(), xyz + 3 * i);
    }
  }
  return true;
}
}

bool vtkAHDProject(const ahd::PointView& points, const vtkAHDPlane& plane, double* xyz,
  ahd::Executor& executor, vtkAHDProgress& progress)
{
  return vtkAHDLoop(points.count, executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Xyz from = Read(points, i);
        Write(from, plane.Project(from).data(), xyz + 3 * i);
      }
    });
}

bool vtkAHDProject(const ahd::PointView& points, vtkAbstractTransform* transform, double* xyz,
  ahd::Executor& executor, vtkAHDProgress& progress)
{
  transform->Update();
  if (!vtkHomogeneousTransform::SafeDownCast(transform))
  {
    return ProjectInTurn(points, transform, xyz, progress);
  }
  return vtkAHDLoop(points.count, executor, progress,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Xyz from = Read(points, i);
        Xyz to;
        transform->InternalTransformPoint(from.data(), to.data());
        Write(from, to.data(), xyz + 3 * i);
      }
    });
}
