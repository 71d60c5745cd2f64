// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDKeptTriangulation_h
#define vtkAHDKeptTriangulation_h

#include "Engine/Core/Fingerprint.h"
#include "Execution/vtkAHDExecution.h"
#include "vtkDataArray.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

class vtkAHDContext;
class vtkInformationObjectBaseKey;
class vtkPointSet;
class vtkPolyData;

/// A triangulation that an execution leaves behind, and which of its triangles were put out.
struct vtkAHDLeftTriangulation
{
  ahd::RunResult Made;
  bool ShowMeans = false; ///< heights are those of the settings
  /// What the points borrow, their places and marks; null where they have their own.
  std::array<vtkSmartPointer<vtkDataArray>, 2> Borrowed;
  std::array<const void*, 2> At = {}; ///< where it reads them
};

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
class vtkAHDKeptTriangulation : public vtkObject
{
public:
  static vtkAHDKeptTriangulation* New();
  vtkTypeMacro(vtkAHDKeptTriangulation, vtkObject);

  using Content = std::unique_ptr<vtkAHDLeftTriangulation>;

  /// Lends the triangulation of a surface in its plane x, y. Null if there is none, another has it,
  /// or points or triangles have changed since, or lie elsewhere; and if the filter is to abort.
  /// Nobody may give their arrays other memory until it is given back. Throws
  /// std::bad_alloc.
  static Content Borrow(vtkPolyData* surface, const vtkAHDContext& context,
    vtkSmartPointer<vtkAHDKeptTriangulation>& lender);

  /// Keeps the content, which `surface` was written from, and says so in the surface. Returns false
  /// if the numbers cannot be known again, or if the filter is to abort; throws std::bad_alloc.
  /// Then `content` is as it was, and nothing is said. To be called once, before anybody knows of
  /// this.
  bool Keep(Content& content, vtkPolyData* surface, const vtkAHDContext& context);

  /// From who borrowed it.
  void GiveBack(Content content);

  /// Does what the content borrows, if anything, belong to this input, and lie where it did?
  bool BorrowsFrom(vtkPointSet* input) const;

  /// Lends it no more. Returns what is there; what is lent is freed when it comes back.
  Content Close();

protected:
  vtkAHDKeptTriangulation() = default;
  ~vtkAHDKeptTriangulation() override = default;

private:
  vtkAHDKeptTriangulation(const vtkAHDKeptTriangulation&) = delete;
  void operator=(const vtkAHDKeptTriangulation&) = delete;

  static vtkInformationObjectBaseKey* KEPT();
  using Prints = std::array<ahd::Fingerprint, 4>;

  static bool TakePrints(const vtkAHDLeftTriangulation& content, vtkPolyData* surface,
    const vtkAHDContext& context, Prints& prints);
  bool HasCellsOf(vtkPolyData* surface) const;
  Content Take();

  std::mutex Mutex; // of Here and IsClosed; all else stays what Keep() makes it
  Content Here;
  bool IsClosed = false;
  // Only to be compared:
  const vtkDataArray* Corners = nullptr;
  std::array<const vtkDataArray*, 2> Borrowed = {};
  std::array<const void*, 2> BorrowedAt = {};
  vtkMTimeType CornersTime = 0;
  vtkIdType Triangles = 0;
  Prints AtTheTime = {};
};

/// What a filter has left behind last: nobody has it any more when this is gone.
class vtkAHDLeftBehind
{
public:
  ~vtkAHDLeftBehind() { this->Let({}); }

  /// In place of the one before, which is closed.
  void Let(vtkSmartPointer<vtkAHDKeptTriangulation> left)
  {
    if (this->Last)
    {
      this->Last->Close();
    }
    this->Last = left;
  }

  /// TakeBack(), unless what is left borrows from this input: no other is to be held.
  void TakeBackUnlessOf(vtkPointSet* input, ahd::Workspace& workspace);

  /// Lets the workspace have its memory, unless that is lent.
  void TakeBack(ahd::Workspace& workspace);

private:
  vtkSmartPointer<vtkAHDKeptTriangulation> Last;
};

#endif
