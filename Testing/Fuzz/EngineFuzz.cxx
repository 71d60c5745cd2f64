// SPDX-License-Identifier: BSD-3-Clause
//
// Bytes become points and settings (FuzzCase.h), the engine triangulates them, and the certifier
// has the last word; small sets go through the oracle too. Then whatever may not change the result
// is changed: settings, threads, the order and layout of the points, a run cancelled or without
// memory before.
#include "Judge.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kFewForOracle = 7;

/// The first run of a case, and what all others are compared with.
struct First
{
  const FuzzCase& given;
  const std::vector<Point> points; ///< as the engine sees them
  const Layout layout;
  test::Outcome outcome;

  explicit First(const FuzzCase& fuzzed)
    : given(fuzzed)
    , points(fuzzed.allPoints())
    , layout(fuzzed, points)
  {
  }
};

std::string differenceOf(const test::Outcome& a, const test::Outcome& b)
{
  return a.status != b.status ? "other status"
    : a.triples != b.triples  ? "other triangles"
    : a.fates != b.fates      ? "other fates"
                              : "";
}

/// Points left out become such that are not finite, which the oracle leaves out.
std::vector<Point> withoutSkipped(const PointView& view)
{
  std::vector<Point> result;
  for (std::size_t i = 0; i < view.count; ++i)
  {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    result.push_back(view.skipped(i) ? Point{ kNaN, kNaN } : view[i]);
  }
  return result;
}

void expectAsDefined(const First& first)
{
  if (first.outcome.report.inserted <= kFewForOracle)
  {
    expect(test::asSet(first.outcome.triples) ==
        test::delaunayByDefinition(withoutSkipped(first.layout.view())),
      "the triangles are those of the definition", first.given);
  }
}

/// Other settings, threads, ids and layout.
void expectSameWhenShuffled(const First& first, Triangulator& triangulator)
{
  const std::vector<std::size_t> oldId = shuffledIds(
    first.points.size(), first.given.head[kShuffle]);
  const PointView before = first.layout.view();
  std::vector<Point> points;
  std::vector<unsigned char> skip;
  for (const std::size_t id : oldId)
  {
    points.push_back(first.points[id]);
    skip.push_back(before.skipped(id) ? 1 : 0);
  }
  PointView view = test::viewOf(points);
  view.skip = skip.data();
  test::Outcome outcome = triangulate(triangulator, view, runOf(first.given, 1));
  expectNone(faultsOf(view, outcome), first.given);
  for (std::int32_t& id : outcome.triples)
  {
    id = std::int32_t(first.outcome.fates[oldId[std::size_t(id)]]);
  }
  expect(
    outcome.triples == first.outcome.triples, "the shuffled triangles are the same", first.given);
}

} // namespace

void fuzzEngine(const FuzzCase& given)
{
  First first(given);
  Triangulator triangulator;
  first.outcome = triangulate(triangulator, first.layout.view(), runOf(given, 0));
  expectNone(faultsOf(first.layout.view(), first.outcome), given);
  expectAsDefined(first);
  expectSameWhenShuffled(first, triangulator);
  const test::Outcome again = triangulate(triangulator, first.layout.view(), runOf(given, 0));
  expectNone(differenceOf(first.outcome, again), given);
}

} // namespace fuzz
} // namespace ahd

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  ahd::fuzz::fuzzEngine(ahd::fuzz::FuzzCase::fromBytes(data, size));
  return 0;
}
