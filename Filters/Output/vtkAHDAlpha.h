// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDAlpha_h
#define vtkAHDAlpha_h

#include "Engine/Core/Executor.h"
#include "Engine/Points/Points.h"
#include "Input/vtkAHDVectors.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkAHDProgress;
class vtkPoints;

/**
 * What Alpha and MaximumEdgeLength leave of a triangulation: triangles, edges, and points.
 *
 * A triangle is kept if none of its edges is longer than MaximumEdgeLength in the plane of the
 * triangulation, and if the radius of its circumcircle in space is not greater than Alpha. An edge
 * all triangles of which were dropped is a line if it is not longer than MaximumEdgeLength either
 * and half its length in space is not greater than Alpha. A vertex or duplicate that is a corner of
 * neither is a vert. Lines and verts there are with Alpha only. All limits are closed; 0 is none.
 * Where all vertices are collinear, the edges are those from one to the next.
 *
 * A length that is NaN, because the third coordinate of a point is, drops no triangle and makes no
 * line.
 */
class vtkAHDAlpha
{
public:
  struct Settings
  {
    double Alpha = 0.0;
    double MaximumEdgeLength = 0.0;
    bool Tris = true; ///< not to be put out, these have still no influence on the others
    bool Lines = true;
    bool Verts = true;
  };

  struct Triangulation
  {
    const vtkTypeInt32* Corners = nullptr;
    const std::int64_t* Neighbors = nullptr; ///< as writeNeighbors; not needed without Alpha
    std::size_t Count = 0;                   ///< of triangles
    bool AreCollinear = false;               ///< are there none because all vertices are?
    const std::int64_t* Fates = nullptr;     ///< as writeFates; not needed without Alpha
  };

  /// Borrows what it is given. `inSpace` and `inPlane` are the places of the same points, those
  /// beyond what the user sees (Alpha) and those that were triangulated (MaximumEdgeLength).
  vtkAHDAlpha(const Settings& settings, const Triangulation& triangulation, vtkPoints* inSpace,
    const ahd::PointView& inPlane);

  /// Returns false if the filter is to abort. Throws std::bad_alloc if there is no room.
  bool Select(ahd::Executor& executor, vtkAHDProgress& progress);

  // What is to be put out, after Select().

  /// One byte per triangle, 1 for those that are kept.
  const std::vector<unsigned char>& GetKept() const { return this->Kept; }
  std::size_t GetKeptCount() const { return this->KeptCount; }

  /// Two points per line, in the order of the triangles whose edges they are.
  const std::vector<vtkTypeInt32>& GetLines() const { return this->Lines; }

  /// Ascending.
  const std::vector<vtkTypeInt32>& GetVerts() const { return this->Verts; }

  /// Upper estimate of the bytes that Select() allocates for so many points.
  static std::size_t EstimateBytes(std::size_t pointCount) { return pointCount * 70; }

  /// The radius of the circle through three points in space, VTK_DOUBLE_MAX if there is none as
  /// they are collinear. Neither overflows nor underflows before that.
  static double Circumradius(const vtkAHDVector& a, const vtkAHDVector& b, const vtkAHDVector& c);

private:
  bool MarkTriangles(ahd::Executor& executor, vtkAHDProgress& progress);
  bool IsKept(std::size_t triangle) const;
  bool FindLines(vtkAHDProgress& progress);
  bool FindLinesBetweenCollinear(vtkAHDProgress& progress);
  void AddLine(vtkTypeInt32 a, vtkTypeInt32 b);
  void FindVerts();
  void Hide();
  bool IsTooLong(vtkTypeInt32 a, vtkTypeInt32 b) const;
  vtkAHDVector InSpace(vtkTypeInt32 point) const;

  const Settings Limits;
  const Triangulation Mesh;
  vtkPoints* const Space;
  const float* SpaceFloats = nullptr; // the coordinates, if they are of one of these types
  const double* SpaceDoubles = nullptr;
  const ahd::PointView Plane;
  std::vector<unsigned char> Kept;
  std::size_t KeptCount = 0;
  std::vector<unsigned char> Used; // of each point: is it a corner of a triangle or line?
  std::vector<vtkTypeInt32> Lines;
  std::vector<vtkTypeInt32> Verts;
};

#endif
