// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDKept_h
#define vtkAHDKept_h

#include "Engine/Core/Executor.h"
#include "Execution/vtkAHDFingerprint.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkAHDProgress;
class vtkPointSet;
class vtkPolyData;

/**
 * The outputs of an execution, for another one with the same points.
 *
 * The same: by what they are, not by which object they are in, so that a reader may make new ones
 * for each time step, and a program may change them where they lie. The outputs' arrays are held,
 * the input is not.
 *
 * To know the points again takes their fingerprint, and that takes time. So it is not taken before
 * an execution comes again with unchanged settings and as many points: outputs are kept from the
 * second such execution on.
 */
class vtkAHDKept
{
public:
  vtkAHDKept();
  ~vtkAHDKept();
  vtkAHDKept(const vtkAHDKept&) = delete;
  vtkAHDKept& operator=(const vtkAHDKept&) = delete;

  /// What the triangulation is made of. `settings`: when they were changed last.
  struct Origin
  {
    vtkPointSet* Input;
    vtkPolyData* Source; ///< may be null
    vtkMTimeType Settings;
  };
  /// Surface, order, Voronoi diagram.
  using Outputs = std::array<vtkPolyData*, 3>;

  /// Can the outputs be passed on for this? If not, lets go of them. False if the filter is to
  /// abort.
  bool Fits(const Origin& origin, ahd::Executor& executor, vtkAHDProgress& progress);

  /// Keeps the outputs, if Fits() took fingerprints, unless points were added, whose data are not
  /// the input's. They belong to the origin that Fits() was called with last, whatever has changed
  /// since. REQUIRES: it said no, and `input` is that origin's.
  void Keep(vtkPointSet* input, const Outputs& outputs);

  /// Fills the outputs anew, with the point data of this input; field data that they have stay.
  /// REQUIRES: Fits() said so.
  void PassOn(vtkPointSet* input, const Outputs& outputs) const;

  /// Lets go of everything.
  void Forget();

private:
  bool TakeFingerprints(const Origin& origin, ahd::Executor& executor, vtkAHDProgress& progress);
  void LetGo();

  bool IsKept = false;
  bool HasOwnPoints = false; // is the surface's vtkPoints another than the input's?
  // Of the origin that Fits() saw last:
  vtkMTimeType Settings = 0;
  vtkIdType Count = -1;                     // of points
  std::vector<vtkAHDFingerprint> Now;       // empty if none were taken
  std::vector<vtkAHDFingerprint> AtTheTime; // of what is kept
  std::array<vtkNew<vtkPolyData>, 3> Data;  // the first without data of the input
};

#endif
