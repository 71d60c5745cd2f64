// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDExecution_h
#define vtkAHDExecution_h

#include "Engine/Core/Fingerprint.h"
#include "Engine/Job/Run.h"
#include "Execution/vtkAHDReport.h"
#include "Input/vtkAHDInput.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

class vtkAbstractTransform;
class vtkAHDLentTriangulation;
class vtkPolyData;

/// Surface, order, Voronoi diagram.
using vtkAHDOutputs = std::array<vtkPolyData*, 3>;

/// The inputs and outputs of an execution.
struct vtkAHDDataSets
{
  vtkPointSet* Input = nullptr;
  vtkPolyData* Source = nullptr; ///< may be null
  vtkAHDOutputs Outputs = {};
  std::size_t InputBytes = 0; ///< allocated to merge the input, if it was made of blocks
};

/**
 * One execution of vtkAdaptiveHilbertDelaunay2D: data sets in, data sets out. It opens the
 * input for an ahd::Run, and writes the result into VTK's arrays.
 */
class vtkAHDExecution
{
public:
  /// Borrows all of them. `bytesBefore`: allocated to merge the input.
  vtkAHDExecution(const vtkAHDSettings& settings, vtkAHDInput& input, ahd::Workspace& workspace,
    const vtkAHDContext& context, std::size_t bytesBefore);

  using LentPointer = vtkSmartPointer<vtkAHDLentTriangulation>;

  /// Triangulates and fills the outputs, which must be empty. They are empty again unless
  /// Report::Status is Ok. Throws nothing. The working memory is kept for the next execution if it
  /// is within the limit and the execution succeeded.
  /// `lent`: null, or becomes the triangulation, for filters that interpolate on the surface, which
  /// is then kept instead of its memory; stays null if it is not lent.
  vtkAHDReport Run(const vtkAHDOutputs& outputs, LentPointer* lent = nullptr);

  /// Triangulates without writing outputs. `made` is valid if Report::Status is Ok; the caller
  /// keeps it, or returns it to the workspace. `bytesBehind`: the caller's later allocations, for
  /// the estimate. `stagesBehind`: the weights of its own stages (see ahd::RunProgress). Throws
  /// nothing. The report has no counts of output cells.
  vtkAHDReport Triangulate(
    ahd::RunResult& made, std::size_t bytesBehind, const std::vector<double>& stagesBehind);

  /// Upper estimate of all allocations from the known sizes: before Run() those of points and
  /// segments, without reading values.
  std::size_t EstimateBytes() const;

private:
  template <typename Steps>
  bool Try(std::size_t bytesBehind, const Steps& steps);
  ahd::CallersMemory OwnMemory(std::size_t bytesBehind) const;
  bool FitsInMemory(ahd::Run& run);
  void Make(ahd::Run& run, ahd::RunResult& made);
  void TakeVoronoiMemory(const ahd::Report& counts, ahd::VoronoiCells& cells) const;
  void Write(ahd::RunResult& made, const vtkAHDOutputs& outputs);
  void WriteVoronoi(ahd::RunResult& made, const vtkAHDOutputs& outputs);
  void Finish(ahd::Run& run, const ahd::RunResult& made);
  bool Lend(ahd::RunResult& made, vtkPolyData* surface, LentPointer& lent) const;
  std::size_t EstimateLent() const;
  void TakePrints();
  void GiveBack(ahd::RunResult& made);
  void KeepOutputMemory(std::size_t held) const;

  const vtkAHDSettings& Settings;
  vtkAHDInput& Input;
  ahd::Workspace& Workspace;
  const vtkAHDContext& Context;
  const std::size_t BytesBefore;
  vtkAHDReport Report;
  std::array<std::optional<ahd::Fingerprint>, 2>
    Prints; // before the run, where there are observers
};

#endif
