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

/// Corners by number: the leaf's points, then those of sections.
struct Numbered
{
  std::array<Index, 3> corners;
  std::uint8_t flags;
};

/// The triangles of a leaf that have become final above, between those that were final there.
///
/// Ranks are in the order of keys on the curve, so few are needed: those of the triangles from
/// above, and of some of the others to find where these go. Where points have a key in common and
/// are compared, all are ranked.
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
    return number(kept) && order(kept) && (!areTied_ || (rank() && order(kept))) &&
      joinWith(kept, out);
  }

private:
  /// From above, beginning at its lowest corner; with the orders of corners, and before which of
  /// the leaf's own it comes.
  struct Above
  {
    Numbered triangle;
    std::array<std::uint64_t, 3> orders;
    std::size_t before;
  };

  Point placeOf(Index number) const
  {
    const std::size_t own = given_.points.count;
    return number < own ? given_.points[number] : foreign_[number - own];
  }
  /// Its rank, or what has the order of ranks.
  std::uint64_t orderOf(Index number) const
  {
    return rankOf_.empty() ? plan_.grid().keyOf(placeOf(number)) : rankOf_[number];
  }
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
    for (std::size_t k = 0; k != kept.sections.size(); ++k)
    {
      const TileSection& section = kept.sections[k];
      std::vector<Index> numbers;
      for (const BorderPoint& point : section.points)
      {
        const bool isOwn = point.block == given_.leaf;
        const std::size_t next = given_.points.count + foreign_.size();
        numbers.push_back(isOwn ? numberOf(point.id) : static_cast<Index>(next));
        if (!isOwn)
        {
          foreign_.push_back(point.at);
          foreignIds_.push_back(point.id);
        }
      }
      for (std::size_t t = 0; t != section.corners.size(); ++t)
      {
        const std::array<Index, 3>& c = section.corners[t];
        if ((section.flags[t] & TileSection::kOwned) != 0 && kept.isKept(k, t))
        {
          above_.push_back(
            { { { { numbers[c[0]], numbers[c[1]], numbers[c[2]] } }, section.flags[t] }, {}, 0 });
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
    std::vector<Point> places;
    places.reserve(given_.points.count + foreign_.size());
    const auto copy = [&](std::size_t i) { places.push_back(placeOf(static_cast<Index>(i))); };
    if (!inSteps(0, given_.points.count + foreign_.size(), ticker_, copy))
    {
      return false;
    }
    const Bounds& all = plan_.facts().bounds;
    const PointView view(&places[0].x, places.size(), 2);
    RankedPoints ranked;
    if (readPoints(view, ticker_, ranked, { all.xmin, all.xmax, all.ymin, all.ymax }) !=
        Status::Ok ||
      rankPoints(view, ticker_, ranked) != Status::Ok)
    {
      return false;
    }
    rankOf_.resize(places.size());
    const auto setRank = [&](std::size_t r) { rankOf_[ranked.id[r]] = static_cast<Index>(r); };
    const auto setSame = [&](std::size_t k)
    { rankOf_[ranked.duplicates[k].id] = rankOf_[ranked.duplicates[k].keptId]; };
    return inSteps(0, ranked.count, ticker_, setRank) &&
      inSteps(0, ranked.duplicates.size(), ticker_, setSame);
  }

  /// Sorts those from above, and finds their places among the leaf's own.
  bool order(const TileKept& kept)
  {
    areTied_ = false;
    for (Above& one : above_)
    {
      turn(one);
      if (!ticker_.step())
      {
        return false;
      }
    }
    const auto isBefore = [&](const Above& a, const Above& b)
    { return comesBefore(a.triangle.corners, b, [&](unsigned e) { return a.orders[e]; }); };
    return sortAsking(above_, ticker_, isBefore) && findPlaces(kept.own);
  }

  /// To its lowest corner.
  void turn(Above& one)
  {
    std::array<Index, 3>& corners = one.triangle.corners;
    const auto order = [&](Index corner) { return orderOf(corner); };
    std::transform(corners.begin(), corners.end(), one.orders.begin(), order);
    const auto lowest = std::min_element(one.orders.begin(), one.orders.end()) - one.orders.begin();
    std::rotate(one.orders.begin(), one.orders.begin() + lowest, one.orders.end());
    std::rotate(corners.begin(), corners.begin() + lowest, corners.end());
    areTied_ = areTied_ || one.orders[0] == one.orders[1] || one.orders[1] == one.orders[2] ||
      one.orders[2] == one.orders[0];
    const unsigned edges = one.triangle.flags & 7u;
    one.triangle.flags = static_cast<std::uint8_t>((edges >> lowest | edges << (3 - lowest)) & 7u);
  }

  /// Does the triangle with these corners, of which orderAt(e) is known or found, come before
  /// another?
  template <typename OrderAt>
  bool comesBefore(const std::array<Index, 3>& corners, const Above& other, const OrderAt& orderAt)
  {
    for (unsigned e = 0; e != 3; ++e)
    {
      if (corners[e] != other.triangle.corners[e])
      {
        const std::uint64_t order = orderAt(e);
        areTied_ = areTied_ || order == other.orders[e];
        return order != other.orders[e] ? order < other.orders[e]
                                        : corners[e] < other.triangle.corners[e];
      }
    }
    return false;
  }

  /// First among every 64th of the leaf's own, which are few.
  bool findPlaces(const TileOwn& own)
  {
    constexpr std::size_t kStride = 64;
    std::vector<std::uint64_t> some;
    const auto add = [&](std::size_t k) { some.push_back(orderOf(own[kStride * k][0])); };
    if (!inSteps(0, (own.count + kStride - 1) / kStride, ticker_, add))
    {
      return false;
    }
    for (Above& one : above_)
    {
      const auto [low, high] = std::equal_range(some.begin(), some.end(), one.orders[0]);
      std::size_t begin = kStride * static_cast<std::size_t>(low - some.begin());
      std::size_t end = kStride * static_cast<std::size_t>(high - some.begin());
      begin -= std::min(begin, kStride);
      end = std::min(end, own.count);
      while (begin < end)
      {
        const std::size_t middle = begin + (end - begin) / 2;
        const std::array<Index, 3> corners = own[middle];
        const bool isBefore = comesBefore(
          corners, one, [&](unsigned e) { return orderOf(corners[e]); });
        (isBefore ? begin : end) = isBefore ? middle + 1 : middle;
      }
      one.before = begin;
      if (!ticker_.step())
      {
        return false;
      }
    }
    return true;
  }

  bool joinWith(const TileKept& kept, TileOutput& out)
  {
    const TileOwn& own = kept.own;
    out.triangles.reserve(3 * (own.count + above_.size()));
    out.edges.reserve(own.count + above_.size());
    const auto put = [&](const Numbered& one)
    {
      for (const Index corner : one.corners)
      {
        out.triangles.push_back(idOf(corner));
      }
      out.edges.push_back(one.flags);
    };
    auto next = above_.cbegin();
    const auto join = [&](std::size_t t)
    {
      for (; next != above_.cend() && next->before == t; ++next)
      {
        put(next->triangle);
      }
      if (kept.isOwnKept(t))
      {
        put({ own[t], 0 });
      }
    };
    if (!inSteps(0, own.count, ticker_, join))
    {
      return false;
    }
    std::for_each(next, above_.cend(), [&](const Above& one) { put(one.triangle); });
    return ticker_.ask();
  }

  const TilePlan& plan_;
  const TilePoints& given_;
  Ticker& ticker_;
  std::vector<Point> foreign_; ///< numbered behind the leaf's points
  std::vector<std::int64_t> foreignIds_;
  std::vector<Above> above_;
  bool areTied_ = false;      ///< two were compared that have a key in common
  std::vector<Index> rankOf_; ///< empty: keys are enough
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
