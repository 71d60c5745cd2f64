// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertAlgorithm
 * @brief   a filter that inserts points into a Delaunay triangulation: how it goes about it
 *
 * The part of vtkAdaptiveHilbertDelaunay2D that says how the points are inserted and how the work
 * is measured: the order of insertion, its limit and what is shown of it, arrays that tell of
 * points and triangles, threads and memory. None of it but InsertionLimit changes the triangles.
 * What is triangulated, and what comes out, is said there.
 *
 * <b>Speed and memory.</b> Points are inserted one after the other, in an order in which neighbours
 * follow each other: along a Hilbert curve whose boxes are divided until each holds at most Nmax
 * points (by default it goes on inside them, down to the single point), the method of T. Su, W.
 * Wang, Z. Lv, W. Wu, X. Li, <em>Rapid Delaunay triangulation for randomly distributed point cloud
 * data using adaptive Hilbert curve</em>, Computers & Graphics 54 (2016) 65-74,
 * doi:10.1016/j.cag.2015.07.019. The time then grows about linearly with the number of points,
 * however unevenly they are distributed. Memory is linear too and estimated beforehand: what cannot
 * be had is refused with an error before it is allocated (see MemoryLimit). At most 2^28 - 2 points
 * are taken. Float and double points are read where they are, and widening float to double is
 * exact; points of another type are converted to double first, which rounds whole numbers beyond
 * 2^53. Projecting and adding points takes a copy of the places in the plane, 25 bytes per point.
 *
 * <b>Threads.</b> Several filters may execute at once, each in a pipeline and a thread of its own:
 * give each a shallow copy of the input and of the source, since VTK's data objects are not for two
 * threads; the arrays may be shared. Nobody may change them meanwhile; changes between executions
 * are seen after Modified() of what was changed. To abort from another thread, set a flag of your
 * own (std::atomic) and let an observer of ProgressEvent call SetAbortExecute when it sees it: VTK
 * keeps that in a plain number, which only the thread that executes may write.
 *
 * <b>To see how it works.</b> With InsertionLimit the filter stops after so many points and puts
 * out the triangulation as it was then; animated, it shows the surface grow. GenerateInsertionRank
 * adds the place of each point in the order of insertion to the surface. The order itself is output
 * port 1, a vtkPolyData, which is empty unless GenerateInsertionCurve or GenerateBoxes is on:
 * - its points are the inserted points, in the order of their insertion, then four corners for each
 *   box. They are of double precision; a corner's z is the lowest finite z of all points that are
 *   neither rejected, skipped nor merged (0 if there is none), so that the boxes lie below the
 *   surface. In another plane than x, y, all are where they are in that plane;
 * - its cells are, with GenerateInsertionCurve, a polyline through the inserted points (if there
 *   are two or more), then, with GenerateBoxes, a counterclockwise quadrangle for each box of the
 *   grid that is not divided further, empty boxes included, in the order in which they are visited;
 * - its point data are "InsertionRank", the place in the order from 0, and "OriginalPointIds", the
 *   id in output port 0 (both vtkIdTypeArray and -1 at corners);
 * - its cell data are "Level" (vtkIntArray), the number of divisions that made the box, 0 for the
 *   box of all points, and "Count" (vtkIdTypeArray), the distinct points in the box, control points
 *   and those beyond the limit included; for the curve -1 and the points it passes. A point on the
 *   border of two boxes belongs to the one of larger x or y.
 *
 * So the Counts of all boxes add up to the points inserted and those beyond the limit. The sides of
 * the boxes are rounded, as they are there to be drawn. No box is more than twice as long as wide,
 * so the boxes of points in a narrow band reach beyond the band.
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
  /**
   * In which order the points are inserted: one of InsertionOrders. Changes the time, never the
   * triangles. The default, ADAPTIVE_HILBERT, is the fastest whatever the distribution; the others
   * are there to be compared with it (Su et al. 2016, tables 2 to 6). AS_GIVEN is for points that
   * follow each other along a curve already: each is looked for from the one before, so points in
   * random order take very long.
   */
  vtkSetClampMacro(InsertionOrder, int, ADAPTIVE_HILBERT, AS_GIVEN);
  vtkGetMacro(InsertionOrder, int);
  void SetInsertionOrderToAdaptiveHilbert() { this->SetInsertionOrder(ADAPTIVE_HILBERT); }
  void SetInsertionOrderToMultiGrid() { this->SetInsertionOrder(MULTI_GRID); }
  void SetInsertionOrderToRegularGrid() { this->SetInsertionOrder(REGULAR_GRID); }
  void SetInsertionOrderToAsGiven() { this->SetInsertionOrder(AS_GIVEN); }
  ///@}

  ///@{
  /**
   * A box of the grid that holds more than this many points is divided further; used by
   * ADAPTIVE_HILBERT and MULTI_GRID. A number of points, from 1 up; default 50, as in the
   * paper, which finds 50 to 200 more efficient than other values (section 4). Changes the time,
   * never the triangles. With the defaults of ControlPoints and GeneRotation not even that: the
   * curve then goes on inside the boxes, down to the single point, and where their borders lie
   * makes no difference but to the boxes that GenerateBoxes shows.
   */
  vtkSetClampMacro(Nmax, int, 1, VTK_INT_MAX);
  vtkGetMacro(Nmax, int);
  ///@}

  ///@{
  /**
   * Which points are inserted before all others, so that the first triangles are neither long nor
   * thin: one of ControlPointRounds. SINGLE_LEVEL is the paper's (section 3.3). The default,
   * EVERY_LEVEL, goes further: several rounds, each some times larger than the one before, in the
   * manner of a biased randomized insertion order (N. Amenta, S. Choi, G. Rote, 2003). Used by
   * ADAPTIVE_HILBERT and MULTI_GRID. Changes the time, never the triangles.
   */
  vtkSetClampMacro(ControlPoints, int, NO_CONTROL_POINTS, EVERY_LEVEL);
  vtkGetMacro(ControlPoints, int);
  void SetControlPointsToNone() { this->SetControlPoints(NO_CONTROL_POINTS); }
  void SetControlPointsToSingleLevel() { this->SetControlPoints(SINGLE_LEVEL); }
  void SetControlPointsToEveryLevel() { this->SetControlPoints(EVERY_LEVEL); }
  ///@}

  ///@{
  /**
   * Turn the curve inside each divided box so that it enters and leaves where the neighbouring
   * boxes are (the paper's "gene", table 1). Used by ADAPTIVE_HILBERT. On by default; off shows
   * what the jumps of an unturned curve cost. Changes the time, never the triangles.
   */
  vtkSetMacro(GeneRotation, bool);
  vtkGetMacro(GeneRotation, bool);
  vtkBooleanMacro(GeneRotation, bool);
  ///@}

  ///@{
  /**
   * No effect: they are here so that programs written for vtkDelaunay2D run as they are. The result
   * does not depend on the order of insertion, which InsertionOrder sets. Off by default.
   */
  vtkSetMacro(RandomPointInsertion, vtkTypeBool);
  vtkGetMacro(RandomPointInsertion, vtkTypeBool);
  vtkBooleanMacro(RandomPointInsertion, vtkTypeBool);
  vtkSetMacro(UseHilbertSorter, vtkTypeBool);
  vtkGetMacro(UseHilbertSorter, vtkTypeBool);
  vtkBooleanMacro(UseHilbertSorter, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Count the work of the insertion: the measures NP and NR. Off by default, since counting slows
   * the insertion a little. Never changes the triangles.
   */
  vtkSetMacro(CountWork, bool);
  vtkGetMacro(CountWork, bool);
  vtkBooleanMacro(CountWork, bool);
  ///@}

  ///@{
  /**
   * Stop after so many points of the order of insertion: the triangles are the Delaunay
   * triangulation of these points, as it was when the last of them was inserted. A number of
   * distinct points (duplicates do not count); 0, the default, and all numbers that are large
   * enough stand for all points. Negative numbers stand for 0. Which points come first depends on
   * InsertionOrder, Nmax, ControlPoints and GeneRotation; GenerateInsertionRank shows it. The other
   * points stay in the output, in no triangle, and are counted by NumberOfPointsBeyondLimit. With a
   * limit the points are inserted by one thread. The time to sort them is as without.
   */
  vtkSetClampMacro(InsertionLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(InsertionLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Add the point array "Fate" (vtkIdTypeArray), which says what became of each point: its own id
   * if it is a vertex, the id of the point that stands for it if it is a duplicate or merged
   * into that, -1 if it was rejected because its x or y is not finite, -2 if it was not inserted,
   * because it is marked as a ghost or hidden point, lies beyond InsertionLimit, or is a duplicate
   * of a point beyond it or merged into one. Off by default; costs 16 bytes per point while the
   * filter runs.
   */
  vtkSetMacro(GenerateFate, bool);
  vtkGetMacro(GenerateFate, bool);
  vtkBooleanMacro(GenerateFate, bool);
  ///@}

  ///@{
  /**
   * Add the cell array "ConstraintEdges" (vtkUnsignedCharArray), which says which edges of a
   * triangle are constraints: 1 for the edge from its first corner to its second, 2 from the second
   * to the third, 4 from the third to the first, added up. 0 for lines and vertices. Off by
   * default; costs 1 byte per triangle.
   */
  vtkSetMacro(GenerateConstraintEdges, bool);
  vtkGetMacro(GenerateConstraintEdges, bool);
  vtkBooleanMacro(GenerateConstraintEdges, bool);
  ///@}

  ///@{
  /**
   * Add the cell array "RegionId" (vtkIdTypeArray): triangles have the same number if a way from
   * one to the other crosses no constraint, lines included. From 0, in the order in which the
   * regions appear among the triangles put out; -1 for lines and vertices. Off by default; costs 24
   * bytes per triangle while the filter runs.
   */
  vtkSetMacro(GenerateRegionIds, bool);
  vtkGetMacro(GenerateRegionIds, bool);
  vtkBooleanMacro(GenerateRegionIds, bool);
  ///@}

  ///@{
  /**
   * Add the cell array "Neighbors" (vtkIdTypeArray, three components): the ids of the cells beyond
   * the edges of a triangle, in the order of the bits of "ConstraintEdges"; -1 where there is none,
   * and for lines and vertices. Off by default; costs 48 bytes per triangle while the filter runs.
   */
  vtkSetMacro(GenerateNeighbors, bool);
  vtkGetMacro(GenerateNeighbors, bool);
  vtkBooleanMacro(GenerateNeighbors, bool);
  ///@}

  ///@{
  /**
   * Add the point array "InsertionRank" (vtkIdTypeArray): the place of each point in the order of
   * insertion, from 0, those beyond InsertionLimit included; -1 for points that are in no order:
   * duplicates, rejected and skipped ones. The order is that of one thread; several threads insert
   * the points of one round of the default order side by side. Off by default; costs 4 bytes per
   * point, and 16 more while the filter runs.
   */
  vtkSetMacro(GenerateInsertionRank, bool);
  vtkGetMacro(GenerateInsertionRank, bool);
  vtkBooleanMacro(GenerateInsertionRank, bool);
  ///@}

  ///@{
  /**
   * Put a polyline through the inserted points, in the order of their insertion, into output port 1
   * (see the description of the class). Off by default.
   */
  vtkSetMacro(GenerateInsertionCurve, bool);
  vtkGetMacro(GenerateInsertionCurve, bool);
  vtkBooleanMacro(GenerateInsertionCurve, bool);
  ///@}

  ///@{
  /**
   * Put the boxes of the grid that decides the order into output port 1 (see the description of the
   * class): those that are not divided further, in the order in which they are visited, each with
   * its level of division and the points in it. They depend on InsertionOrder, Nmax and, as they
   * follow the curve, on GeneRotation; SINGLE_LEVEL's control points do not count where it is
   * decided whether a box is divided. AS_GIVEN has no boxes. With the default settings the order
   * is made without a grid, as the curve goes on inside the boxes down to the single point; the
   * boxes are then those along which it runs. Off by default; costs about 300 bytes per box. Boxes
   * of few points and a small Nmax may be many more than points. How many there are shows only when
   * the points are sorted: if there is no memory for them, the execution is refused then.
   */
  vtkSetMacro(GenerateBoxes, bool);
  vtkGetMacro(GenerateBoxes, bool);
  vtkBooleanMacro(GenerateBoxes, bool);
  ///@}

  ///@{
  /**
   * The most memory the filter may take, in kibibytes (1024 bytes), its output included, its input
   * not. An execution whose estimate is higher is refused with an error before anything is
   * allocated (with GenerateBoxes, before anything is inserted). 0, the default, stands for what
   * the machine and the limits of the process leave.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * How many threads work. Changes the time, never the triangles.
   *
   * 0, the default: one for each processor that this process may run on (on Linux, its CPU affinity
   * is respected), but no more than vtkSMPTools was told to take, by vtkSMPTools::Initialize(n) or,
   * without it, by the environment variable VTK_SMP_MAX_THREADS. This holds as well where the
   * backend of vtkSMPTools is Sequential, as it is by default in Debian's ParaView: VTK's own
   * filters then use one thread, this one uses all. Where this filter runs inside a loop of
   * vtkSMPTools and vtkSMPTools::SetNestedParallelism(false) was called, 0 stands for 1.
   *
   * 1 to 1024: exactly so many. Larger numbers stand for 1024, negative ones for 0.
   *
   * One of them is the thread that calls Update(). It alone reports progress, and it alone is asked
   * for an abort. The others belong to vtkSMPTools' backend, which may have fewer than are wished
   * for; where that is Sequential, or is at work already, the filter starts threads of its own for
   * the time of one execution. Threads that the system refuses are done without.
   *
   * Points are inserted by one thread if InsertionOrder is not ADAPTIVE_HILBERT, if other settings
   * of the insertion differ from the default, or if CountWork or InsertionLimit is on: there is
   * then an order to be kept to. So are few points, as it would not pay. The other steps use all
   * threads.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The most working memory, in kibibytes (1024 bytes), that the filter keeps for its next
   * execution, which then does not ask the system for it anew (about a tenth of the time of 10^6
   * points). After an execution that took more, all of it is given back; 0 keeps none, ever. The
   * default, 262144 (256 MiB), is enough for 3 million points. The working memory of an execution
   * that failed or was aborted is given back always. The input is never kept.
   */
  vtkSetClampMacro(ReuseLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(ReuseLimit, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Triangulate again only what is new: where the coordinates of the points and their ghost marks
   * (vtkGhostType), the source and all settings are those of the last execution, as in a series of
   * time steps of which only the data change, its triangles and everything made with them are
   * passed on, with the point data and field data of now. The same is what has the same numbers, in
   * whichever object, if it comes through a connection: setting a data object (SetInputData,
   * SetSourceData) counts as a change of settings. Warnings are not said again. On by default; off
   * triangulates at each execution.
   *
   * An execution is known again by a fingerprint of 128 bits, which takes one more look at all
   * coordinates. So as not to burden a single execution with it, it is taken only where settings
   * and number of points are those of the execution before: a series is triangulated twice, then
   * passed on. From the second on the filter holds on to the arrays of its last output, until it
   * triangulates again, but not to its input. Who changes the cells of an output in place changes
   * what is passed on: copy them before. There is nothing to pass on after an execution that was
   * aborted or ended in an error or that added points, and where coordinates do not lie in memory
   * point by point. Of the blocks of a composite data set that are triangulated one by one, only
   * the last one is remembered.
   */
  vtkSetMacro(KeepTriangulation, bool);
  vtkGetMacro(KeepTriangulation, bool);
  vtkBooleanMacro(KeepTriangulation, bool);
  ///@}

  ///@{
  /**
   * Counts of the last execution. Inserted points, duplicates, rejected points, skipped points,
   * those beyond the limit and merged ones (NumberOfMergedPoints) add up to the number of all
   * points, the added ones (NumberOfAddedPoints) included. Triangles: those that are put out. All 0
   * if the execution was aborted or ended in an error.
   */
  vtkGetMacro(NumberOfPointsInserted, vtkIdType);
  vtkGetMacro(NumberOfDuplicates, vtkIdType);
  vtkGetMacro(NumberOfRejectedPoints, vtkIdType);
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);
  vtkGetMacro(NumberOfPointsBeyondLimit, vtkIdType);
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /**
   * The paper's measures of the last execution, per inserted point. NP: triangles tested to locate
   * the point, the one started from included. NR: triangles removed to make room for it. A good
   * order makes both small: time of locating goes with NP, time of updating with NR. -1 if they
   * were not counted (see CountWork).
   */
  vtkGetMacro(NP, double);
  vtkGetMacro(NR, double);
  ///@}

  ///@{
  /**
   * Wall-clock seconds of the last execution: reading and sorting the points, inserting them,
   * putting out the triangles. 0 if the execution was aborted or ended in an error, or passed on
   * the triangles of the one before.
   */
  vtkGetMacro(SortSeconds, double);
  vtkGetMacro(InsertSeconds, double);
  vtkGetMacro(OutputSeconds, double);
  ///@}

  /**
   * Threads that shared the work of the last execution, the calling one included: 1 if there was
   * too little to share, else what NumberOfThreads asked for, as far as threads could be started.
   */
  vtkGetMacro(NumberOfThreadsUsed, int);

  /**
   * How often this filter has begun to triangulate since it was made: executions that passed on the
   * triangles of the one before (see KeepTriangulation) do not count.
   */
  vtkGetMacro(NumberOfTriangulations, int);

  /**
   * Upper estimate, in kibibytes, of the memory that the last execution needed, or was refused,
   * beyond its input: what MemoryLimit is compared with.
   */
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);

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
  bool GenerateFate = false;
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
