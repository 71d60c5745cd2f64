// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDAlpha.h"

#include "Pipeline/vtkAHDLoop.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace
{

vtkAHDVector Minus(const vtkAHDVector& a, const vtkAHDVector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// std::hypot takes many times as long.
double Length(double x, double y, double z)
{
  const double square = x * x + y * y + z * z;
  return square > 1e-290 && square < 1e300 ? std::sqrt(square) : std::hypot(x, y, z);
}

double Length(const vtkAHDVector& v)
{
  return Length(v[0], v[1], v[2]);
}

vtkAHDVector Times(const vtkAHDVector& v, double factor)
{
  return { { v[0] * factor, v[1] * factor, v[2] * factor } };
}

/// Of the parallelogram.
double Area(const vtkAHDVector& u, const vtkAHDVector& v)
{
  return Length(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

/// A power of two that brings lengths up to this one near 1, or 1 where that is not needed.
double Scale(double length)
{
  if (length > 1e-60 && length < 1e60)
  {
    return 1.0;
  }
  int exponent = 0;
  std::frexp(length, &exponent);
  return std::ldexp(1.0, std::min(std::max(-exponent, -1020), 1020));
}

}

vtkAHDAlpha::vtkAHDAlpha(const Settings& settings, const Triangulation& triangulation,
  vtkPoints* inSpace, const ahd::PointView& inPlane)
  : Limits(settings)
  , Mesh(triangulation)
  , Space(inSpace)
  , Plane(inPlane)
{
  if (auto* floats = vtkFloatArray::FastDownCast(inSpace->GetData()))
  {
    this->SpaceFloats = floats->GetPointer(0);
  }
  else if (auto* doubles = vtkDoubleArray::FastDownCast(inSpace->GetData()))
  {
    this->SpaceDoubles = doubles->GetPointer(0);
  }
}

vtkAHDVector vtkAHDAlpha::InSpace(vtkTypeInt32 point) const
{
  const std::size_t first = 3 * static_cast<std::size_t>(point);
  if (this->SpaceFloats)
  {
    const float* p = this->SpaceFloats + first;
    return { { p[0], p[1], p[2] } };
  }
  if (this->SpaceDoubles)
  {
    const double* p = this->SpaceDoubles + first;
    return { { p[0], p[1], p[2] } };
  }
  vtkAHDVector result;
  this->Space->GetPoint(point, result.data());
  return result;
}

double vtkAHDAlpha::Circumradius(
  const vtkAHDVector& a, const vtkAHDVector& b, const vtkAHDVector& c)
{
  vtkAHDVector sides[3] = { Minus(b, a), Minus(c, b), Minus(a, c) };
  double lengths[3] = { Length(sides[0]), Length(sides[1]), Length(sides[2]) };
  const double longest = std::max(lengths[0], std::max(lengths[1], lengths[2]));
  const double scale = Scale(longest);
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = Times(sides[i], scale);
    lengths[i] *= scale;
  }
  // The angle at the longest side's opposite corner is the one whose sine loses fewest digits.
  const int k = lengths[0] >= longest * scale ? 0 : lengths[1] >= longest * scale ? 1 : 2;
  const double area = Area(sides[(k + 1) % 3], sides[(k + 2) % 3]);
  const double radius = area == 0.0 ? VTK_DOUBLE_MAX
                                    : lengths[0] * lengths[1] * lengths[2] / (2.0 * area) / scale;
  return radius > VTK_DOUBLE_MAX ? VTK_DOUBLE_MAX : radius;
}

bool vtkAHDAlpha::Select(ahd::Executor& executor, vtkAHDProgress& progress)
{
  if (!this->MarkTriangles(executor, progress))
  {
    return false;
  }
  if (this->Limits.Alpha > 0.0)
  {
    this->Used.assign(this->Plane.count, 0);
    for (std::size_t i = 0; i < 3 * this->Mesh.Count; ++i)
    {
      this->Used[static_cast<std::size_t>(this->Mesh.Corners[i])] |= this->Kept[i / 3];
    }
    const bool isDone = this->Mesh.AreCollinear ? this->FindLinesBetweenCollinear(progress)
                                                : this->FindLines(progress);
    if (!isDone)
    {
      return false;
    }
    this->FindVerts();
    this->Hide();
  }
  this->KeptCount = static_cast<std::size_t>(std::count(this->Kept.begin(), this->Kept.end(), 1));
  return !progress.MustAbort();
}

bool vtkAHDAlpha::MarkTriangles(ahd::Executor& executor, vtkAHDProgress& progress)
{
  this->Kept.resize(this->Mesh.Count);
  return vtkAHDLoop(this->Mesh.Count, executor, progress,
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        this->Kept[t] = this->IsKept(t) ? 1 : 0;
      }
    });
}

