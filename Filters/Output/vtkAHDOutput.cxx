// SPDX-License-Identifier: BSD-3-Clause
#include "Output/vtkAHDOutput.h"

#include "Pipeline/vtkAHDArray.h"
#include "Pipeline/vtkAHDLoop.h"
#include "Pipeline/vtkAHDNamesakes.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <memory>

namespace
{
// n points have fewer than 2n triangles, so the engine's limit on points keeps ids and offsets
// below 2^31: 32-bit storage always fits. Who raises the limit has to write 64-bit ids here.
static_assert(ahd::kMaximumPoints * 2 * 3 <= std::size_t(VTK_TYPE_INT32_MAX),
  "offsets of the triangles must fit into 32 bits");
using IdArray = vtkTypeInt32Array;

/// Adds a point array of what write(ids) writes, one number per point.
template <typename Write>
ahd::Status AddIds(const char* name, vtkPolyData* output, ahd::Executor& executor,
  vtkAHDProgress& progress, const Write& write)
{
  // Through a copy: vtkIdType may have 32 bits, and where it has 64 it is not std::int64_t.
  const std::size_t count = static_cast<std::size_t>(output->GetNumberOfPoints());
  const std::unique_ptr<std::int64_t[]> ids(new std::int64_t[count]);
  const ahd::Status status = write(ids.get());
  if (status != ahd::Status::Ok)
  {
    return status;
  }
  auto array = vtkAHDNewArray<vtkIdTypeArray>(output->GetNumberOfPoints());
  array->SetName(name);
  vtkIdType* values = array->GetPointer(0);
  const bool all = vtkAHDLoop(count, executor, progress,
    [&ids, values](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        values[i] = static_cast<vtkIdType>(ids[i]);
      }
    });
  if (!all)
  {
    return ahd::Status::Cancelled;
  }
  vtkAHDReplaceArray(output->GetPointData(), array);
  return status;
}
}

std::size_t vtkAHDOutput::EstimateBytes(std::size_t pointCount, std::size_t idArrays)
{
  const std::size_t perTriangle = (3 + 1) * sizeof(vtkTypeInt32); // corners and offset
  const std::size_t ids = idArrays * (sizeof(std::int64_t) + sizeof(vtkIdType));
  return pointCount * (2 * perTriangle + ids);
}

ahd::Status vtkAHDOutput::WriteTriangles(ahd::Triangulator& triangulator, vtkPolyData* output,
  ahd::Executor& executor, vtkAHDProgress& progress)
{
  const vtkIdType count = static_cast<vtkIdType>(triangulator.report().triangles);
  auto corners = vtkAHDNewArray<IdArray>(3 * count);
  const ahd::Status status = triangulator.writeTriangles(
    corners->GetPointer(0), &progress, &executor);
  if (status != ahd::Status::Ok)
  {
    return status;
  }
  auto offsets = vtkAHDNewArray<IdArray>(count + 1);
  auto* offset = offsets->GetPointer(0);
  const bool all = vtkAHDLoop(static_cast<std::size_t>(count + 1), executor, progress,
    [offset](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        offset[i] = static_cast<vtkTypeInt32>(3 * i);
      }
    });
  if (!all)
  {
    return ahd::Status::Cancelled;
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, corners);
  output->SetPolys(triangles);
  return status;
}

void vtkAHDOutput::AddCount(vtkPolyData* output, const char* name, vtkIdType count)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->InsertNextValue(count);
  output->GetFieldData()->AddArray(array);
}

ahd::Status vtkAHDOutput::AddFate(const ahd::Triangulator& triangulator,
  const std::vector<ahd::MergedPoint>& merged, vtkPolyData* output, ahd::Executor& executor,
  vtkAHDProgress& progress)
{
  return AddIds("Fate", output, executor, progress,
    [&](std::int64_t* ids)
    {
      const ahd::Status status = triangulator.writeFates(ids, &progress, &executor);
      for (const ahd::MergedPoint& m : merged)
      {
        ids[m.id] = ids[m.keptId];
      }
      return status;
    });
}

ahd::Status vtkAHDOutput::AddInsertionRank(const ahd::Triangulator& triangulator,
  vtkPolyData* output, ahd::Executor& executor, vtkAHDProgress& progress)
{
  return AddIds("InsertionRank", output, executor, progress,
    [&](std::int64_t* ids) { return triangulator.writeInsertionRanks(ids, &progress, &executor); });
}
