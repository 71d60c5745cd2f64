// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertDelaunay2D
 * @brief   exact 2D Delaunay triangulation of large point sets
 *
 * Triangulates points in x and y (or another plane: ProjectionPlaneMode); z is carried along.
 * Details, and what differs from vtkDelaunay2D: Plugin/Documentation/Reference.md.
 *
 * <b>Output port 0</b>: the points of the input (the same vtkPoints, ids and point data; points
 * that are added follow them, and all are then a copy in double precision) and one triangle per
 * cell. Cells of the input are not passed on. By default the triangles
 * - are the Delaunay triangulation of the distinct points, exactly, for all finite coordinates;
 * - are counterclockwise and cover the convex hull (in other planes than x, y: see Rim); points on
 * its edges are corners of triangles;
 * - number 2v - 2 - h, for v distinct points of which h lie on the boundary of the hull;
 * - are a function of the coordinates and constraints, and so is their order. Shuffling the input
 *   changes only the ids; of the settings of the insertion only InsertionLimit has a say.
 *
 * Ports 1 (order of insertion) and 2 (Voronoi diagram) are empty unless asked for.
 *
 * <b>Point status.</b> Each point is a vertex; a duplicate (x and y of a point of smaller id);
 * merged (within Tolerance of another); rejected (x or y NaN or infinite); skipped (a ghost or
 * hidden point by vtkGhostType); or beyond InsertionLimit. All stay among the output's points and
 * are counted, by Get methods and as field data of their names.
 *
 * <b>Limits and errors.</b> At most 2^28 - 2 points. Too many points or too little memory: one
 * error, all outputs empty, nothing thrown. Aborted (SetAbortExecute): outputs empty, no error.
 * Each warning comes once per execution, with counts. With several MPI ranks: DistributePoints.
 *
 * @sa
 * vtkDelaunay2D vtkAdaptiveHilbertAlgorithm
 */

#ifndef vtkAdaptiveHilbertDelaunay2D_h
#define vtkAdaptiveHilbertDelaunay2D_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkAdaptiveHilbertAlgorithm.h"
#include "vtkSmartPointer.h" // for return values

#include <array>
#include <memory> // for std::unique_ptr

namespace ahd
{
class Workspace;
enum class Status;
}
class vtkAHDContext;
class vtkAHDLeftBehind;
class vtkAHDOutputCache;
class vtkAHDOutputMemory;
class vtkAHDRankBlocks;
class vtkAHDRankUpdates;
class vtkAHDRanks;
struct vtkAHDDataSets;
struct vtkAHDRankResult;
class vtkAbstractTransform;
class vtkMultiProcessController;
class vtkPointSet;

