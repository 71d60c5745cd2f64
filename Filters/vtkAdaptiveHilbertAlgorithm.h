// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
/**
 * @class   vtkAdaptiveHilbertAlgorithm
 * @brief   settings and measures of vtkAdaptiveHilbertDelaunay2D
 *
 * The superclass of vtkAdaptiveHilbertDelaunay2D: its numeric settings and its measures. The
 * descriptions name values of settings as ParaView's panel does.
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
#include <string> // for names and texts

namespace ahd
{
class JobSettings;
struct RunReport;
}
class vtkFieldData;
struct vtkAHDSettingsOfRanks;

// The values of ProjectionPlaneMode, named as in vtkDelaunay2D.h.
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
    /// points of the source keep their own z and data
    OWN = 0,
    /// they take z and data from the surface of the input
    FROM_SURFACE = 1,
    /// those without z take both from the surface of the input and the lines with z
    MIXED = 2
  };

  /// The values of ClosedLines.
  enum ClosedLinesValues
  {
    /// they are edges, like other lines
    LINES = 0,
    /// they bound the surface, like polygons
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
    /// the convex hull in a plane of coordinates, otherwise trimmed
    AUTOMATIC = 0,
    /// the triangles cover the convex hull
    CONVEX_HULL = 1,
    /// without the flat triangles along the rim
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
    CLIP_TO_BOUNDS = 1,
    /// VoronoiPolygon
    CLIP_TO_POLYGON = 2
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
    /// off: no control points
    NO_CONTROL_POINTS = 0,
    /// one point of each box of the first level
    SINGLE_LEVEL = 1,
    /// a sparse subset of the points, before it a sparser one, and so on
    EVERY_LEVEL = 2
  };

  ///@{
  /// Triangulate the points of all blocks of a multiblock data set together, into one surface
  /// without seams, for example of lidar tiles. Point arrays that all blocks have are passed on. If
  /// off, each block becomes a surface of its own. Off by default.
  /// The points are numbered block after block. The points and their data are copied.
  vtkSetMacro(MergeBlocks, bool);
  vtkGetMacro(MergeBlocks, bool);
  vtkBooleanMacro(MergeBlocks, bool);
  ///@}

  ///@{
  /// How the source gives its lines. Coordinates: by its own points, which are added to the surface
  /// (a point with the same x and y as one of the input is not added again). Point ids: its points
  /// stand for the points of the input with the same ids, and their coordinates are ignored, as in
  /// VTK's vtkDelaunay2D. Default: SOURCE_COORDINATES in ParaView, SOURCE_IDS in VTK.
  /// Points of the source are numbered after those of the input.
  vtkSetClampMacro(SourceMode, int, SOURCE_IDS, SOURCE_COORDINATES);
  vtkGetMacro(SourceMode, int);
  void SetSourceModeToIds() { this->SetSourceMode(SOURCE_IDS); }
  void SetSourceModeToCoordinates() { this->SetSourceMode(SOURCE_COORDINATES); }
  ///@}

  ///@{
  /// The heights of the source's points. Own: their own z. Two-dimensional lines, as in most maps,
  /// lie at z = 0 and pull the surface down to it. From Surface: height and point data are
  /// interpolated linearly on the surface of the input; points outside it keep their own z, and a
  /// warning counts them. Mixed: points with a z keep it; those without (NaN, see Zero Is Missing)
  /// take theirs from the surface of the input and of the lines between points with z. Not used
  /// with Source Mode Point ids. Default: OWN.
  /// From Surface and Mixed triangulate twice: first without the points that take their heights
  /// from there, then all.
  vtkSetClampMacro(SourceHeights, int, OWN, MIXED);
  vtkGetMacro(SourceHeights, int);
  void SetSourceHeightsToOwn() { this->SetSourceHeights(OWN); }
  void SetSourceHeightsToFromSurface() { this->SetSourceHeights(FROM_SURFACE); }
  void SetSourceHeightsToMixed() { this->SetSourceHeights(MIXED); }
  ///@}

  ///@{
  /// With Source Heights Mixed, points of the source with z = 0 have no height, too. For files and
  /// readers that give 0 where there is none. Off by default.
  vtkSetMacro(ZeroIsMissing, bool);
  vtkGetMacro(ZeroIsMissing, bool);
  vtkBooleanMacro(ZeroIsMissing, bool);
  ///@}

  ///@{
  /// With Source Heights From Surface or Mixed, add a point where a line of the source crosses an
  /// edge of the surface that its heights come from, so that the line follows the terrain. If off,
  /// it runs straight from point to point, through the air and below ground. With Mixed, a line
  /// between two points with z is straight. On by default.
  /// A place is the exact crossing, rounded once, as with CrossingMode SPLIT; lines with a point at
  /// one place share it.
  vtkSetMacro(SourceLinesOnSurface, bool);
  vtkGetMacro(SourceLinesOnSurface, bool);
  vtkBooleanMacro(SourceLinesOnSurface, bool);
  ///@}

  ///@{
  /// Divide segments of the source that are longer than this, in the plane of the triangulation,
  /// into equal parts, by points that are added. 0: none is divided. Default 0, at least 0.
  /// After points were added on the surface (SourceLinesOnSurface), each piece is divided by
  /// itself. The new points take heights and data as the line does: from the surface, or linearly
  /// between the ends of the piece.
  virtual void SetMaximumSegmentLength(double value);
  vtkGetMacro(MaximumSegmentLength, double);
  ///@}

  ///@{
  /// How lines of the source that end where they begin are treated. Lines: as edges of the surface,
  /// like other lines; right for contours. Loops: as outlines that bound the surface, like
  /// polygons; right for coastlines, lakes and borders from GeoJSON, shapefiles and .csv, which
  /// come as lines. Lines that meet end to end, as those of Extract Surface and Feature Edges, are
  /// joined to such outlines. Default: LINES.
  /// A line is closed if its ends are the same point or have the same x and y in the plane of the
  /// triangulation. Others are joined where two of them end, and no third; those that do not close
  /// then stay lines of their own. In the order of the constraints, loops come after the other
  /// lines.
  vtkSetClampMacro(ClosedLines, int, LINES, LOOPS);
  vtkGetMacro(ClosedLines, int);
  void SetClosedLinesToLines() { this->SetClosedLines(LINES); }
  void SetClosedLinesToLoops() { this->SetClosedLines(LOOPS); }
  ///@}

  ///@{
  /// Take the points of a source that has nothing but points as one line, in their order: a table
  /// of points along a shore or a road. If the first and the last have the same x and y, the line
  /// is closed (see Closed Lines). A source with lines, polygons or triangle strips has its own.
  /// Not used with Source Mode Point ids. Off by default.
  vtkSetMacro(PointsAsLine, bool);
  vtkGetMacro(PointsAsLine, bool);
  vtkBooleanMacro(PointsAsLine, bool);
  ///@}

  ///@{
  /// Which side of the outlines (polygons and loops of the source) is kept. Even-odd: the inside of
  /// an odd number of outlines, whatever their direction. Orientation, as in vtkDelaunay2D: the
  /// left side of each, so counterclockwise outlines are filled, clockwise ones are holes, and they
  /// may be nested; outlines in shapefiles run the other way. Default: EVEN_ODD in ParaView,
  /// ORIENTATION in VTK.
  /// With Orientation, regions that no loop bounds are kept, too. Without loops, all triangles are
  /// kept.
  vtkSetClampMacro(FillRule, int, ORIENTATION, EVEN_ODD);
  vtkGetMacro(FillRule, int);
  void SetFillRuleToOrientation() { this->SetFillRule(ORIENTATION); }
  void SetFillRuleToEvenOdd() { this->SetFillRule(EVEN_ODD); }
  ///@}

  ///@{
  /// How two lines of the source that cross between their points are treated. Leave out: the later
  /// of the two segments is left out and counted (Number Of Crossings), and an outline that lacks a
  /// segment bounds nothing. Split: a point is added at the crossing, with height and data from
  /// both lines, and no segment is left out. Default: LEAVE_OUT.
  /// Lines come before polygons, then cells in their order. The height and data of an added point
  /// are the mean of those interpolated linearly along the two segments.
  vtkSetClampMacro(CrossingMode, int, LEAVE_OUT, SPLIT);
  vtkGetMacro(CrossingMode, int);
  void SetCrossingModeToLeaveOut() { this->SetCrossingMode(LEAVE_OUT); }
  void SetCrossingModeToSplit() { this->SetCrossingMode(SPLIT); }
  ///@}

  ///@{
  /// Remove every triangle with an edge longer than this, measured in the plane of the
  /// triangulation, in the units of the points. A survey then gets its concave outline instead of
  /// the convex hull. 0: no limit. Default 0, at least 0.
  /// Longer lines of Alpha are removed, too.
  virtual void SetMaximumEdgeLength(double value);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /// The alpha shape, as in Delaunay 2D: triangles with a circumradius of at most Alpha; as lines,
  /// edges of at most 2 Alpha that belong to none of these triangles; as vertices, points that
  /// belong to neither. Radii and lengths are measured in space, z included. 0: off, all triangles.
  /// Default 0, at least 0.
  /// Reference.md says where it differs from vtkDelaunay2D.
  virtual void SetAlpha(double value);
  virtual double GetAlphaMinValue() { return 0.0; }
  virtual double GetAlphaMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Alpha, double);
  ///@}

  ///@{
  /// Output the triangles of the alpha shape. On by default.
  vtkSetMacro(AlphaTris, vtkTypeBool);
  vtkGetMacro(AlphaTris, vtkTypeBool);
  vtkBooleanMacro(AlphaTris, vtkTypeBool);
  ///@}

  ///@{
  /// Output, as lines, the edges of the alpha shape that belong to none of its triangles. On by
  /// default.
  vtkSetMacro(AlphaLines, vtkTypeBool);
  vtkGetMacro(AlphaLines, vtkTypeBool);
  vtkBooleanMacro(AlphaLines, vtkTypeBool);
  ///@}

  ///@{
  /// Output, as vertices, the points of the alpha shape that belong to none of its triangles and
  /// lines. On by default.
  vtkSetMacro(AlphaVerts, vtkTypeBool);
  vtkGetMacro(AlphaVerts, vtkTypeBool);
  vtkBooleanMacro(AlphaVerts, vtkTypeBool);
  ///@}

  ///@{
  /// Leave out points as long as the surface differs at none of them by more than this, vertically
  /// (in a fitted plane: along its normal), in the units of z. Corners of the convex hull and
  /// points of lines and outlines stay. Largest Error is the largest that is left, Number Of Points
  /// Within Error the number left out. 0: off, all points. Default 0, at least 0.
  /// The bound holds at all points that represent a place, and is checked in wider arithmetic. It
  /// is not combined with Insertion Limit, Alpha, or the mean of DuplicatePolicy: these are
  /// refused.
  virtual void SetMaximumError(double value);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /// The best surface of so many points: those are left out without which it differs least from
  /// all. Largest Error says by how much. With Maximum Error, too, it ends at whichever comes
  /// first. 0: no limit. Default 0, at least 0.
  /// Points that stay in any case, see MaximumError, are never too many.
  vtkSetClampMacro(MaximumNumberOfVertices, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfVertices, vtkIdType);
  ///@}

  ///@{
  /// With Maximum Error or Maximum Number Of Vertices: at the end take points out again as long as
  /// the error stays within the bound. It takes longer, and leaves 5 to 20 % fewer. Off by default.
  vtkSetMacro(SecondPass, bool);
  vtkGetMacro(SecondPass, bool);
  vtkBooleanMacro(SecondPass, bool);
  ///@}

  ///@{
  /// With Maximum Error or Maximum Number Of Vertices: the surface has the points of its triangles
  /// only, with their ids in the input as the point array OriginalPointIds. With the status of
  /// points or errors, which are about all points, it has all. On by default.
  vtkSetMacro(KeptPointsOnly, bool);
  vtkGetMacro(KeptPointsOnly, bool);
  vtkBooleanMacro(KeptPointsOnly, bool);
  ///@}

  ///@{
  /// The point array, of one number for each point, of which Maximum Error is the error, in place
  /// of z. Where it is NaN the point stays. Points of the source have the values of their own array
  /// of this name. Empty or "None": z. Default "".
  /// DuplicatePolicy still chooses by z which of several points at one place is the vertex.
  virtual void SetValueArrayName(const std::string& name);
  virtual std::string GetValueArrayName() { return this->ValueArrayName; }
  ///@}

  ///@{
  /// The point array of weights: numbers times which the errors of points count. Where one is
  /// negative or NaN the point stays. Points that are added have the weight 1. Empty or "None": all
  /// have. Default "".
  virtual void SetWeightArrayName(const std::string& name);
  virtual std::string GetWeightArrayName() { return this->WeightArrayName; }
  ///@}

  ///@{
  /// The point array of marks: where one is not 0 the point stays. Empty or "None": no marks.
  /// Default "".
  virtual void SetKeepArrayName(const std::string& name);
  virtual std::string GetKeepArrayName() { return this->KeepArrayName; }
  ///@}

  ///@{
  /// The plane in which the points are triangulated. XY plane: z is the height. Transform plane: x
  /// and y after the Transform. Best-fitting plane: the plane with the least sum of squared
  /// distances from the points, for a rock face or a scanned wall. The output has the points at
  /// their original positions. Default: VTK_DELAUNAY_XY_PLANE.
  /// After a transform or in a fitted plane, the triangulation is exact for the coordinates there,
  /// rounded to double precision, and duplicates are determined there. In the x, y plane a
  /// Transform is applied if one is set; in the transform plane a missing Transform causes a
  /// warning. For the best-fitting plane see ComputeBestFittingPlane; Transform is not used.
  vtkSetClampMacro(ProjectionPlaneMode, int, VTK_DELAUNAY_XY_PLANE, VTK_BEST_FITTING_PLANE);
  vtkGetMacro(ProjectionPlaneMode, int);
  ///@}

  ///@{
  /// Where the surface ends if no outline bounds it. Convex hull: it has all triangles. Trimmed:
  /// without the flat triangles along the rim, those with an angle above 158 degrees whose longest
  /// edge lies there; in a fitted plane these stand as walls along a rim that is straight in space.
  /// Automatic: the convex hull in the XY plane, and in the best-fitting plane of points that all
  /// have the same z, x or y; otherwise trimmed. No effect with Alpha, Maximum Edge Length or
  /// Bounding Triangulation. Number Of Trimmed Triangles counts the triangles removed. Default:
  /// AUTOMATIC.
  /// The angle is exactly 180 degrees less the arc tangent of 2/5. Triangles that thereby come to
  /// the rim are trimmed likewise. Constraints stay edges. A warning appears if a point is left
  /// without a triangle or a tenth of the area is removed.
  vtkSetClampMacro(Rim, int, AUTOMATIC, TRIMMED);
  vtkGetMacro(Rim, int);
  void SetRimToAutomatic() { this->SetRim(AUTOMATIC); }
  void SetRimToConvexHull() { this->SetRim(CONVEX_HULL); }
  void SetRimToTrimmed() { this->SetRim(TRIMMED); }
  ///@}

  ///@{
  /// Merge points that are closer to each other than this fraction of the diagonal of the points'
  /// bounding box, in the plane of the triangulation. 0: only points with exactly the same x and y
  /// are merged. Number Of Merged Points counts the points merged beyond these; Generate Point
  /// Status shows into which point. From 0 to 1. Default 0.
  /// Points are processed in lexicographic order of x, y; a point within that distance of vertices
  /// is merged into the nearest. Constraints follow. vtkDelaunay2D's default is 1e-5, of the
  /// diagonal in space.
  virtual void SetTolerance(double value);
  virtual double GetToleranceMinValue() { return 0.0; }
  virtual double GetToleranceMaxValue() { return 1.0; }
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Which of the points with the same x and y becomes the vertex and gives the surface its height.
  /// First: the point with the smallest id. Lowest z, highest z: the deepest or the shoalest
  /// sounding, for example. Mean z: the first point, at the mean of the heights. Default: FIRST.
  /// Finite heights take precedence; the mean is that of all finite heights, in a copy of the
  /// points. Merged points do not count. Changes ids and z, never the shape in the plane.
  vtkSetClampMacro(DuplicatePolicy, int, FIRST, MEAN_Z);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToFirst() { this->SetDuplicatePolicy(FIRST); }
  void SetDuplicatePolicyToLowestZ() { this->SetDuplicatePolicy(LOWEST_Z); }
  void SetDuplicatePolicyToHighestZ() { this->SetDuplicatePolicy(HIGHEST_Z); }
  void SetDuplicatePolicyToMeanZ() { this->SetDuplicatePolicy(MEAN_Z); }
  ///@}

  ///@{
  /// Add a point array, Fate, with the status of each point: its own id if it is a vertex of the
  /// surface; the id of another point if it is a duplicate of it or was merged into it; -1 if it
  /// was rejected, because x or y is NaN or infinite; -2 if it was not inserted, because it is
  /// marked as a ghost or hidden, is beyond the Insertion Limit, or is a duplicate of a point
  /// beyond it; -3 if it is within Maximum Error. Switch it on to find the points that are not in
  /// the surface. Off by default.
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
  /// Add a point array, Error: how far the surface is from each point, vertically, or in a fitted
  /// plane along its normal. 0 for vertices; NaN where there is no surface, and for points that
  /// were rejected or skipped. With Value Array Name it is the difference of these values. Off by
  /// default.
  /// A vtkDoubleArray. Weights do not change it. The largest of all points that MaximumError left
  /// out is LargestError, if there are no weights.
  vtkSetMacro(GenerateErrors, bool);
  vtkGetMacro(GenerateErrors, bool);
  vtkBooleanMacro(GenerateErrors, bool);
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
  /// Fill the third output, Voronoi, with a polygon for each vertex: the region that is nearer to
  /// it than to any other vertex. The polygons lie at z = 0 and have the point data of their
  /// vertices as cell data. In ParaView: the filter Voronoi Cells 2D (Adaptive Hilbert). Off by
  /// default.
  /// Output port 2: convex counterclockwise polygons, with the vertex's id as "OriginalPointIds"
  /// (vtkIdTypeArray). Corners are those of the exact polygons, rounded once to double precision;
  /// corners that differ by at most 4 units in the last place may be merged. Constraints are
  /// ignored.
  vtkSetMacro(GenerateVoronoi, bool);
  vtkGetMacro(GenerateVoronoi, bool);
  vtkBooleanMacro(GenerateVoronoi, bool);
  ///@}

  ///@{
  /// Where the polygons of the Voronoi diagram, of which the outer ones are unbounded, are clipped.
  /// Hull: at the convex hull of the points. Bounds: at their bounding box. Polygon: at Voronoi
  /// Polygon. Default: CLIP_TO_HULL.
  /// Hull and bounds are those of the vertices, in the plane of the triangulation.
  vtkSetClampMacro(VoronoiClip, int, CLIP_TO_HULL, CLIP_TO_POLYGON);
  vtkGetMacro(VoronoiClip, int);
  void SetVoronoiClipToHull() { this->SetVoronoiClip(CLIP_TO_HULL); }
  void SetVoronoiClipToBounds() { this->SetVoronoiClip(CLIP_TO_BOUNDS); }
  void SetVoronoiClipToPolygon() { this->SetVoronoiClip(CLIP_TO_POLYGON); }
  ///@}

  ///@{
  /// Two opposite corners of a box, or the corners of a convex polygon in their order: x y, x y,
  /// ... in the plane of the triangulation. The Voronoi polygon of each vertex is the part of it
  /// that is nearer to that vertex than to any other, however few or collinear the vertices are;
  /// vertices without a part have none. Used if Voronoi Clip is Polygon. Default "".
  /// Numbers are separated by blanks, commas or semicolons. Corners that are no convex polygon are
  /// an error of the execution.
  virtual void SetVoronoiPolygon(const std::string& name);
  virtual std::string GetVoronoiPolygon() { return this->VoronoiPolygon; }
  ///@}

  ///@{
  /// The order in which the points are inserted. It changes the time, never the triangles. Adaptive
  /// Hilbert (HG), the fastest: boxes, divided where points are crowded, visited along a Hilbert
  /// curve. Multi-grid (MG): the same boxes, visited line by line. Regular grid (RG): boxes of one
  /// size, visited line by line. As given: the order of the input; very slow for points in random
  /// order. Change it to compare. Default: ADAPTIVE_HILBERT.
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
  /// outputs the boxes. Otherwise it has none, since the curve continues inside the boxes down to
  /// single points, and ParaView greys it out. Default 50, at least 1.
  vtkSetClampMacro(Nmax, int, 1, VTK_INT_MAX);
  vtkGetMacro(Nmax, int);
  ///@}

  ///@{
  /// A sparse subset of the points, inserted before all others so that fewer long thin triangles
  /// are built and removed again. It changes the time, never the triangles. Off: none. First level:
  /// one point of each box of the first division, as Su et al. do. Every level: a sparse subset of
  /// the points, a sparser subset of that, and so on, inserted from coarse to fine. Used by
  /// Adaptive Hilbert and Multi-grid. Change it to compare. Default: EVERY_LEVEL.
  vtkSetClampMacro(ControlPoints, int, NO_CONTROL_POINTS, EVERY_LEVEL);
  vtkGetMacro(ControlPoints, int);
  void SetControlPointsToNone() { this->SetControlPoints(NO_CONTROL_POINTS); }
  void SetControlPointsToSingleLevel() { this->SetControlPoints(SINGLE_LEVEL); }
  void SetControlPointsToEveryLevel() { this->SetControlPoints(EVERY_LEVEL); }
  ///@}

  ///@{
  /// Turn the Hilbert curve in each divided box so that it connects to the curve in the boxes
  /// before and after (the paper's "gene"). If off, the curve jumps between boxes, and after each
  /// jump the search for the next point starts farther away. It changes the time, never the
  /// triangles. Used by Adaptive Hilbert. Change it to compare. On by default.
  vtkSetMacro(GeneRotation, bool);
  vtkGetMacro(GeneRotation, bool);
  vtkBooleanMacro(GeneRotation, bool);
  ///@}

  ///@{
  /// Count the triangles tested to locate each point (NP) and the triangles removed to insert it
  /// (NR). Switch it on to compare insertion orders by their work, which is the same on every
  /// machine, rather than by seconds. Counting takes time, and one thread inserts; it never changes
  /// the triangles. Off by default.
  vtkSetMacro(CountWork, bool);
  vtkGetMacro(CountWork, bool);
  vtkBooleanMacro(CountWork, bool);
  ///@}

  ///@{
  /// Stop after this number of points: the surface is the triangulation of these alone. 0, or any
  /// number that is large enough: all points. The insertion settings determine which points come
  /// first. In ParaView move the slider, or animate it, to watch the surface grow: both go from 3,
  /// the fewest points that can form a triangle, to the number of points; for all points type 0.
  /// Default 0, at least 0.
  /// Only distinct points count. The others are in no triangle; NumberOfPointsBeyondLimit counts
  /// them. With a limit, one thread inserts.
  vtkSetClampMacro(InsertionLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(InsertionLimit, vtkIdType);
  ///@}

  ///@{
  /// Add a point array, InsertionRank: the position of each point in the order of insertion, from
  /// 0; -1 for duplicates, rejected and skipped points. Colour by it to see the order. Off by
  /// default.
  /// The array is a vtkIdTypeArray; the order is that of one thread.
  vtkSetMacro(GenerateInsertionRank, bool);
  vtkGetMacro(GenerateInsertionRank, bool);
  vtkBooleanMacro(GenerateInsertionRank, bool);
  ///@}

  ///@{
  /// Add a line through the inserted points, in the order of insertion, to the second output,
  /// Insertion order. Its point array InsertionRank counts along the line; OriginalPointIds has the
  /// points' ids in the input. Off by default.
  /// Output port 1.
  vtkSetMacro(GenerateInsertionCurve, bool);
  vtkGetMacro(GenerateInsertionCurve, bool);
  vtkBooleanMacro(GenerateInsertionCurve, bool);
  ///@}

  ///@{
  /// Add the boxes of the grid that determines the order to the second output, Insertion order: the
  /// boxes that are not divided further, in the order in which they are visited, at the height of
  /// the lowest point. Cell arrays: Level, the number of divisions that made the box; Count, the
  /// number of points in it. The order As given has no boxes. Off by default.
  /// Output port 1; about 300 bytes a box.
  vtkSetMacro(GenerateBoxes, bool);
  vtkGetMacro(GenerateBoxes, bool);
  vtkBooleanMacro(GenerateBoxes, bool);
  ///@}

  ///@{
  /// As in Delaunay 2D: how far away the eight points of Bounding Triangulation are. No other
  /// effect. Default 1, at least 0.75.
  /// In multiples of the diagonal, in space, of the bounding box.
  virtual void SetOffset(double value);
  virtual double GetOffsetMinValue() { return 0.75; }
  virtual double GetOffsetMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /// As in Delaunay 2D: add eight points on a circle around all others, and the triangles that
  /// connect them. Only if the points are triangulated in x and y. Off by default.
  /// The circle is centred on the bounding box. In other planes there is a warning.
  vtkSetMacro(BoundingTriangulation, vtkTypeBool);
  vtkGetMacro(BoundingTriangulation, vtkTypeBool);
  vtkBooleanMacro(BoundingTriangulation, vtkTypeBool);
  ///@}

  ///@{
  /// No effect: present for scripts written for vtkDelaunay2D. Insertion Order sets the order of
  /// insertion, which never changes the triangles. Off by default.
  vtkSetMacro(RandomPointInsertion, vtkTypeBool);
  vtkGetMacro(RandomPointInsertion, vtkTypeBool);
  vtkBooleanMacro(RandomPointInsertion, vtkTypeBool);
  ///@}

  ///@{
  /// No effect: present for scripts written for vtkDelaunay2D. Points are inserted along a Hilbert
  /// curve anyway, unless Insertion Order says otherwise. Off by default.
  vtkSetMacro(UseHilbertSorter, vtkTypeBool);
  vtkGetMacro(UseHilbertSorter, vtkTypeBool);
  vtkBooleanMacro(UseHilbertSorter, vtkTypeBool);
  ///@}

  ///@{
  /// The number of threads. It changes the time, never the triangles. 0: one for each processor
  /// that the program (ParaView; with a server, the server) may use, unless VTK is limited to
  /// fewer, for example by the environment variable VTK_SMP_MAX_THREADS. 1 to 1024: exactly this
  /// number. Set it if other programs need processors, too. With Count Work, an Insertion Limit,
  /// another Insertion Order than Adaptive Hilbert, or insertion settings other than the defaults,
  /// one thread inserts the points; also if there are few points. From 0 to 1024. Default 0.
  /// The calling thread is one of them; only there is progress reported and an abort checked. 0
  /// also respects vtkSMPTools::Initialize(n).
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// On a server with several ranks: triangulate the points of all ranks together, into one surface
  /// without seams, with exactly the triangles that one rank would give. Each point moves to the
  /// rank that owns its location, with the point arrays that all ranks have; downstream filters get
  /// the ghost cells they request. If off, each rank triangulates its own points. With some
  /// settings one rank computes the whole surface; a warning says so once. All ranks must update
  /// the filter: a script of pvbatch --sym that updates it on one rank alone never returns. No
  /// effect with one rank, nor in the class and plugin in Python, where each rank works on its own.
  /// On by default in ParaView, off in VTK.
  /// If off, there is a warning with several ranks. The ranks are those of Controller. The
  /// triangles are those of one rank that has all inputs and sources, appended in the order of the
  /// ranks. All ranks must update with the same settings: if one executes, all do. Each outputs the
  /// triangles that it owns, by location, with its points, and after these the points of other
  /// ranks that are corners, with vtkGhostType DUPLICATEPOINT. Layers of ghost cells are marked as
  /// well. The global ids "GlobalPointIds" number the points as appended, those of sources last;
  /// "GlobalCellIds" the triangles. Counts are those of all ranks. Ids in the source's cells refer
  /// to the rank's own points. Sources that are the same on all ranks count once if their points
  /// are added. A failure on one rank is one error on each. With settings that have no method for
  /// several ranks, one rank triangulates all points and outputs the whole surface, if its memory
  /// suffices; a warning names the first such setting, and Reference.md lists them. With
  /// MergeBlocks off, block k of all ranks is triangulated by itself, for each k.
  vtkSetMacro(DistributePoints, bool);
  vtkGetMacro(DistributePoints, bool);
  vtkBooleanMacro(DistributePoints, bool);
  ///@}

  ///@{
  /// Reuse triangles while points, source and settings stay the same, as in time steps in which
  /// only the arrays change: from the third run on, the triangles are passed on, with the current
  /// arrays. Switch it off to triangulate in each run. On by default.
  /// Coordinates, ghost marks, source and settings are compared; point data and field data are the
  /// current ones.
  vtkSetMacro(KeepTriangulation, bool);
  vtkGetMacro(KeepTriangulation, bool);
  vtkBooleanMacro(KeepTriangulation, bool);
  ///@}

  ///@{
  /// The most memory the filter may use beyond its input, in kibibytes (1024 bytes). A run that is
  /// estimated to need more is refused with an error before anything is computed. 0: the memory
  /// that the machine has left. Set it if other programs need memory, too. Default 0, at least 0.
  /// The output is included. 0 also respects the limits of the process. With GenerateBoxes the
  /// error comes before any point is inserted.
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the filter keeps to make its next run faster:
  /// working memory, and the memory of former outputs. Memory beyond that is freed after each run.
  /// The default, 256 MiB, is enough for 2 million points. 0 keeps nothing. Raise it for larger
  /// data that change in time, lower it if many such filters are in one pipeline. Default 262144,
  /// at least 0.
  /// Working memory comes first: a run that took more, failed or was aborted frees all of it.
  /// Within the limit a triangulation stays whole until the next execution, for filters that
  /// interpolate on its surface. The rest of the limit is for the memory of outputs that have been
  /// released.
  vtkSetClampMacro(ReuseLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(ReuseLimit, vtkTypeInt64);
  ///@}

  ///@{
  /// Triangles of the surface, in the last run.
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// Points that are vertices of the surface, in the last run.
  /// Counts are 0 if the run was aborted or failed; otherwise those of points add up to all points,
  /// added ones included.
  vtkGetMacro(NumberOfPointsInserted, vtkIdType);
  ///@}

  ///@{
  /// Points with the same x and y as an earlier point, in the last run. They are not in the
  /// surface.
  vtkGetMacro(NumberOfDuplicates, vtkIdType);
  ///@}

  ///@{
  /// Points that were merged into another by Tolerance, in the last run. Points with exactly the
  /// same x and y are counted as duplicates.
  vtkGetMacro(NumberOfMergedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points of the surface that are not in the input, in the last run: points of the source, points
  /// at crossings, and those of Bounding Triangulation.
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points rejected because x or y is NaN or infinite, in the last run. They are not in the
  /// surface.
  vtkGetMacro(NumberOfRejectedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points skipped because they are marked as ghosts or hidden, in the last run.
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);
  ///@}

  ///@{
  /// Points that are not in the surface because of the Insertion Limit, in the last run.
  vtkGetMacro(NumberOfPointsBeyondLimit, vtkIdType);
  ///@}

  ///@{
  /// Points that Maximum Error or Maximum Number Of Vertices left out, in the last run.
  vtkGetMacro(NumberOfPointsWithinError, vtkIdType);
  ///@}

  ///@{
  /// Edges of the triangulation that are edges of the source, in the last run.
  /// Edges of removed triangles are included.
  vtkGetMacro(NumberOfConstraintEdges, vtkIdType);
  ///@}

  ///@{
  /// Segments of the source left out because they cross an earlier one, in the last run; with
  /// Crossing Mode Split, the points added where segments cross. The field data array Crossings
  /// lists the lines.
  vtkGetMacro(NumberOfCrossings, vtkIdType);
  ///@}

  ///@{
  /// Points added to lines of the source, in the last run, where they cross edges of the surface
  /// (Source Lines On Surface) or are divided (Maximum Segment Length).
  vtkGetMacro(NumberOfAddedLinePoints, vtkIdType);
  ///@}

  ///@{
  /// With Crossing Mode Split: segments of the source that bend by rounding, in the last run,
  /// because they pass through a point that is not exactly on them.
  vtkGetMacro(NumberOfBentConstraints, vtkIdType);
  ///@}

  ///@{
  /// Segments of the source left out of the triangulation, in the last run: they cross another, or
  /// an end is not a vertex.
  vtkGetMacro(NumberOfConstraintsLeftOut, vtkIdType);
  ///@}

  ///@{
  /// Outlines that bound nothing because one of their segments was left out, in the last run.
  vtkGetMacro(NumberOfUnfilledLoops, vtkIdType);
  ///@}

  ///@{
  /// Flat triangles that Rim removed, in the last run.
  vtkGetMacro(NumberOfTrimmedTriangles, vtkIdType);
  ///@}

  ///@{
  /// The largest vertical distance from the surface of a point that Maximum Error or Maximum Number
  /// Of Vertices left out, in the last run.
  vtkGetMacro(LargestError, double);
  ///@}

  ///@{
  /// Triangles tested to locate a point, per inserted point, in the last run. The time to locate
  /// points is proportional to it. -1 if it was not counted: switch Count Work on.
  /// The triangle where the search starts is included.
  vtkGetMacro(NP, double);
  ///@}

  ///@{
  /// Triangles removed to insert a point, per inserted point, in the last run. The time to update
  /// the triangles is proportional to it. -1 if it was not counted: switch Count Work on.
  vtkGetMacro(NR, double);
  ///@}

  ///@{
  /// Wall-clock seconds to read the points and sort them into the order of insertion, in the last
  /// run.
  /// Seconds are 0 if triangles were passed on.
  vtkGetMacro(SortSeconds, double);
  ///@}

  ///@{
  /// Wall-clock seconds to insert the points, in the last run.
  vtkGetMacro(InsertSeconds, double);
  ///@}

  ///@{
  /// Wall-clock seconds to insert the lines of the source as edges, in the last run.
  vtkGetMacro(ConstrainSeconds, double);
  ///@}

  ///@{
  /// Wall-clock seconds to write the triangles in their canonical order, in the last run.
  vtkGetMacro(OutputSeconds, double);
  ///@}

  ///@{
  /// Threads that shared the work of the last run; 1 if there was too little work to share.
  vtkGetMacro(NumberOfThreadsUsed, int);
  ///@}

  ///@{
  /// How often this filter has triangulated since it was created; runs that passed on existing
  /// triangles do not count.
  vtkGetMacro(NumberOfTriangulations, int);
  ///@}

  ///@{
  /// The most memory, in kibibytes (1024 bytes), that the last run may have needed beyond its
  /// input, or was refused: the number that is compared with Memory Limit.
  /// After too many crossings: the estimate for one more than fits.
  vtkGetMacro(MemoryEstimate, vtkTypeInt64);
  ///@}

  /// What the last run found, as a text with a line for each number. Numbers that are 0 are left
  /// out, but for the first. Empty before a run.
  virtual std::string GetMeasures();

  /// What the last run took, as a text with a line for each number: seconds of wall-clock time,
  /// threads, memory. Numbers that are 0 are left out, but for the first. Empty before a run.
  virtual std::string GetResources();

protected:
  vtkAdaptiveHilbertAlgorithm();
  ~vtkAdaptiveHilbertAlgorithm() override;

  /// Sets all measures to their values after a failed execution.
  void ClearMeasures();

  /// Sets those that an engine's report has.
  void TakeMeasures(const ahd::RunReport& report);

  /// Sets those that are seconds to 0.
  void ClearSeconds();

  /// Adds the measures that are counts as arrays of one value with their names.
  void AddCounts(vtkFieldData* data) const;

  /// Sets the settings that a job of the engine has, too.
  void GetJobSettings(ahd::JobSettings& settings) const;

  /// Throws std::bad_alloc.
  void GetSettingsOfRanks(vtkAHDSettingsOfRanks& settings) const;

  // Settings.
  bool MergeBlocks = false;
  int SourceMode = SOURCE_IDS;
  int SourceHeights = OWN;
  bool ZeroIsMissing = false;
  bool SourceLinesOnSurface = true;
  double MaximumSegmentLength = 0.0;
  int ClosedLines = LINES;
  bool PointsAsLine = false;
  int FillRule = ORIENTATION;
  int CrossingMode = LEAVE_OUT;
  double MaximumEdgeLength = 0.0;
  double Alpha = 0.0;
  vtkTypeBool AlphaTris = 1;
  vtkTypeBool AlphaLines = 1;
  vtkTypeBool AlphaVerts = 1;
  double MaximumError = 0.0;
  vtkIdType MaximumNumberOfVertices = 0;
  bool SecondPass = false;
  bool KeptPointsOnly = true;
  std::string ValueArrayName = "";
  std::string WeightArrayName = "";
  std::string KeepArrayName = "";
  int ProjectionPlaneMode = VTK_DELAUNAY_XY_PLANE;
  int Rim = AUTOMATIC;
  double Tolerance = 0.0;
  int DuplicatePolicy = FIRST;
  bool GeneratePointStatus = false;
  bool GenerateErrors = false;
  bool GenerateConstraintEdges = false;
  bool GenerateRegionIds = false;
  bool GenerateNeighbors = false;
  bool GenerateVoronoi = false;
  int VoronoiClip = CLIP_TO_HULL;
  std::string VoronoiPolygon = "";
  int InsertionOrder = ADAPTIVE_HILBERT;
  int Nmax = 50;
  int ControlPoints = EVERY_LEVEL;
  bool GeneRotation = true;
  bool CountWork = false;
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

  // Measures of the last execution.
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfPointsInserted = 0;
  vtkIdType NumberOfDuplicates = 0;
  vtkIdType NumberOfMergedPoints = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfRejectedPoints = 0;
  vtkIdType NumberOfSkippedPoints = 0;
  vtkIdType NumberOfPointsBeyondLimit = 0;
  vtkIdType NumberOfPointsWithinError = 0;
  vtkIdType NumberOfConstraintEdges = 0;
  vtkIdType NumberOfCrossings = 0;
  vtkIdType NumberOfAddedLinePoints = 0;
  vtkIdType NumberOfBentConstraints = 0;
  vtkIdType NumberOfConstraintsLeftOut = 0;
  vtkIdType NumberOfUnfilledLoops = 0;
  vtkIdType NumberOfTrimmedTriangles = 0;
  double LargestError = 0.0;
  double NP = -1.0;
  double NR = -1.0;
  double SortSeconds = 0.0;
  double InsertSeconds = 0.0;
  double ConstrainSeconds = 0.0;
  double OutputSeconds = 0.0;
  int NumberOfThreadsUsed = 0;
  vtkTypeInt64 MemoryEstimate = 0;

  // Measures of all executions.
  int NumberOfTriangulations = 0;

private:
  vtkAdaptiveHilbertAlgorithm(const vtkAdaptiveHilbertAlgorithm&) = delete;
  void operator=(const vtkAdaptiveHilbertAlgorithm&) = delete;
};

#endif
