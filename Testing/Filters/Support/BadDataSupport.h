// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_BadDataSupport_h
#define ahd_BadDataSupport_h

#include "ConstraintTestSupport.h"

#include <gtest/gtest.h>

#include <limits>

namespace ahdtest
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Every point has one fate, and each count is that of the fates. @pre GenerateFate was on.
inline void expectCountsOfFates(vtkAdaptiveHilbertDelaunay2D* filter)
{
  const std::vector<vtkIdType> fates = idsOf(filter->GetOutput()->GetPointData(), "Fate");
  vtkIdType vertices = 0, others = 0, rejected = 0, out = 0;
  for (std::size_t i = 0; i < fates.size(); ++i)
  {
    vertices += fates[i] == vtkIdType(i);
    others += fates[i] >= 0 && fates[i] != vtkIdType(i);
    rejected += fates[i] == -1;
    out += fates[i] == -2;
  }
  EXPECT_EQ(vtkIdType(fates.size()), filter->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(vertices, filter->GetNumberOfPointsInserted());
  EXPECT_EQ(others, filter->GetNumberOfDuplicates() + filter->GetNumberOfMergedPoints());
  EXPECT_EQ(rejected, filter->GetNumberOfRejectedPoints());
  EXPECT_EQ(out, filter->GetNumberOfSkippedPoints() + filter->GetNumberOfPointsBeyondLimit());
}

/// The filter reported so many warnings and no error, and the last warning contains each of
/// `parts`.
inline void expectWarnings(
  const WatchedFilter& filter, std::size_t count, const std::vector<std::string>& parts = {})
{
  EXPECT_TRUE(filter.Said->Errors.empty()) << filter.Said->Errors[0];
  EXPECT_TRUE(filter.PipelineSaid->Errors.empty()) << filter.PipelineSaid->Errors[0];
  EXPECT_EQ(filter.Said->Warnings.size(), count);
  for (std::size_t i = count; i < filter.Said->Warnings.size(); ++i)
  {
    ADD_FAILURE() << filter.Said->Warnings[i];
  }
  for (const std::string& part : parts)
  {
    const std::string last = filter.Said->Warnings.empty() ? "" : filter.Said->Warnings.back();
    EXPECT_NE(last.find(part), std::string::npos) << "no \"" << part << "\" in: " << last;
  }
}

} // namespace ahdtest

#endif
