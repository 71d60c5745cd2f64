// SPDX-License-Identifier: BSD-3-Clause
#include "TileSegments.h"

#include "../Order/CurveKeys.h"
#include "../Predicates/Predicates.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// Calls visit(from, to) for each segment, places of corners.
template <typename Visit>
void eachSegment(const TileLines& lines, Visit visit)
{
  for (std::size_t chain = 0; chain != lines.chains(); ++chain)
  {
    const auto begin = static_cast<std::size_t>(lines.offsets[chain]);
    const auto end = static_cast<std::size_t>(lines.offsets[chain + 1]);
    for (std::size_t k = begin; k + 1 < end; ++k)
    {
      visit(lines.corners[k], lines.corners[k + 1]);
    }
    if (chain >= lines.lines && end > begin + 1)
    {
      visit(lines.corners[end - 1], lines.corners[begin]);
    }
  }
}

/// Has the line of the segment a place in the region?
bool doesLineMeet(const EndPair& s, const Bounds& region)
{
  const Point corners[] = { { region.xmin, region.ymin }, { region.xmax, region.ymin },
    { region.xmin, region.ymax }, { region.xmax, region.ymax } };
  bool isLeft = false, isRight = false; // or on it
  for (const Point& corner : corners)
  {
    const int side = orient2d(s.from, s.to, corner);
    isLeft = isLeft || side >= 0;
    isRight = isRight || side <= 0;
  }
  return isLeft && isRight;
}

} // namespace

TileSegments::TileSegments(const TileLines& lines)
{
  std::vector<EndPair> all;
  eachSegment(lines,
    [&](const Point& from, const Point& to)
    {
      if (isFinite(from) && isFinite(to) && !(from == to))
      {
        all.push_back({ from, to });
      }
    });
  const auto boxOf = [](const EndPair& s) { return Box::around(s.from, s.to); };
  Ticker ticker(nullptr, Phase::Outputs, 0); // never cancelled
  Buffer<std::uint64_t> keys;
  Box around;
  sortAlongCurve(
    all.size(), [&](std::size_t k) { return boxOf(all[k]); }, keys, around, ticker);
  segments_.reserve(all.size());
  for (std::size_t k = 0; k != all.size(); ++k)
  {
    segments_.push_back(all[static_cast<Index>(keys[k])]);
  }
  levels_.allocate(segments_.size());
  levels_.fitItems([&](std::size_t k) { return boxOf(segments_[k]); }, ticker);
}

bool TileSegments::listIn(const Bounds& region, std::vector<EndPair>& found, Ticker& ticker) const
{
  const Box box = Box::around({ region.xmin, region.ymin }, { region.xmax, region.ymax });
  const auto enter = [&](const Box& around)
  {
    return !ticker.step(kChildren) ? Levels::Way::Stop
      : around.meets(box)          ? Levels::Way::In
                                   : Levels::Way::Past;
  };
  const auto look = [&](std::size_t leaf)
  {
    for (std::size_t k = Levels::childrenBegin(0, leaf); k != levels_.childrenEnd(0, leaf); ++k)
    {
      const EndPair& s = segments_[k];
      if (Box::around(s.from, s.to).meets(box) && doesLineMeet(s, region))
      {
        found.push_back(s);
      }
    }
    return true;
  };
  return levels_.visit(enter, look);
}

} // namespace ahd
