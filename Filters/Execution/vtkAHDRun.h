// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDRun_h
#define vtkAHDRun_h

#include "Engine/Crossings/Crossings.h"
#include "Engine/Merge/Merge.h"
#include "Engine/Options.h"
#include "Engine/Result.h"
#include "Engine/Triangulate.h"
#include "Input/vtkAHDConstraints.h"
#include "Input/vtkAHDDuplicates.h"
#include "Input/vtkAHDWorkingPoints.h"
#include "Output/vtkAHDCellArrays.h"
#include "Output/vtkAHDPointOutput.h"
#include "Output/vtkAHDVoronoi.h"
#include "Pipeline/vtkAHDExecutor.h"
#include "Pipeline/vtkAHDProgress.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkAbstractTransform;
class vtkAdaptiveHilbertDelaunay2D;
class vtkInformationVector;
class vtkPointSet;
class vtkPolyData;

/**
 * One execution of vtkAdaptiveHilbertDelaunay2D: what its steps share, and their order. The work is
 * done by others, to whom the steps hand on; the filter's settings are read, never written.
 */
class vtkAHDRun
{
public:
  /// Borrows all of them. `source` may be null. REQUIRES: three outputs.
  vtkAHDRun(vtkAdaptiveHilbertDelaunay2D* filter, vtkPointSet* input, vtkPolyData* source,
    vtkInformationVector* outputs);
  ~vtkAHDRun();
  vtkAHDRun(const vtkAHDRun&) = delete;
  vtkAHDRun& operator=(const vtkAHDRun&) = delete;

  /// Are there not too many points, and is there memory for it all, as far as that is known before?
  /// Says so if not.
  bool FitsInMemory();

  /// Triangulates and fills the outputs; throws nothing.
  ahd::Status Triangulate();

  /// Empties the outputs and says why, unless it was the user who cancelled.
  void Fail(ahd::Status status);

  /// Shows the counts and times of this execution in the filter's Get methods.
  void KeepMeasures();

  /// Warns of what there is to be warned of, each at most once.
  void Warn();

private:
  // The steps, in this order. Each returns Ok, or why there is to be no next step; each may throw
  // std::bad_alloc.
  ahd::Status OpenPoints();      // Points: the input's, then the source's own
  ahd::Status Project();         // Points: moved into the plane of the triangulation
  ahd::Status Merge();           // Points: those near to others are left out
  ahd::Status AddBounding();     // Points: the eight around all
  ahd::Status ReadConstraints(); // what the source asks for, in the ids of Points
  ahd::Status Split();           // Points and constraints: crossings
  ahd::Status Insert();          // the Delaunay triangulation of Points, unconstrained
  ahd::Status ChooseShown();     // Shown
  ahd::Status MakeVoronoi();     // Diagram
  ahd::Status Constrain();       // constraints become edges, loops drop triangles
  ahd::Status WritePoints();     // Surface: points and their data
  ahd::Status ShowMeans();       // Surface: points that are the mean of several
  ahd::Status WriteTriangles();  // Surface: triangles
  ahd::Status ShowInTriangles(); // Surface: the points that are shown
  ahd::Status DropByLength();    // Surface: triangles dropped by Alpha and MaximumEdgeLength
  ahd::Status AddArrays();       // Surface: arrays of points and cells, field data
  ahd::Status ShowInArrays();    // Surface: the points that are shown
  ahd::Status AddCellArrays();   // Surface: what is known of each triangle
  ahd::Status WriteVoronoi();    // Voronoi: Diagram, with the point data of Surface
  ahd::Status WriteOrder();      // Order

  ahd::Status TakeSteps();
  ahd::Status WriteFates(std::unique_ptr<std::int64_t[]>& fates);
  ahd::Options GetOptions() const;
  bool IsOrderWanted() const;
  bool IsProjected() const; // is the plane of the triangulation another than x, y?
  bool HasConstraints() const;
  vtkPolyData* GetSourceOfPoints() const;
  std::size_t CountExpectedPoints() const;
  std::size_t EstimateBytes() const;
  std::size_t EstimateSourceBytes(std::size_t count) const;
  std::size_t EstimateExtraBytes() const; // of what looks at finished triangles
  std::size_t EstimateDuplicateBytes(std::size_t count) const;
  void AddBoxesToEstimate(std::size_t boxes);
  void KeepTimes();
  void AddCounts();
  void AddCrossings();
  void AddSplitPoints(const std::vector<ahd::CrossingPoint>& points);
  vtkIdType GetFirstCrossing() const; // the id of the first of them
  void FindCrossingHeights();         // z in Points, from those of the ends
  ahd::PointView GetAllButCrossings() const;
  void EndCrossingsAtShown(const std::int64_t* fates);
  ahd::Status ShowMeansAtCrossings(const std::int64_t* fates);
  void WarnOfConstraints();
  void WarnOfNoTriangle();
  void WarnOfPlane();
  void WarnOfDropped();

  vtkAdaptiveHilbertDelaunay2D* const Filter;
  ahd::Triangulator& Triangulator; // the filter's
  vtkPointSet* const Input;
  vtkPolyData* const Source; // may be null
  vtkPolyData* const Surface;
  vtkPolyData* const Order;
  vtkPolyData* const Voronoi;
  vtkAHDWorkingPoints Points;
  vtkSmartPointer<vtkAbstractTransform> ToPlane; // null where the plane is x, y
  vtkAHDProgress Progress;
  vtkAHDExecutor Executor;
  std::vector<ahd::MergedPoint> Merged; // points that Tolerance left out
  vtkAHDConstraints Constraints;
  vtkAHDDuplicates Shown;                              // which of several points at one place
  std::vector<vtkAHDCrossing> Crossings;               // of the points added last
  std::vector<std::array<vtkIdType, 2>> CrossingCells; // of the source: the later, the earlier
  std::size_t DelaunayTriangles = 0;                   // before constraints drop some
  vtkTypeInt64 Limit = 0;                              // KiB
  std::size_t MostBoxes = 0;                           // for which there is memory
  vtkAHDVoronoi Diagram;
  vtkAHDCellArrays Cells;
  bool IsDiagramInPlane = false; // although the points are not: there is no way back
  ahd::Report Report;
  vtkAHDWorkingPoints::Oddities Odd;
};

#endif
