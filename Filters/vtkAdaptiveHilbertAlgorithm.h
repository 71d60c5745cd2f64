// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertAlgorithm
 * @brief   settings and measures of the insertion, threads and memory
 *
 * The superclass of vtkAdaptiveHilbertDelaunay2D: how the points are inserted, which arrays and
 * which output of the insertion are made, threads, memory, and what was measured. None of its
 * settings but InsertionLimit changes the triangles.
 *
 * Methods: T. Su, W. Wang, Z. Lv, W. Wu, X. Li, Computers & Graphics 54 (2016) 65-74,
 * doi:10.1016/j.cag.2015.07.019. Details: Plugin/Documentation/Reference.md.
 *
 * Several filters may execute at once, each in a thread and a pipeline of its own, with a shallow
 * copy of the input and of the source each. To abort from another thread, set a flag of your own,
 * and let an observer of ProgressEvent call SetAbortExecute when it sees it.
 *
 * @sa
 * vtkAdaptiveHilbertDelaunay2D
 */

#ifndef vtkAdaptiveHilbertAlgorithm_h
#define vtkAdaptiveHilbertAlgorithm_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

struct vtkAHDReport;
struct vtkAHDSettings;

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertAlgorithm
  : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkAdaptiveHilbertAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of InsertionOrder.
  enum InsertionOrders
  {
    ADAPTIVE_HILBERT = 0, ///< HG: boxes divided where crowded, along an adaptive Hilbert curve
    MULTI_GRID = 1,       ///< MG: boxes divided where crowded, line by line (S. H. Lo, 2013)
    REGULAR_GRID = 2,     ///< RG: boxes of one even grid, line by line
    AS_GIVEN = 3          ///< the order of the input
  };

  /// The values of ControlPoints.
  enum ControlPointRounds
  {
    NO_CONTROL_POINTS = 0, ///< none
    SINGLE_LEVEL = 1,      ///< one point of each box of the first level
    EVERY_LEVEL = 2        ///< a sparse subset of the points, before it a sparser one, and so on
  };

  ///@{
  /// In which order the points are inserted. Changes the time, never the triangles. The default,
  /// ADAPTIVE_HILBERT, is the fastest. AS_GIVEN takes very long for points in random order.
  vtkSetClampMacro(InsertionOrder, int, ADAPTIVE_HILBERT, AS_GIVEN);
  vtkGetMacro(InsertionOrder, int);
  void SetInsertionOrderToAdaptiveHilbert() { this->SetInsertionOrder(ADAPTIVE_HILBERT); }
  void SetInsertionOrderToMultiGrid() { this->SetInsertionOrder(MULTI_GRID); }
  void SetInsertionOrderToRegularGrid() { this->SetInsertionOrder(REGULAR_GRID); }
  void SetInsertionOrderToAsGiven() { this->SetInsertionOrder(AS_GIVEN); }
  ///@}

  ///@{
  /// A box with more points than this is divided: from 1, default 50. Used by ADAPTIVE_HILBERT and
  /// MULTI_GRID. Changes the time, never the triangles; with the defaults of ControlPoints and
  /// GeneRotation it changes only the boxes of GenerateBoxes.
  vtkSetClampMacro(Nmax, int, 1, VTK_INT_MAX);
  vtkGetMacro(Nmax, int);
  ///@}

  ///@{
  /// Which points are inserted before all others, so that the first triangles are neither long nor
  /// thin. Default EVERY_LEVEL. Used by ADAPTIVE_HILBERT and MULTI_GRID. Changes the time, never
  /// the triangles.
  vtkSetClampMacro(ControlPoints, int, NO_CONTROL_POINTS, EVERY_LEVEL);
  vtkGetMacro(ControlPoints, int);
  void SetControlPointsToNone() { this->SetControlPoints(NO_CONTROL_POINTS); }
  void SetControlPointsToSingleLevel() { this->SetControlPoints(SINGLE_LEVEL); }
  void SetControlPointsToEveryLevel() { this->SetControlPoints(EVERY_LEVEL); }
  ///@}

  ///@{
  /// Turn the curve inside each divided box so that it meets the neighbouring boxes (the paper's
  /// "gene"). On by default. Used by ADAPTIVE_HILBERT. Changes the time, never the triangles.
  vtkSetMacro(GeneRotation, bool);
  vtkGetMacro(GeneRotation, bool);
  vtkBooleanMacro(GeneRotation, bool);
  ///@}

  ///@{
  /// No effect; here for programs written for vtkDelaunay2D. Off by default.
  vtkSetMacro(RandomPointInsertion, vtkTypeBool);
  vtkGetMacro(RandomPointInsertion, vtkTypeBool);
  vtkBooleanMacro(RandomPointInsertion, vtkTypeBool);
  vtkSetMacro(UseHilbertSorter, vtkTypeBool);
  vtkGetMacro(UseHilbertSorter, vtkTypeBool);
  vtkBooleanMacro(UseHilbertSorter, vtkTypeBool);
  ///@}

  ///@{
  /// Count NP and NR. Off by default, as it takes time; one thread inserts. Never changes
  /// triangles.
  vtkSetMacro(CountWork, bool);
  vtkGetMacro(CountWork, bool);
  vtkBooleanMacro(CountWork, bool);
  ///@}

  ///@{
  /// Stop after so many distinct points of the order of insertion; the triangles are the Delaunay
  /// triangulation of these. From 0; 0, the default: all points. The other points are in no
  /// triangle and counted by NumberOfPointsBeyondLimit. With a limit, one thread inserts.
  vtkSetClampMacro(InsertionLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(InsertionLimit, vtkIdType);
  ///@}

  ///@{
  /// Add the point array "Fate" (vtkIdTypeArray), the status of each point: its own id: a vertex;
  /// another id: a duplicate of that point or merged into it; -1: x or y is not finite; -2: not
  /// inserted (a ghost or hidden point, beyond InsertionLimit, or a duplicate of such a point).
  /// Off by default. GenerateFate is the old name of the setting.
  vtkSetMacro(GeneratePointStatus, bool);
  vtkGetMacro(GeneratePointStatus, bool);
  vtkBooleanMacro(GeneratePointStatus, bool);
  void SetGenerateFate(bool on) { this->SetGeneratePointStatus(on); }
  bool GetGenerateFate() { return this->GetGeneratePointStatus(); }
  void GenerateFateOn() { this->SetGeneratePointStatus(true); }
  void GenerateFateOff() { this->SetGeneratePointStatus(false); }
  ///@}

  ///@{
  /**
   * Add cell arrays; each is off by default.
   * - "ConstraintEdges" (vtkUnsignedCharArray): the edges of a triangle that are constraints, as a
   *   sum: 1 from its first corner to its second, 2 second to third, 4 third to first.
   * - "RegionId" (vtkIdTypeArray): triangles have one number if a path between them crosses no
   *   constraint; from 0.
   * - "Neighbors" (vtkIdTypeArray, three components): the cells beyond the edges of a triangle, in
   *   the order of these bits; -1: none.
   *
   * Lines and vertices have 0, -1 and -1.
   */
  vtkSetMacro(GenerateConstraintEdges, bool);
  vtkGetMacro(GenerateConstraintEdges, bool);
  vtkBooleanMacro(GenerateConstraintEdges, bool);
  vtkSetMacro(GenerateRegionIds, bool);
  vtkGetMacro(GenerateRegionIds, bool);
  vtkBooleanMacro(GenerateRegionIds, bool);
  vtkSetMacro(GenerateNeighbors, bool);
  vtkGetMacro(GenerateNeighbors, bool);
  vtkBooleanMacro(GenerateNeighbors, bool);
  ///@}

  ///@{
  /**
   * Show the insertion; each is off by default.
   * - Rank: add the point array "InsertionRank" (vtkIdTypeArray), the place of each point in the
   *   order of one thread, from 0; -1: duplicate, rejected or skipped.
   * - Curve: a polyline through the inserted points in output port 1.
   * - Boxes: the boxes of the grid that are not divided further in output port 1, about 300 bytes
   *   each. AS_GIVEN has none.
   */
  vtkSetMacro(GenerateInsertionRank, bool);
  vtkGetMacro(GenerateInsertionRank, bool);
  vtkBooleanMacro(GenerateInsertionRank, bool);
  vtkSetMacro(GenerateInsertionCurve, bool);
  vtkGetMacro(GenerateInsertionCurve, bool);
  vtkBooleanMacro(GenerateInsertionCurve, bool);
  vtkSetMacro(GenerateBoxes, bool);
  vtkGetMacro(GenerateBoxes, bool);
  vtkBooleanMacro(GenerateBoxes, bool);
  ///@}

  ///@{
  /**
   * Memory in kibibytes (1024 bytes), from 0. MemoryLimit: the most the filter may take, its output
   * included, its input not; 0, the default: what machine and process have left. A higher estimate
   * is an error before anything is allocated (GenerateBoxes: before anything is inserted).
   * ReuseLimit: the most memory kept for the next execution; 0: none; default 262144, 256 MiB,
   * enough for 2 million points. Working memory comes first: what took more, failed or was aborted
   * gives all back. Within it a triangulation stays whole until the next execution, for who
   * interpolates on its surface. What is left of it keeps the memory of outputs that nobody has any
   * more.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  vtkSetClampMacro(ReuseLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(ReuseLimit, vtkTypeInt64);
  ///@}

  ///@{
  /// How many threads work, from 0 to 1024, the calling one included; it alone reports progress and
  /// is asked for an abort. 0, the default: one for each processor that this process may use, but
  /// no more than vtkSMPTools::Initialize(n) or VTK_SMP_MAX_THREADS say. Changes the time, never
  /// the triangles.
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// Pass on the triangles of the last execution, with the point data and field data of now, where
  /// coordinates, ghost marks, source and settings are the same: from the third execution of a
  /// series on. On by default; off triangulates each time.
  vtkSetMacro(KeepTriangulation, bool);
  vtkGetMacro(KeepTriangulation, bool);
  vtkBooleanMacro(KeepTriangulation, bool);
  ///@}

  ///@{
  /**
   * Of the last execution. Counts: 0 if it was aborted or ended in an error; those of points, with
   * NumberOfMergedPoints, add up to all points, NumberOfAddedPoints included. NP and NR, per
   * inserted point: triangles tested to locate it, the one started from included, and triangles
   * removed for it; -1 without CountWork. Seconds of wall clock: reading and sorting the points,
   * inserting them, writing the triangles; 0 also if triangles were passed on.
   */
  vtkGetMacro(NumberOfPointsInserted, vtkIdType);
  vtkGetMacro(NumberOfDuplicates, vtkIdType);
  vtkGetMacro(NumberOfRejectedPoints, vtkIdType);
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);
  vtkGetMacro(NumberOfPointsBeyondLimit, vtkIdType);
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  vtkGetMacro(NP, double);
  vtkGetMacro(NR, double);
  vtkGetMacro(SortSeconds, double);
  vtkGetMacro(InsertSeconds, double);
  vtkGetMacro(OutputSeconds, double);
  ///@}

  ///@{
  /// Threads that shared the last execution, the calling one included (1: too little to share). How
  /// often this filter has triangulated; executions that passed on triangles do not count. Upper
  /// estimate, in kibibytes, of the memory that the last execution needed beyond its input, or was
  /// refused: what MemoryLimit is compared with. If it had too many crossings: what one more than
  /// fits would need.
  vtkGetMacro(NumberOfThreadsUsed, int);
  vtkGetMacro(NumberOfTriangulations, int);
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  ///@}

