// SPDX-License-Identifier: BSD-3-Clause
//
// Steps that splitting takes for stars, whose pairs grow with the square; by the polls of Progress.
#include "Crossings/Crossings.h"

#include "EngineRun.h"
#include "Listeners.h"
#include "SeparateLines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ahd
{
namespace test
{
namespace
{

using Segments = SeparateLines;

/// Diameters in so many stars beside each other, through a double in the middle of each.
Segments starsOf(std::size_t segments, std::size_t stars)
{
  std::mt19937_64 random(1); // its sequence is fixed by the standard
  const auto coordinate = [&] { return double(random() % 2000) - 1000.0; };
  const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(double(stars))));
  Segments result;
  for (std::size_t k = 0; k != segments; ++k)
  {
    const std::size_t star = k % stars;
    const double x = 4096.0 * double(star % across), y = 4096.0 * double(star / across);
    double u = coordinate();
    const double v = coordinate();
    u += u == 0.0 ? 1.0 : 0.0;
    result.add({ x + u, y + v }, { x - u, y - v });
  }
  return result;
}

/// Segments that nearly pass through one place, whose coordinates are no doubles.
Segments starBesideADouble(std::size_t segments)
{
  std::mt19937_64 random(1);
  const auto fraction = [&] { return double(random() >> 11) * 0x1p-53; };
  Segments result;
  for (std::size_t k = 0; k != segments; ++k)
  {
    const double turn = 3.14159 * fraction(), far = 0.5 + fraction();
    const double u = std::cos(turn), v = std::sin(turn);
    result.add({ 0.1 + far * u, 0.2 + far * v }, { 0.1 - 1.1 * u, 0.2 - 1.1 * v });
  }
  return result;
}

/// Steps that splitting takes, divided by m log^2 m for m ids in the result.
double stepsOver(const Segments& segments, SplitConstraints& split)
{
  Listener counter;
  EXPECT_EQ(
    splitAtCrossings(viewOf(segments.points), segments.view(), &counter, split), Status::Ok);
  const double size = double(split.ids.size());
  const double steps = double(counter.askings() + 1) * double(kStepsPerAsking);
  return steps / (size * std::log2(size) * std::log2(size));
}

TEST(SplitWork, StarsWhosePairsAreNotListed)
{
  for (const std::size_t stars : { 1, 12, 60 })
  {
    const Segments segments = starsOf(12000, stars);
    SplitConstraints split;
    EXPECT_LE(stepsOver(segments, split), 4.0) << stars;
    EXPECT_GE(split.crossings, segments.count() * segments.count() / stars / 3);
    EXPECT_EQ(split.points.size(), stars);
  }
}

/// Many pieces of it run between the same two doubles, and are searched as one; each by itself
/// takes a quarter more steps.
TEST(SplitWork, AStarWhoseMiddleIsNoDouble)
{
  SplitConstraints split;
  EXPECT_LE(stepsOver(starBesideADouble(600), split), 5.5);
  EXPECT_GT(split.points.size(), 600u);
}

} // namespace
} // namespace test
} // namespace ahd
