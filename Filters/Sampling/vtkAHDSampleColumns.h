// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleColumns_h
#define vtkAHDSampleColumns_h

#include "Engine/Core/Uninitialised.h"
#include "Engine/Sample/Sample.h"
#include "Pipeline/vtkAHDContext.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;
class vtkPointData;

namespace ahd
{
class Triangulation;
}

/// One array to interpolate: of the points, and of the places.
struct vtkAHDSampleColumn
{
  vtkSmartPointer<vtkDataArray> From; ///< null: the heights
  std::string Name;
  std::size_t Components = 1;
  bool IsFloat = false; ///< the results are float, else double

  const double* Values = nullptr;            ///< by points
  ahd::UninitialisedVector<double> Read;     ///< these, where they are no doubles in memory
  vtkSmartPointer<vtkDataArray> Out;         ///< of the places
  vtkSmartPointer<vtkDataArray> OutGradient; ///< null: none is wanted
  double* Results = nullptr;
  double* Gradients = nullptr;
  std::size_t Missing = 0; ///< values at places on the surface that are NaN
};

/// What is missing of an array.
struct vtkAHDMissingValues
{
  std::string Name;       ///< empty: the heights
  std::size_t Places = 0; ///< values at places on the surface that are none
  bool OfPoints = false;  ///< the array has NaN at vertices
  bool OfAdded = false;   ///< at such that were added, of the source for example

  /// See ahd::HasFields.
  auto fields() { return std::tie(this->Name, this->Places, this->OfPoints, this->OfAdded); }
};

/// The points from `First` to before `End`, which were added to the input; but for crossings, whose
/// values are made of those of others.
struct vtkAHDAddedPoints
{
  std::size_t First;
  std::size_t End;
};

/**
 * The arrays of one execution: which are interpolated, their numbers as the engine wants them, and
 * the arrays that come of it.
 */
class vtkAHDSampleColumns
{
public:
  /// What stands behind the name of an array in that of its gradients.
  static constexpr const char* kGradient = "Gradient";

  /// Chooses. `given`: the point data of the input, which says which arrays are ids; `data`: the
  /// point data with a value for each of `count` points, from which are read.
  vtkAHDSampleColumns(const vtkAHDSampleSettings& settings, vtkPointData* given, vtkPointData* data,
    std::size_t count);

  /// Names of arrays that cannot be interpolated; and whether one was passed over because its name
  /// is that of an array that is made.
  const std::vector<std::string>& GetUnfit() const { return this->Unfit; }
  const std::vector<std::string>& GetReplaced() const { return this->Replaced; }

  /// Upper estimate of the bytes that all below allocates, heights and mask included, and what a
  /// Sampler takes for it; as a double, as it may be beyond all whole numbers.
  double EstimateBytes(std::size_t points, double places) const;

  /// Those of it that the arrays have which are put out, mask included.
  double EstimateOutputBytes(double places) const;

  std::size_t GetNumberOfComponents() const;

  /// What AddTo() makes the active scalars: type and number of components.
  struct Kind
  {
    int Type = VTK_DOUBLE;
    int Components = 1;
  };
  Kind GetKindOfScalars() const;

  /// Reads values and makes arrays for so many places. `heights`: borrowed. Throws vtkAHDStop and
  /// std::bad_alloc.
  void Open(const double* heights, std::size_t places, const vtkAHDContext& context);

  /// For the engine; after Open(). Good as long as this object.
  const std::vector<ahd::SampleArray>& GetArrays() const { return this->Arrays; }

  /// Counts the values that are missing at places whose mask is 1. After the engine has written
  /// values, before Finish(); Gather() counts, too.
  void CountMissing(const char* mask, const vtkAHDContext& context);

  /// How many that were, of the array of this name; empty: of the heights.
  std::size_t CountMissingOf(const std::string& name) const;

  /// Of all arrays, the heights first. Throws vtkAHDStop and std::bad_alloc.
  std::vector<vtkAHDMissingValues> FindMissing(const double* heights,
    const ahd::Triangulation& surface, const vtkAHDAddedPoints& added,
    const vtkAHDContext& context) const;

  /// Makes the arrays what they are to be: their type, and NoValue in place of NaN.
  void Finish(const vtkAHDContext& context);

  /// In place of Open() and Finish(): each place takes the values of a point as they are; an id
  /// that is NaN stands for none. Counts values that are NaN.
  std::size_t Gather(
    const double* heights, const double* ids, std::size_t places, const vtkAHDContext& context);

  /// The heights at the places, after Finish() or Gather(): always there.
  vtkDataArray* GetHeights() const { return this->Columns.front().Out; }

  /// Adds the arrays to the point data of places, and makes active what is in `data`.
  void AddTo(vtkDataSetAttributes* places) const;

private:
  /// What is chosen from.
  struct Choice
  {
    vtkPointData* Arrays; // one of each name
    vtkPointData* Given;
    std::size_t Points;
  };

  double OutputPerPlace() const;
  double BytesPerPlace(const vtkAHDSampleColumn& column) const;
  std::size_t NumbersPerPlace(const vtkAHDSampleColumn& column) const;
  void Choose(vtkAbstractArray* array, const Choice& choice);
  bool IsTaken(const std::string& name, const Choice& choice) const;
  bool MakesGradientOf(const std::string& name, const Choice& choice) const;

  const vtkAHDSampleSettings& Settings;
  vtkPointData* const Data;
  std::vector<vtkAHDSampleColumn> Columns; // the heights first
  std::vector<ahd::SampleArray> Arrays;
  std::vector<std::string> Unfit;
  std::vector<std::string> Replaced;
};

#endif
