// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRankSampling_h
#define vtkAHDRankSampling_h

#include "Ranks/vtkAHDRankSamples.h"
#include "Sampling/vtkAHDRaster.h"
#include "Sampling/vtkAHDSampleColumns.h"
#include "Sampling/vtkAHDSampleExecution.h"
#include "Sampling/vtkAHDSampleSettings.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkStructuredGrid;

/**
 * One execution of vtkAdaptiveHilbertInterpolation2D on all ranks of a controller: each computes
 * its piece of the raster, or its own places, by vtkAHDSampleExecution with the points of
 * vtkAHDRankSamples. Collective.
 */
class vtkAHDRankSampling
{
public:
  /// Borrows all of them.
  vtkAHDRankSampling(vtkAlgorithm* filter, const vtkAHDSettings& settings,
    const vtkAHDSampleSettings& wishes, vtkAHDRanks& ranks, const vtkAHDContext& context);

  /// The input of one rank, and the requested output.
  struct Inputs
  {
    vtkAHDDataSets Data;                                     ///< without outputs
    ahd::Status Before = ahd::Status::Ok;                    ///< the reason if the input failed
    vtkDataObject* Places = nullptr;                         ///< null: a raster
    std::array<int, 6> Extent = { { 0, -1, 0, -1, 0, -1 } }; ///< of the raster
    std::array<int, 6> Whole = { { 0, -1, 0, -1, 0, -1 } };  ///< as it was announced
    std::array<int, 3> Piece = { { 0, 1, 0 } };              ///< its number, of how many, ghosts
  };

  /// Fills this rank's output, and reports errors, and on one rank warnings. Returns false on all
  /// ranks after a failure: then outputs are empty. Throws nothing.
  bool Run(const Inputs& inputs, vtkDataObject* output);

  /// The raster around the points of all ranks alone. Throws vtkAHDStop and std::bad_alloc, on
  /// one rank or on all. @pre called within vtkAHDRanks::Execute().
  vtkAHDRaster FindRaster(const Inputs& inputs);

  /// Of the active scalars. @pre FindRaster().
  vtkAHDSampleColumns::Kind GetKindOfScalars() const { return this->Scalars; }

  /// Of all ranks.
  const vtkAHDSampleResult& GetResult() const { return this->Result; }
  double GetSeconds() const { return this->Seconds; }
  bool IsAborted() const { return this->Aborted; }
  /// Does the raster differ from the one announced on some rank? The piece is then one of it.
  bool IsOtherRaster() const { return this->OtherRaster; }
  /// Of this rank.
  vtkTypeInt64 GetEstimate() const { return this->Estimate; }

private:
  /// The data they share.
  struct Meeting
  {
    bool AreUnfit = false;            // places on one of them
    std::size_t Other = 0;            // a rank with other settings than rank 0
    const char* Difference = nullptr; // the setting
  };

  Meeting Meet(const Inputs& inputs);
  void MeetAll(const Inputs& inputs);
  bool RunTogether(const Inputs& inputs, vtkDataObject* output);
  void SayError(ahd::Status status);
  ahd::Bounds FindBounds(const Inputs& inputs, std::size_t& points);
  void FindScalars(const vtkAHDAllFacts& facts);
  vtkAHDRaster MakeRaster(const vtkAHDRankSamples& samples);
  vtkAHDRaster PieceOf(const vtkAHDRaster& whole, const Inputs& inputs);
  void FindOthers(const vtkAHDRaster& piece);
  std::vector<ahd::Bounds> BoxesOf(const Inputs& inputs, const vtkAHDRaster& piece) const;
  void Interpolate(const Inputs& inputs, const vtkAHDRaster& piece,
    const vtkAHDRankSamples& samples, vtkDataSet* output);
  void Share(const vtkAHDSampleExecution& execution, bool isDone, const std::string& error,
    const vtkAHDRankSamples& samples);
  void LowerHidden(vtkStructuredGrid* surface);
  void MarkAlike(vtkDataSet* image);
  void Say(const vtkAHDSampleExecution& execution, const vtkAHDRankSamples& samples,
    const std::vector<std::string>& warnings);

  vtkAlgorithm* const Filter;
  const vtkAHDSettings& Settings;
  const vtkAHDSampleSettings& Wishes;
  vtkAHDRanks& Ranks;
  const vtkAHDContext& Context;
  std::string Error;                           // reported by all
  std::vector<ahd::SampleRaster> PiecesBefore; // of the ranks before this one
  vtkAHDSampleColumns::Kind Scalars;
  vtkAHDSampleResult Result;
  double Seconds = 0.0;
  vtkTypeInt64 Estimate = 0;
  bool Aborted = false;
  bool OtherRaster = false;
  bool HaveSurface = false; // made by the Delaunay filter, on a rank
};

#endif
