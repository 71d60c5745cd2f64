// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDInput_h
#define vtkAHDInput_h

#include "Engine/Triangulate.h"
#include "vtkType.h"

#include <array>
#include <memory>

class vtkAHDProgress;
class vtkDataArray;
class vtkPointSet;

/**
 * A vtkPointSet as the engine sees points: where they lie in memory if they are floats or doubles,
 * a converted copy if they are anything else. Borrows the point set, which must outlive it.
 */
class vtkAHDInput
{
public:
  explicit vtkAHDInput(vtkPointSet* points);

  /// The number of points, those to be left out included.
  vtkIdType GetCount() const { return this->Count; }

  /// Is there an array vtkGhostType that has not one value per point? It is ignored.
  bool GetMarksAreUnfit() const { return this->MarksAreUnfit; }

  /// Bytes that Open() allocates: 0 if the points are read where they are.
  std::size_t GetBytesToConvert() const;

  /// Converts the points if that is needed. Returns false if the filter is to abort; throws
  /// std::bad_alloc if there is no room.
  bool Open(ahd::Executor& executor, vtkAHDProgress& progress);

  /// The points. Ghost and hidden points (vtkGhostType) are marked to be left out.
  /// REQUIRES: Open() was called.
  const ahd::PointView& View() const { return this->Points; }

  /// The three coordinates of a point. REQUIRES: Open() was called.
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

  /// What is worth a warning.
  struct Oddities
  {
    vtkIdType FirstRejected = 0; ///< smallest id of a point with an x or y that is not finite
    vtkIdType OddZ = 0;          ///< points with finite x, y and a z that is not finite
  };

  /// One pass over the points. Returns false if the filter is to abort. REQUIRES: Open() was
  /// called.
  bool FindOddities(ahd::Executor& executor, vtkAHDProgress& progress, Oddities& odd) const;

private:
  vtkDataArray* Coordinates = nullptr; // 3 numbers per point; null if there are no points
  vtkIdType Count = 0;
  bool MarksAreUnfit = false;
  std::unique_ptr<double[]> Converted; // as Coordinates, if these are neither floats nor doubles
  ahd::PointView Points;
};

#endif
