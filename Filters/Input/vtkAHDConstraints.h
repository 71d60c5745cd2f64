// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDConstraints_h
#define vtkAHDConstraints_h

#include "Engine/Constraints.h"
#include "Engine/Merge/Merge.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkAHDProgress;
class vtkCellArray;
class vtkPolyData;

/**
 * What the source asks for, as the engine takes it: its lines as open chains, then its polygons as
 * loops, each in the order of the cells, in the ids of the working points. Verts and strips are
 * passed over. Everything that allocates throws std::bad_alloc.
 */
class vtkAHDConstraints
{
public:
  /// An id in a cell of the source that is no point's.
  struct UnfitIds
  {
    std::size_t Count = 0;
    vtkIdType FirstId = 0;
    vtkIdType FirstCell = 0;
  };

  /// Upper estimate of the bytes that the chains of `source` take; 0 if it is null.
  static std::size_t EstimateBytes(vtkPolyData* source);

  /// The segments of `source`, at most; 0 if it is null.
  static std::size_t CountSegments(vtkPolyData* source);

  /// Reads the cells. Their ids 0 to `idCount` - 1 become `firstId` and following, any others -1.
  /// Returns false if the filter is to abort. To be called first, once.
  bool Read(
    vtkPolyData* source, vtkIdType firstId, vtkIdType idCount, const vtkAHDProgress& progress);

  /// Puts for each point that was merged the one that was kept. Returns false if the filter is to
  /// abort.
  bool Follow(const std::vector<ahd::MergedPoint>& merged, const vtkAHDProgress& progress);

  /// Puts other chains for these, as many and of the same kinds.
  void Replace(std::vector<std::int64_t>&& ids, std::vector<std::int64_t>&& offsets);

  /// The ids at the ends of a segment. REQUIRES: there is such a segment.
  std::array<vtkIdType, 2> GetEnds(std::size_t chain, std::size_t segment) const;

  /// The segments, at most.
  std::size_t GetSegmentCount() const { return this->Ids.size(); }

  /// The chains. Good until this changes.
  ahd::ConstraintView View() const;

  /// Are there none?
  bool IsEmpty() const { return this->Ids.empty(); }

  /// The cell of the source that a chain is made of.
  vtkIdType GetCell(std::size_t chain) const
  {
    return this->FirstCell + static_cast<vtkIdType>(chain);
  }

  /// Ids that are no point's.
  const UnfitIds& GetUnfitIds() const { return this->Unfit; }

private:
  bool ReadCells(
    vtkCellArray* cells, vtkIdType firstId, vtkIdType idCount, const vtkAHDProgress& progress);

  bool MustAbort(const vtkAHDProgress& progress);

  std::vector<std::int64_t> Ids;
  std::vector<std::int64_t> Offsets = { 0 };
  std::size_t Lines = 0;
  vtkIdType FirstCell = 0; // verts come before lines
  UnfitIds Unfit;
  std::size_t UntilAsking = 0; // steps until the next look at whether the filter is to abort
};

#endif
