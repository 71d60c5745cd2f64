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
#include "vtkUnsignedCharArray.h"

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

/// One array to interpolate, of the points and of the places.
struct vtkAHDSampleColumn
{
  vtkSmartPointer<vtkDataArray> From; ///< null: the heights
  std::string Name;
  std::size_t Components = 1;
  bool IsFloat = false; ///< the results are float, else double

  const double* Values = nullptr;            ///< by points
  ahd::UninitialisedVector<double> Read;     ///< these, if they are not doubles in memory
  vtkSmartPointer<vtkDataArray> Out;         ///< of the places
  vtkSmartPointer<vtkDataArray> OutGradient; ///< null: none
  double* Results = nullptr;
  double* Gradients = nullptr;
  std::size_t Missing = 0; ///< values at places on the surface that are NaN
};

/// The missing values of an array.
struct vtkAHDMissingValues
{
  std::string Name;       ///< empty: the heights
  std::size_t Places = 0; ///< missing values at places on the surface
  bool OfPoints = false;  ///< the array has NaN at vertices
  bool OfAdded = false;   ///< at added vertices, for example of the source

  /// See ahd::HasFields.
  auto fields() { return std::tie(this->Name, this->Places, this->OfPoints, this->OfAdded); }
};

/// The points from `First` to before `End`, which were added to the input; without crossings, whose
/// values are interpolated.
struct vtkAHDAddedPoints
{
  std::size_t First;
  std::size_t End;
};

/**
 * The arrays of one execution: the interpolated ones, their numbers for the engine, and
 * the output arrays.
 */
class vtkAHDSampleColumns
{
public:
  /// The suffix of the names of gradients.
  static constexpr const char* kGradient = "Gradient";

  /// Chooses the arrays. `given`: the point data of the input, which tell which arrays are ids;
  /// `data`: the point data to read, with a value for each of `count` points.
  vtkAHDSampleColumns(const vtkAHDSampleSettings& settings, vtkPointData* given, vtkPointData* data,
    std::size_t count);

  /// Names of arrays that cannot be interpolated, and of those left out because an output array has
  /// their name.
  const std::vector<std::string>& GetUnfit() const { return this->Unfit; }
  const std::vector<std::string>& GetReplaced() const { return this->Replaced; }

  /// Upper estimate of the bytes that all functions below allocate, heights and mask included, with
  /// those of a Sampler; a double, as it may exceed whole numbers.
  double EstimateBytes(std::size_t points, double places) const;

  /// Those of the output arrays, mask included.
  double EstimateOutputBytes(double places) const;

  std::size_t GetNumberOfComponents() const;

  /// Type and number of components of the active scalars after AddTo().
  struct Kind
  {
    int Type = VTK_DOUBLE;
    int Components = 1;
  };
  Kind GetKindOfScalars() const;

  /// Reads values and makes arrays for so many places. `heights`: borrowed. Throws vtkAHDStop and
  /// std::bad_alloc.
  void Open(const double* heights, std::size_t places, const vtkAHDContext& context);

  /// For the engine; after Open(). Valid as long as this object.
  const std::vector<ahd::SampleArray>& GetArrays() const { return this->Arrays; }

  /// Counts the missing values at places whose mask is 1. After the engine has written
  /// values, before Finish(); Gather() counts, too.
  void CountMissing(const char* mask, const vtkAHDContext& context);

  /// Their number, for the array of this name; empty: the heights.
  std::size_t CountMissingOf(const std::string& name) const;

  /// Those of all arrays, the heights first. Throws vtkAHDStop and std::bad_alloc.
  std::vector<vtkAHDMissingValues> FindMissing(const double* heights,
    const ahd::Triangulation& surface, const vtkAHDAddedPoints& added,
    const vtkAHDContext& context) const;

  /// Completes the arrays: their type, and NoValue in place of NaN.
  void Finish(const vtkAHDContext& context);

  /// In place of Open() and Finish(): each place gets the values of a point unchanged; NaN as
  /// the id means none. Counts values that are NaN.
  std::size_t Gather(
    const double* heights, const double* ids, std::size_t places, const vtkAHDContext& context);

  /// For each place a ghost mark, HIDDENPOINT where neither the height nor an array has a value;
  /// null if each place has one. `mask`: 1 for places on the surface. After Finish() or Gather().
  /// Throws vtkAHDStop and std::bad_alloc.
  vtkSmartPointer<vtkUnsignedCharArray> MarkWithoutValue(
    const char* mask, const vtkAHDContext& context) const;

  /// The heights at the places, after Finish() or Gather(); never null.
  vtkDataArray* GetHeights() const { return this->Columns.front().Out; }

  /// Adds the arrays to the point data of places, with the active attributes of `data`.
  void AddTo(vtkDataSetAttributes* places) const;

private:
  /// The candidates.
  struct Choice
  {
    vtkPointData* Arrays; // one of each name
    vtkPointData* Given;
    std::size_t Points;
  };

  bool HasValueAt(vtkIdType place) const;
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
