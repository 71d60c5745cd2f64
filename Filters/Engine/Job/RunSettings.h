// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RunSettings_h
#define ahd_RunSettings_h

#include "../Constraints.h"
#include "../Options.h"
#include "../Prepare/Prepare.h"
#include "../Surface/Plane.h"
#include "../Surface/Selection.h"
#include "../Voronoi/Voronoi.h"
#include "ArrayRows.h"
#include "Words.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ahd
{

/// Why a simplified surface is not possible: what the setting would do is not defined for one.
enum class Conflict
{
  None,
  InsertionLimit,
  Alpha,
  MeanZ
};

/// The settings of a run, and what they imply.
struct RunSettings
{
  Options options;         ///< the run sets Options::mostBoxes
  bool showsMeans = false; ///< of places with several points, in space
  bool idsAreOfInput = true;
  bool closedLinesAreLoops = false;
  bool pointsAreLine = false;                       ///< of a source that has nothing else
  SourceHeights sourceHeights = SourceHeights::Own; ///< of source points that are added
  bool zeroIsMissing = false;
  bool linesOnSurface = true;
  double maximumSegmentLength = 0.0;
  bool split = false;
  FillRule fillRule = FillRule::Orientation;
  PlaneKind plane = PlaneKind::Xy;
  std::size_t unfittedPoints = 0;
  double tolerance = 0.0;
  bool bounding = false;
  double offset = 1.0;
  RimKind rim = RimKind::ConvexHull;
  SizeLimits limits;
  double maximumError = 0.0;               ///< of a simplified surface; 0: no bound
  std::size_t maximumNumberOfVertices = 0; ///< of one; 0: no limit
  bool secondPass = false;                 ///< of one: SimplifyRequest::secondPass
  bool hasValues = false, hasWeights = false, hasMarks = false; ///< PointNumbers, for the estimate
  VoronoiClip voronoiClip = VoronoiClip::Hull;
  std::vector<Point> voronoiPolygon; ///< its corners; empty unless it clips the cells

  // The requested outputs.
  std::array<bool, kWantedArrays> wanted = {};
  bool curve = false;
  bool voronoi = false;
  bool samples = false; ///< values are interpolated: tables of the surface, and no cells

  bool wants(WantedArray array) const { return wanted[std::size_t(array)]; }
  /// Bytes of the wanted arrays for each cell, or for each point.
  std::size_t bytesOfArrays(bool ofCells) const
  {
    std::size_t bytes = 0;
    for (std::size_t k = 0; k < kWantedArrays; ++k)
    {
      bytes += wanted[k] && kWantedRows[k].isOfCells == ofCells ? kWantedRows[k].bytes : 0;
    }
    return bytes;
  }
  /// The time to write them; that of a plain triangulation is 1.
  double timeOfArrays() const
  {
    double time = 0.0;
    for (std::size_t k = 0; k < kWantedArrays; ++k)
    {
      time += wanted[k] ? kWantedRows[k].time : 0.0;
    }
    return time;
  }

  /// Are the cells of a Voronoi diagram clipped at a polygon?
  bool clipsAtPolygon() const { return voronoi && voronoiClip == VoronoiClip::Polygon; }
  /// Have points of the source heights of a surface?
  bool laysSource() const { return sourceHeights != SourceHeights::Own; }
  /// Is the plane another than x, y?
  bool isProjected() const { return plane != PlaneKind::Xy; }
  /// Must the plane be fitted?
  bool fitsPlane() const { return plane == PlaneKind::BestFit; }
  /// Is a bounding triangulation added?
  bool addsBounding() const { return bounding && !isProjected(); }
  /// Are triangles removed for their size?
  bool limitsSize() const { return limits.any(); }
  /// May the rim be trimmed? It depends on the plane.
  bool mayTrimRim() const
  {
    const bool asked = rim == RimKind::Trimmed || (rim == RimKind::Automatic && isProjected());
    return asked && !limitsSize() && !addsBounding();
  }
  /// Is the rim trimmed? `fitted`: the plane, if fitted.
  bool trimsRim(const Plane& fitted) const
  {
    const bool isRounded = !fitsPlane() || !fitted.isOfCoordinates();
    return mayTrimRim() && (isRounded || rim == RimKind::Trimmed);
  }
  /// Is the surface simplified?
  bool simplifies() const { return maximumError > 0.0 || maximumNumberOfVertices > 0; }
  Conflict conflict() const
  {
    return !simplifies()           ? Conflict::None
      : options.insertionLimit > 0 ? Conflict::InsertionLimit
      : limits.alpha > 0.0         ? Conflict::Alpha
      : showsMeans                 ? Conflict::MeanZ
                                   : Conflict::None;
  }
  /// Is the insertion order drawn?
  bool drawsOrder() const { return curve || options.keepBoxes; }
  /// Should points above each other be reported? Not if a policy for them is set.
  bool takesFirst() const
  {
    return !showsMeans && options.representative == Representative::FirstId;
  }

  /// Fills in the request of prepare(), except a plane or projection.
  void ask(InputRequest& request) const
  {
    request.idsAreOfInput = idsAreOfInput;
    request.closedLinesAreLoops = closedLinesAreLoops;
    request.pointsAreLine = pointsAreLine;
    request.heights = sourceHeights;
    request.zeroIsMissing = zeroIsMissing;
    request.linesOnSurface = linesOnSurface;
    request.maximumSegmentLength = maximumSegmentLength;
    request.representative = options.representative;
    request.meanHeights = showsMeans;
    request.fitPlane = fitsPlane();
    request.unfittedPoints = unfittedPoints;
    request.tolerance = tolerance;
    request.bounding = addsBounding();
    request.offset = offset;
    request.split = split;
  }
};

} // namespace ahd

#endif
