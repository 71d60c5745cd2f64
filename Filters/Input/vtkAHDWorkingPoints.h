// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDWorkingPoints_h
#define vtkAHDWorkingPoints_h

#include "Engine/Triangulate.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkAHDProgress;
class vtkDataArray;
class vtkPointSet;
class vtkPoints;

/**
 * The points of one execution, as the engine sees them: those of the input, then those that are
 * added, each with the id that it has in the output.
 *
 * Their places are the input's own coordinates where these lie, as long as they are floats or
 * doubles, are triangulated in x and y, and nothing is added. Else they are a copy in double
 * precision, three numbers for each point: x and y in the plane of the triangulation, and what is
 * above it.
 *
 * Added are, in this order: points of the source, the eight points around all, and crossings.
 * Borrows the input, which must outlive it. Everything that allocates throws std::bad_alloc.
 */
class vtkAHDWorkingPoints
{
public:
  explicit vtkAHDWorkingPoints(vtkPointSet* input);

  /// The number of points of the input, those to be left out included.
  vtkIdType GetInputCount() const { return this->InputCount; }

  /// The number of all points, those to be left out included.
  vtkIdType GetCount() const { return this->InputCount + static_cast<vtkIdType>(this->Added); }

  /// Points that were added.
  vtkIdType GetAddedCount() const { return static_cast<vtkIdType>(this->Added); }

  /// Is there an array vtkGhostType that has not one value per point? It is ignored.
  bool GetMarksAreUnfit() const { return this->MarksAreUnfit; }

  /// Bytes that a copy of the places takes, for so many points.
  static std::size_t EstimateBytes(std::size_t pointCount)
  {
    return pointCount * (3 * sizeof(double) + 1);
  }

  /// Can the points not be read where they are, since they are neither floats nor doubles?
  bool MustBeConverted() const;

  /// Looks at the points where they lie, or copies them if that cannot be. Returns false if the
  /// filter is to abort. To be called first.
  bool Open(ahd::Executor& executor, vtkAHDProgress& progress);

  /// Makes a copy of the places, unless there is one already. Returns false if the filter is to
  /// abort.
  bool Copy(ahd::Executor& executor, vtkAHDProgress& progress);

  /// x, y and z of each point in turn, to be changed: how points get into another plane.
  /// REQUIRES: Copy().
  double* GetPlaces() { return this->Places.data(); }

  /// Adds `count` points, none of them to be left out, and returns where their places are to be
  /// written, three numbers each. REQUIRES: Copy().
  double* Add(std::size_t count);

  /// Leaves out the points whose byte is not 0, and no others. REQUIRES: a byte for each point.
  void SetSkipped(std::vector<unsigned char>&& skip);

  /// The places, and which points are to be left out: ghost and hidden points (vtkGhostType), and
  /// those of SetSkipped. Good until the next call of a function that is not const.
  const ahd::PointView& View() const { return this->Points; }

  /// The place of a point.
  std::array<double, 3> GetPoint(std::size_t i) const
  {
    if (this->Points.floats)
    {
      const float* p = this->Points.floats + 3 * i;
      return { { p[0], p[1], p[2] } };
    }
    const double* p = this->Points.doubles + 3 * i;
    return { { p[0], p[1], p[2] } };
  }

  /// The smallest box around the places that are finite and not left out; empty (min > max) if
  /// there is none. Returns false if the filter is to abort.
  bool FindBounds(ahd::Executor& executor, vtkAHDProgress& progress, ahd::Bounds& bounds) const;

  /// What is worth a warning.
  struct Oddities
  {
    vtkIdType FirstRejected = 0; ///< smallest id of a point with an x or y that is not finite
    vtkIdType OddZ = 0;          ///< points with finite x, y and a z that is not finite
  };

  /// One pass over the points. Returns false if the filter is to abort.
  bool FindOddities(ahd::Executor& executor, vtkAHDProgress& progress, Oddities& odd) const;

private:
  vtkDataArray* Coordinates = nullptr; // 3 numbers per point; null if there are no points
  vtkIdType InputCount = 0;
  std::size_t Added = 0;
  bool MarksAreUnfit = false;
  std::vector<double> Places;      // the copy; empty without
  std::vector<unsigned char> Skip; // a byte per point, if they are not the input's own marks
  ahd::PointView Points;
};

#endif
