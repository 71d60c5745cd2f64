// SPDX-License-Identifier: BSD-3-Clause
#include "Execution/vtkAHDKeptTriangulation.h"

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

vtkStandardNewMacro(vtkAHDKeptTriangulation);
vtkInformationKeyMacro(vtkAHDKeptTriangulation, KEPT, ObjectBase);

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
bool vtkAHDKeptTriangulation::TakePrints(const vtkAHDLeftTriangulation& content,
  vtkPolyData* surface, const vtkAHDContext& context, Prints& prints)
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

bool vtkAHDKeptTriangulation::HasCellsOf(vtkPolyData* surface) const
{
  vtkCellArray* const cells = surface->GetPolys();
  vtkDataArray* const corners = cells->GetConnectivityArray();
  return corners == this->Corners && corners->GetMTime() == this->CornersTime &&
    cells->GetNumberOfCells() == this->Triangles && surface->GetPoints();
}

bool vtkAHDKeptTriangulation::Keep(
  Content& content, vtkPolyData* surface, const vtkAHDContext& context)
{
  vtkDataArray* const corners = surface->GetPolys()->GetConnectivityArray();
  if (!TakePrints(*content, surface, context, this->AtTheTime))
  {
    return false;
  }
  corners->GetInformation()->Set(KEPT(), this);
  this->Corners = corners;
  this->CornersTime = corners->GetMTime();
  this->Triangles = surface->GetPolys()->GetNumberOfCells();
  std::copy(content->Borrowed.begin(), content->Borrowed.end(), this->Borrowed.begin());
  this->BorrowedAt = content->At;
  this->Here = std::move(content);
  return true;
}

vtkAHDKeptTriangulation::Content vtkAHDKeptTriangulation::Borrow(vtkPolyData* surface,
  const vtkAHDContext& context, vtkSmartPointer<vtkAHDKeptTriangulation>& lender)
{
  vtkDataArray* const corners = surface->GetPolys()->GetConnectivityArray();
  if (!corners || !corners->HasInformation())
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkAHDKeptTriangulation> kept = vtkAHDKeptTriangulation::SafeDownCast(
    corners->GetInformation()->Get(KEPT()));
  if (!kept || !kept->HasCellsOf(surface))
  {
    return nullptr;
  }
  Content content = kept->Take();
  Prints now;
  if (content && (!TakePrints(*content, surface, context, now) || now != kept->AtTheTime))
  {
    kept->GiveBack(std::move(content));
    return nullptr;
  }
  lender = kept;
  return content;
}

vtkAHDKeptTriangulation::Content vtkAHDKeptTriangulation::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::move(this->Here);
}

void vtkAHDKeptTriangulation::GiveBack(Content content)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->IsClosed)
  {
    this->Here = std::move(content);
  }
}

vtkAHDKeptTriangulation::Content vtkAHDKeptTriangulation::Close()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsClosed = true;
  return std::move(this->Here);
}

bool vtkAHDKeptTriangulation::BorrowsFrom(vtkPointSet* input) const
{
  vtkDataArray* const places = input->GetPoints() ? input->GetPoints()->GetData() : nullptr;
  vtkDataArray* const marks = input->GetPointGhostArray();
  const auto isOneOf = [this](std::size_t k, vtkDataArray* now)
  { return !this->Borrowed[k] || (this->Borrowed[k] == now && IsAt(now, this->BorrowedAt[k])); };
  return isOneOf(0, places) && isOneOf(1, marks);
}

void vtkAHDLeftBehind::TakeBackUnlessOf(vtkPointSet* input, ahd::Workspace& workspace)
{
  if (this->Last && !this->Last->BorrowsFrom(input))
  {
    this->TakeBack(workspace);
  }
}

void vtkAHDLeftBehind::TakeBack(ahd::Workspace& workspace)
{
  if (this->Last)
  {
    if (const vtkAHDKeptTriangulation::Content content = this->Last->Close())
    {
      workspace.reclaim(std::move(content->Made.triangulation));
    }
    this->Last = nullptr;
  }
}
