// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSampleExecution_h
#define vtkAHDSampleExecution_h

#include "Engine/Surface/Plane.h"
#include "Engine/Triangulate.h"
#include "Execution/vtkAHDReport.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "Sampling/vtkAHDPlaces.h"
#include "Sampling/vtkAHDRaster.h"
#include "Sampling/vtkAHDSampleColumns.h"
#include "Sampling/vtkAHDSampleMessages.h"
#include "Sampling/vtkAHDSampleSettings.h"
#include "Sampling/vtkAHDSampledSurface.h"
#include "vtkType.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

class vtkAHDSamplePieces;
class vtkAlgorithm;
class vtkDataSet;
class vtkPointData;
class vtkPointSet;
class vtkPolyData;

/// The inputs of an interpolation.
struct vtkAHDSampleInputs
{
  vtkPointSet* Points = nullptr;
  vtkPolyData* Source = nullptr; ///< may be null
  /// Null, or Points, if these are a surface whose own triangles are used.
  vtkPolyData* Surface = nullptr;
  vtkDataSet* Places = nullptr; ///< null: a raster
  /// Null, or of what the places are one piece, of this number, the first one first: the outputs of
  /// all stay.
  const vtkAHDSamplePieces* Pieces = nullptr;
  std::size_t Piece = 0;
  std::size_t InputBytes = 0; ///< allocated to merge the input, if it was made of blocks
  bool SaysArrays = true;     ///< warn of arrays that are not interpolated
  vtkAHDSettingsTimes SettingsTimes = {};
  ahd::SampleRaster Told; ///< the announced raster that downstream filters request; empty: none

  // One of several ranks: without warnings.
  std::size_t AddedPoints = 0;          ///< points of sources, the last of Points
  const vtkAHDRaster* Raster = nullptr; ///< null: the requested one; else a piece of it
  /// Null, or the pieces of the ranks before: places that are in these, too, do not count.
  const std::vector<ahd::SampleRaster>* PiecesBefore = nullptr;
};

/// Kept for the next execution.
struct vtkAHDSampleMemoryKept
{
  ahd::Workspace Workspace;
  std::unique_ptr<vtkAHDSampledSurface> Surface; ///< null: none
};

/**
 * One execution of vtkAdaptiveHilbertInterpolation2D: data sets in, a data set out. It triangulates
 * by vtkAHDExecution unless the surface was kept, and interpolates by vtkAHDSampling.
 */
class vtkAHDSampleExecution
{
public:
  /// Borrows all but the settings. `keep`: keep the surface for the next execution, if it
  /// is not too large.
  vtkAHDSampleExecution(vtkAlgorithm* filter, const vtkAHDSettings& settings,
    const vtkAHDSampleSettings& wishes, const vtkAHDContext& context, bool keep);
  ~vtkAHDSampleExecution();

  /// Fills the output, which has the requested type. Reports errors and warnings, except those
  /// about places and their values: vtkAHDSayPlaceWarnings() reports these from GetResult().
  /// Returns false after a failure: then the output is empty. Throws std::bad_alloc only if nothing
  /// can be reported.
  bool Run(const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept, vtkDataSet* output);

  /// Of the last Run().
  const vtkAHDSampleResult& GetResult() const { return this->Result; }
  /// Of the triangulation.
  const vtkAHDReport& GetReport() const { return this->Report; }
  const vtkAHDSampleMemory& GetMemory() const { return this->Memory; }
  bool HasTriangulated() const { return this->Triangulated; }
  double GetSeconds() const { return this->Seconds; }
  /// Does the raster differ from that of the points, because more was announced to downstream
  /// filters?
  bool CoversTold() const { return this->Covers; }

private:
  bool FindPlaces(const vtkAHDSampleInputs& inputs);
  void FindLimit(double held);
  bool FitsToFindPlaces(const vtkAHDSampleInputs& inputs);
  bool FitsInMemory(const vtkAHDSampleInputs& inputs, const vtkAHDSampleMemoryKept& kept);
  std::vector<double> StagesBehind(std::size_t points) const;
  void BorrowSurface(const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept);
  void TakeSurface(const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept);
  void Interpolate(
    const vtkAHDSampleInputs& inputs, vtkAHDSampledSurface& surface, vtkDataSet* output);
  void FindMissing(const vtkAHDSampleColumns& columns, const vtkAHDSampleInputs& inputs,
    vtkAHDSampledSurface& surface, const double* heights);
  void TakeFromCounts(const vtkAHDSampleInputs& inputs, vtkAHDSampledSurface& surface,
    const double* heights, vtkPointData* data);
  void Keep(const vtkAHDSampleInputs& inputs, vtkAHDSampleMemoryKept& kept);
  void CountPlaces(const ahd::SamplePlaces& places, const ahd::SampleReport& counts,
    vtkAHDSampledSurface& surface);
  double EstimateRaster() const;
  void EstimateSampling(const vtkAHDSampleInputs& inputs, std::size_t points);

  vtkAlgorithm* const Filter;
  vtkAHDSettings Settings;
  ahd::Plane Plane; // of a given surface, if fitted
  const vtkAHDSampleSettings& Wishes;
  const vtkAHDContext& Context;
  const bool MayKeep;

  vtkAHDRaster Raster;
  bool Covers = false;                  // more than is its own
  std::unique_ptr<vtkAHDPlaces> Places; // null: the raster
  std::size_t NumberOfPlaces = 0;
  double BytesOfSampling = 0.0;
  std::size_t CommonPlaces = 0; // that earlier ranks have, too
  vtkAHDReport Report;          // of the triangulation
  vtkAHDSampleResult Result;
  vtkAHDSampleMemory Memory;
  std::optional<vtkAHDProgress::Silence> Silence; // while what is read has been checked
  bool IsKept = false; // the surface is there: that of the execution before, or borrowed
  bool Triangulated = false;
  double Seconds = 0.0;
};

#endif
