// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
/**
 * @class   vtkAdaptiveHilbertAlgorithm
 * @brief   settings and measures of vtkAdaptiveHilbertDelaunay2D
 *
 * The superclass of vtkAdaptiveHilbertDelaunay2D: its settings that are numbers, and what was
 * measured. In what is said here, values of settings have the names of ParaView's panel.
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

#include <limits> // for defaults that are NaN
#include <string> // for settings that are names

class vtkFieldData;
struct vtkAHDSettingsOfRanks;

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

class ADAPTIVEHILBERTDELAUNAYFILTERS_EXPORT vtkAdaptiveHilbertAlgorithm
  : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkAdaptiveHilbertAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values of SourceMode.
  enum SourceModeValues
  {
    /// the ids in the source's cells are those of the input's points
    SOURCE_IDS = 0,
    /// the source's own points are triangulated with those of the input
    SOURCE_COORDINATES = 1
  };

  /// The values of SourceHeights.
  enum SourceHeightsValues
  {
    /// points of the source have their own z and data
    OWN = 0,
    /// they are laid on the surface of the input
    FROM_SURFACE = 1
  };

  /// The values of ClosedLines.
  enum ClosedLinesValues
  {
    /// they are lines as others are
    LINES = 0,
    /// they bound what is kept, as polygons do
    LOOPS = 1
  };

  /// The values of FillRule.
  enum FillRuleValues
  {
    /// inside is on the left of each loop
    ORIENTATION = 0,
    /// inside is where a path from outside crosses loops an odd number of times
    EVEN_ODD = 1
  };

  /// The values of CrossingMode.
  enum CrossingModeValues
  {
    /// of two segments that cross, the later one is left out
    LEAVE_OUT = 0,
    /// both are split where they cross, by a point that is added
    SPLIT = 1
  };

  /// The values of Rim.
  enum RimValues
  {
    /// the convex hull in a plane of coordinates, else trimmed
    AUTOMATIC = 0,
    /// the triangles cover the convex hull
    CONVEX_HULL = 1,
    /// less the flat ones along it
    TRIMMED = 2
  };

  /// The values of DuplicatePolicy.
  enum DuplicatePolicyValues
  {
    /// the smallest id
    FIRST = 0,
    /// the lowest z
    LOWEST_Z = 1,
    /// the highest z
    HIGHEST_Z = 2,
    /// the smallest id, at the mean of all z
    MEAN_Z = 3
  };

  /// The values of VoronoiClip.
  enum VoronoiClipValues
  {
    /// the convex hull of the points
    CLIP_TO_HULL = 0,
    /// the bounding box of the points
    CLIP_TO_BOUNDS = 1
  };

  /// The values of InsertionOrder.
  enum InsertionOrderValues
  {
    /// HG: boxes divided where crowded, along an adaptive Hilbert curve
    ADAPTIVE_HILBERT = 0,
    /// MG: boxes divided where crowded, line by line (S. H. Lo, 2013)
    MULTI_GRID = 1,
    /// RG: boxes of one even grid, line by line
    REGULAR_GRID = 2,
    /// the order of the input
    AS_GIVEN = 3
  };

  /// The values of ControlPoints.
  enum ControlPointsValues
  {
    /// none
    NO_CONTROL_POINTS = 0,
    /// one point of each box of the first level
    SINGLE_LEVEL = 1,
    /// a sparse subset of the points, before it a sparser one, and so on
    EVERY_LEVEL = 2
  };

  ///@{
  /// Triangulate the points of all blocks of a multiblock data set together, into one surface
  /// without seams: lidar tiles, for instance. Point arrays that all blocks have are passed on.
  /// Without it each block becomes a surface by itself. Off by default.
  /// The points are numbered block after block. Costs a copy of the points and their data.
  vtkSetMacro(MergeBlocks, bool);
  vtkGetMacro(MergeBlocks, bool);
  vtkBooleanMacro(MergeBlocks, bool);
  ///@}

  ///@{
  /// How the source says where its lines run. Coordinates: by its own points, which are added to
  /// the surface (a point that is there already, at the same x and y, is not added twice). Point
  /// ids: its points stand for the points of the input with the same ids, and their coordinates are
  /// not looked at, as in VTK's vtkDelaunay2D. Default: SOURCE_COORDINATES in ParaView, SOURCE_IDS
  /// in VTK.
  /// Points of the source are added behind those of the input.
  vtkSetClampMacro(SourceMode, int, SOURCE_IDS, SOURCE_COORDINATES);
  vtkGetMacro(SourceMode, int);
  void SetSourceModeToIds() { this->SetSourceMode(SOURCE_IDS); }
  void SetSourceModeToCoordinates() { this->SetSourceMode(SOURCE_COORDINATES); }
  ///@}

  ///@{
  /// Which heights the points of the source have. Own: their own z. A line of two dimensions, as
  /// from most maps, lies at z = 0 and pulls the surface down to it. From Surface: the height, and
  /// all point data, of the surface of the input where they lie, by linear interpolation; outside
  /// of it they keep their own z, and a warning counts them. Not used with Source Mode Point ids.
  /// Default: OWN.
  /// From Surface triangulates the input twice: first alone.
  vtkSetClampMacro(SourceHeights, int, OWN, FROM_SURFACE);
  vtkGetMacro(SourceHeights, int);
  void SetSourceHeightsToOwn() { this->SetSourceHeights(OWN); }
  void SetSourceHeightsToFromSurface() { this->SetSourceHeights(FROM_SURFACE); }
  ///@}

  ///@{
  /// What lines of the source are that end where they begin. Lines: edges of the surface, as other
  /// lines are; right for contours. Loops: outlines that bound the surface, as polygons do; right
  /// for coastlines, lakes and borders from GeoJSON, shapefiles and .csv, which come as lines.
  /// Default: LINES.
  /// A line is closed if its ends are one point, or have the same x and y in the plane of the
  /// triangulation. In the order of the constraints, loops come after the other lines.
  vtkSetClampMacro(ClosedLines, int, LINES, LOOPS);
  vtkGetMacro(ClosedLines, int);
  void SetClosedLinesToLines() { this->SetClosedLines(LINES); }
  void SetClosedLinesToLoops() { this->SetClosedLines(LOOPS); }
  ///@}

  ///@{
  /// Which side of the outlines (polygons and loops of the source) is kept. Even-odd: what lies
  /// inside an odd number of outlines, whichever way they run. Orientation, as in vtkDelaunay2D:
  /// the left side of each, so counterclockwise outlines are filled, clockwise ones are holes, and
  /// they may be nested; outlines of shapefiles run the other way. Default: EVEN_ODD in ParaView,
  /// ORIENTATION in VTK.
  /// With Orientation, what no loop bounds is kept, too. Without loops all is.
  vtkSetClampMacro(FillRule, int, ORIENTATION, EVEN_ODD);
  vtkGetMacro(FillRule, int);
  void SetFillRuleToOrientation() { this->SetFillRule(ORIENTATION); }
  void SetFillRuleToEvenOdd() { this->SetFillRule(EVEN_ODD); }
  ///@}

  ///@{
  /// What to do where two lines of the source cross each other between their points. Leave out: the
  /// later one of the two segments is left out and counted (Number Of Crossings), and an outline
  /// that lacks a segment bounds nothing. Split: a point is added where they cross, its height and
  /// data taken from both lines, and no segment is left out. Default: LEAVE_OUT.
  /// Lines come before polygons; then the order of the cells counts. The height and data of an
  /// added point are the mean of what linear interpolation along either segment gives.
  vtkSetClampMacro(CrossingMode, int, LEAVE_OUT, SPLIT);
  vtkGetMacro(CrossingMode, int);
  void SetCrossingModeToLeaveOut() { this->SetCrossingMode(LEAVE_OUT); }
  void SetCrossingModeToSplit() { this->SetCrossingMode(SPLIT); }
  ///@}

  ///@{
  /// Leave out every triangle that has an edge longer than this, measured in the plane of the
  /// triangulation, in the units of the points. It gives a survey its concave outline instead of
  /// the convex hull. 0: none is left out. Default 0, at least 0.
  /// Lines of Alpha that are longer are left out, too.
  virtual void SetMaximumEdgeLength(double value);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /// The alpha shape, as in Delaunay 2D: triangles whose circle through the corners has a radius of
  /// at most Alpha, edges of at most 2 Alpha that are in none of these triangles as lines, and
  /// points that are in neither as vertices. Radius and length are those in space, z included. 0:
  /// off, all triangles. Default 0, at least 0.
  /// Where it differs from vtkDelaunay2D: Reference.md.
  virtual void SetAlpha(double value);
  virtual double GetAlphaMinValue() { return 0.0; }
  virtual double GetAlphaMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /// Put out the triangles of the alpha shape. On by default.
  vtkSetMacro(AlphaTris, vtkTypeBool);
  vtkGetMacro(AlphaTris, vtkTypeBool);
  vtkBooleanMacro(AlphaTris, vtkTypeBool);
  ///@}

  ///@{
  /// Put out, as lines, the edges of the alpha shape that are in none of its triangles. On by
  /// default.
  vtkSetMacro(AlphaLines, vtkTypeBool);
  vtkGetMacro(AlphaLines, vtkTypeBool);
  vtkBooleanMacro(AlphaLines, vtkTypeBool);
  ///@}

  ///@{
  /// Put out, as vertices, the points of the alpha shape that are in none of its triangles and
  /// lines. On by default.
  vtkSetMacro(AlphaVerts, vtkTypeBool);
  vtkGetMacro(AlphaVerts, vtkTypeBool);
  vtkBooleanMacro(AlphaVerts, vtkTypeBool);
  ///@}

  ///@{
  /// The plane in which the points are triangulated. XY plane: z is the height. Transform plane: x
  /// and y after the Transform. Best-fitting plane: the plane from which the points are least far,
  /// for a rock face or a scanned wall. The points of the surface stay where they are. Default:
  /// VTK_DELAUNAY_XY_PLANE.
  /// After a transform or in a fitted plane, exactness is for the coordinates there, rounded to
  /// double precision, and duplicates are judged there. In the x, y plane a Transform counts if one
  /// is set; in the transform plane a warning says that none is. For the best-fitting plane see
  /// ComputeBestFittingPlane; Transform is not used.
  vtkSetClampMacro(ProjectionPlaneMode, int, VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE);
  vtkGetMacro(ProjectionPlaneMode, int);
  ///@}

  ///@{
  /// How far the surface reaches where no outline bounds it. Convex hull: all triangles. Trimmed:
  /// without the flat ones along the rim, those with an angle above 153 degrees whose longest edge
  /// lies there; in a fitted plane these stand as walls along a rim that is straight in space.
  /// Automatic: the convex hull in the XY plane, and in the best-fitting plane of points that all
  /// have the same z, x or y; else trimmed. No effect with Alpha, Maximum Edge Length or Bounding
  /// Triangulation. Number Of Trimmed Triangles counts what went. Default: AUTOMATIC.
  /// The angle is exactly 180 degrees less the arc tangent of 1/2; of what lies behind, triangles
  /// go likewise. Constraints stay edges. A warning where a point is left without a triangle, or a
  /// tenth of the area goes.
  vtkSetClampMacro(Rim, int, AUTOMATIC, TRIMMED);
  vtkGetMacro(Rim, int);
  void SetRimToAutomatic() { this->SetRim(AUTOMATIC); }
  void SetRimToConvexHull() { this->SetRim(CONVEX_HULL); }
  void SetRimToTrimmed() { this->SetRim(TRIMMED); }
  ///@}

  ///@{
  /// Merge points that are closer to each other than this fraction of the diagonal of the points'
  /// bounding box, in the plane of the triangulation. 0: only points with the very same x and y are
  /// merged. Number Of Merged Points counts what more was merged; Generate Point Status says into
  /// which point. From 0 to 1. Default 0.
  /// Points are taken in lexicographic order of x, y; one that has vertices within that distance is
  /// merged into the nearest. Constraints follow. vtkDelaunay2D's default is 1e-5, of the diagonal
  /// in space.
  virtual void SetTolerance(double value);
  virtual double GetToleranceMinValue() { return 0.0; }
  virtual double GetToleranceMaxValue() { return 1.0; }
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Which of the points with the same x and y becomes the vertex, and so shows its height. First:
  /// the one with the smallest id. Lowest z, highest z: the deepest or the shoalest sounding, for
  /// instance. Mean z: the first, with the mean of the heights. Default: FIRST.
  /// Heights that are finite come first; the mean is that of all that are finite, in a copy of the
  /// points. Merged points have no say. Changes ids and z, never the shape in the plane.
  vtkSetClampMacro(DuplicatePolicy, int, FIRST, MEAN_Z);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToFirst() { this->SetDuplicatePolicy(FIRST); }
  void SetDuplicatePolicyToLowestZ() { this->SetDuplicatePolicy(LOWEST_Z); }
  void SetDuplicatePolicyToHighestZ() { this->SetDuplicatePolicy(HIGHEST_Z); }
  void SetDuplicatePolicyToMeanZ() { this->SetDuplicatePolicy(MEAN_Z); }
  ///@}

  ///@{
  /// Add a point array, Fate, with the status of each point: its own id if it is a vertex of the
  /// surface; the id of another point if it is a duplicate of it or was merged into it; -1 if its x
  /// or y is not a finite number; -2 if it was not inserted, because it is marked as a ghost or
  /// hidden, lies beyond the Insertion Limit, or is a duplicate of a point that does. Switch it on
  /// to find the points that are not in the surface. Off by default.
  /// The array is a vtkIdTypeArray.
  vtkSetMacro(GeneratePointStatus, bool);
  vtkGetMacro(GeneratePointStatus, bool);
  vtkBooleanMacro(GeneratePointStatus, bool);
  // GenerateFate is the old name.
  void SetGenerateFate(bool on) { this->SetGeneratePointStatus(on); }
  bool GetGenerateFate() { return this->GetGeneratePointStatus(); }
  void GenerateFateOn() { this->SetGeneratePointStatus(true); }
  void GenerateFateOff() { this->SetGeneratePointStatus(false); }
  ///@}

  ///@{
  /// Add a cell array, ConstraintEdges: which edges of a triangle are edges of the source. The sum
  /// of 1 (from the first corner to the second), 2 (from the second to the third) and 4 (from the
  /// third to the first). Off by default.
  /// The array is a vtkUnsignedCharArray. Lines and vertices have 0.
  vtkSetMacro(GenerateConstraintEdges, bool);
  vtkGetMacro(GenerateConstraintEdges, bool);
  vtkBooleanMacro(GenerateConstraintEdges, bool);
  ///@}

  ///@{
  /// Add a cell array, RegionId: triangles that can be reached from each other without crossing a
  /// line of the source have the same number, from 0. Off by default.
  /// The array is a vtkIdTypeArray. Lines and vertices have -1.
  vtkSetMacro(GenerateRegionIds, bool);
  vtkGetMacro(GenerateRegionIds, bool);
  vtkBooleanMacro(GenerateRegionIds, bool);
  ///@}

  ///@{
  /// Add a cell array, Neighbors, of three numbers: the triangles on the other side of the edges
  /// from the first corner to the second, from the second to the third, and from the third to the
  /// first; -1 where there is none. Off by default.
  /// The array is a vtkIdTypeArray. Lines and vertices have -1.
  vtkSetMacro(GenerateNeighbors, bool);
  vtkGetMacro(GenerateNeighbors, bool);
  vtkBooleanMacro(GenerateNeighbors, bool);
  ///@}

  ///@{
  /// Fill the third output, Voronoi: for each vertex a polygon, the places that are nearer to it
  /// than to any other vertex. The polygons have the point data of their vertices as cell data, and
  /// lie at z = 0. ParaView does not show them at once, as they may cover the surface: click the
  /// eye of the output Voronoi. Off by default.
  /// Output port 2: convex counterclockwise polygons, with the vertex's id as "OriginalPointIds"
  /// (vtkIdTypeArray). Corners are those of the exact polygons, rounded once to double precision;
  /// those that differ by no more than 4 units in the last place may be one. Constraints have no
  /// say.
  vtkSetMacro(GenerateVoronoi, bool);
  vtkGetMacro(GenerateVoronoi, bool);
  vtkBooleanMacro(GenerateVoronoi, bool);
  ///@}

  ///@{
  /// Where the Voronoi diagram ends, as its outer polygons are unbounded. Hull: at the convex hull
  /// of the points. Bounds: at their bounding box. Default: CLIP_TO_HULL.
  /// Both are those of the vertices, in the plane of the triangulation.
  vtkSetClampMacro(VoronoiClip, int, CLIP_TO_HULL, CLIP_TO_BOUNDS);
  vtkGetMacro(VoronoiClip, int);
  void SetVoronoiClipToHull() { this->SetVoronoiClip(CLIP_TO_HULL); }
  void SetVoronoiClipToBounds() { this->SetVoronoiClip(CLIP_TO_BOUNDS); }
  ///@}

  ///@{
  /// In which order the points are inserted. It changes the time, never the triangles. Adaptive
  /// Hilbert (HG), the fastest: boxes that are divided where points are crowded, visited along a
  /// Hilbert curve. Multi-grid (MG): the same boxes, visited line by line. Regular grid (RG): boxes
  /// of one size, visited line by line. As given: the order of the input; very slow where the
  /// points come at random. Change it to compare. Default: ADAPTIVE_HILBERT.
  vtkSetClampMacro(InsertionOrder, int, ADAPTIVE_HILBERT, AS_GIVEN);
  vtkGetMacro(InsertionOrder, int);
  void SetInsertionOrderToAdaptiveHilbert() { this->SetInsertionOrder(ADAPTIVE_HILBERT); }
  void SetInsertionOrderToMultiGrid() { this->SetInsertionOrder(MULTI_GRID); }
  void SetInsertionOrderToRegularGrid() { this->SetInsertionOrder(REGULAR_GRID); }
  void SetInsertionOrderToAsGiven() { this->SetInsertionOrder(AS_GIVEN); }
  ///@}

  ///@{
  /// A box with more points than this is divided. Su et al. find 50 to 200 good. Smaller boxes
  /// follow crowded points more closely and take longer to sort. It changes the time, never the
  /// triangles. It has an effect with the Insertion Order Multi-grid, and with Adaptive Hilbert if
  /// Control Points is Off or First level, Gene Rotation is off, or Generate Boxes is on, which
  /// shows the boxes; else it has none, as the curve goes on inside the boxes to the single point,
  /// and ParaView greys it. Default 50, at least 1.
  vtkSetClampMacro(Nmax, int, 1, VTK_INT_MAX);
  vtkGetMacro(Nmax, int);
  ///@}

  ///@{
  /// A sparse selection of the points, inserted before all others so that long thin triangles are
  /// not built first and removed later. It changes the time, never the triangles. Off: none. First
  /// level: one point of each box of the first division, as Su et al. do. Every level: a sparse
  /// selection of the points, of that selection another, and so on, from coarse to fine. Used by
  /// Adaptive Hilbert and Multi-grid. Change it to compare. Default: EVERY_LEVEL.
  vtkSetClampMacro(ControlPoints, int, NO_CONTROL_POINTS, EVERY_LEVEL);
  vtkGetMacro(ControlPoints, int);
  void SetControlPointsToNone() { this->SetControlPoints(NO_CONTROL_POINTS); }
  void SetControlPointsToSingleLevel() { this->SetControlPoints(SINGLE_LEVEL); }
  void SetControlPointsToEveryLevel() { this->SetControlPoints(EVERY_LEVEL); }
  ///@}

  ///@{
  /// Turn the Hilbert curve in each divided box so that it enters and leaves where its neighbours
  /// on the curve expect it (the paper's "gene"). Switched off, the curve jumps between boxes, and
  /// after each jump the next point is searched from farther away. It changes the time, never the
  /// triangles. Used by Adaptive Hilbert. Change it to compare. On by default.
  vtkSetMacro(GeneRotation, bool);
  vtkGetMacro(GeneRotation, bool);
  vtkBooleanMacro(GeneRotation, bool);
  ///@}

  ///@{
  /// Stop after so many points: the surface is the triangulation of these, as it was when the last
  /// of them was inserted. 0, and numbers that are large enough: all points. Which points come
  /// first depends on the settings of the insertion. In ParaView move the slider, or animate it, to
  /// see the surface grow: both go from 3, the first that may give a triangle, to the number of
  /// points; for all points type 0. Default 0, at least 0.
  /// Distinct points count. The others are in no triangle and counted by NumberOfPointsBeyondLimit.
  /// With a limit, one thread inserts.
  vtkSetClampMacro(InsertionLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(InsertionLimit, vtkIdType);
  ///@}

  ///@{
  /// Add a point array, InsertionRank: the place of each point in the order of insertion, from 0;
  /// -1 for duplicates, rejected and skipped points. Colour by it to see the order. Off by default.
  /// The array is a vtkIdTypeArray; the order is that of one thread.
  vtkSetMacro(GenerateInsertionRank, bool);
  vtkGetMacro(GenerateInsertionRank, bool);
  vtkBooleanMacro(GenerateInsertionRank, bool);
  ///@}

  ///@{
  /// Put a line through the inserted points, in the order of their insertion, into the second
  /// output, Insertion order. Its point array InsertionRank counts along the line; OriginalPointIds
  /// has the points' ids in the input. Off by default.
  /// Output port 1.
  vtkSetMacro(GenerateInsertionCurve, bool);
  vtkGetMacro(GenerateInsertionCurve, bool);
  vtkBooleanMacro(GenerateInsertionCurve, bool);
  ///@}

  ///@{
  /// Put the boxes of the grid that decides the order into the second output, Insertion order:
  /// those that are not divided further, in the order in which they are visited, at the height of
  /// the lowest point. Their cell arrays: Level, the number of divisions that made the box; Count,
  /// the points in it. The order As given has no boxes. Off by default.
  /// Output port 1; about 300 bytes a box.
  vtkSetMacro(GenerateBoxes, bool);
  vtkGetMacro(GenerateBoxes, bool);
  vtkBooleanMacro(GenerateBoxes, bool);
  ///@}

  ///@{
  /// As in Delaunay 2D: how far away the eight points of Bounding Triangulation lie. It changes
  /// nothing else. Default 1, at least 0.75.
  /// In diagonals, in space, of the bounding box.
  virtual void SetOffset(double value);
  virtual double GetOffsetMinValue() { return 0.75; }
  virtual double GetOffsetMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /// As in Delaunay 2D: add eight points on a circle around all others, and the triangles that join
  /// them. Only where the points are triangulated in x and y. Off by default.
  /// The circle is about the centre of the bounding box. In other planes a warning.
  vtkSetMacro(BoundingTriangulation, vtkTypeBool);
  vtkGetMacro(BoundingTriangulation, vtkTypeBool);
  vtkBooleanMacro(BoundingTriangulation, vtkTypeBool);
  ///@}

  ///@{
  /// Does nothing: there for scripts written for vtkDelaunay2D. The order of insertion is set by
  /// Insertion Order and never changes the triangles. Off by default.
  vtkSetMacro(RandomPointInsertion, vtkTypeBool);
  vtkGetMacro(RandomPointInsertion, vtkTypeBool);
  vtkBooleanMacro(RandomPointInsertion, vtkTypeBool);
  ///@}

  ///@{
  /// Does nothing: there for scripts written for vtkDelaunay2D. Points are inserted along a Hilbert
  /// curve anyway, unless Insertion Order says otherwise. Off by default.
  vtkSetMacro(UseHilbertSorter, vtkTypeBool);
  vtkGetMacro(UseHilbertSorter, vtkTypeBool);
  vtkBooleanMacro(UseHilbertSorter, vtkTypeBool);
  ///@}

  ///@{
  /// How many processors the filter works on. It changes the time, never the triangles. 0: all that
  /// the program (ParaView; with a server, the server) may use, unless VTK was told to use fewer,
  /// for example by the environment variable VTK_SMP_MAX_THREADS. 1 to 1024: exactly so many. Set
  /// it where others need the processors too. With Count Work, an Insertion Limit, another
  /// Insertion Order than Adaptive Hilbert, or other insertion settings than the defaults, the
  /// points are inserted by one; so are few points. From 0 to 1024. Default 0.
  /// The calling thread is one of them; it alone reports progress and is asked for an abort. 0
  /// heeds vtkSMPTools::Initialize(n), too.
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// On a server with several ranks: triangulate the points of all ranks together, into one surface
  /// without seams, exactly the triangles that one rank would give. The points move to the rank
  /// that owns their place, with the point arrays that all ranks have; filters behind get the ghost
  /// cells that they ask for. Off: each rank triangulates its own points. For some settings one
  /// rank does it all, which a warning says once. All ranks have to update the filter: a script of
  /// pvbatch --sym that does so on one alone waits for ever. No effect with one rank, nor in
  /// Python's class and plugin, where each rank works on its own. On by default in ParaView, off in
  /// VTK.
  /// Off, there is a warning where there are several ranks. The ranks are those of Controller. The
  /// triangles are those of one rank that has all inputs and sources, appended in the order of the
  /// ranks. All ranks have to update alike, with the same settings: where one has to execute, all
  /// do. Each puts out the triangles that it owns, by place; with its points; and behind these the
  /// points of others that are corners, with vtkGhostType DUPLICATEPOINT. Layers of ghost cells are
  /// marked as well. The global ids "GlobalPointIds" number the points as appended, those of
  /// sources last; "GlobalCellIds" the triangles. Counts are of all ranks. Ids in the source's
  /// cells are those of the rank's own points. Sources that are the same on all ranks count once
  /// where their points are added. What fails on one rank ends in one error on each. Settings that
  /// ranks have no method for have one rank triangulate all points and put out everything, if there
  /// is room on it; a warning names the first: Reference.md lists them. With MergeBlocks off, block
  /// k of all ranks is triangulated by itself, for each k.
  vtkSetMacro(DistributePoints, bool);
  vtkGetMacro(DistributePoints, bool);
  vtkBooleanMacro(DistributePoints, bool);
  ///@}

  ///@{
  /// Triangulate again only what is new: where points, source and settings are those of the last
  /// two runs, as in time steps of which only the arrays change, the triangles are passed on from
  /// the third on, with the arrays of now. Switch it off to triangulate at each run. On by default.
  /// Coordinates, ghost marks, source and settings are compared; point data and field data are
  /// those of now.
  vtkSetMacro(KeepTriangulation, bool);
  vtkGetMacro(KeepTriangulation, bool);
  vtkBooleanMacro(KeepTriangulation, bool);
  ///@}

  ///@{
  /// The most memory the filter may take beyond its input, in kibibytes (1024 bytes). What is
  /// estimated to need more is refused with an error before anything is computed. 0: what the
  /// machine has left. Set it where others need the machine's memory too. Default 0, at least 0.
  /// The output is included. 0 heeds the limits of the process, too. With GenerateBoxes the error
  /// comes before anything is inserted.
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the filter keeps for its next run, which is
  /// then faster: its working memory, and that of former outputs. What takes more is given back
  /// after each run. The default, 256 MiB, is enough for 2 million points. 0 keeps nothing. Raise
  /// it where larger data change in time, lower it where many such filters are in one pipeline.
  /// Default 262144, at least 0.
  /// Working memory comes first: what took more, failed or was aborted gives all back. Within it a
  /// triangulation stays whole until the next execution, for filters that interpolate on its
  /// surface. What is left of it keeps the memory of outputs that nobody has any more.
  vtkSetClampMacro(ReuseLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(ReuseLimit, vtkTypeInt64);
  ///@}

  ///@{
  /// Count the triangles tested to find where each point goes (NP) and the triangles removed to
  /// make room for it (NR). Switch it on to compare insertion orders by their work, which is the
  /// same on every machine, rather than by seconds. Counting takes time, and one thread inserts; it
  /// never changes the triangles. Off by default.
  vtkSetMacro(CountWork, bool);
  vtkGetMacro(CountWork, bool);
  vtkBooleanMacro(CountWork, bool);
  ///@}

  ///@{
  /// Threads that shared the work of the last run; 1 if there was too little to share.
  vtkGetMacro(NumberOfThreadsUsed, int);
  ///@}

  ///@{
  /// How often this filter has triangulated since it was made; runs that passed on the triangles of
  /// the one before do not count.
  vtkGetMacro(NumberOfTriangulations, int);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its
  /// input, or was refused: what Memory Limit is compared with.
  /// If there were too many crossings: what one more than fits would need.
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  ///@}

  ///@{
  /// Triangles of the surface, in the last run.
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// Points that are vertices of the surface, in the last run.
  /// Counts are 0 if the run was aborted or ended in an error; else those of points add up to all
  /// points, added ones included.
  vtkGetMacro(NumberOfPointsInserted, vtkIdType);
  ///@}

  ///@{
  /// Points with the same x and y as an earlier point, in the last run. They are not in the
  /// surface.
  vtkGetMacro(NumberOfDuplicates, vtkIdType);
  ///@}

  ///@{
  /// Points that were merged into another by the Tolerance, in the last run. Points with the very
  /// same x and y are counted as duplicates.
  vtkGetMacro(NumberOfMergedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points of the surface that are not in the input, in the last run: points of the source, where
  /// lines cross, and those of Bounding Triangulation.
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points whose x or y is NaN or infinite, in the last run. They are not in the surface.
  vtkGetMacro(NumberOfRejectedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points left out because they are marked as ghosts or hidden, in the last run.
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points that are not in the surface because of the Insertion Limit, in the last run.
  vtkGetMacro(NumberOfPointsBeyondLimit, vtkIdType);
  ///@}

  ///@{
  /// Edges of the triangulation that are edges of the source, in the last run.
  /// Those of triangles that were dropped are included.
  vtkGetMacro(NumberOfConstraintEdges, vtkIdType);
  ///@}

  ///@{
  /// Segments of the source that were left out as they cross an earlier one, in the last run; with
  /// the crossing mode Split, the points added where segments cross. The field data array Crossings
  /// says which lines.
  vtkGetMacro(NumberOfCrossings, vtkIdType);
  ///@}

  ///@{
  /// With the crossing mode Split: segments of the source that were led, in the last run, through a
  /// point that lies beside them by less than rounding tells apart.
  vtkGetMacro(NumberOfBentConstraints, vtkIdType);
  ///@}

  ///@{
  /// Segments of the source that are no edges of the triangulation, in the last run: they cross
  /// another, or have an end that is no vertex.
  vtkGetMacro(NumberOfConstraintsLeftOut, vtkIdType);
  ///@}

  ///@{
  /// Outlines that bound nothing, as one of their segments was left out, in the last run.
  vtkGetMacro(NumberOfUnfilledLoops, vtkIdType);
  ///@}

  ///@{
  /// Flat triangles that Rim took away, in the last run.
  vtkGetMacro(NumberOfTrimmedTriangles, vtkIdType);
  ///@}

  ///@{
  /// Triangles tested to find where a point goes, per inserted point, in the last run. The time of
  /// finding is proportional to it. -1 if it was not counted: switch Count Work on.
  /// The triangle that the search starts from is included.
  vtkGetMacro(NP, double);
  ///@}

  ///@{
  /// Triangles removed to make room for a point, per inserted point, in the last run. The time of
  /// updating is proportional to it. -1 if it was not counted: switch Count Work on.
  vtkGetMacro(NR, double);
  ///@}

  ///@{
  /// Wall-clock seconds of reading the points and sorting them into the order of insertion, in the
  /// last run.
  /// Seconds are 0 if triangles were passed on.
  vtkGetMacro(SortSeconds, double);
  ///@}

  ///@{
  /// Wall-clock seconds of inserting the points, in the last run.
  vtkGetMacro(InsertSeconds, double);
  ///@}

  ///@{
  /// Wall-clock seconds of making the lines of the source edges, in the last run.
  vtkGetMacro(ConstrainSeconds, double);
  ///@}

  ///@{
  /// Wall-clock seconds of putting the triangles out in their canonical order, in the last run.
  vtkGetMacro(OutputSeconds, double);
  ///@}

protected:
  vtkAdaptiveHilbertAlgorithm();
  ~vtkAdaptiveHilbertAlgorithm() override;

  /// Sets all measures to what they are after an execution that came to nothing.
  void ClearMeasures();

  /// Sets those that are seconds to 0.
  void ClearSeconds();

  /// Adds the measures that are counts as arrays of one value with their names.
  void AddCounts(vtkFieldData* data) const;

  /// Throws std::bad_alloc.
  void GetSettingsOfRanks(vtkAHDSettingsOfRanks& settings) const;

  // Settings.
  bool MergeBlocks = false;
  int SourceMode = SOURCE_IDS;
  int SourceHeights = OWN;
  int ClosedLines = LINES;
  int FillRule = ORIENTATION;
  int CrossingMode = LEAVE_OUT;
  double MaximumEdgeLength = 0.0;
  double Alpha = 0.0;
  vtkTypeBool AlphaTris = 1;
  vtkTypeBool AlphaLines = 1;
  vtkTypeBool AlphaVerts = 1;
  int ProjectionPlaneMode = VTK_DELAUNAY_XY_PLANE;
  int Rim = AUTOMATIC;
  double Tolerance = 0.0;
  int DuplicatePolicy = FIRST;
  bool GeneratePointStatus = false;
  bool GenerateConstraintEdges = false;
  bool GenerateRegionIds = false;
  bool GenerateNeighbors = false;
  bool GenerateVoronoi = false;
  int VoronoiClip = CLIP_TO_HULL;
  int InsertionOrder = ADAPTIVE_HILBERT;
  int Nmax = 50;
  int ControlPoints = EVERY_LEVEL;
  bool GeneRotation = true;
  vtkIdType InsertionLimit = 0;
  bool GenerateInsertionRank = false;
  bool GenerateInsertionCurve = false;
  bool GenerateBoxes = false;
  double Offset = 1.0;
  vtkTypeBool BoundingTriangulation = 0;
  vtkTypeBool RandomPointInsertion = 0;
  vtkTypeBool UseHilbertSorter = 0;
  int NumberOfThreads = 0;
  bool DistributePoints = false;
  bool KeepTriangulation = true;
  vtkTypeInt64 MemoryLimit = 0;
  vtkTypeInt64 ReuseLimit = 262144;
  bool CountWork = false;

  // Measures of the last execution.
  int NumberOfThreadsUsed = 0;
  vtkTypeInt64 MemoryEstimate = 0;
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfPointsInserted = 0;
  vtkIdType NumberOfDuplicates = 0;
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfRejectedPoints = 0;
  vtkIdType NumberOfSkippedPoints = 0;
  vtkIdType NumberOfPointsBeyondLimit = 0;
  vtkIdType NumberOfConstraintEdges = 0;
  vtkIdType NumberOfCrossings = 0;
  vtkIdType NumberOfBentConstraints = 0;
  vtkIdType NumberOfConstraintsLeftOut = 0;
  vtkIdType NumberOfUnfilledLoops = 0;
  vtkIdType NumberOfTrimmedTriangles = 0;
  double NP = -1.0;
  double NR = -1.0;
  double SortSeconds = 0.0;
  double InsertSeconds = 0.0;
  double ConstrainSeconds = 0.0;
  double OutputSeconds = 0.0;

  // Measures of all executions.
  int NumberOfTriangulations = 0;

private:
  vtkAdaptiveHilbertAlgorithm(const vtkAdaptiveHilbertAlgorithm&) = delete;
  void operator=(const vtkAdaptiveHilbertAlgorithm&) = delete;
};

#endif