bool vtkAHDAlpha::IsKept(std::size_t triangle) const
{
  const vtkTypeInt32* corners = this->Mesh.Corners + 3 * triangle;
  if (this->IsTooLong(corners[0], corners[1]) || this->IsTooLong(corners[1], corners[2]) ||
    this->IsTooLong(corners[2], corners[0]))
  {
    return false;
  }
  // Not the same as <= where it is NaN.
  return !(this->Limits.Alpha > 0.0 &&
    Circumradius(this->InSpace(corners[0]), this->InSpace(corners[1]), this->InSpace(corners[2])) >
      this->Limits.Alpha);
}

bool vtkAHDAlpha::IsTooLong(vtkTypeInt32 a, vtkTypeInt32 b) const
{
  if (!(this->Limits.MaximumEdgeLength > 0.0))
  {
    return false;
  }
  const ahd::Point p = this->Plane[static_cast<std::size_t>(a)];
  const ahd::Point q = this->Plane[static_cast<std::size_t>(b)];
  return Length(p.x - q.x, p.y - q.y, 0.0) > this->Limits.MaximumEdgeLength;
}

bool vtkAHDAlpha::FindLines(vtkAHDProgress& progress)
{
  constexpr std::size_t kBetweenAskings = std::size_t(1) << 13;
  for (std::size_t t = 0; t < this->Mesh.Count; ++t)
  {
    if (t % kBetweenAskings == 0 && progress.MustAbort())
    {
      return false;
    }
    for (std::size_t e = 0; e < 3 && !this->Kept[t]; ++e)
    {
      const std::int64_t other = this->Mesh.Neighbors[3 * t + e];
      // The first of the two triangles has it.
      if (other < 0 ||
        (other > static_cast<std::int64_t>(t) && !this->Kept[static_cast<std::size_t>(other)]))
      {
        this->AddLine(this->Mesh.Corners[3 * t + e], this->Mesh.Corners[3 * t + (e + 1) % 3]);
      }
    }
  }
  return true;
}

bool vtkAHDAlpha::FindLinesBetweenCollinear(vtkAHDProgress& progress)
{
  std::vector<vtkTypeInt32> vertices;
  for (std::size_t i = 0; i < this->Plane.count; ++i)
  {
    if (this->Mesh.Fates[i] == static_cast<std::int64_t>(i))
    {
      vertices.push_back(static_cast<vtkTypeInt32>(i));
    }
  }
  if (progress.MustAbort())
  {
    return false;
  }
  std::sort(vertices.begin(), vertices.end(),
    [this](vtkTypeInt32 a, vtkTypeInt32 b)
    {
      return ahd::lexicographicallyLess(
        this->Plane[static_cast<std::size_t>(a)], this->Plane[static_cast<std::size_t>(b)]);
    });
  for (std::size_t i = 1; i < vertices.size(); ++i)
  {
    this->AddLine(vertices[i - 1], vertices[i]);
  }
  return true;
}

/// Adds the edge, unless it is too long.
void vtkAHDAlpha::AddLine(vtkTypeInt32 a, vtkTypeInt32 b)
{
  if (0.5 * Length(Minus(this->InSpace(a), this->InSpace(b))) <= this->Limits.Alpha &&
    !this->IsTooLong(a, b))
  {
    this->Used[static_cast<std::size_t>(a)] = 1;
    this->Used[static_cast<std::size_t>(b)] = 1;
    this->Lines.push_back(a);
    this->Lines.push_back(b);
  }
}

void vtkAHDAlpha::FindVerts()
{
  for (std::size_t i = 0; i < this->Plane.count; ++i)
  {
    if (!this->Used[i] && this->Mesh.Fates[i] >= 0)
    {
      this->Verts.push_back(static_cast<vtkTypeInt32>(i));
    }
  }
}

void vtkAHDAlpha::Hide()
{
  if (!this->Limits.Tris)
  {
    std::fill(this->Kept.begin(), this->Kept.end(), static_cast<unsigned char>(0));
  }
  if (!this->Limits.Lines)
  {
    this->Lines.clear();
  }
  if (!this->Limits.Verts)
  {
    this->Verts.clear();
  }
}
