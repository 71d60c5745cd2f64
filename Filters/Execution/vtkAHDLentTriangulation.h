// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDLentTriangulation_h
#define vtkAHDLentTriangulation_h

#include "Engine/Core/Fingerprint.h"
#include "Execution/vtkAHDExecution.h"
#include "vtkDataArray.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

class vtkAHDContext;
class vtkInformationObjectBaseKey;
class vtkPointSet;
class vtkPolyData;

/**
 * The triangulation that a surface was written from, found in the information of the array of its
 * corners: so whoever has a shallow copy of the surface finds it.
 *
 * It is lent to one at a time, as tables are made in it, and only as long as the filter that made
 * the surface has not taken it back. Take(), GiveBack() and Close() may be called by any thread.
 *
 * The arrays that it borrows are held, their memory is not, as it cannot be: they are looked at
 * again before it is lent, and it is not lent where their numbers lie elsewhere than they did.
 */
class vtkAHDLentTriangulation : public vtkObject
{
public:
  static vtkAHDLentTriangulation* New();
  vtkTypeMacro(vtkAHDLentTriangulation, vtkObject);

  /// The triangulation, and which of its triangles were put out.
  struct Content
  {
    ahd::RunResult Made;
    bool ShowMeans = false; ///< heights are those of the settings
    /// What the points borrow, their places and marks; null where they have their own.
    std::array<vtkSmartPointer<vtkDataArray>, 2> Borrowed;
    std::array<const void*, 2> At = {}; ///< where it reads them
    /// What they were when the run began, where somebody may have written to them since.
    std::array<std::optional<ahd::Fingerprint>, 2> Before;
  };
  using ContentPointer = std::unique_ptr<Content>;

  /// Lends the triangulation of a surface in its plane x, y. Null if there is none, another has it,
  /// or points or triangles have changed since, or lie elsewhere; and if the filter is to abort.
  /// Their arrays are read until the tables of corners and heights are made: until then nobody may
  /// be told of progress (vtkAHDProgress::Silence). Throws std::bad_alloc.
  static ContentPointer Borrow(vtkPolyData* surface, const vtkAHDContext& context,
    vtkSmartPointer<vtkAHDLentTriangulation>& lender);

  /// Keeps the content, which `surface` was written from, and says so in the surface. Returns false
  /// if the numbers cannot be known again or have changed, or if the filter is to abort; throws
  /// std::bad_alloc. Then `content` is as it was, and nothing is said. To be called once, before
  /// anybody knows of this.
  bool Keep(ContentPointer& content, vtkPolyData* surface, const vtkAHDContext& context);

  /// From who borrowed it.
  void GiveBack(ContentPointer content);

  /// Does what the content borrows, if anything, belong to this input, and lie where it did?
  bool BorrowsFrom(vtkPointSet* input) const;

  /// Lends it no more. Returns what is there; what is lent is freed when it comes back.
  ContentPointer Close();

  /// Close(), and lets the workspace have the memory, unless that is lent.
  void TakeBack(ahd::Workspace& workspace);

protected:
  vtkAHDLentTriangulation() = default;
  ~vtkAHDLentTriangulation() override = default;

private:
  vtkAHDLentTriangulation(const vtkAHDLentTriangulation&) = delete;
  void operator=(const vtkAHDLentTriangulation&) = delete;

  static vtkInformationObjectBaseKey* LENT();
  using Prints = std::array<ahd::Fingerprint, 4>;

  static bool TakePrints(
    const Content& content, vtkPolyData* surface, const vtkAHDContext& context, Prints& prints);
  bool HasCellsOf(vtkPolyData* surface) const;
  ContentPointer Take();

  std::mutex Mutex; // of Here and IsClosed; all else stays what Keep() makes it
  ContentPointer Here;
  bool IsClosed = false;
  // Only to be compared:
  const vtkDataArray* Corners = nullptr;
  std::array<const vtkDataArray*, 2> Borrowed = {};
  std::array<const void*, 2> BorrowedAt = {};
  vtkMTimeType CornersTime = 0;
  vtkIdType Triangles = 0;
  Prints AtTheTime = {};
};

#endif
