// SPDX-License-Identifier: BSD-3-Clause
//
// The memory that a job needs.
#include "Job.h"

namespace ahd
{

std::size_t Job::estimate() const
{
  return expected(request()).estimate;
}

RunWishes Job::wishes() const
{
  RunWishes made;
  made.options = settings.options();
  made.alpha = settings.limits().alpha > 0.0;
  made.maximumEdgeLength = settings.limits().maximumEdgeLength > 0.0;
  made.trimsRim = settings.mayTrimRim();
  made.showsMeans = settings.showsMeans();
  made.samples = settings.is(IntSetting::WantSamples);
  made.pointStatus = settings.is(IntSetting::WantPointStatus);
  made.insertionRanks = settings.is(IntSetting::WantInsertionRanks);
  made.neighbors = settings.is(IntSetting::WantNeighbors);
  made.regions = settings.is(IntSetting::WantRegions);
  made.constraintEdges = settings.is(IntSetting::WantConstraintEdges);
  made.voronoi = settings.is(IntSetting::WantVoronoi);
  made.curve = settings.is(IntSetting::WantCurve);
  made.perAddedPoint = static_cast<std::size_t>(settings[IntSetting::OtherMemoryPerPoint]);
  return made;
}

/// Upper estimate of all that is allocated, for what is known of sizes.
std::size_t Job::estimate(const JobSizes& sizes) const
{
  InputRequest asked = request();
  asked.fitPlane = settings.isProjected(); // or what takes the same
  return static_cast<std::size_t>(settings[IntSetting::OtherMemory]) + arrays.copiedBytes() +
    runMemoryEstimate(asked, wishes(), sizes);
}

} // namespace ahd
