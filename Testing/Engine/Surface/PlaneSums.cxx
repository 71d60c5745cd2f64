// SPDX-License-Identifier: BSD-3-Clause
//
// The sums behind the plane that fits: the same for any order of the terms, any lanes and any
// processor.
#include "Surface/ExactSum.h"

#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

/// Of magnitude 1 at most, some of them tiny.
std::vector<double> makeTerms(std::size_t count)
{
  Random random(1);
  std::vector<double> terms;
  for (std::size_t i = 0; i < count; ++i)
  {
    terms.push_back(std::ldexp(2.0 * random.unit() - 1.0, -int(random.below(90))));
  }
  terms[1] = 1.0;
  terms[2] = -1.0;
  return terms;
}

/// The contract of ExactSum, term by term.
double sumByDefinition(const std::vector<double>& terms)
{
  double parts[3] = { 0, 0, 0 };
  for (double term : terms)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int digits = 24 + 25 * k;
      const double part = std::ldexp(std::nearbyint(std::ldexp(term, digits)), -digits);
      parts[k] += part;
      term -= part;
    }
  }
  return parts[0] + (parts[1] + parts[2]);
}

TEST(PlaneSums, AllDispatchTargetsAddAsDefined)
{
  const std::vector<double> terms = makeTerms(200 * kSumLanes);
  for (const DispatchTarget<AddTerms>& target : kAddTermsTargets)
  {
    if (!processorHas(target.needs))
    {
      continue;
    }
    SumParts parts = {};
    for (std::size_t i = 0; i < terms.size(); i += kSumLanes)
    {
      SumTerms some;
      std::copy_n(terms.begin() + std::ptrdiff_t(i), kSumLanes, some.begin());
      target.run(some, parts);
      for (std::size_t lane = 0; lane < kSumLanes; ++lane)
      {
        std::vector<double> own;
        for (std::size_t k = lane; k < i + kSumLanes; k += kSumLanes)
        {
          own.push_back(terms[k]);
        }
        ASSERT_EQ(parts[0][lane] + (parts[1][lane] + parts[2][lane]), sumByDefinition(own))
          << "target " << int(target.needs) << ", lane " << lane;
      }
    }
  }
}

TEST(PlaneSums, LanesAndPartsAddUp)
{
  const std::vector<double> terms = makeTerms(50 * kSumLanes);
  ExactSum first, second;
  for (std::size_t i = 0; i < terms.size(); i += kSumLanes)
  {
    SumTerms some;
    std::copy_n(terms.begin() + std::ptrdiff_t(i), kSumLanes, some.begin());
    (i % (3 * kSumLanes) == 0 ? first : second).add(some);
  }
  first.merge(second);
  EXPECT_EQ(first.value(), sumByDefinition(terms));
}

} // namespace
} // namespace test
} // namespace ahd
