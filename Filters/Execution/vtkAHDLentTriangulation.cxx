// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDLentTriangulation.h"

#include "Execution/vtkAHDFingerprint.h"
#include "Pipeline/vtkAHDContext.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkAHDLentTriangulation);
vtkInformationKeyMacro(vtkAHDLentTriangulation, LENT, ObjectBase);

namespace
{
/// Does an array have its numbers there? Null has none, and so they are anywhere.
bool IsAt(vtkDataArray* array, const void* place)
{
  return !array || array->GetVoidPointer(0) == place;
}
}

/// Of the surface's points and corners, and of what the triangulation borrows. False if that cannot
/// be known again, or lies elsewhere than where the triangulation reads it.
bool vtkAHDLentTriangulation::TakePrints(
  const Content& content, vtkPolyData* surface, const vtkAHDContext& context, Prints& prints)
{
  vtkDataArray* const shown = surface->GetPoints()->GetData();
  vtkDataArray* const places = content.Borrowed[0];
  if (!IsAt(places, content.At[0]) || !IsAt(content.Borrowed[1], content.At[1]) ||
    !vtkAHDTakeFingerprint(shown, context, prints[0]) ||
    !vtkAHDTakeFingerprint(content.Borrowed[1], context, prints[2]) ||
    !vtkAHDTakeFingerprint(surface->GetPolys()->GetConnectivityArray(), context, prints[3]))
  {
    return false;
  }
  prints[1] = prints[0]; // mostly they are one array
  return places == shown || vtkAHDTakeFingerprint(places, context, prints[1]);
}

bool vtkAHDLentTriangulation::HasCellsOf(vtkPolyData* surface) const
{
  vtkCellArray* const cells = surface->GetPolys();
  vtkDataArray* const corners = cells->GetConnectivityArray();
  return corners == this->Corners && corners->GetMTime() == this->CornersTime &&
    cells->GetNumberOfCells() == this->Triangles && surface->GetPoints();
}

bool vtkAHDLentTriangulation::Keep(
  ContentPointer& content, vtkPolyData* surface, const vtkAHDContext& context)
{
  vtkDataArray* const corners = surface->GetPolys()->GetConnectivityArray();
  if (!TakePrints(*content, surface, context, this->AtTheTime))
  {
    return false;
  }
  for (std::size_t k = 0; k < content->Before.size(); ++k)
  {
    if (content->Before[k] && *content->Before[k] != this->AtTheTime[k + 1])
    {
      return false;
    }
  }
  corners->GetInformation()->Set(LENT(), this);
  this->Corners = corners;
  this->CornersTime = corners->GetMTime();
  this->Triangles = surface->GetPolys()->GetNumberOfCells();
  std::copy(content->Borrowed.begin(), content->Borrowed.end(), this->Borrowed.begin());
  this->BorrowedAt = content->At;
  this->Here = std::move(content);
  return true;
}

vtkAHDLentTriangulation::ContentPointer vtkAHDLentTriangulation::Borrow(vtkPolyData* surface,
  const vtkAHDContext& context, vtkSmartPointer<vtkAHDLentTriangulation>& lender)
{
  vtkDataArray* const corners = surface->GetPolys()->GetConnectivityArray();
  if (!corners || !corners->HasInformation())
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkAHDLentTriangulation> lent = vtkAHDLentTriangulation::SafeDownCast(
    corners->GetInformation()->Get(LENT()));
  if (!lent || !lent->HasCellsOf(surface))
  {
    return nullptr;
  }
  ContentPointer content = lent->Take();
  Prints now;
  if (content && (!TakePrints(*content, surface, context, now) || now != lent->AtTheTime))
  {
    lent->GiveBack(std::move(content));
    return nullptr;
  }
  lender = lent;
  return content;
}

vtkAHDLentTriangulation::ContentPointer vtkAHDLentTriangulation::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Here);
}

void vtkAHDLentTriangulation::GiveBack(ContentPointer content)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->IsClosed)
  {
    this->Here = std::move(content);
  }
}

vtkAHDLentTriangulation::ContentPointer vtkAHDLentTriangulation::Close()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsClosed = true;
  return std::move(this->Here);
}

bool vtkAHDLentTriangulation::BorrowsFrom(vtkPointSet* input) const
{
  vtkDataArray* const places = input->GetPoints() ? input->GetPoints()->GetData() : nullptr;
  vtkDataArray* const marks = input->GetPointGhostArray();
  const auto isOneOf = [this](std::size_t k, vtkDataArray* now)
  { return !this->Borrowed[k] || (this->Borrowed[k] == now && IsAt(now, this->BorrowedAt[k])); };
  return isOneOf(0, places) && isOneOf(1, marks);
}

void vtkAHDLentTriangulation::TakeBack(ahd::Workspace& workspace)
{
  if (const ContentPointer content = this->Close())
  {
    workspace.reclaim(std::move(content->Made.triangulation));
  }
}
