// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDProjection.h"

#include "Pipeline/vtkAHDContext.h"

#include "vtkAbstractTransform.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <algorithm>
#include <array>
#include <limits>

namespace
{
using Xyz = std::array<double, 3>;

/// A transform may make anything of a coordinate that is not finite, even a finite one.
void Write(const Xyz& from, const double* to, double* xyz)
{
  const bool isFinite = from[0] * 0 + from[1] * 0 + from[2] * 0 == 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    xyz[k] = isFinite ? to[k] : std::numeric_limits<double>::quiet_NaN();
  }
}
}

bool vtkAHDProjection::project(const ahd::PointView& points, double* to, const ahd::Context&) const
{
  this->Transform->Update();
  if (!vtkHomogeneousTransform::SafeDownCast(this->Transform))
  {
    return this->ProjectInTurn(points, to);
  }
  return this->Context->TryRange(points.count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Xyz from = points.place(i);
        Xyz place;
        this->Transform->InternalTransformPoint(from.data(), place.data());
        Write(from, place.data(), to + 3 * i);
      }
    });
}

/// Through the method that takes many points: those that not every transform can do one by one.
bool vtkAHDProjection::ProjectInTurn(const ahd::PointView& points, double* to) const
{
  constexpr std::size_t kPiece = std::size_t(1) << 14;
  vtkNew<vtkPoints> from;
  vtkNew<vtkPoints> moved;
  from->SetDataTypeToDouble();
  moved->SetDataTypeToDouble();
  for (std::size_t begin = 0; begin < points.count; begin += kPiece)
  {
    if (this->Context->IsAborted())
    {
      return false;
    }
    const std::size_t end = std::min(points.count, begin + kPiece);
    from->SetNumberOfPoints(static_cast<vtkIdType>(end - begin));
    for (std::size_t i = begin; i < end; ++i)
    {
      from->SetPoint(static_cast<vtkIdType>(i - begin), points.place(i).data());
    }
    from->Modified();
    moved->Reset();
    this->Transform->TransformPoints(from, moved);
    for (std::size_t i = begin; i < end; ++i)
    {
      Xyz place;
      moved->GetPoint(static_cast<vtkIdType>(i - begin), place.data());
      Write(points.place(i), place.data(), to + 3 * i);
    }
  }
  return true;
}

vtkSmartPointer<vtkTransform> vtkAHDMakeTransform(const ahd::Plane& plane)
{
  const ahd::Vector3* const axes[] = { &plane.firstAxis(), &plane.secondAxis(), &plane.normal() };
  const ahd::Vector3 origin = plane.project({ { 0, 0, 0 } });
  vtkNew<vtkMatrix4x4> matrix;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      matrix->SetElement(static_cast<int>(row), static_cast<int>(column), (*axes[row])[column]);
    }
    matrix->SetElement(static_cast<int>(row), 3, origin[row]);
  }
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->SetMatrix(matrix);
  return transform;
}
