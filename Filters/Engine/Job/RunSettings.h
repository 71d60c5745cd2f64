// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RunSettings_h
#define ahd_RunSettings_h

#include "../Constraints.h"
#include "../Options.h"
#include "../Prepare/Prepare.h"
#include "../Surface/Plane.h"
#include "../Surface/Selection.h"
#include "../Voronoi/Voronoi.h"
#include "Words.h"

namespace ahd
{

/// The settings of a run, and what they imply.
struct RunSettings
{
  Options options;         ///< the run sets Options::mostBoxes
  bool showsMeans = false; ///< of places with several points, in space
  bool idsAreOfInput = true;
  bool closedLinesAreLoops = false;
  bool heightsFromSurface = false; ///< of source points that are added
  bool split = false;
  FillRule fillRule = FillRule::Orientation;
  PlaneKind plane = PlaneKind::Xy;
  double tolerance = 0.0;
  bool bounding = false;
  double offset = 1.0;
  RimKind rim = RimKind::ConvexHull;
  SizeLimits limits;
  VoronoiClip voronoiClip = VoronoiClip::Hull;

  // The requested outputs.
  bool pointStatus = false;
  bool insertionRanks = false;
  bool curve = false;
  bool constraintEdges = false;
  bool regions = false;
  bool neighbors = false;
  bool voronoi = false;
  bool samples = false; ///< values are interpolated: tables of the surface, and no cells

  /// Is the plane another than x, y?
  bool isProjected() const { return plane != PlaneKind::Xy; }
  /// Must the plane be fitted?
  bool fitsPlane() const { return plane == PlaneKind::BestFit; }
  /// Is a bounding triangulation added?
  bool addsBounding() const { return bounding && !isProjected(); }
  /// Are triangles removed for their size?
  bool limitsSize() const { return limits.alpha > 0.0 || limits.maximumEdgeLength > 0.0; }
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
    request.heightsFromSurface = heightsFromSurface;
    request.representative = options.representative;
    request.meanHeights = showsMeans;
    request.fitPlane = fitsPlane();
    request.tolerance = tolerance;
    request.bounding = addsBounding();
    request.offset = offset;
    request.split = split;
  }
};

} // namespace ahd

#endif
