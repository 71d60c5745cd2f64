// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDPlane.h"

#include "Input/vtkAHDFit.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

bool vtkAHDPlane::Fit(
  const ahd::PointView& points, ahd::Executor& executor, vtkAHDProgress& progress)
{
  vtkAHDFit fit;
  if (!fit.Run(points, executor, progress))
  {
    return false;
  }
  this->Origin = fit.Origin;
  this->Height = fit.Height;
  this->Shrink = fit.Shrink;
  this->Orient(fit.Normal);
  return true;
}

void vtkAHDPlane::Orient(vtkAHDVector normal)
{
  const double length = std::sqrt(vtkAHDDot(normal, normal));
  double most = 0.0;
  for (double& component : normal)
  {
    component /= length;
    most = std::max(most, std::fabs(component));
  }
  std::size_t main = 2;
  while (main > 0 && std::fabs(normal[main]) < most * (1 - 1e-6))
  {
    --main;
  }
  if (normal[main] < 0)
  {
    this->Height = -this->Height;
    for (double& component : normal)
    {
      component = 0.0 - component; // no -0.0
    }
  }
  this->Axes[2] = normal;
  this->Axes[0] = vtkAHDPerpendicular(vtkAHDUnitAxis(main + 1), normal);
  this->Axes[1] = vtkAHDCross(normal, this->Axes[0]);
}

vtkAHDVector vtkAHDPlane::Project(const vtkAHDVector& p) const
{
  vtkAHDVector d;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = p[k] * this->Shrink - this->Origin[k] * this->Shrink;
  }
  return { { vtkAHDDot(this->Axes[0], d) / this->Shrink, vtkAHDDot(this->Axes[1], d) / this->Shrink,
    vtkAHDDot(this->Axes[2], d) / this->Shrink - this->Height } };
}

vtkSmartPointer<vtkTransform> vtkAHDPlane::MakeTransform() const
{
  const vtkAHDVector origin = this->Project({ { 0, 0, 0 } });
  vtkNew<vtkMatrix4x4> matrix;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      matrix->SetElement(static_cast<int>(row), static_cast<int>(column), this->Axes[row][column]);
    }
    matrix->SetElement(static_cast<int>(row), 3, origin[row]);
  }
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->SetMatrix(matrix);
  return transform;
}
