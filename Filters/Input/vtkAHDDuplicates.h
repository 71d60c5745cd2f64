// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDDuplicates_h
#define vtkAHDDuplicates_h

#include "Engine/Core/Executor.h"
#include "Engine/Points/Points.h"
#include "Input/vtkAHDVectors.h"
#include "Pipeline/vtkAHDLoop.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

class vtkCellArray;

/**
 * Which of the points at one place is shown as the vertex there, where that is not the one of
 * smallest id, as the engine has it.
 *
 * Points that were merged, as they are close to another, have no say. Allocates 4 bytes per point
 * at most; throws std::bad_alloc.
 */
class vtkAHDDuplicates
{
public:
  /// For each place the point of lowest or highest z; of several, the one of smallest id. A z that
  /// is not finite is taken only where there is no other. `fates` is what
  /// ahd::Triangulator::writeFates wrote for `places`. Returns false if the filter is to abort.
  /// REQUIRES: places.stride is 3, the third number of each point is its z.
  bool Choose(const std::int64_t* fates, const ahd::PointView& places, bool highest,
    vtkAHDProgress& progress);

  /// Do all places show the point of smallest id?
  bool IsEmpty() const { return this->Shown.empty(); }

  /// The point that is shown where this one is a vertex.
  std::int64_t Get(std::int64_t id) const
  {
    return this->Shown.empty() || id < 0 || id >= std::int64_t(this->Shown.size())
      ? id
      : this->Shown[std::size_t(id)];
  }

  /// Replaces each of the ids, those below 0 excepted. Returns false if the filter is to abort.
  template <typename Id>
  bool Apply(Id* ids, std::size_t count, ahd::Executor& executor, vtkAHDProgress& progress) const
  {
    return this->Shown.empty() ||
      vtkAHDLoop(count, executor, progress,
        [this, ids](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            ids[i] = static_cast<Id>(this->Get(ids[i]));
          }
        });
  }

  /// The same for the ids of the cells, which may be null.
  bool Apply(vtkCellArray* cells, ahd::Executor& executor, vtkAHDProgress& progress) const;

  /// Numbers of all points: each vertex that is not shown swaps its own for that of the point
  /// shown. What Apply() makes of fates is to be swapped as well.
  template <typename Number>
  void Swap(Number* numbers) const
  {
    for (std::size_t i = 0; i < this->Shown.size(); ++i)
    {
      std::swap(numbers[i], numbers[this->Shown[i]]);
    }
  }

private:
  std::vector<std::int32_t> Shown; // for each point; empty if each shows itself
};

/// Where the vertex of several points at one place is shown by their mean.
struct vtkAHDMean
{
  std::int64_t Id;       ///< the point of smallest id there
  vtkAHDVector Position; ///< the mean of all that have a finite z
};

/// The means of all places with several points of which one at least has a finite z, by increasing
/// id. `fates` and `places` as above; `positions` is what is averaged: the same points, where they
/// are in space. A coordinate that all have in common is kept to the last bit, and the order of the
/// points has no say. Returns false if the filter is to abort; throws std::bad_alloc.
bool vtkAHDFindMeans(const std::int64_t* fates, const ahd::PointView& places,
  const ahd::PointView& positions, vtkAHDProgress& progress, std::vector<vtkAHDMean>& means);

#endif