protected:
  vtkAdaptiveHilbertAlgorithm();
  ~vtkAdaptiveHilbertAlgorithm() override;

  /// Sets all measures to what they are after an execution that came to nothing.
  virtual void ClearMeasures();

  /// Sets all measures to those of the last execution.
  virtual void TakeMeasures(const vtkAHDReport& report);

  /// What this class is set to, as an execution reads it.
  virtual void ReadSettings(vtkAHDSettings& settings) const;

  // Settings.
  int InsertionOrder = ADAPTIVE_HILBERT;
  int Nmax = 50;
  int ControlPoints = EVERY_LEVEL;
  bool GeneRotation = true;
  vtkTypeBool RandomPointInsertion = 0;
  vtkTypeBool UseHilbertSorter = 0;
  bool CountWork = false;
  vtkIdType InsertionLimit = 0;
  bool GeneratePointStatus = false;
  bool GenerateConstraintEdges = false;
  bool GenerateRegionIds = false;
  bool GenerateNeighbors = false;
  bool GenerateInsertionRank = false;
  bool GenerateInsertionCurve = false;
  bool GenerateBoxes = false;
  vtkTypeInt64 MemoryLimit = 0;
  int NumberOfThreads = 0;
  vtkTypeInt64 ReuseLimit = 262144;
  bool KeepTriangulation = true;

  // Measures of the last execution.
  vtkIdType NumberOfPointsInserted = 0;
  vtkIdType NumberOfDuplicates = 0;
  vtkIdType NumberOfRejectedPoints = 0;
  vtkIdType NumberOfSkippedPoints = 0;
  vtkIdType NumberOfPointsBeyondLimit = 0;
  vtkIdType NumberOfTriangles = 0;
  double NP = -1.0;
  double NR = -1.0;
  double SortSeconds = 0.0;
  double InsertSeconds = 0.0;
  double OutputSeconds = 0.0;
  int NumberOfThreadsUsed = 0;
  vtkTypeInt64 MemoryEstimate = 0;

  int NumberOfTriangulations = 0; // of all executions

private:
  vtkAdaptiveHilbertAlgorithm(const vtkAdaptiveHilbertAlgorithm&) = delete;
  void operator=(const vtkAdaptiveHilbertAlgorithm&) = delete;
};

#endif
