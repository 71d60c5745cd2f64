// SPDX-License-Identifier: BSD-3-Clause
#include "../Core/Border.h"
#include "../Core/SortAsking.h"
#include "../Order/Rank.h"
#include "TileVisits.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// Corners by number: the leaf's points, then those of sections, and where they begin.
struct Numbered
{
  std::array<Index, 3> corners;
  std::uint8_t flags;
};

/// The triangles of a leaf that have become final above, between those that were final there.
class LeafTriangles
{
public:
  LeafTriangles(const TilePlan& plan, const TilePoints& given, Ticker& ticker)
    : plan_(plan)
    , given_(given)
    , ticker_(ticker)
  {
  }

  bool make(const TileKept& kept, TileOutput& out)
  {
    return number(kept) && rank() && sortSeam() && joinWith(kept, out);
  }

private:
  std::int64_t idOf(Index number) const
  {
    const std::size_t own = given_.points.count;
    return number >= own ? foreignIds_[number - own]
      : given_.ids       ? given_.ids[number]
                         : static_cast<std::int64_t>(plan_.firstPoint(given_.leaf) + number);
  }
  /// @pre the leaf's
  Index numberOf(std::int64_t id) const
  {
    return static_cast<Index>(given_.ids
        ? std::lower_bound(given_.ids, given_.ids + given_.points.count, id) - given_.ids
        : id - static_cast<std::int64_t>(plan_.firstPoint(given_.leaf)));
  }

  bool number(const TileKept& kept)
  {
    const std::size_t own = given_.points.count;
    places_.reserve(own);
    const auto copy = [&](std::size_t i) { places_.push_back(given_.points[i]); };
    if (!inSteps(0, own, ticker_, copy))
    {
      return false;
    }
    for (std::size_t k = 0; k != kept.sections.size(); ++k)
    {
      const TileSection& section = kept.sections[k];
      std::vector<Index> numbers;
      for (const BorderPoint& point : section.points)
      {
        const bool isOwn = point.block == given_.leaf;
        numbers.push_back(isOwn ? numberOf(point.id) : static_cast<Index>(places_.size()));
        if (!isOwn)
        {
          places_.push_back(point.at);
          foreignIds_.push_back(point.id);
        }
      }
      for (std::size_t t = 0; t != section.corners.size(); ++t)
      {
        const std::array<Index, 3>& c = section.corners[t];
        if ((section.flags[t] & TileSection::kOwned) != 0 && kept.isKept(k, t))
        {
          seam_.push_back({ { numbers[c[0]], numbers[c[1]], numbers[c[2]] }, section.flags[t] });
        }
      }
      if (!ticker_.ask())
      {
        return false;
      }
    }
    return true;
  }

  /// Those of all points: of crowds, all are here.
  bool rank()
  {
    const Bounds& all = plan_.facts().bounds;
    const PointView view(places_.empty() ? nullptr : &places_[0].x, places_.size(), 2);
    RankedPoints ranked;
    if (readPoints(view, ticker_, ranked, { all.xmin, all.xmax, all.ymin, all.ymax }) !=
        Status::Ok ||
      rankPoints(view, ticker_, ranked) != Status::Ok)
    {
      return false;
    }
    rankOf_.resize(places_.size());
    const auto setRank = [&](std::size_t r) { rankOf_[ranked.id[r]] = static_cast<Index>(r); };
    const auto setSame = [&](std::size_t k)
    { rankOf_[ranked.duplicates[k].id] = rankOf_[ranked.duplicates[k].keptId]; };
    return inSteps(0, ranked.count, ticker_, setRank) &&
      inSteps(0, ranked.duplicates.size(), ticker_, setSame);
  }

  std::array<Index, 3> ranksOf(const std::array<Index, 3>& corners) const
  {
    return { { rankOf_[corners[0]], rankOf_[corners[1]], rankOf_[corners[2]] } };
  }

  bool sortSeam()
  {
    for (Numbered& one : seam_)
    {
      const std::array<Index, 3> ranks = ranksOf(one.corners);
      const auto lowest = static_cast<unsigned>(
        std::min_element(ranks.begin(), ranks.end()) - ranks.begin());
      std::rotate(one.corners.begin(), one.corners.begin() + lowest, one.corners.end());
      const unsigned edges = one.flags & 7u;
      one.flags = static_cast<std::uint8_t>((edges >> lowest | edges << (3 - lowest)) & 7u);
    }
    return sortAsking(seam_, ticker_,
      [&](const Numbered& a, const Numbered& b)
      { return ranksOf(a.corners) < ranksOf(b.corners); });
  }

  bool joinWith(const TileKept& kept, TileOutput& out)
  {
    const TileOwn& own = kept.own;
    out.triangles.reserve(3 * (own.count + seam_.size()));
    out.edges.reserve(own.count + seam_.size());
    const auto put = [&](const Numbered& one)
    {
      for (const Index corner : one.corners)
      {
        out.triangles.push_back(idOf(corner));
      }
      out.edges.push_back(one.flags);
    };
    auto next = seam_.cbegin();
    const auto join = [&](std::size_t t)
    {
      const Numbered one{ own[t], 0 };
      const std::array<Index, 3> ranks = ranksOf(one.corners);
      for (; next != seam_.cend() && ranksOf(next->corners) < ranks; ++next)
      {
        put(*next);
      }
      if (kept.isOwnKept(t))
      {
        put(one);
      }
    };
    if (!inSteps(0, own.count, ticker_, join))
    {
      return false;
    }
    std::for_each(next, seam_.cend(), put);
    return ticker_.ask();
  }

  const TilePlan& plan_;
  const TilePoints& given_;
  Ticker& ticker_;
  std::vector<Point> places_;
  std::vector<std::int64_t> foreignIds_;
  std::vector<Numbered> seam_;
  std::vector<Index> rankOf_;
};

} // namespace

Status TileVisits::makeTriangles(
  const TilePoints& given, const TileKept& kept, const Context& context, TileOutput& out) const
{
  out = TileOutput();
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      out.constraints = kept.constraints;
      return LeafTriangles(plan_, given, ticker).make(kept, out);
    });
}

} // namespace ahd
