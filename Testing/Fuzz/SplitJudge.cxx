// SPDX-License-Identifier: BSD-3-Clause
#include "PartJudges.h"

#include "../Engine/Crossings/SplitDrawings.h"

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kMostPieces = 120; ///< brute force compares each with each

test::Drawing drawingOf(const ToSplit& given)
{
  test::Drawing result;
  result.points = given.points;
  result.skip = given.skip;
  for (std::size_t k = 0; k < given.chains.chains(); ++k)
  {
    (k < given.chains.lines() ? result.lines : result.loops).push_back(given.chains.chain(k));
  }
  return result;
}

} // namespace

std::string splitAndJudge(const ToSplit& given, SplitConstraints& split)
{
  const test::Drawing drawing = drawingOf(given);
  const test::Chains chains(drawing);
  const Status status = splitAtCrossings(drawing.view(), chains.view(), nullptr, split);
  if (status != Status::Ok)
  {
    return "splitting: status " + std::to_string(int(status));
  }
  // the largest double has no next one, which nearness needs
  const bool isSmall = split.ids.size() <= kMostPieces && given.points.size() <= kMostPieces &&
    test::largestCoordinate(given.points) < std::numeric_limits<double>::max();
  return isSmall && split.unresolved == 0 ? faultsOf(drawing, split) : "";
}

} // namespace fuzz
} // namespace ahd
