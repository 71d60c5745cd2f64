// SPDX-License-Identifier: BSD-3-Clause
#include "Input/vtkAHDBlocks.h"

#include "Input/vtkAHDHeldCopy.h"
#include "Pipeline/vtkAHDAttributes.h"
#include "Pipeline/vtkAHDCellsView.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <new>

namespace
{
/// Marks that can be used: one for each point.
bool HasMarks(vtkPointSet* block)
{
  auto* marks = vtkArrayDownCast<vtkUnsignedCharArray>(
    block->GetPointData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  return marks && marks->GetNumberOfComponents() == 1 &&
    marks->GetNumberOfTuples() == block->GetNumberOfPoints();
}

/// The block's arrays that have a value for each point; ghost marks of its own or, if `marked`,
/// those of no ghost.
vtkSmartPointer<vtkPointData> UsableData(vtkPointSet* block, bool marked)
{
  auto usable = vtkSmartPointer<vtkPointData>::New();
  usable->ShallowCopy(block->GetPointData());
  vtkAHDRemoveArraysOfOneName(usable);
  for (int i = usable->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (usable->GetAbstractArray(i)->GetNumberOfTuples() != block->GetNumberOfPoints())
    {
      usable->RemoveArray(i);
    }
  }
  if (!HasMarks(block))
  {
    usable->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  }
  if (marked && !HasMarks(block))
  {
    vtkNew<vtkUnsignedCharArray> none;
    none->SetName(vtkDataSetAttributes::GhostArrayName());
    none->SetNumberOfValues(block->GetNumberOfPoints());
    none->FillValue(0);
    usable->AddArray(none);
  }
  return usable;
}

/// Appends the number of cells, which are only counted.
void AppendUnread(vtkCellArray* to, vtkCellArray* cells)
{
  for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k)
  {
    to->InsertNextCell(0);
  }
}

/// Appends cells, their ids moved by `begin`. `what`: as vtkAHDCellsView takes it.
void Append(vtkCellArray* to, vtkCellArray* cells, const char* what, vtkIdType begin,
  const vtkAHDContext& context)
{
  vtkAHDCellsView opened(cells, what);
  const ahd::CellsView view = opened.Open(context);
  if (view.ids == 0)
  {
    AppendUnread(to, cells);
    return;
  }
  const auto offset = [&view](std::size_t k)
  { return view.offsets32 ? std::size_t(view.offsets32[k]) : std::size_t(view.offsets64[k]); };
  if (offset(0) == 0 && offset(view.cells) == view.ids)
  {
    to->Append(cells, begin);
    return;
  }
  // vtkCellArray::Append() would give the ids that no cell has to the cells that come next.
  for (std::size_t k = 0; k < view.cells; ++k)
  {
    to->InsertNextCell(static_cast<int>(offset(k + 1) - offset(k)));
    for (std::size_t i = offset(k); i < offset(k + 1); ++i)
    {
      to->InsertCellPoint(begin + (view.ids32 ? view.ids32[i] : view.ids64[i]));
    }
  }
}
}

vtkAHDBlocks::vtkAHDBlocks(vtkCompositeDataSet* blocks, Kind kind)
  : Wanted(kind)
{
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* block = iterator->GetCurrentDataObject();
    auto* points = this->HasCells() ? vtkPolyData::SafeDownCast(block)
                                    : vtkPointSet::SafeDownCast(block);
    if (points &&
      (points->GetNumberOfPoints() > 0 || (this->HasCells() && points->GetNumberOfCells() > 0)))
    {
      this->Blocks.push_back(vtkAHDHeldCopy(points));
      this->Count += points->GetNumberOfPoints();
      const bool marked = points->GetPointData()->HasArray(vtkDataSetAttributes::GhostArrayName());
      this->UnfitMarks += marked && !HasMarks(points) ? 1 : 0;
    }
    else if (!points && block)
    {
      this->FirstOther = this->Others == 0 ? block->GetClassName() : this->FirstOther;
      ++this->Others;
    }
  }
}

std::size_t vtkAHDBlocks::EstimateBytes() const
{
  std::size_t kibibytes = 1;
  for (vtkPolyData* block : this->Blocks)
  {
    kibibytes += 1 +
      (this->HasCells() ? block->GetActualMemorySize()
                        : block->GetPointData()->GetActualMemorySize());
  }
  const std::size_t perPoint = 3 * sizeof(double) + 1; // a place and a mark
  return kibibytes * 1024 + static_cast<std::size_t>(this->Count) * perPoint;
}

vtkSmartPointer<vtkPolyData> vtkAHDBlocks::Merge(const vtkAHDContext& context) const
{
  bool areFloats = true;
  for (vtkPolyData* block : this->Blocks)
  {
    areFloats = areFloats &&
      (block->GetNumberOfPoints() == 0 || block->GetPoints()->GetDataType() == VTK_FLOAT);
  }
  auto merged = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(areFloats ? VTK_FLOAT : VTK_DOUBLE);
  if (!points->GetData()->Allocate(3 * this->Count))
  {
    throw std::bad_alloc();
  }
  points->SetNumberOfPoints(this->Count);
  vtkIdType begin = 0;
  for (vtkPolyData* block : this->Blocks)
  {
    context.StopIfAborted();
    if (const vtkIdType count = block->GetNumberOfPoints())
    {
      points->GetData()->InsertTuples(begin, count, 0, block->GetPoints()->GetData());
      begin += count;
    }
  }
  merged->SetPoints(points);
  this->MergePointData(merged, context);
  if (this->HasCells())
  {
    this->MergeCells(merged, context);
  }
  return merged;
}

void vtkAHDBlocks::MergeCells(vtkPolyData* merged, const vtkAHDContext& context) const
{
  vtkNew<vtkCellArray> verts, lines, polygons, strips;
  vtkIdType begin = 0;
  for (vtkPolyData* block : this->Blocks)
  {
    context.StopIfAborted();
    AppendUnread(verts, block->GetVerts());
    Append(lines, block->GetLines(), "lines of a block of the source", begin, context);
    Append(polygons, block->GetPolys(), "polygons of a block of the source", begin, context);
    AppendUnread(strips, block->GetStrips());
    begin += this->Wanted == Kind::SourcesByIds ? 0 : block->GetNumberOfPoints();
  }
  merged->SetVerts(verts);
  merged->SetLines(lines);
  merged->SetPolys(polygons);
  merged->SetStrips(strips);
}

void vtkAHDBlocks::MergePointData(vtkPolyData* merged, const vtkAHDContext& context) const
{
  bool marked = false;
  for (vtkPolyData* block : this->Blocks)
  {
    marked = marked || HasMarks(block);
  }
  std::vector<vtkSmartPointer<vtkPointData>> data;
  vtkDataSetAttributes::FieldList common;
  for (vtkPolyData* block : this->Blocks)
  {
    data.push_back(UsableData(block, marked));
    common.IntersectFieldList(data.back());
  }
  vtkPointData* all = merged->GetPointData();
  all->CopyAllOn();
  all->CopyAllocate(common, this->Count);
  vtkIdType begin = 0;
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    context.StopIfAborted();
    const vtkIdType count = this->Blocks[i]->GetNumberOfPoints();
    all->CopyData(common, data[i], static_cast<int>(i), begin, count, 0);
    begin += count;
  }
}
