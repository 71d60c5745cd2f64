// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRefineExecution_h
#define vtkAHDRefineExecution_h

#include "Engine/Job/RefineRun.h"
#include "Engine/Job/Run.h"
#include "Pipeline/vtkAHDContext.h"
#include "Pipeline/vtkAHDSettings.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkAHDMergedBlocks;
class vtkAlgorithm;
class vtkDataArray;
class vtkIdTypeArray;
class vtkPoints;
class vtkPolyData;

/// What a quality mesh must be like.
struct vtkAHDRefineWishes
{
  ahd::RefineRequest Request; ///< without sizes
  std::string SizeArrayName;  ///< empty: none
};

/**
 * One execution of vtkAdaptiveHilbertQualityMesh2D: triangulates, finds points to add, and
 * triangulates all points with the pieces of the segments, as made.refine() for NumPy does.
 */
class vtkAHDRefineExecution
{
public:
  /// Borrows all of them.
  vtkAHDRefineExecution(vtkAlgorithm* filter, const vtkAHDSettings& settings,
    const vtkAHDRefineWishes& wishes, const vtkAHDContext& context)
    : Filter(filter)
    , Settings(settings)
    , Wishes(wishes)
    , Context(context)
  {
  }

  /// Fills the outputs, which must be empty; false: not wholly, and the reason has been said,
  /// unless it is an abort. Throws std::bad_alloc.
  bool Run(const vtkAHDMergedBlocks& merged, vtkPolyData* mesh, vtkPolyData* segments);

  const ahd::RefinedMesh& GetFound() const { return this->Found; }
  double GetLeastAngle() const { return this->LeastAngle; }
  vtkTypeInt64 GetMemoryEstimate() const { return this->Estimate; }

private:
  bool Try(const vtkAHDMergedBlocks& merged, vtkPolyData* mesh, vtkPolyData* segments);
  bool Refine(ahd::RunResult& made, vtkPolyData* given, std::size_t other);
  bool ReadSizes(vtkPolyData* given, std::vector<double>& sizes);
  bool TriangulateAgain(ahd::RunResult& made, std::size_t held, vtkPolyData* surface);
  void WritePoints(const ahd::RunResult& made, vtkPolyData* given, vtkPolyData* mesh) const;
  void WriteTriangles(ahd::RunResult& made, vtkPolyData* surface, vtkPolyData* mesh);
  void WriteSegments(vtkPolyData* mesh, vtkPolyData* segments) const;
  bool Refuse(const ahd::Facts& facts) const;
  ahd::RefineInput ToRefine(ahd::RunResult& made) const
  {
    const ahd::Context context = this->Context;
    return { made.points, this->Settings.options, made.triangulation, this->Context.GetProgress(),
      context.executor };
  }

  vtkAlgorithm* const Filter;
  const vtkAHDSettings& Settings;
  const vtkAHDRefineWishes& Wishes;
  const vtkAHDContext& Context;
  ahd::RefinedMesh Found;
  double LeastAngle = 0.0;
  vtkTypeInt64 Estimate = 0;
};

#endif