// The values of ProjectionPlaneMode, by the names that vtkDelaunay2D.h gives them.
#ifndef VTK_DELAUNAY_XY_PLANE
#define VTK_DELAUNAY_XY_PLANE 0
#endif
#ifndef VTK_SET_TRANSFORM_PLANE
#define VTK_SET_TRANSFORM_PLANE 1
#endif
#ifndef VTK_BEST_FITTING_PLANE
#define VTK_BEST_FITTING_PLANE 2
#endif

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertDelaunay2D
  : public vtkAdaptiveHilbertAlgorithm
{
public:
  static vtkAdaptiveHilbertDelaunay2D* New();
  vtkTypeMacro(vtkAdaptiveHilbertDelaunay2D, vtkAdaptiveHilbertAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of SourceMode.
  enum SourceModes
  {
    SOURCE_IDS = 0,        ///< the ids in the source's cells are those of the input's points
    SOURCE_COORDINATES = 1 ///< the source's own points are triangulated with those of the input
  };

  /// The values of CrossingMode.
  enum CrossingModes
  {
    LEAVE_OUT = 0, ///< of two segments that cross, the later one is left out
    SPLIT = 1      ///< both are split where they cross, by a point that is added
  };

  /// The values of ClosedLines.
  enum ClosedLineModes
  {
    LINES = 0, ///< they are lines as others are
    LOOPS = 1  ///< they bound what is kept, as polygons do
  };

  /// The values of SourceHeights.
  enum SourceHeightModes
  {
    OWN = 0,         ///< points of the source have their own z and data
    FROM_SURFACE = 1 ///< they are laid on the surface of the input
  };

  /// The values of FillRule.
  enum FillRules
  {
    ORIENTATION = 0, ///< inside is on the left of each loop
    EVEN_ODD = 1     ///< inside is where a path from outside crosses loops an odd number of times
  };

  /// The values of DuplicatePolicy.
  enum DuplicatePolicies
  {
    FIRST = 0,     ///< the smallest id
    LOWEST_Z = 1,  ///< the lowest z
    HIGHEST_Z = 2, ///< the highest z
    MEAN_Z = 3     ///< the smallest id, at the mean of all z
  };

  /// The values of VoronoiClip.
  enum VoronoiClips
  {
    CLIP_TO_HULL = 0,  ///< the convex hull of the points
    CLIP_TO_BOUNDS = 1 ///< the bounding box of the points
  };

  /// The values of Rim.
  enum Rims
  {
    AUTOMATIC = 0,   ///< the convex hull in x, y; trimmed in any other plane
    CONVEX_HULL = 1, ///< the triangles cover the convex hull
    TRIMMED = 2      ///< less the flat ones along it
  };

  ///@{
  /// The constraints, input port 1, a vtkPolyData; none by default. Lines and polylines become
  /// edges of the triangulation, polygons edges and loops that bound what is kept. Points on a
  /// segment divide it; segments may overlap. A segment that crosses an earlier one (see
  /// CrossingMode) or has an end that is no vertex is left out, and its loop bounds nothing: both
  /// are counted. The field data array "Crossings" names the first 1000 pairs of cells that cross,
  /// later one first. Of a composite data set (SetSourceConnection, SetInputData(1, ...)) all
  /// vtkPolyData are appended to one source, cells by kind; GetSource() is null then.
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSource();
  ///@}

  ///@{
  /// What the source's cells refer to. SOURCE_IDS, the default and what vtkDelaunay2D does: the
  /// points of the input, by their ids. SOURCE_COORDINATES: the source's own points, all of which
  /// are added behind those of the input.
  vtkSetClampMacro(SourceMode, int, SOURCE_IDS, SOURCE_COORDINATES);
  vtkGetMacro(SourceMode, int);
  void SetSourceModeToIds() { this->SetSourceMode(SOURCE_IDS); }
  void SetSourceModeToCoordinates() { this->SetSourceMode(SOURCE_COORDINATES); }
  ///@}

  ///@{
  /// What is done where constraints cross. LEAVE_OUT, the default: the later of the two segments is
  /// no constraint (lines come before polygons, then the order of the cells counts). SPLIT: a point
  /// is added where they cross, with the mean of what linear interpolation along either gives.
  vtkSetClampMacro(CrossingMode, int, LEAVE_OUT, SPLIT);
  vtkGetMacro(CrossingMode, int);
  void SetCrossingModeToLeaveOut() { this->SetCrossingMode(LEAVE_OUT); }
  void SetCrossingModeToSplit() { this->SetCrossingMode(SPLIT); }
  ///@}

  ///@{
  /// What lines are that end where they begin: whose ends are one point, or have the same x and y
  /// in the plane of the triangulation. LINES, the default. LOOPS: the same as polygons, whose
  /// outlines GIS readers give as lines; in the order of the constraints they come after the
  /// others.
  vtkSetClampMacro(ClosedLines, int, LINES, LOOPS);
  vtkGetMacro(ClosedLines, int);
  void SetClosedLinesToLines() { this->SetClosedLines(LINES); }
  void SetClosedLinesToLoops() { this->SetClosedLines(LOOPS); }
  ///@}

  ///@{
  /// Which z and point data the points of the source have with SOURCE_COORDINATES. OWN, the
  /// default: their own; lines in two dimensions so pull the surface down to z = 0. FROM_SURFACE:
  /// what linear interpolation gives in the triangulation of the input alone; outside of it their
  /// own, with a warning. Triangulates the input twice.
  vtkSetClampMacro(SourceHeights, int, OWN, FROM_SURFACE);
  vtkGetMacro(SourceHeights, int);
  void SetSourceHeightsToOwn() { this->SetSourceHeights(OWN); }
  void SetSourceHeightsToFromSurface() { this->SetSourceHeights(FROM_SURFACE); }
  ///@}

  ///@{
  /// What loops keep; without loops, all. ORIENTATION, the default and vtkDelaunay2D's rule: what
  /// is on the left of every loop edge that bounds it, and what no loop bounds. EVEN_ODD: what lies
  /// inside an odd number of loops, whichever way they run.
  vtkSetClampMacro(FillRule, int, ORIENTATION, EVEN_ODD);
  vtkGetMacro(FillRule, int);
  void SetFillRuleToOrientation() { this->SetFillRule(ORIENTATION); }
  void SetFillRuleToEvenOdd() { this->SetFillRule(EVEN_ODD); }
  ///@}

  ///@{
  /// A length in space, in the unit of the points, from 0; 0, the default: all triangles. Else the
  /// triangles with a circumradius of at most Alpha, as lines the edges of none of these that are
  /// at most twice as long, as vertices the points in neither; AlphaTris, AlphaLines and
  /// AlphaVerts, on by default, put each kind out. As in vtkDelaunay2D; exceptions: Reference.md.
  virtual void SetAlpha(double alpha);
  virtual double GetAlphaMinValue() { return 0.0; }
  virtual double GetAlphaMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Alpha, double);
  vtkSetMacro(AlphaTris, vtkTypeBool);
  vtkGetMacro(AlphaTris, vtkTypeBool);
  vtkBooleanMacro(AlphaTris, vtkTypeBool);
  vtkSetMacro(AlphaLines, vtkTypeBool);
  vtkGetMacro(AlphaLines, vtkTypeBool);
  vtkBooleanMacro(AlphaLines, vtkTypeBool);
  vtkSetMacro(AlphaVerts, vtkTypeBool);
  vtkGetMacro(AlphaVerts, vtkTypeBool);
  vtkBooleanMacro(AlphaVerts, vtkTypeBool);
  ///@}

  ///@{
  /// Triangles with an edge longer than this, and lines of Alpha that are, are not put out: a
  /// length in the plane of the triangulation, from 0; 0, the default: no limit.
  virtual void SetMaximumEdgeLength(double length);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * The plane in which the points are triangulated; the output has them where they were.
   * - VTK_DELAUNAY_XY_PLANE (0), the default: x and y, after Transform if one is set.
   * - VTK_SET_TRANSFORM_PLANE (1): x and y after Transform; without one a warning, and x and y.
   * - VTK_BEST_FITTING_PLANE (2): see ComputeBestFittingPlane; Transform is not used.
   *
   * After a transform or in a fitted plane, exactness is for the coordinates there, rounded to
   * double precision, and duplicates are judged there.
   */
  vtkSetClampMacro(ProjectionPlaneMode, int, VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE);
  vtkGetMacro(ProjectionPlaneMode, int);
  ///@}

  ///@{
  /// How far the surface reaches where no loop bounds it. CONVEX_HULL: to the convex hull in the
  /// plane. TRIMMED: triangles with an angle above 153 degrees (exactly: 180 less the arc tangent
  /// of 1/2) go if their longest edge lies on the rim, then those behind; in a fitted plane these
  /// are slivers along a rim that is straight in space, and stand as walls. AUTOMATIC, the default:
  /// CONVEX_HULL in x, y, and in the fitted plane of points that all have one z, x or y; else
  /// TRIMMED. Constraints stay edges. Nothing goes with Alpha, MaximumEdgeLength or a bounding
  /// triangulation. A warning where a point is left without a triangle, or a tenth of the area
  /// goes.
  vtkSetClampMacro(Rim, int, AUTOMATIC, TRIMMED);
  vtkGetMacro(Rim, int);
  void SetRimToAutomatic() { this->SetRim(AUTOMATIC); }
  void SetRimToConvexHull() { this->SetRim(CONVEX_HULL); }
  void SetRimToTrimmed() { this->SetRim(TRIMMED); }
  ///@}

  ///@{
  /// What the points are transformed by before they are triangulated, linear or not; null, the
  /// default: nothing. Its changes are noticed; it is never changed, and stays set.
  virtual void SetTransform(vtkAbstractTransform* transform);
  vtkGetObjectMacro(Transform, vtkAbstractTransform);
  ///@}

  /// The plane with the least sum of squared distances of the finite points, as a vtkTransform that
  /// turns and shifts it to z = 0; up is where the normal's largest component is positive. Points
  /// that all have one z, x or y keep the two other coordinates, to the bit. The caller owns what
  /// is returned; null without input or memory.
  static VTK_NEWINSTANCE vtkAbstractTransform* ComputeBestFittingPlane(vtkPointSet* input);

  ///@{
  /// Merge points nearer to each other than this fraction, from 0 to 1, of the diagonal of the
  /// bounding box of all points in the plane; default 0. Points are taken in lexicographic order of
  /// x, y; one that has vertices within that distance is merged into the nearest. Constraints
  /// follow. vtkDelaunay2D's default is 1e-5, of the diagonal in space.
  virtual void SetTolerance(double tolerance);
  virtual double GetToleranceMinValue() { return 0.0; }
  virtual double GetToleranceMaxValue() { return 1.0; }
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Which of several points with the same place in the plane is the vertex: FIRST, the default,
  /// the one of smallest id; that of LOWEST_Z or HIGHEST_Z (finite if there is one); MEAN_Z, the
  /// one of smallest id, its z in a copy of the points the mean of all that are finite. Merged
  /// points have no say. Changes ids and z, never the shape in the plane.
  vtkSetClampMacro(DuplicatePolicy, int, FIRST, MEAN_Z);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToFirst() { this->SetDuplicatePolicy(FIRST); }
  void SetDuplicatePolicyToLowestZ() { this->SetDuplicatePolicy(LOWEST_Z); }
  void SetDuplicatePolicyToHighestZ() { this->SetDuplicatePolicy(HIGHEST_Z); }
  void SetDuplicatePolicyToMeanZ() { this->SetDuplicatePolicy(MEAN_Z); }
  ///@}

  ///@{
  /// BoundingTriangulation adds vtkDelaunay2D's eight points: on a circle about the centre of the
  /// bounding box, its radius Offset times the box's diagonal in space. Off by default; only in the
  /// plane x, y, elsewhere a warning. Offset: from 0.75, default 1.
  virtual void SetOffset(double offset);
  virtual double GetOffsetMinValue() { return 0.75; }
  virtual double GetOffsetMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Offset, double);
  vtkSetMacro(BoundingTriangulation, vtkTypeBool);
  vtkGetMacro(BoundingTriangulation, vtkTypeBool);
  vtkBooleanMacro(BoundingTriangulation, vtkTypeBool);
  ///@}

  ///@{
  /// Triangulate the points of all blocks of a composite data set together, numbered block after
  /// block, with the point arrays that all have. Off by default: each block by itself. Costs a copy
  /// of the points and their data.
  virtual void SetMergeBlocks(bool merge);
  vtkGetMacro(MergeBlocks, bool);
  vtkBooleanMacro(MergeBlocks, bool);
  ///@}

  ///@{
  /// Put the Voronoi diagram of the vertices into output port 2: for each a convex counterclockwise
  /// polygon, with its point data as cell data and its id as "OriginalPointIds" (vtkIdTypeArray).
  /// Clipped at the convex hull (CLIP_TO_HULL, the default) or the bounding box of the vertices in
  /// the plane. Corners are those of the exact polygons, rounded once to double precision; those
  /// that differ by no more than 4 units in the last place may be one. Constraints have no say. Off
  /// by default.
  vtkSetMacro(GenerateVoronoi, bool);
  vtkGetMacro(GenerateVoronoi, bool);
  vtkBooleanMacro(GenerateVoronoi, bool);
  vtkSetClampMacro(VoronoiClip, int, CLIP_TO_HULL, CLIP_TO_BOUNDS);
  vtkGetMacro(VoronoiClip, int);
  void SetVoronoiClipToHull() { this->SetVoronoiClip(CLIP_TO_HULL); }
  void SetVoronoiClipToBounds() { this->SetVoronoiClip(CLIP_TO_BOUNDS); }
  ///@}

  ///@{
  /**
   * Triangulate the points of all ranks of Controller together: exactly the triangles of one rank
   * that has all inputs and sources, appended in the order of the ranks. Off by default: each rank
   * its own points, with a warning where there are several. No effect with one rank.
   *
   * All ranks have to update alike, with the same settings: where one has to execute, all do. Each
   * puts out the triangles that it owns, by place; with its points, which move to their owners with
   * those point data arrays that all ranks have; and behind these the points of others that are
   * corners, with vtkGhostType DUPLICATEPOINT. Layers of ghost cells, marked as well, are put out
   * where the filters behind ask for them. The global ids "GlobalPointIds" number the points as
   * appended, those of sources last; "GlobalCellIds" the triangles. Counts are of all ranks. Ids in
   * the source's cells are those of the rank's own points. Sources that are the same on all ranks
   * count once where their points are added. What fails on one rank ends in one error on each.
   * Settings that ranks have no method for have one rank triangulate all points and put out
   * everything, if there is room on it; a warning names the first: Reference.md lists them. With
   * MergeBlocks off, block k of all ranks is triangulated by itself, for each k.
   */
  virtual void SetDistributePoints(bool distribute);
  vtkGetMacro(DistributePoints, bool);
  vtkBooleanMacro(DistributePoints, bool);
  ///@}

  ///@{
  /// The ranks of DistributePoints; by default those of the global controller when the filter is
  /// made. Null: this process alone. Always null where VTK was built without ParallelCore.
  virtual void SetController(vtkMultiProcessController* controller);
  virtual vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /// Of the last execution; 0 if it was aborted or ended in an error. Points merged by Tolerance;
  /// points added; distinct edges that are constraints, those of dropped triangles included;
  /// segments left out as they cross others (SPLIT: points added); segments that SPLIT led through
  /// a vertex that is not exactly on them; all segments left out; loops that bound nothing;
  /// triangles that Rim took away. Wall-clock seconds for the constraints.
  vtkGetMacro(NumberOfMergedPoints, vtkIdType);
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  vtkGetMacro(NumberOfConstraintEdges, vtkIdType);
  vtkGetMacro(NumberOfCrossings, vtkIdType);
  vtkGetMacro(NumberOfBentConstraints, vtkIdType);
  vtkGetMacro(NumberOfConstraintsLeftOut, vtkIdType);
  vtkGetMacro(NumberOfUnfilledLoops, vtkIdType);
  vtkGetMacro(NumberOfTrimmedTriangles, vtkIdType);
  vtkGetMacro(ConstrainSeconds, double);
  ///@}

  /// When the filter or its Transform was changed last.
  vtkMTimeType GetMTime() override;

  /// Across ranks, the pipeline of each is modified whenever that of one is: so all execute, or
  /// none. Collective there.
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int requestFromOutputPort, vtkMTimeType* mtime) override;

  /// Across ranks, the outputs have blocks where these are triangulated each by itself.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkAdaptiveHilbertDelaunay2D();
  ~vtkAdaptiveHilbertDelaunay2D() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ClearMeasures() override;
  void TakeMeasures(const vtkAHDReport& report) override;
  void ReadSettings(vtkAHDSettings& settings) const override;

  // Settings.
  int SourceMode = SOURCE_IDS;
  int CrossingMode = LEAVE_OUT;
  int ClosedLines = LINES;
  int SourceHeights = OWN;
  int FillRule = ORIENTATION;
  double Alpha = 0.0;
  vtkTypeBool AlphaTris = 1;
  vtkTypeBool AlphaLines = 1;
  vtkTypeBool AlphaVerts = 1;
  double MaximumEdgeLength = 0.0;
  int ProjectionPlaneMode = VTK_DELAUNAY_XY_PLANE;
  int Rim = AUTOMATIC;
  vtkAbstractTransform* Transform = nullptr;
  double Tolerance = 0.0;
  int DuplicatePolicy = FIRST;
  double Offset = 1.0;
  vtkTypeBool BoundingTriangulation = 0;
  bool MergeBlocks = false;
  bool GenerateVoronoi = false;
  int VoronoiClip = CLIP_TO_HULL;
  bool DistributePoints = false;
  vtkMultiProcessController* Controller = nullptr;

  // Measures of the last execution.
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfConstraintEdges = 0;
  vtkIdType NumberOfCrossings = 0;
  vtkIdType NumberOfBentConstraints = 0;
  vtkIdType NumberOfConstraintsLeftOut = 0;
  vtkIdType NumberOfUnfilledLoops = 0;
  vtkIdType NumberOfTrimmedTriangles = 0;
  double ConstrainSeconds = 0.0;

