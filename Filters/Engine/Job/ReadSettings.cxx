// SPDX-License-Identifier: BSD-3-Clause
// Made by Filters/Settings/generate.py: change what is there, not this.
#include "Settings.h"

namespace ahd
{
namespace
{

template <typename Number, typename Member>
void put(Number number, Member& to)
{
  to = static_cast<Member>(number);
}

} // namespace

void JobSettings::read(RunSettings& run) const
{
  put((*this)[IntSetting::InsertionOrder], run.options.order);
  put((*this)[IntSetting::Nmax], run.options.nmax);
  put((*this)[IntSetting::ControlPoints], run.options.controlPoints);
  put((*this)[IntSetting::GeneRotation], run.options.geneRotation);
  put((*this)[IntSetting::CountWork], run.options.countWork);
  put((*this)[IntSetting::InsertionLimit], run.options.insertionLimit);
  put((*this)[IntSetting::MaximumVertices], run.maximumNumberOfVertices);
  put((*this)[IntSetting::SecondPass], run.secondPass);
  put((*this)[IntSetting::UnfittedPoints], run.unfittedPoints);
  put((*this)[IntSetting::ClosedLines], run.closedLinesAreLoops);
  put((*this)[IntSetting::PointsAsLine], run.pointsAreLine);
  put((*this)[IntSetting::SplitCrossings], run.split);
  put((*this)[IntSetting::SourceHeights], run.sourceHeights);
  put((*this)[IntSetting::ZeroIsMissing], run.zeroIsMissing);
  put((*this)[IntSetting::LinesOnSurface], run.linesOnSurface);
  put((*this)[IntSetting::FillRule], run.fillRule);
  put((*this)[IntSetting::Plane], run.plane);
  put((*this)[IntSetting::Rim], run.rim);
  put((*this)[IntSetting::Bounding], run.bounding);
  put((*this)[IntSetting::AlphaTriangles], run.limits.triangles);
  put((*this)[IntSetting::AlphaLines], run.limits.lines);
  put((*this)[IntSetting::AlphaVertices], run.limits.vertices);
  put((*this)[IntSetting::VoronoiClip], run.voronoiClip);
  put((*this)[IntSetting::WantVoronoi], run.voronoi);
  put((*this)[IntSetting::WantOrder], run.options.keepOrder);
  put((*this)[IntSetting::WantBoxes], run.options.keepBoxes);
  put((*this)[IntSetting::WantCurve], run.curve);
  put((*this)[IntSetting::WantSamples], run.samples);
  put((*this)[DoubleSetting::Tolerance], run.tolerance);
  put((*this)[DoubleSetting::Offset], run.offset);
  put((*this)[DoubleSetting::Alpha], run.limits.alpha);
  put((*this)[DoubleSetting::MaximumEdgeLength], run.limits.maximumEdgeLength);
  put((*this)[DoubleSetting::MaximumError], run.maximumError);
  put((*this)[DoubleSetting::MaximumSegmentLength], run.maximumSegmentLength);
  for (std::size_t k = 0; k < kWantedArrays; ++k)
  {
    run.wanted[k] = is(kWantedRows[k].setting);
  }
}

} // namespace ahd
