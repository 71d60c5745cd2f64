// SPDX-License-Identifier: BSD-3-Clause
#include "PaperOrder.h"

#include "Order/Quantise.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace ahd
{
namespace test
{

const std::vector<GeneRow>& geneTable()
{
  constexpr Step kNone = Step::None;
  constexpr Step kRight = Step::LeftToRight;
  constexpr Step kLeft = Step::RightToLeft;
  constexpr Step kUp = Step::BottomToTop;
  constexpr Step kDown = Step::TopToBottom;
  static const std::vector<GeneRow> kTable = {
    { kRight, kUp, Turn::Clockwise90, true },          // 1
    { kRight, kDown, Turn::WithoutChange, false },     // 2
    { kLeft, kUp, Turn::Turn180, false },              // 3
    { kLeft, kDown, Turn::Counterclockwise90, true },  // 4
    { kUp, kRight, Turn::WithoutChange, false },       // 5, printed: top to bottom
    { kUp, kLeft, Turn::Clockwise90, true },           // 6, printed: top to bottom
    { kDown, kRight, Turn::Counterclockwise90, true }, // 7, printed: bottom to top
    { kDown, kLeft, Turn::Turn180, false },            // 8, printed: bottom to top
    { kRight, kRight, Turn::WithoutChange, false },    // 9
    { kLeft, kLeft, Turn::Turn180, false },            // 10
    { kDown, kDown, Turn::Counterclockwise90, true },  // 11
    { kUp, kUp, Turn::Clockwise90, true },             // 12
    { kRight, kNone, Turn::WithoutChange, false },     // 13
    { kNone, kRight, Turn::WithoutChange, false },     // 14
    { kDown, kNone, Turn::Counterclockwise90, true },  // 15
    { kNone, kDown, Turn::Counterclockwise90, true },  // 16
    { kLeft, kNone, Turn::Turn180, false },            // 17
    { kNone, kLeft, Turn::Turn180, false },            // 18
    { kUp, kNone, Turn::Clockwise90, true },           // 19
    { kNone, kUp, Turn::Clockwise90, true },           // 20
  };
  return kTable;
}

namespace
{

struct Vector
{
  int x, y;
};

/// The textbook recursion: a square with this corner, the curve starting towards `first` and ending
/// across `second`, both of the square's side in length.
void drawHilbert(Vector corner, Vector first, Vector second, unsigned order, Curve& curve)
{
  const int x = corner.x, y = corner.y;
  if (order == 0)
  {
    const int column = x + std::min(0, first.x + second.x);
    const int row = y + std::min(0, first.y + second.y);
    curve.push_back({ Column(column), Row(row) });
    return;
  }
  const Vector a{ first.x / 2, first.y / 2 };
  const Vector b{ second.x / 2, second.y / 2 };
  drawHilbert(corner, b, a, order - 1, curve);
  drawHilbert({ x + a.x, y + a.y }, a, b, order - 1, curve);
  drawHilbert({ x + a.x + b.x, y + a.y + b.y }, a, b, order - 1, curve);
  drawHilbert(
    { x + a.x + second.x, y + a.y + second.y }, { -b.x, -b.y }, { -a.x, -a.y }, order - 1, curve);
}

std::pair<Column, Row> turned(std::pair<Column, Row> box, Turn turn, std::uint32_t side)
{
  const std::uint32_t last = side - 1;
  switch (turn)
  {
    case Turn::Clockwise90:
      return { box.second, last - box.first };
    case Turn::Turn180:
      return { last - box.first, last - box.second };
    case Turn::Counterclockwise90:
      return { last - box.second, box.first };
    default:
      return box;
  }
}

std::uint32_t sideOf(const Curve& curve)
{
  std::uint32_t side = 1;
  while (std::size_t(side) * side < curve.size())
  {
    side *= 2;
  }
  return side;
}

Step stepBetween(std::pair<Column, Row> a, std::pair<Column, Row> b)
{
  return b.first > a.first ? Step::LeftToRight
    : b.first < a.first    ? Step::RightToLeft
    : b.second > a.second  ? Step::BottomToTop
                           : Step::TopToBottom;
}

/// Line by line, from bottom-left (Lo 2013; the paper's Figure 1).
Curve lineByLine(unsigned order)
{
  Curve curve;
  for (Row row = 0; row < 1u << order; ++row)
  {
    for (Column column = 0; column < 1u << order; ++column)
    {
      curve.push_back({ column, row });
    }
  }
  return curve;
}

/// Formula 5 and the judgement after it; a division has one level at least.
unsigned orderOfDivision(std::size_t np)
{
  unsigned r = 1;
  for (double nave = double(np) / 4.0; nave > 16.0; nave /= 4.0)
  {
    ++r;
  }
  return r;
}

/// Integer coordinates of all points in the bounds of some.
std::map<Index, std::pair<Column, Row>> quantised(
  const std::vector<Point>& points, const std::vector<Index>& ids)
{
  Bounds b{ points[ids[0]].x, points[ids[0]].x, points[ids[0]].y, points[ids[0]].y };
  for (const Index id : ids)
  {
    const Point& p = points[id];
    b = { std::min(b.xmin, p.x), std::max(b.xmax, p.x), std::min(b.ymin, p.y),
      std::max(b.ymax, p.y) };
  }
  const Grid grid(b);
  std::map<Index, std::pair<Column, Row>> result;
  for (const Index id : ids)
  {
    result[id] = { grid.column(points[id].x), grid.row(points[id].y) };
  }
  return result;
}

class GridDivision
{
public:
  GridDivision(const std::vector<Point>& points, const Options& options)
    : points_(points)
    , options_(options)
  {
  }

  PaperOrder run()
  {
    std::vector<Index> all;
    for (Index id = 0; id < points_.size(); ++id)
    {
      all.push_back(id);
    }
    if (all.empty())
    {
      return result_;
    }
    place_ = quantised(points_, all);
    if (options_.order == InsertionOrder::AsGiven ||
      (options_.order != InsertionOrder::RegularGrid && !isCrowded(all)))
    {
      putUndivided({ 0, 0, 0, 0, all });
    }
    else
    {
      gridDivide({ 0, 0, 0, 0, all }, Turn::WithoutChange, false, 1);
    }
    insertFromBothSets();
    return result_;
  }

private:
  bool isCrowded(const std::vector<Index>& ids) const
  {
    return ids.size() > std::size_t(options_.nmax);
  }

  bool hasControlPoints(ControlPoints kind) const
  {
    return options_.controlPoints == kind &&
      (options_.order == InsertionOrder::AdaptiveHilbert ||
        options_.order == InsertionOrder::MultiGrid);
  }

  /// The paper's griddivide(m) for one box, traversed in turn.
  void gridDivide(const PaperBox& box, Turn turn, bool reverse, int m)
  {
    const unsigned r = orderOfDivision(box.ids.size());
    if (box.levels + r > 32)
    {
      putByRank(box);
      return;
    }
    const bool isHilbert = options_.order == InsertionOrder::AdaptiveHilbert;
    const Curve curve = isHilbert ? transformed(hilbertCurve(r), turn, reverse) : lineByLine(r);
    std::map<std::pair<Column, Row>, std::vector<Index>> units = assign(box, r);
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      PaperBox unit{ box.column << r | curve[i].first, box.row << r | curve[i].second,
        box.levels + r, m, units[curve[i]] };
      if (m == 1 && hasControlPoints(ControlPoints::SingleLevel) && !unit.ids.empty())
      {
        control_.push_back(unit.ids.front());
        unit.ids.erase(unit.ids.begin());
      }
      if (isCrowded(unit.ids) && options_.order != InsertionOrder::RegularGrid)
      {
        const GeneRow gene = isHilbert && options_.geneRotation
          ? geneOfBox(curve, i)
          : GeneRow{ Step::None, Step::None, Turn::WithoutChange, false };
        gridDivide(unit, gene.turn, gene.reverse, m + 1);
      }
      else
      {
        putUndivided(unit);
      }
    }
  }

  /// The points of each unit of the box, in input order.
  std::map<std::pair<Column, Row>, std::vector<Index>> assign(const PaperBox& box, unsigned r)
  {
    std::map<std::pair<Column, Row>, std::vector<Index>> units;
    const unsigned shift = 32 - box.levels - r;
    const std::uint32_t mask = (1u << r) - 1;
    for (const Index id : box.ids)
    {
      const auto& place = place_.at(id);
      units[{ place.first >> shift & mask, place.second >> shift & mask }].push_back(id);
    }
    return units;
  }

  void putUncontrolled(const PaperBox& box)
  {
    result_.boxes.push_back(box);
    uncontrolled_.insert(uncontrolled_.end(), box.ids.begin(), box.ids.end());
  }

  /// A box that is not crowded: its points in input order, as in the paper; with control points at
  /// every level the curve goes on inside it (a departure).
  void putUndivided(const PaperBox& box)
  {
    if (options_.order == InsertionOrder::AdaptiveHilbert &&
      hasControlPoints(ControlPoints::EveryLevel))
    {
      putByRank(box);
    }
    else
    {
      putUncontrolled(box);
    }
  }

  /// Also where the finest grid does not divide a box as wanted (another departure).
  void putByRank(const PaperBox& box)
  {
    if (rank_.empty())
    {
      const std::vector<Index> ranked = rankByDefinition(points_);
      rank_.resize(points_.size());
      for (std::size_t i = 0; i < ranked.size(); ++i)
      {
        rank_[ranked[i]] = i;
      }
    }
    PaperBox sorted = box;
    std::sort(sorted.ids.begin(), sorted.ids.end(),
      [this](Index a, Index b) { return rank_[a] < rank_[b]; });
    putUncontrolled(sorted);
  }

  void insertFromBothSets()
  {
    result_.sequence.assign(control_.rbegin(), control_.rend());
    result_.sequence.insert(result_.sequence.end(), uncontrolled_.begin(), uncontrolled_.end());
    if (hasControlPoints(ControlPoints::EveryLevel))
    {
      oneOfTwelveFirst(result_.sequence, 1);
    }
  }

  /// Not the paper's: one of every 12 before the others, recursively as long as there are more.
  static void oneOfTwelveFirst(std::vector<Index>& sequence, std::uint64_t stride)
  {
    if (sequence.size() <= 12)
    {
      return;
    }
    std::vector<Index> first, others;
    for (std::size_t begin = 0; begin < sequence.size(); begin += 12)
    {
      const std::size_t count = std::min<std::size_t>(12, sequence.size() - begin);
      std::uint64_t hash = (begin / 12 + stride) * 0x9E3779B97F4A7C15u;
      hash = (hash ^ (hash >> 32)) * 0x9E3779B97F4A7C15u;
      const std::uint64_t drawn = (hash >> 32) * 12 >> 32;
      const std::uint64_t chosen = drawn < count ? drawn : 0;
      for (std::size_t i = 0; i < count; ++i)
      {
        (i == chosen ? first : others).push_back(sequence[begin + i]);
      }
    }
    oneOfTwelveFirst(first, 12 * stride);
    first.insert(first.end(), others.begin(), others.end());
    sequence = first;
  }

  const std::vector<Point>& points_;
  const Options& options_;
  std::map<Index, std::pair<Column, Row>> place_;
  std::vector<Index> control_;
  std::vector<Index> uncontrolled_;
  std::vector<std::size_t> rank_; ///< of each id; empty until needed
  PaperOrder result_;
};

/// Sorts places along the Hilbert curve of 32 levels by walking down it, four quarters at a time.
class QuarterWalk
{
public:
  QuarterWalk(const std::vector<Point>& points, std::vector<Index>& result)
    : points_(points)
    , result_(result)
  {
  }

  /// Ranks distinct points in their own bounds.
  void rank(const std::vector<Index>& ids)
  {
    if (!ids.empty())
    {
      QuarterWalk inside(points_, result_);
      inside.place_ = quantised(points_, ids);
      inside.walk(ids, 31, Turn::WithoutChange, false);
    }
  }

private:
  void walk(const std::vector<Index>& ids, int bit, Turn turn, bool reverse)
  {
    if (ids.size() == 1)
    {
      result_.push_back(ids[0]);
      return;
    }
    if (bit < 0)
    {
      rankSamePlace(ids);
      return;
    }
    const Curve cell = transformed(hilbertCurve(1), turn, reverse);
    for (std::size_t q = 0; q < 4; ++q)
    {
      std::vector<Index> quarter;
      for (const Index id : ids)
      {
        const auto& place = place_.at(id);
        const std::pair<Column, Row> at{ place.first >> bit & 1u, place.second >> bit & 1u };
        if (at == cell[q])
        {
          quarter.push_back(id);
        }
      }
      if (!quarter.empty())
      {
        const GeneRow& gene = geneOfBox(cell, q);
        walk(quarter, bit - 1, gene.turn, gene.reverse);
      }
    }
  }

  void rankSamePlace(std::vector<Index> ids)
  {
    if (ids.size() > 16)
    {
      rank(ids);
      return;
    }
    std::sort(ids.begin(), ids.end(),
      [this](Index a, Index b) { return lexicographicallyLess(points_[a], points_[b]); });
    result_.insert(result_.end(), ids.begin(), ids.end());
  }

  const std::vector<Point>& points_;
  std::vector<Index>& result_;
  std::map<Index, std::pair<Column, Row>> place_;
};

} // namespace

Curve hilbertCurve(unsigned order)
{
  Curve curve;
  const int side = 1 << order;
  drawHilbert({ 0, 0 }, { 0, side }, { side, 0 }, order, curve);
  return curve;
}

Curve transformed(const Curve& curve, Turn turn, bool reverse)
{
  Curve result;
  const std::uint32_t side = sideOf(curve);
  for (const auto& box : curve)
  {
    result.push_back(turned(box, turn, side));
  }
  if (reverse)
  {
    std::reverse(result.begin(), result.end());
  }
  return result;
}

const GeneRow& geneOfBox(const Curve& curve, std::size_t box)
{
  const Step from = box == 0 ? Step::None : stepBetween(curve[box - 1], curve[box]);
  const Step to = box + 1 == curve.size() ? Step::None : stepBetween(curve[box], curve[box + 1]);
  for (const GeneRow& row : geneTable())
  {
    if (row.fromPrevious == from && row.toNext == to)
    {
      return row;
    }
  }
  throw std::logic_error("no gene for a box that the curve leaves where it came from");
}

PaperOrder paperOrder(const std::vector<Point>& points, const Options& options)
{
  return GridDivision(points, options).run();
}

std::vector<Index> rankByDefinition(const std::vector<Point>& points)
{
  std::vector<Index> ids(points.size());
  for (Index id = 0; id < points.size(); ++id)
  {
    ids[id] = id;
  }
  std::sort(ids.begin(), ids.end(),
    [&](Index a, Index b)
    { return lexicographicallyLess(points[a], points[b]) || (points[a] == points[b] && a < b); });
  ids.erase(
    std::unique(ids.begin(), ids.end(), [&](Index a, Index b) { return points[a] == points[b]; }),
    ids.end());
  std::vector<Index> result;
  QuarterWalk(points, result).rank(ids);
  return result;
}

} // namespace test
} // namespace ahd
