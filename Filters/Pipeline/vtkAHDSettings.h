// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDSettings_h
#define vtkAHDSettings_h

#include "Engine/Constraints.h"
#include "Engine/Options.h"
#include "Engine/Surface/Plane.h"
#include "Engine/Surface/Selection.h"
#include "Engine/Voronoi/Voronoi.h"
#include "Pipeline/vtkAHDSettingsOfRanks.h"
#include "vtkAbstractTransform.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

/// What a filter is asked for, as it was when the execution began: its settings, in the engine's
/// words where it has them. Whoever has a copy holds what it names, but for the plane.
struct vtkAHDSettings
{
  ahd::Options Insertion; ///< Options::mostBoxes is found out
  ahd::FillRule FillRule = ahd::FillRule::Orientation;
  ahd::SizeLimits Limits; ///< Alpha, MaximumEdgeLength
  ahd::VoronoiClip VoronoiClip = ahd::VoronoiClip::Hull;
  bool SourceIdsAreOfInput = true;
  bool AddSourcePoints = false;
  bool ClosedLinesAreLoops = false;
  bool HeightsFromSurface = false; ///< of the source's points; only with AddSourcePoints
  bool Split = false;
  bool FitPlane = false;
  const ahd::Plane* Plane = nullptr; ///< with FitPlane: null, or this one, which was fitted before
  vtkSmartPointer<vtkAbstractTransform> Transform; ///< null: none is used
  bool TransformIsMissing = false;                 ///< although it is asked for
  double Tolerance = 0.0;
  bool ShowMeans = false; ///< of z, at duplicates
  bool Bounding = false;
  double Offset = 1.0;
  bool Trim = false;          ///< the rim, where nothing else bounds the surface
  bool TrimIfRounded = false; ///< with Trim: not where a fitted plane is that of two coordinates
  bool GeneratePointStatus = false;
  bool GenerateInsertionRank = false;
  bool GenerateInsertionCurve = false;
  bool GenerateConstraintEdges = false;
  bool GenerateRegionIds = false;
  bool GenerateNeighbors = false;
  bool GenerateVoronoi = false;
  bool Samples =
    false;             ///< values are interpolated on the surface: its tables are needed, not cells
  int GhostLevels = 0; ///< layers of ghost cells that are asked for; only on ranks
  vtkTypeInt64 MemoryLimit = 0; ///< KiB; 0: what there is
  vtkTypeInt64 ReuseLimit = 0;  ///< KiB
  vtkAHDSettingsOfRanks OfRanks;

  /// Is the plane of the triangulation another than x, y?
  bool IsProjected() const { return this->FitPlane || this->Transform; }
  /// Is there to be a bounding triangulation?
  bool AddsBounding() const { return this->Bounding && !this->IsProjected(); }
  /// May the rim have to be trimmed? The plane says whether it does.
  bool MayTrimRim() const { return this->Trim && !this->LimitsSize() && !this->AddsBounding(); }
  /// Is the rim to be trimmed? `plane`: where one is fitted, that.
  bool TrimsRim(const ahd::Plane& plane) const
  {
    const bool isRounded = !this->FitPlane || !plane.isOfCoordinates();
    return this->MayTrimRim() && (isRounded || !this->TrimIfRounded);
  }
  /// Is anything of the second output asked for?
  bool WantsOrder() const { return this->GenerateInsertionCurve || this->Insertion.keepBoxes; }
  /// Are triangles to be left out for their size?
  bool LimitsSize() const
  {
    return this->Limits.alpha > 0.0 || this->Limits.maximumEdgeLength > 0.0;
  }
};

#endif