private:
  friend class vtkAdaptiveHilbertInterpolation2D; // reads the settings
  vtkAdaptiveHilbertDelaunay2D(const vtkAdaptiveHilbertDelaunay2D&) = delete;
  void operator=(const vtkAdaptiveHilbertDelaunay2D&) = delete;

  using RankSurfaces = std::array<vtkSmartPointer<vtkPolyData>, 3>; // the outputs, held

  void Execute(vtkDataObject* input, vtkDataObject* source, vtkAHDDataSets& data,
    const vtkAHDContext& context);
  bool IsDistributed() const;
  bool IsEmptyPiece(vtkInformationVector* outputs) const;
  void KeepFirstPieces(vtkInformationVector* outputs) const;
  void DescribePortsAnew();
  void MakeOutputs(vtkDataObject* input, vtkInformationVector* outputs) const;
  void ExecuteOnRanks(vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputs);
  void ExecuteBlocksOnRanks(vtkAHDRanks& ranks, const vtkAHDRankBlocks& blocks,
    vtkDataObject* source, int levels, vtkInformationVector* outputs);
  void SayAbort(ahd::Status status);
  bool WarnOfInput(vtkDataObject* input);
  void ExecuteOneOnRanks(vtkAHDRanks& ranks, vtkDataObject* input, vtkDataObject* source,
    int levels, const RankSurfaces& surfaces);
  void WarnOnRanks(const vtkAHDSettings& settings, const vtkAHDRankResult& result);
  void EndOnRanks(ahd::Status status, vtkAHDRankResult& result, const RankSurfaces& surfaces);
  void Triangulate(const vtkAHDDataSets& data, const vtkAHDContext& context);
  bool PassOnCached(const vtkAHDDataSets& data, const vtkAHDContext& context);
  void EndWithoutMemory(const vtkAHDDataSets& data);
  void AddCounts(vtkPolyData* surface) const;
  void WarnAboutRanks();

  const std::unique_ptr<ahd::Workspace> Workspace;        // kept for the next execution
  const std::unique_ptr<vtkAHDLeftBehind> Left;           // the last execution's triangulation
  const std::unique_ptr<vtkAHDOutputCache> Cache;         // the last execution's outputs
  const std::unique_ptr<vtkAHDOutputMemory> OutputMemory; // kept for the next execution
  const std::unique_ptr<vtkAHDRankUpdates> Updates;       // agreed on by ranks
  bool WarnedAboutRanks = false;
  bool WarnedAboutOneRank = false;
};

#endif
