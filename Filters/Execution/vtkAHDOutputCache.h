// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDOutputCache_h
#define vtkAHDOutputCache_h

#include "Execution/vtkAHDFingerprint.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkAHDContext;
struct vtkAHDDataSets;
class vtkPolyData;

/**
 * The outputs of an execution, for another one with the same points.
 *
 * Points are compared by value, not by object, so that a reader may create new ones for each time
 * step, and a program may change them in place. The outputs' arrays are held, the input is not. If
 * an owner of the outputs changes their arrays, they are released.
 *
 * Points are recognised by their fingerprint, which takes time. So it is only computed once an
 * execution repeats with unchanged settings and number of points: the second such execution
 * keeps its outputs, and they are passed on from the third on.
 */
class vtkAHDOutputCache
{
public:
  vtkAHDOutputCache();
  ~vtkAHDOutputCache();
  vtkAHDOutputCache(const vtkAHDOutputCache&) = delete;
  vtkAHDOutputCache& operator=(const vtkAHDOutputCache&) = delete;

  /// Can the outputs be passed on for these data sets, with settings last modified at
  /// `settings`, and are they unchanged? If not, releases them. False on an
  /// abort.
  bool Fits(const vtkAHDDataSets& data, vtkMTimeType settings, const vtkAHDContext& context);

  /// Keeps the outputs, if Fits() took fingerprints, unless points were added, whose data are not
  /// the input's. They belong to the data sets that Fits() was called with last, whatever has
  /// changed since. Keeps nothing on an abort. @pre it returned false for these.
  void Keep(const vtkAHDDataSets& data, const vtkAHDContext& context);

  /// Fills the outputs anew, with the point data of this input; field data that they have stay.
  /// @pre Fits() returned true.
  void PassOn(const vtkAHDDataSets& data) const;

  /// Releases everything except the outputs of GiveEmpty().
  void Forget();

  /// Keeps which arrays the outputs have, without their values. `settings`: as Fits() takes it.
  void KeepEmpty(const vtkAHDDataSets& data, vtkMTimeType settings);

  /// Are outputs without a point known for these settings?
  bool KnowsEmpty(vtkMTimeType settings) const { return this->EmptyOf == settings; }

  /// Makes this output one without points, with the arrays of the kept one.
  void GiveEmpty(std::size_t port, vtkPolyData* output) const;

private:
  /// The identity of an array of the outputs.
  struct Known
  {
    std::string Name;
    ahd::Fingerprint Print;
    bool operator==(const Known& other) const
    {
      return this->Name == other.Name && this->Print == other.Print;
    }
  };

  void Share(const vtkAHDDataSets& data);
  bool TakeFingerprints(const vtkAHDDataSets& data, const vtkAHDContext& context);
  bool TakeOutputs(const vtkAHDContext& context, std::vector<Known>& found) const;
  bool HasOutputs(const vtkAHDContext& context) const;
  void LetGo();

  bool IsKept = false;
  bool HasOwnPoints = false; // is the surface's vtkPoints another than the input's?
  // From the last call of Fits():
  vtkMTimeType Settings = 0;
  vtkIdType Count = -1;                    // of points
  std::vector<ahd::Fingerprint> Now;       // empty if none were taken
  std::vector<ahd::Fingerprint> AtTheTime; // of the kept outputs
  std::array<vtkNew<vtkPolyData>, 3> Data; // without data of the input
  std::vector<Known> Outputs;              // their arrays, when they were kept

  std::array<vtkNew<vtkPolyData>, 3> Empty; // the outputs without a point
  vtkMTimeType EmptyOf = 0;                 // the settings that these were made with
};

#endif
