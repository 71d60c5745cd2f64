// SPDX-License-Identifier: BSD-3-Clause
//
// The sums behind the plane that fits: the same for any order of the terms, any lanes and any
// processor.
#include "Surface/PlanePasses.h"

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

/// Points whose coordinates are the terms.
PlanePlaces placesOf(const std::vector<double>& terms)
{
  PlanePlaces places;
  places.points = PointView(terms.data(), terms.size() / 3, 3);
  return places;
}

template <typename Pass>
typename Pass::Part runPass(
  const DispatchTarget<RunPass<Pass>>& target, const PlanePlaces& places, const Pass& pass)
{
  typename Pass::Part part;
  const std::size_t half = places.points.count / 2;
  target.run(places, pass, 0, half, part);
  target.run(places, pass, half, places.points.count, part);
  return part;
}

TEST(PlaneSums, AllDispatchTargetsAddAsDefined)
{
  for (const std::size_t count : { 200 * kSumLanes, 200 * kSumLanes + 1, 101 * kSumLanes - 2 })
  {
    const std::vector<double> terms = makeTerms(3 * count);
    for (const auto& target : kPassTargets<PlaneSums>)
    {
      if (!processorHas(target.needs))
      {
        continue;
      }
      const ExactSums<3> sums = runPass(target, placesOf(terms), PlaneSums{});
      for (std::size_t k = 0; k < 3; ++k)
      {
        std::vector<double> own;
        for (std::size_t i = k; i < terms.size(); i += 3)
        {
          own.push_back(terms[i]);
        }
        EXPECT_EQ(sums[k].value(), sumByDefinition(own))
          << "target " << int(target.needs) << ", coordinate " << k << " of " << count;
      }
    }
  }
}

/// Axes and factors whose products and sums round.
const Matrix3 kAxes = { { { { 0.6, 0.64, 0.48 } }, { { 0.8, -0.48, -0.36 } },
  { { 1.0 / 3, 0.6, -0.8 } } } };
const Vector3 kFactor = { { 0.5, 0.25, 0.125 } };

TEST(PlaneSums, AllDispatchTargetsMultiplyAsDefined)
{
  const std::vector<double> terms = makeTerms(3 * (100 * kSumLanes + 5));
  std::vector<double> products[9];
  for (std::size_t i = 0; i < terms.size(); i += 3)
  {
    Vector3 x;
    for (std::size_t k = 0; k < 3; ++k)
    {
      x[k] = (kAxes[k][0] * terms[i] + kAxes[k][1] * terms[i + 1] + kAxes[k][2] * terms[i + 2]) *
        kFactor[k];
      products[6 + k].push_back(x[k]);
    }
    std::size_t pair = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (std::size_t j = k; j < 3; ++j)
      {
        products[pair++].push_back(x[k] * x[j]);
      }
    }
  }
  for (const auto& target : kPassTargets<PlaneProducts>)
  {
    if (processorHas(target.needs))
    {
      const ExactSums<9> sums = runPass(target, placesOf(terms), PlaneProducts{ kAxes, kFactor });
      for (std::size_t k = 0; k < 9; ++k)
      {
        EXPECT_EQ(sums[k].value(), sumByDefinition(products[k]))
          << "target " << int(target.needs) << ", sum " << k;
      }
    }
  }
}

TEST(PlaneSums, AllDispatchTargetsReachAsFar)
{
  const std::vector<double> terms = makeTerms(3 * (100 * kSumLanes + 5));
  Vector3 expected = { { 0, 0, 0 } };
  for (std::size_t i = 0; i < terms.size(); i += 3)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double along = kAxes[k][0] * terms[i] + kAxes[k][1] * terms[i + 1] +
        kAxes[k][2] * terms[i + 2];
      expected[k] = std::max(expected[k], std::fabs(along));
    }
  }
  for (const auto& target : kPassTargets<PlaneReaches>)
  {
    if (processorHas(target.needs))
    {
      EXPECT_EQ(runPass(target, placesOf(terms), PlaneReaches{ kAxes }).farthest(), expected)
        << "target " << int(target.needs);
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
