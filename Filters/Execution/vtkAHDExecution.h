// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDExecution_h
#define vtkAHDExecution_h

#include "Engine/RunMemory.h"
#include "Engine/Triangulate.h"
#include "Execution/vtkAHDReport.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkAbstractTransform;
class vtkAHDLeftBehind;
class vtkPolyData;

/// Surface, order, Voronoi diagram.
using vtkAHDOutputs = std::array<vtkPolyData*, 3>;

/// What goes into an execution and what comes out.
struct vtkAHDDataSets
{
  vtkPointSet* Input = nullptr;
  vtkPolyData* Source = nullptr; ///< may be null
  vtkAHDOutputs Outputs = {};
  std::size_t InputBytes = 0; ///< that making the input has taken, if it was made of blocks
};

/// A triangulation, and the points that it borrows.
struct vtkAHDTriangulated
{
  ahd::PreparedInput Points;
  ahd::Triangulation Triangulation;
};

/**
 * One execution of vtkAdaptiveHilbertDelaunay2D: data sets in, data sets out. The engine computes:
 * what there is to be triangulated becomes an ahd::PreparedInput, that an ahd::Triangulation, and
 * each output is written from these two.
 */
class vtkAHDExecution
{
public:
  /// Borrows all of them. `bytesBefore`: those that making the input has taken.
  vtkAHDExecution(const vtkAHDSettings& settings, vtkAHDInput& input, ahd::Workspace& workspace,
    const vtkAHDContext& context, std::size_t bytesBefore);

  /// Triangulates and fills the outputs, which are to be empty. They are empty again unless
  /// Report::Status is Ok. Throws nothing. The working memory is kept for the next execution if it
  /// is not too much and nothing went wrong.
  /// `left`: null, or where the triangulation is left for who interpolates on the surface, then
  /// instead of its memory.
  vtkAHDReport Run(const vtkAHDOutputs& outputs, vtkAHDLeftBehind* left = nullptr);

  /// Triangulates alone. `made` is of use if Report::Status is Ok; the caller keeps it, or gives it
  /// back to the workspace. `bytesBehind`: what he will allocate behind this, part of the estimate.
  /// `stagesBehind`: the weights of his own stages (see vtkAHDProgress). Throws nothing. The report
  /// knows no cells that were put out.
  vtkAHDReport Triangulate(
    vtkAHDTriangulated& made, std::size_t bytesBehind, const std::vector<double>& stagesBehind);

  /// Upper estimate of all that is allocated, for what is known of sizes: points and segments
  /// before Run(), where no value is looked at.
  std::size_t EstimateBytes() const;

private:
  /// The values on the way from the input to the outputs.
  struct Results : vtkAHDTriangulated
  {
    ahd::VoronoiCells Voronoi;
    ahd::Selection Selection;
  };

  template <typename Steps>
  void Try(const Steps& steps);
  void MakeSurface(Results& results);
  bool FitsInMemory();
  bool Fits(std::size_t crossings, std::size_t boxes);
  std::vector<double> FirstStages() const;
  void SetStages() const;
  void MakeTriangles(Results& results);
  void Prepare(ahd::PreparedInput& points);
  void TakeVoronoiMemory(const ahd::Report& counts, ahd::VoronoiCells& cells) const;
  void Constrain(Results& results);
  void Write(Results& results, const vtkAHDOutputs& outputs);
  void WriteVoronoi(Results& results, const vtkAHDOutputs& outputs);
  void FindStacks(const Results& results);
  void ReportOn(const Results& results);
  bool Leave(Results& results, vtkPolyData* surface, vtkAHDLeftBehind& left) const;
  std::size_t EstimateLeft() const;
  void GiveBack(Results& results);
  void KeepOutputMemory(std::size_t held) const;
  void LimitAsked(std::size_t& asked);
  void CheckAsked(ahd::Status status);
  void UpdateEstimate();

  const vtkAHDSettings& Settings;
  vtkAHDInput& Input;
  ahd::Workspace& Workspace;
  const vtkAHDContext& Context;
  const std::size_t BytesBefore;
  std::size_t BytesBehind = 0;
  ahd::Options Options;
  ahd::RunSizes Known; // of what the execution has to deal with
  vtkAHDReport Report;
};

#endif
