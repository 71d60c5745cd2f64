// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDConstraints.h"

#include "Pipeline/vtkAHDProgress.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <utility>

namespace
{
std::size_t CountIds(vtkPolyData* source)
{
  return source ? static_cast<std::size_t>(source->GetLines()->GetNumberOfConnectivityIds() +
                    source->GetPolys()->GetNumberOfConnectivityIds())
                : 0;
}
}

std::size_t vtkAHDConstraints::CountSegments(vtkPolyData* source)
{
  return CountIds(source); // a loop has as many as points, a line one less
}

std::size_t vtkAHDConstraints::EstimateBytes(vtkPolyData* source)
{
  const std::size_t chains = source
    ? static_cast<std::size_t>(source->GetNumberOfLines() + source->GetNumberOfPolys())
    : 0;
  return (CountIds(source) + chains) * sizeof(std::int64_t);
}

bool vtkAHDConstraints::Read(
  vtkPolyData* source, vtkIdType firstId, vtkIdType idCount, const vtkAHDProgress& progress)
{
  this->FirstCell = source->GetNumberOfVerts();
  this->Lines = static_cast<std::size_t>(source->GetNumberOfLines());
  this->Ids.reserve(CountIds(source));
  this->Offsets.reserve(
    static_cast<std::size_t>(source->GetNumberOfLines() + source->GetNumberOfPolys()) + 1);
  return this->ReadCells(source->GetLines(), firstId, idCount, progress) &&
    this->ReadCells(source->GetPolys(), firstId, idCount, progress);
}

/// One step: asks now and then.
bool vtkAHDConstraints::MustAbort(const vtkAHDProgress& progress)
{
  constexpr std::size_t kSteps = std::size_t(1) << 14;
  if (this->UntilAsking > 0)
  {
    --this->UntilAsking;
    return false;
  }
  this->UntilAsking = kSteps;
  return progress.MustAbort();
}

bool vtkAHDConstraints::ReadCells(
  vtkCellArray* cells, vtkIdType firstId, vtkIdType idCount, const vtkAHDProgress& progress)
{
  // The iterator's own memory, not that of the cell array, which others may be reading.
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (this->MustAbort(progress))
      {
        return false;
      }
      const bool fits = ids[i] >= 0 && ids[i] < idCount;
      if (!fits && this->Unfit.Count++ == 0)
      {
        this->Unfit.FirstId = ids[i];
        this->Unfit.FirstCell = this->GetCell(this->Offsets.size() - 1);
      }
      this->Ids.push_back(fits ? firstId + ids[i] : -1);
    }
    this->Offsets.push_back(static_cast<std::int64_t>(this->Ids.size()));
  }
  return true;
}

bool vtkAHDConstraints::Follow(
  const std::vector<ahd::MergedPoint>& merged, const vtkAHDProgress& progress)
{
  if (merged.empty())
  {
    return true;
  }
  for (std::int64_t& id : this->Ids)
  {
    if (this->MustAbort(progress))
    {
      return false;
    }
    const auto found = std::lower_bound(merged.begin(), merged.end(), id,
      [](const ahd::MergedPoint& m, std::int64_t i) { return std::int64_t(m.id) < i; });
    if (found != merged.end() && std::int64_t(found->id) == id)
    {
      id = found->keptId;
    }
  }
  return true;
}

void vtkAHDConstraints::Replace(
  std::vector<std::int64_t>&& ids, std::vector<std::int64_t>&& offsets)
{
  this->Ids = std::move(ids);
  this->Offsets = std::move(offsets);
}

std::array<vtkIdType, 2> vtkAHDConstraints::GetEnds(std::size_t chain, std::size_t segment) const
{
  const std::size_t begin = static_cast<std::size_t>(this->Offsets[chain]);
  const std::size_t end = static_cast<std::size_t>(this->Offsets[chain + 1]);
  const std::size_t first = begin + segment;
  const std::size_t second = first + 1 < end ? first + 1 : begin; // of a loop
  return { { static_cast<vtkIdType>(this->Ids[first]),
    static_cast<vtkIdType>(this->Ids[second]) } };
}

ahd::ConstraintView vtkAHDConstraints::View() const
{
  ahd::ConstraintView view;
  view.ids = this->Ids.data();
  view.offsets = this->Offsets.data();
  view.chains = this->Offsets.size() - 1;
  view.lines = this->Lines;
  return view;
}
