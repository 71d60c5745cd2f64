// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveHilbertDelaunay2D
 * @brief   exact 2D Delaunay triangulation of large point sets
 *
 * Makes a surface of triangles out of scattered points: soundings, lidar returns, samples of a
 * height field, points of a plane. The triangulation is computed in x and y (or another plane: see
 * ProjectionPlaneMode); z is carried along unseen, so heights make a terrain (a triangulated
 * irregular network). Breaklines, outlines and holes are given as constraints.
 *
 * <b>What comes out.</b> The vtkPolyData has the very points of the input (the same vtkPoints
 * object, the same ids, all point data) and one triangle per cell. Input cells and cell data are
 * not passed on. With default settings and no constraints, the triangles
 * - are the Delaunay triangulation of the points: no point lies inside the circumcircle of a
 *   triangle. This holds exactly, not up to a tolerance, for every finite coordinate;
 * - are all counterclockwise in the x, y plane;
 * - cover the convex hull of the points; points on its straight edges are corners of triangles;
 * - number 2v - 2 - h, for v distinct points of which h lie on the boundary of the hull.
 *
 * This is output port 0. Output ports 1 and 2 are empty unless asked for (see below, and
 * GenerateVoronoi).
 *
 * <b>Constraints.</b> Input port 1, the source, is an optional vtkPolyData; its cells refer to the
 * points of the input by their ids, or to its own points (see SourceMode). Each segment of its
 * lines and polylines becomes an edge, or a row of edges where points lie on it. So does each of
 * its polygons, as loops, the last point joined to the first; what they enclose is kept, the rest
 * dropped (see FillRule). The result is the constrained Delaunay triangulation: no point that can
 * be seen from inside a triangle lies in its circumcircle, where constraints block the view.
 * Segments may overlap, repeat each other or have no length; ends that are duplicates stand for the
 * vertex at their place. A segment that crosses one before it is left out, or both are split (see
 * CrossingMode); one whose end is no vertex is left out. A loop with a segment left out bounds
 * nothing, its other segments are edges. All of this is counted, and the field data array
 * "Crossings" (vtkIdTypeArray, two components) names the cells of the source that cross, the later
 * one first, one row for each segment left out or point added, at most 1000.
 *
 * <b>Points that are added</b> by SOURCE_COORDINATES, BoundingTriangulation and SPLIT follow those
 * of the input, in this order. The output's points are then a copy in double precision, and its
 * point data copies of the input's arrays, with a value for each added point. Global and pedigree
 * ids become arrays like others, -1 for added points (0 if unsigned, empty if strings).
 *
 * <b>Point arrays</b> of any kind and number of tuples are passed on as they are. In a copy (points
 * added) those with too few tuples have NaN, 0 or nothing for the rest, and what is too much is
 * left out. An array that the filter makes takes the place of one of the input with its name, which
 * then is no active attribute, and "Crossings" of the input is not passed on. Of several with one
 * name the last counts.
 *
 * <b>The result is canonical.</b> Where four or more points lie on one circle, there is more than
 * one Delaunay triangulation; here the coordinates alone decide which is taken, and the triangles
 * and their corners come in an order that the coordinates decide as well. None of the settings of
 * vtkAdaptiveHilbertAlgorithm but InsertionLimit changes the triangles or their order, and
 * shuffling the input changes nothing but the ids. The order of constraints has a say where they
 * cross.
 *
 * <b>What becomes of each point.</b> Every point is one of these, and the filter counts them:
 * - a vertex of the triangulation;
 * - a duplicate: same x and y as a point of smaller id, which stands for it in the triangles (but
 *   see DuplicatePolicy);
 * - merged: within Tolerance of another, which stands for it;
 * - rejected: its x or y is NaN or infinite;
 * - skipped: marked as a duplicate of another piece's point or as hidden in the point data array
 *   vtkGhostType;
 * - beyond the limit: it would be a vertex, but InsertionLimit stopped the insertion before.
 *
 * All stay in the output's points. Switch GenerateFate on to get each point's fate as a point
 * array. The counts are available from the Get methods below and, as integer arrays of one value
 * with the names of these methods (NumberOfDuplicates, ...), in the field data of the output.
 *
 * How the points are inserted, what shows it, and what is said of speed and memory is in
 * vtkAdaptiveHilbertAlgorithm.
 *
 * <b>Warnings and errors.</b> Each at most once per execution, with counts. Warnings: rejected
 * points, and points whose z is NaN or infinite (these are triangulated all the same); no triangle,
 * because there are fewer than three distinct points or all are collinear (or InsertionLimit lets
 * no others be inserted: then this is said), or because loops keep none, or nothing at all, because
 * Alpha and MaximumEdgeLength leave nothing; a Voronoi diagram that cannot be moved back from the
 * plane, as Transform has no inverse; segments left out as they
 * cross others, with the cells of the first two, or as an end is no vertex, and loops that bound
 * nothing for that reason; ids of the source that are no point's; an array vtkGhostType that has
 * not one unsigned char per point, and is ignored; several MPI ranks (once in the filter's life,
 * from rank 0), since each rank then triangulates its own points only. The blocks of a composite
 * data set are triangulated one by one; one that is no vtkPointSet, such as an image, gets a
 * warning and an empty output. Duplicates are no reason for a warning: ship tracks cross. No points
 * in, or all skipped: no triangles out, and nothing is said. Errors, with all outputs empty: too
 * many points, or not enough memory. The error is said once, the request counts as done (as in
 * vtkDelaunay2D), and the filters behind this one get the empty outputs. An aborted execution
 * (SetAbortExecute from a progress observer) leaves empty outputs and no error; to run again, call
 * SetAbortExecute(0) and Modified().
 *
 * <b>Compared with vtkDelaunay2D.</b> All settings of vtkDelaunay2D are here, by the same names;
 * what differs is said with each. (Numbers that are NaN are not taken as settings.) vtkDelaunay2D
 * drops points closer to others than a Tolerance and decides with rounded arithmetic, so its result
 * may depend on the order of the points, miss some, and lack constraints ("Edge not recovered"); it
 * starts from a big bounding triangulation, which can leave the boundary short of the convex hull.
 *
 * @sa
 * vtkDelaunay2D
 */

