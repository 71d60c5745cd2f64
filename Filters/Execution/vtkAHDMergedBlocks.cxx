// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDMergedBlocks.h"

#include "Engine/Core/Memory.h"
#include "Engine/Points/Points.h"
#include "Execution/vtkAHDMessages.h"
#include "Input/vtkAHDHeldCopy.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSay.h"
#include "Pipeline/vtkAHDSettings.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <new>

vtkAHDMergedBlocks::vtkAHDMergedBlocks(vtkAlgorithm* filter, const vtkAHDSettings& settings,
  vtkDataObject* input, vtkDataObject* source, const vtkAHDContext& context)
  : Filter(filter)
  , Limit(settings.MemoryLimit)
  , GivenInput(input)
  , GivenSource(source)
  , Input(vtkAHDHeldCopy(vtkPointSet::SafeDownCast(input)))
  , Source(vtkAHDHeldCopy(vtkPolyData::SafeDownCast(source)))
{
  context.GetProgress().Watch(input);
  context.GetProgress().Watch(source);
  if (this->Input)
  {
    this->GivenPoints = vtkPointSet::SafeDownCast(input)->GetPoints();
  }
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    this->Input = this->Merge(vtkAHDBlocks(blocks), context);
  }
  auto* blocks = vtkCompositeDataSet::SafeDownCast(source);
  if (source && !blocks && !this->Source)
  {
    this->Input = nullptr;
    if (filter)
    {
      vtkErrorWithObjectMacro(filter,
        "The source is a " << source->GetClassName()
                           << ", but a vtkPolyData is needed, or blocks of these. Nothing was "
                              "computed.");
    }
  }
  if (blocks && this->Input)
  {
    const auto kind = settings.idsAreOfInput ? vtkAHDBlocks::Kind::SourcesByIds
                                             : vtkAHDBlocks::Kind::Sources;
    this->Source = this->Merge(vtkAHDBlocks(blocks, kind), context);
    if (!this->Source)
    {
      this->Input = nullptr; // a surface without its constraints was not requested
    }
  }
}

ahd::Status vtkAHDMergedBlocks::GetStatus(const vtkAHDContext& context) const
{
  return this->Input      ? ahd::Status::Ok
    : context.IsAborted() ? ahd::Status::Cancelled
    : this->CellsAreBad   ? ahd::Status::BadCells
                          : ahd::Status::OutOfMemory;
}

/// Null if that was aborted, or if there are too many points or there is no memory, which it says.
vtkSmartPointer<vtkPolyData> vtkAHDMergedBlocks::Merge(
  const vtkAHDBlocks& blocks, const vtkAHDContext& context)
{
  if (static_cast<std::size_t>(blocks.GetCount()) > ahd::kMaximumPoints)
  {
    if (this->Filter)
    {
      vtkAHDSayTooManyPoints(this->Filter, static_cast<std::size_t>(blocks.GetCount()));
    }
    return nullptr;
  }
  this->Bytes += blocks.EstimateBytes();
  const vtkTypeInt64 needed = static_cast<vtkTypeInt64>(this->Bytes / 1024);
  const vtkTypeInt64 limit = this->Limit > 0
    ? this->Limit
    : static_cast<vtkTypeInt64>(ahd::availableMemory() / 1024);
  try
  {
    if (needed <= limit)
    {
      return blocks.Merge(context);
    }
  }
  catch (const vtkAHDStop& stop)
  {
    this->CellsAreBad = stop.Reason == ahd::Status::BadCells;
    if (this->Filter && this->CellsAreBad)
    {
      vtkAHDSayBadCells(this->Filter, stop.CellsOf, stop.Cell);
    }
    return nullptr;
  }
  catch (const std::bad_alloc&)
  {
  }
  if (!this->Filter)
  {
    return nullptr;
  }
  vtkAHDSay(this->Filter, ahd::Topic::Refusal,
    { { "reason", ahd::Reason::MemoryLimit }, { "doing", "merging" },
      { "points", blocks.GetCount() }, { "memory_estimate", needed }, { "is_in_kib", true },
      { "memory_allowed", limit }, { "memory_limit", this->Limit } });
  return nullptr;
}

void vtkAHDMergedBlocks::HandOnPoints(vtkPolyData* surface) const
{
  const bool areThose = this->GivenPoints && surface->GetPoints() == this->Input->GetPoints();
  if (areThose && this->GivenPoints->GetData() == this->Input->GetPoints()->GetData())
  {
    surface->SetPoints(this->GivenPoints);
  }
}

void vtkAHDMergedBlocks::Warn() const
{
  ahd::Facts facts;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(this->GivenInput))
  {
    const vtkAHDBlocks all(blocks);
    facts.add({ "other_blocks", all.GetNumberOfOthers() });
    facts.add({ "first_other", std::string(all.GetFirstOther()) });
    facts.add({ "unfit_marks", all.GetNumberOfUnfitMarks() });
  }
  else if (!vtkPointSet::SafeDownCast(this->GivenInput))
  {
    // A block of a composite data set: their types are not looked at by the pipeline.
    facts.add({ "without_points",
      std::string(this->GivenInput ? this->GivenInput->GetClassName() : "missing block") });
  }
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(this->GivenSource))
  {
    const vtkAHDBlocks all(blocks, vtkAHDBlocks::Kind::Sources);
    facts.add({ "other_sources", all.GetNumberOfOthers() });
    facts.add({ "first_other_source", std::string(all.GetFirstOther()) });
  }
  vtkAHDSay(this->Filter, ahd::Topic::Blocks, facts);
}
