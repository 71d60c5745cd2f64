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
 * The same: by what they are, not by which object they are in, so that a reader may make new ones
 * for each time step, and a program may change them where they lie. The outputs' arrays are held,
 * the input is not. Whoever has the outputs may change their arrays, too: then they are let go.
 *
 * To know the points again takes their fingerprint, and that takes time. So it is not taken before
 * an execution comes again with unchanged settings and as many points: the second such execution
 * keeps its outputs, and they are passed on from the third on.
 */
class vtkAHDOutputCache
{
public:
  vtkAHDOutputCache();
  ~vtkAHDOutputCache();
  vtkAHDOutputCache(const vtkAHDOutputCache&) = delete;
  vtkAHDOutputCache& operator=(const vtkAHDOutputCache&) = delete;

  /// Can the outputs be passed on for these data sets, with settings that were changed last at
  /// `settings`, and are they what they were? If not, lets go of them. False if the filter is to
  /// abort.
  bool Fits(const vtkAHDDataSets& data, vtkMTimeType settings, const vtkAHDContext& context);

  /// Keeps the outputs, if Fits() took fingerprints, unless points were added, whose data are not
  /// the input's. They belong to the data sets that Fits() was called with last, whatever has
  /// changed since. Keeps nothing if the filter is to abort. REQUIRES: it said no to these.
  void Keep(const vtkAHDDataSets& data, const vtkAHDContext& context);

  /// Fills the outputs anew, with the point data of this input; field data that they have stay.
  /// REQUIRES: Fits() said so.
  void PassOn(const vtkAHDDataSets& data) const;

  /// Lets go of everything, but of what GiveEmpty() gives.
  void Forget();

  /// Keeps which arrays the outputs have, without their values. `settings`: as Fits() takes it.
  void KeepEmpty(const vtkAHDDataSets& data, vtkMTimeType settings);

  /// Are outputs without a point known for these settings?
  bool KnowsEmpty(vtkMTimeType settings) const { return this->EmptyOf == settings; }

  /// Makes this output one without a point, that has the arrays of the one that was kept.
  void GiveEmpty(std::size_t port, vtkPolyData* output) const;

private:
  /// An array of the outputs, as it is known again.
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
  // Of what Fits() saw last:
  vtkMTimeType Settings = 0;
  vtkIdType Count = -1;                    // of points
  std::vector<ahd::Fingerprint> Now;       // empty if none were taken
  std::vector<ahd::Fingerprint> AtTheTime; // of what is kept
  std::array<vtkNew<vtkPolyData>, 3> Data; // without data of the input
  std::vector<Known> Outputs;              // their arrays, when they were kept

  std::array<vtkNew<vtkPolyData>, 3> Empty; // the outputs without a point
  vtkMTimeType EmptyOf = 0;                 // the settings that these were made with
};

#endif