#ifndef vtkAdaptiveHilbertDelaunay2D_h
#define vtkAdaptiveHilbertDelaunay2D_h

#include "AdaptiveHilbertDelaunayFiltersModule.h" // for the export macro
#include "vtkAdaptiveHilbertAlgorithm.h"
#include "vtkSmartPointer.h" // for return values

#include <memory> // for std::unique_ptr

namespace ahd
{
class Workspace;
}
class vtkAHDContext;
class vtkAHDOutputCache;
struct vtkAHDDataSets;
class vtkAbstractTransform;
class vtkCompositeDataSet;
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

  /// The values of FillRule.
  enum FillRules
  {
    ORIENTATION = 0, ///< inside is on the left of each loop
    EVEN_ODD = 1     ///< inside is where a way from outside crosses loops an odd number of times
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

  ///@{
  /**
   * The constraints, input port 1, a vtkPolyData; none by default. Lines and polylines become edges
   * of the triangulation, polygons loops that bound what is kept (see the description of the class,
   * SourceMode, CrossingMode and FillRule). Vertices and strips of the source mean nothing here,
   * nor do cells of fewer than two points; a polygon of two is an edge and has no inside. Of a
   * composite data set VTK's pipeline takes block by block, with the whole input each; where the
   * input is one, too, the pipeline refuses that with an error. SetSourceData takes the data as
   * they are, SetSourceConnection the output of a filter; GetSource returns them, null if there are
   * none. As in vtkDelaunay2D.
   */
  void SetSourceData(vtkPolyData* source);
  void SetSourceConnection(vtkAlgorithmOutput* output);
  vtkPolyData* GetSource();
  ///@}

  ///@{
  /**
   * What the source's cells refer to: one of SourceModes. SOURCE_IDS, the default and what
   * vtkDelaunay2D does: the points of the input, by their ids; the source's own points mean
   * nothing. SOURCE_COORDINATES: the source's own points, which are added behind those of the input
   * and triangulated with them (a shapefile's lines over a lidar file), all of them, in no cell
   * too. One that coincides with a point of the input is a duplicate of it. Its point data are
   * those of the source's arrays that have the name and the number of components of one of the
   * input, rounded where that one's type has no such value (NaN to 0); where there is none, NaN in
   * arrays of floating point numbers and 0 in others. Ghost marks of the source mean nothing.
   */
  vtkSetClampMacro(SourceMode, int, SOURCE_IDS, SOURCE_COORDINATES);
  vtkGetMacro(SourceMode, int);
  void SetSourceModeToIds() { this->SetSourceMode(SOURCE_IDS); }
  void SetSourceModeToCoordinates() { this->SetSourceMode(SOURCE_COORDINATES); }
  ///@}

  ///@{
  /**
   * What is done where constraints cross, other than in a point of theirs: one of CrossingModes.
   * LEAVE_OUT, the default: the later of the two segments is no constraint (lines come before
   * polygons, then the order of the cells decides), and if it is part of a loop, the loop bounds
   * nothing. SPLIT: a point is added where they cross, rounded to double precision, and both bend
   * to pass through it. Its z and point data are the means of what linear interpolation along
   * either gives, rounded in arrays of whole numbers, empty in arrays of strings. If they still
   * cross after 16 rounds of this, it is as with LEAVE_OUT. A warning says how many were left out;
   * NumberOfCrossings counts the points added. vtkDelaunay2D leaves such edges to chance.
   */
  vtkSetClampMacro(CrossingMode, int, LEAVE_OUT, SPLIT);
  vtkGetMacro(CrossingMode, int);
  void SetCrossingModeToLeaveOut() { this->SetCrossingMode(LEAVE_OUT); }
  void SetCrossingModeToSplit() { this->SetCrossingMode(SPLIT); }
  ///@}

  ///@{
  /**
   * What loops keep: one of FillRules. ORIENTATION, the default and vtkDelaunay2D's rule: what is
   * on the left of every loop edge that bounds it, and what no loop bounds; so an outline runs
   * counterclockwise and a hole in it clockwise, nested as deep as you like, and a lone clockwise
   * loop is a hole in the convex hull. EVEN_ODD: what lies inside an odd number of loops, whichever
   * way they run; for data whose orientation means nothing. Without loops all is kept.
   */
  vtkSetClampMacro(FillRule, int, ORIENTATION, EVEN_ODD);
  vtkGetMacro(FillRule, int);
  void SetFillRuleToOrientation() { this->SetFillRule(ORIENTATION); }
  void SetFillRuleToEvenOdd() { this->SetFillRule(EVEN_ODD); }
  ///@}

  ///@{
  /**
   * A length, in the unit of the points: only what fits is put out. Triangles whose circumscribed
   * circle has no larger radius than this, measured in the space of the points; edges of none of
   * these that are not longer than twice this, as lines; and points in none of both, as vertices.
   * 0, the default, puts out all triangles and nothing else. The three kinds can be hidden one by
   * one, by AlphaTris, AlphaLines and AlphaVerts, all on by default and without effect where Alpha
   * is 0; to hide one changes nothing of the others.
   *
   * As in vtkDelaunay2D: from the same triangles both select the same cells. This includes that
   * - duplicates and merged points are corners of nothing, so they are put out as vertices, too.
   *   Points that are rejected, skipped or beyond InsertionLimit are not;
   * - a triangle that cannot be measured, because the z of a corner is NaN, is kept;
   * - where all points are collinear, there are lines from one to the next though no triangle. (Of
   *   fewer than three points vtkDelaunay2D puts out nothing, this filter a line or a vertex.)
   *
   * One thing differs: where loops of the source leave something out, vtkDelaunay2D fills it with
   * lines of its short edges; here nothing is put out there but the points that are used by nothing
   * else, as vertices.
   */
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
  /**
   * Triangles with an edge longer than this are not put out: gives a survey its concave outline. A
   * length in the plane of the triangulation, in the unit of its coordinates, up from 0; 0, the
   * default, keeps all. With Alpha, lines are not longer either. vtkDelaunay2D has no such setting.
   */
  virtual void SetMaximumEdgeLength(double length);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * The plane in which the points are triangulated, one of these; the output has the points where
   * they were, and triangles are counterclockwise in the plane.
   * - VTK_DELAUNAY_XY_PLANE (0), the default: x and y; if a Transform is set, those after it.
   * - VTK_SET_TRANSFORM_PLANE (1): x and y after Transform. Without one, x and y, with a warning.
   * - VTK_BEST_FITTING_PLANE (2): the plane with the least sum of squared distances of the points
   *   from it, vertical ones included. Points that are skipped or have a coordinate that is not
   *   finite do not count for it; neither does Transform. See ComputeBestFittingPlane.
   *
   * In the last two cases, and with a Transform, exactness is for the coordinates in the plane,
   * which are rounded to double precision: duplicates are points that coincide there, and one that
   * has no finite place there, or a coordinate that is not finite, is rejected (a Transform may lay
   * all in one place or on a line: then there is no triangle, and a warning). "z" then means the
   * height above the plane. Costs 24 bytes per point while the filter runs.
   *
   * vtkDelaunay2D fits the plane by distances along z, so none that is vertical or nearly so; its
   * triangles may face either side; and a Transform takes the place of the fit.
   */
  vtkSetClampMacro(ProjectionPlaneMode, int, VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE);
  vtkGetMacro(ProjectionPlaneMode, int);
  ///@}

  ///@{
  /**
   * What the points are transformed by before they are triangulated in x and y; the output has them
   * as they were. Any vtkAbstractTransform, linear or not, invertible or not; none by default. Used
   * unless ProjectionPlaneMode is VTK_BEST_FITTING_PLANE. Changes of the transform are noticed at
   * the next Update(). It is brought up to date, never changed, and stays set; vtkDelaunay2D
   * forgets it with the first execution, and does not notice its changes.
   */
  virtual void SetTransform(vtkAbstractTransform* transform);
  vtkGetObjectMacro(Transform, vtkAbstractTransform);
  ///@}

  /**
   * The plane that fits the points best, as a transform (a vtkTransform) that makes it the plane
   * z = 0: no scaling, no mirror, only a turn and a shift. The caller owns what is returned; null
   * if there is no input or no memory. Total least squares; the points' order has no say.
   *
   * What z becomes points to the side on which its component of largest magnitude is positive
   * (within a millionth of each other: z before y before x), so that triangles are counterclockwise
   * as seen from there. What x becomes is, of the coordinate axes, the one after that component's
   * (x after z), laid into the plane; so points near the plane z = 0 keep their x and y but for a
   * shift. Coincident points get a plane of constant z; points on a line the plane through it whose
   * normal is closest to z, or to y for a line that is steeper than 45 degrees.
   *
   * Far from the origin of the coordinates, the matrix rounds more than the filter itself does with
   * VTK_BEST_FITTING_PLANE, where the shift comes first and is exact.
   */
  static VTK_NEWINSTANCE vtkAbstractTransform* ComputeBestFittingPlane(vtkPointSet* input);

  ///@{
  /**
   * Points that are nearer to each other than this are merged into one, as a fraction of the
   * diagonal of the bounding box of all points in the plane of the triangulation, from 0 to 1. 0,
   * the default, merges none but those that coincide. Points are taken in the order of their x,
   * then y, and one that has kept ones within that distance is merged into the nearest of them: so
   * the order of the input has no say. Constraints follow their points. NumberOfMergedPoints
   * counts, GenerateFate says into which. vtkDelaunay2D's default is 1e-5, of the diagonal in
   * space, and what it drops depends on the order of the points.
   */
  virtual void SetTolerance(double tolerance);
  virtual double GetToleranceMinValue() { return 0.0; }
  virtual double GetToleranceMaxValue() { return 1.0; }
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Which of several points with the same place in the plane is the vertex: one of
   * DuplicatePolicies. FIRST, the default: the one of smallest id. LOWEST_Z, HIGHEST_Z: the one of
   * the lowest or highest z, of several of these the one of smallest id; a z that is not finite is
   * taken only where all are. MEAN_Z: the one of smallest id, and the output's points are a copy in
   * which its z is the mean of all finite ones, but not in the insertion curve. (In a plane other
   * than x, y: by height above it; the mean is of all coordinates.) Points merged by Tolerance have
   * no say. Crossings lie between the points shown. Changes ids and z, never the shape in the
   * plane. In vtkDelaunay2D the first one inserted stays.
   */
  vtkSetClampMacro(DuplicatePolicy, int, FIRST, MEAN_Z);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToFirst() { this->SetDuplicatePolicy(FIRST); }
  void SetDuplicatePolicyToLowestZ() { this->SetDuplicatePolicy(LOWEST_Z); }
  void SetDuplicatePolicyToHighestZ() { this->SetDuplicatePolicy(HIGHEST_Z); }
  void SetDuplicatePolicyToMeanZ() { this->SetDuplicatePolicy(MEAN_Z); }
  ///@}

  ///@{
  /**
   * With BoundingTriangulation on, eight points are added around all others and triangulated with
   * them: on a circle about the centre of the bounding box, its radius Offset times the length of
   * the box's diagonal in space, at angles of 0, 45, ... 315 degrees, z that of the centre. Points
   * that are rejected or skipped do not count for the box. Off by default. Offset: from 0.75,
   * default 1; without BoundingTriangulation it has no effect, since the boundary is the convex
   * hull anyway. The points are those of vtkDelaunay2D, which starts from them always. As there,
   * they have no place where the points are triangulated in another plane than x and y: a warning
   * says that they are not added (vtkDelaunay2D says so too, and puts out triangles of points that
   * are not there).
   */
  virtual void SetOffset(double offset);
  virtual double GetOffsetMinValue() { return 0.75; }
  virtual double GetOffsetMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Offset, double);
  vtkSetMacro(BoundingTriangulation, vtkTypeBool);
  vtkGetMacro(BoundingTriangulation, vtkTypeBool);
  vtkBooleanMacro(BoundingTriangulation, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Triangulate the points of all blocks of a composite data set together, such as lidar tiles,
   * without seams between them; the output is one vtkPolyData. Off by default: each block is
   * triangulated by itself, as with any other filter. The points of a block follow those of the one
   * before, in the order of the data set's iterator; the source's ids and all others refer to that
   * numbering. Point data: the arrays that all blocks have, by name, type and number of components,
   * with one tuple per point.
   * Ghost marks count. Blocks without points are passed over; so are those that are no vtkPointSet,
   * with a warning. Costs a copy of the points and their data. No effect on other data sets.
   */
  virtual void SetMergeBlocks(bool merge);
  vtkGetMacro(MergeBlocks, bool);
  vtkBooleanMacro(MergeBlocks, bool);
  ///@}

  ///@{
  /**
   * Put the Voronoi diagram of the vertices into output port 2: for each vertex a convex polygon of
   * what is nearer to it than to any other vertex, in the plane of the triangulation, with the
   * point data of the vertex as cell data, but for vtkGhostType, the array that is the active
   * GlobalIds, and arrays with fewer tuples than there are points. The cell array
   * "OriginalPointIds" (vtkIdTypeArray) has the vertex's id in the points of port 0; the polygons
   * are in the order of the smallest id at each place, which is this one unless DuplicatePolicy
   * takes another. Constraints and what is dropped make no difference to it; points that are added
   * are vertices, too. Cut off at the convex hull of the vertices (CLIP_TO_HULL, the default) or at
   * their bounding box in the plane (CLIP_TO_BOUNDS): VoronoiClip, one of VoronoiClips.
   *
   * The polygons are counterclockwise and share their corners, which are of double precision and
   * rounded: circumcentres that cannot be told apart, as those of a lattice's squares, are one
   * corner. Where points are so close that this is true of a whole cell, its polygon has corners in
   * the same place. On the hull, vertices are corners of their own polygons. Collinear points have
   * no polygons in their hull, which has no area, but strips in their box if that has one; a single
   * point has none.
   *
   * z is 0 in the plane x, y. Elsewhere the polygons lie where Transform, or the best fitting
   * plane, takes them from: the inverse of the transform moves them back (corners beyond the
   * largest double become infinite). If there is no inverse a warning says so, and they stay in the
   * plane z = 0. Off by default; costs up to 620 bytes per point while the filter runs, and the
   * point data once more.
   */
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
   * Counts of the last execution, 0 if it was aborted or ended in an error: points merged by
   * Tolerance; points added (of the source, around all, at crossings); distinct edges of the
   * triangulation that are constraints, those of dropped triangles included; with LEAVE_OUT the
   * segments left out as they cross others, with SPLIT the points added; segments that are no
   * constraint, as they cross others or an end of theirs is no vertex; loops that bound nothing, as
   * a segment of theirs was left out.
   */
  vtkGetMacro(NumberOfMergedPoints, vtkIdType);
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  vtkGetMacro(NumberOfConstraintEdges, vtkIdType);
  vtkGetMacro(NumberOfCrossings, vtkIdType);
  vtkGetMacro(NumberOfConstraintsLeftOut, vtkIdType);
  vtkGetMacro(NumberOfUnfilledLoops, vtkIdType);
  ///@}

  /// Wall-clock seconds of the last execution for the constraints: splitting them, making them
  /// edges, and finding what the loops keep. 0 if it was aborted or ended in an error.
  vtkGetMacro(ConstrainSeconds, double);

  /// When the filter or its Transform was changed last.
  vtkMTimeType GetMTime() override;

protected:
  vtkAdaptiveHilbertDelaunay2D();
  ~vtkAdaptiveHilbertDelaunay2D() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void ClearMeasures() override;
  void TakeMeasures(const vtkAHDReport& report) override;
  void ReadSettings(vtkAHDSettings& settings) const override;

  // Settings.
  int SourceMode = SOURCE_IDS;
  int CrossingMode = LEAVE_OUT;
  int FillRule = ORIENTATION;
  double Alpha = 0.0;
  vtkTypeBool AlphaTris = 1;
  vtkTypeBool AlphaLines = 1;
  vtkTypeBool AlphaVerts = 1;
  double MaximumEdgeLength = 0.0;
  int ProjectionPlaneMode = VTK_DELAUNAY_XY_PLANE;
  vtkAbstractTransform* Transform = nullptr;
  double Tolerance = 0.0;
  int DuplicatePolicy = FIRST;
  double Offset = 1.0;
  vtkTypeBool BoundingTriangulation = 0;
  bool MergeBlocks = false;
  bool GenerateVoronoi = false;
  int VoronoiClip = CLIP_TO_HULL;

  // Measures of the last execution.
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfConstraintEdges = 0;
  vtkIdType NumberOfCrossings = 0;
  vtkIdType NumberOfConstraintsLeftOut = 0;
  vtkIdType NumberOfUnfilledLoops = 0;
  double ConstrainSeconds = 0.0;

private:
  vtkAdaptiveHilbertDelaunay2D(const vtkAdaptiveHilbertDelaunay2D&) = delete;
  void operator=(const vtkAdaptiveHilbertDelaunay2D&) = delete;

  void Execute(vtkDataObject* input, vtkAHDDataSets& data, const vtkAHDContext& context);
  void Triangulate(const vtkAHDDataSets& data, const vtkAHDContext& context);
  bool PassOnCached(const vtkAHDDataSets& data, const vtkAHDContext& context);
  void EndWithoutMemory(const vtkAHDDataSets& data);
  void AddCounts(vtkPolyData* surface) const;
  vtkSmartPointer<vtkPointSet> MergeInput(
    vtkCompositeDataSet* blocks, vtkAHDDataSets& data, const vtkAHDContext& context);
  void WarnAboutBlocks(vtkDataObject* input);
  void WarnAboutRanks();

  const std::unique_ptr<ahd::Workspace> Workspace; // kept for the next execution
  const std::unique_ptr<vtkAHDOutputCache> Cache;  // the last execution's outputs
  bool WarnedAboutRanks = false;
};

#endif
