// SPDX-License-Identifier: BSD-3-Clause
#include "LivingJudge.h"

#include "../Engine/Edit/EditHistory.h"
#include "../Engine/Refine/RefineCase.h"
#include "Judge.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kMostToRefine = 60, kMostAdded = 200, kMostToEdit = 40, kSteps = 20;

/// The larger side of the bounds.
double widthOf(const std::vector<Point>& points)
{
  Bounds b{ HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  for (const Point& p : points)
  {
    b = isFinite(p) ? Bounds{ std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
      std::max(b.ymax, p.y) }
                    : b;
  }
  return std::max(b.xmax - b.xmin, b.ymax - b.ymin);
}

/// What is wished besides an angle, by bits: a length, an area, a size at each point.
void expectRefined(const FuzzCase& given, const test::ConstraintCase& from, FillRule rule)
{
  test::RefineCase refined(from, rule);
  const double width = widthOf(from.points);
  const bool isAny = width > 0.0 && std::isfinite(width * width) && width * width > 0.0;
  const unsigned bits = isAny ? given.head[kLimit] : 0;
  RefineRequest& request = refined.request;
  request.minimumAngle = given.head[kNmax] % 35;
  request.mostSteinerPoints = kMostAdded;
  request.maximumLength = (bits & 1u) != 0 ? width / 4.0 : 0.0;
  request.maximumArea = (bits & 2u) != 0 ? width * width / 32.0 : 0.0;
  std::vector<double> sizes;
  for (std::size_t k = 0; k < from.points.size(); ++k)
  {
    sizes.push_back(width / double(2 + (bits + k) % 7));
  }
  request.sizes = (bits & 4u) != 0 ? sizes.data() : nullptr;
  expect(refined.run() == Status::Ok, "refined", given);
  if (refined.made.fault == RefineFault::None)
  {
    expectNone(refined.faults(), given);
    expectStops(given, [&](Progress* progress) { return refined.run(progress); });
  }
}

void expectEdited(const FuzzCase& given, const std::vector<Point>& points)
{
  const std::size_t count = std::min(points.size(), kMostToEdit);
  test::History history({ points.begin(), points.begin() + std::ptrdiff_t(count) },
    given.head[kShuffle] + 256u * given.head[kMostBoxes]);
  for (std::size_t k = 0; k < kSteps; ++k)
  {
    history.step();
  }
  history.expectAsFresh();
}

} // namespace

void expectLiving(const FuzzCase& given, const test::ConstraintCase& from, FillRule rule)
{
  GTEST_FLAG_SET(break_on_failure, true);
  if (from.points.size() <= kMostToRefine)
  {
    expectRefined(given, from, rule);
    expectEdited(given, from.points);
  }
}

} // namespace fuzz
} // namespace ahd
