// SPDX-License-Identifier: BSD-3-Clause
#include "../Core/AskedMemory.h"
#include "../Core/SortAsking.h"
#include "../Points/JoinedBounds.h"
#include "../Predicates/Discs.h"
#include "../Predicates/Predicates.h"
#include "TileVisits.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// Finds what each leaf needs of the triangles that became final in a node.
class Sharing
{
public:
  Sharing(const TilePlan& plan, std::size_t node, const Part& part,
    const std::vector<TileBorder>& borders, Ticker& ticker)
    : plan_(plan)
    , node_(node)
    , part_(part)
    , borders_(borders)
    , given_(part.given())
    , ticker_(ticker)
    , memory_(ticker)
  {
  }

  bool write(BlockBytes& share)
  {
    return listTriangles() && (node_ != plan_.root() || listHull()) && sort() && listCrowds() &&
      writeSections(share);
  }

private:
  /// A triangle, or a point, for a leaf.
  struct Item
  {
    Index leaf, number;

    bool operator<(const Item& other) const
    {
      return leaf != other.leaf ? leaf < other.leaf : number < other.number;
    }
    bool operator==(const Item& other) const
    {
      return leaf == other.leaf && number == other.number;
    }
  };

  struct Triangle
  {
    std::array<Index, 3> corners;
    std::uint8_t flags;
    Index piece;
  };

  /// Calls visit(leaf) for those of the node for whose reach `meets` holds: it holds for that of
  /// a node if it does for one within.
  template <typename Meets, typename Visit>
  void eachLeaf(const Meets& meets, Visit visit)
  {
    open_.assign(1, node_);
    while (goesOn_ && !open_.empty())
    {
      const std::size_t part = open_.back();
      open_.pop_back();
      goesOn_ = ticker_.step();
      const bool isLeaf = part < plan_.leaves();
      if (!isEmpty(plan_.reach(part)) && meets(plan_.reach(part), isLeaf))
      {
        isLeaf ? visit(static_cast<Index>(part)) : openAll(part);
      }
    }
  }
  void openAll(std::size_t node)
  {
    const std::vector<std::size_t>& parts = plan_.joinedBy(node);
    open_.insert(open_.end(), parts.begin(), parts.end());
  }

  bool listTriangles()
  {
    return part_.eachFinal(ticker_,
             [&](const std::array<Index, 3>& corners, std::uint8_t flags, Index piece)
             {
               const Corners at{ given_[corners[0]].at, given_[corners[1]].at,
                 given_[corners[2]].at };
               const Circumdisc disc(at);
               const auto meets = [&disc](const Bounds& box, bool isLeaf)
               { return isLeaf ? disc.meets(box) : disc.meetsByFilter(box).value_or(true); };
               const auto triangle = static_cast<Index>(triangles_.size());
               eachLeaf(meets, [&](Index leaf) { memory_.add(ofLeaves_, Item{ leaf, triangle }); });
               triangles_.push_back({ corners, flags, piece });
             }) &&
      goesOn_;
  }

  /// The ends of edges of the hull that a leaf has a place beyond, or on their line. All points
  /// where there is no triangle.
  bool listHull()
  {
    const auto always = [](const Bounds&, bool) { return true; };
    for (std::size_t i = 0; !part_.hasTriangles() && goesOn_ && i != given_.size(); ++i)
    {
      const auto point = static_cast<Index>(i);
      eachLeaf(always, [&](Index leaf) { memory_.add(points_, Item{ leaf, point }); });
    }
    part_.eachHullEdge(
      [&](Index from, Index to)
      {
        const Point a = given_[from].at, b = given_[to].at;
        const auto isBeyond = [&a, &b](const Bounds& box, bool)
        {
          return orient2d(a, b, { box.xmin, box.ymin }) <= 0 ||
            orient2d(a, b, { box.xmax, box.ymin }) <= 0 ||
            orient2d(a, b, { box.xmin, box.ymax }) <= 0 ||
            orient2d(a, b, { box.xmax, box.ymax }) <= 0;
        };
        eachLeaf(isBeyond,
          [&](Index leaf)
          {
            memory_.add(points_, Item{ leaf, from });
            memory_.add(points_, Item{ leaf, to });
          });
      });
    return goesOn_;
  }

  /// By leaves; points with the corners of triangles.
  bool sort()
  {
    for (const Item& item : ofLeaves_)
    {
      for (const Index corner : triangles_[item.number].corners)
      {
        memory_.add(points_, Item{ item.leaf, corner });
      }
      if (!ticker_.step())
      {
        return false;
      }
    }
    return sortOnce(ofLeaves_, ticker_) && sortOnce(points_, ticker_);
  }

  /// Of a crowd a leaf gets all points.
  bool listCrowds()
  {
    std::vector<std::pair<std::uint64_t, Index>> crowded; // keys
    const auto find = [&](std::size_t i)
    {
      if ((given_[i].marks & BorderPoint::kOfCrowd) != 0)
      {
        crowded.emplace_back(plan_.grid().keyOf(given_[i].at), Index(i));
      }
    };
    if (!inSteps(0, given_.size(), ticker_, find) || !sortOnce(crowded, ticker_))
    {
      return false;
    }
    std::vector<std::pair<Index, std::uint64_t>> wanted; // by leaves
    for (const Item& item : points_)
    {
      if (!crowded.empty() && (given_[item.number].marks & BorderPoint::kOfCrowd) != 0)
      {
        wanted.emplace_back(item.leaf, plan_.grid().keyOf(given_[item.number].at));
      }
    }
    if (!sortOnce(wanted, ticker_))
    {
      return false;
    }
    for (const auto& [leaf, key] : wanted)
    {
      auto at = std::lower_bound(crowded.begin(), crowded.end(), std::make_pair(key, Index(0)));
      for (; at != crowded.end() && at->first == key && goesOn_; ++at)
      {
        memory_.add(points_, Item{ leaf, at->second });
        goesOn_ = ticker_.step();
      }
    }
    return goesOn_ && (wanted.empty() || sortOnce(points_, ticker_));
  }

  bool writeSections(BlockBytes& share)
  {
    followPieces();
    const std::size_t most = points_.size() * sizeof(BorderPoint) +
      ofLeaves_.size() * (sizeof(std::array<Index, 3>) + 1 + sizeof(Index));
    memory_.take(most);
    share.reserve(most);
    ShareWriter writer(plan_, node_, constraintsOf(part_.triangulation().constraints()), share);
    auto point = points_.cbegin(), triangle = ofLeaves_.cbegin();
    for (std::size_t leaf = plan_.rowOf(node_).begin; leaf != plan_.rowOf(node_).end; ++leaf)
    {
      const auto firstPoint = point, firstTriangle = triangle;
      const auto isOther = [leaf](const Item& item) { return item.leaf != leaf; };
      point = std::find_if(firstPoint, points_.cend(), isOther);
      triangle = std::find_if(firstTriangle, ofLeaves_.cend(), isOther);
      TileSection section = sectionOf({ firstPoint, point }, { firstTriangle, triangle });
      section.pieces = piecesFor(leaf);
      writer.add(section);
      if (!ticker_.ask())
      {
        return false;
      }
    }
    writer.end();
    return true;
  }

  using Place = std::vector<Item>::const_iterator;
  struct Items
  {
    Place begin, end;
  };
  TileSection sectionOf(const Items& points, const Items& triangles) const
  {
    TileSection section;
    for (Place point = points.begin; point != points.end; ++point)
    {
      section.points.push_back(given_[point->number]);
    }
    for (Place item = triangles.begin; item != triangles.end; ++item)
    {
      const Triangle& triangle = triangles_[item->number];
      std::array<Index, 3> places;
      std::uint32_t lowest = ~std::uint32_t(0);
      for (unsigned e = 0; e != 3; ++e)
      {
        const Item corner{ item->leaf, triangle.corners[e] };
        places[e] = static_cast<Index>(
          std::lower_bound(points.begin, points.end, corner) - points.begin);
        lowest = std::min(lowest, given_[corner.number].block); // leaves are in the order of ranks
      }
      section.corners.push_back(places);
      section.flags.push_back(static_cast<std::uint8_t>(
        triangle.flags | (lowest == item->leaf ? TileSection::kOwned : 0u)));
      if (plan_.hasLoops() && node_ != plan_.root())
      {
        section.pieceOf.push_back(triangle.piece);
      }
    }
    return section;
  }

  /// Of each piece of each part below, what it is here.
  void followPieces()
  {
    for (std::size_t child = 0; plan_.hasLoops() && child != borders_.size(); ++child)
    {
      const std::vector<Index>& below = borders_[child].pieces;
      Part::Kept kept;
      std::vector<Index> here;
      if (node_ == plan_.root())
      {
        part_.tellKept(child, kept);
      }
      else
      {
        here = part_.piecesBelow(child);
      }
      pieces_.emplace_back();
      for (std::size_t i = 0; i != below.size(); ++i)
      {
        pieces_.back().resize(std::max<std::size_t>(pieces_.back().size(), below[i] + 1));
        pieces_.back()[below[i]] = !here.empty() ? here[i] : kept.isAll ? 1 : kept.edges[i];
      }
    }
  }

  /// Of those of the part that has the leaf.
  std::vector<Index> piecesFor(std::size_t leaf) const
  {
    for (std::size_t child = 0; child != pieces_.size(); ++child)
    {
      if (plan_.rowOf(plan_.joinedBy(node_)[child]).has(leaf))
      {
        return pieces_[child];
      }
    }
    return {};
  }

  const TilePlan& plan_;
  const std::size_t node_;
  const Part& part_;
  const std::vector<TileBorder>& borders_; ///< of the parts below; they have their pieces
  const std::vector<BorderPoint>& given_;
  Ticker& ticker_;
  GrowingMemory memory_; ///< of the lists, and of the share
  bool goesOn_ = true;
  std::vector<std::size_t> open_;
  std::vector<Triangle> triangles_;
  std::vector<Item> ofLeaves_; ///< triangles
  std::vector<Item> points_;
  std::vector<std::vector<Index>> pieces_;
};

} // namespace

bool writeShare(const TilePlan& plan, std::size_t node, const Part& part,
  const std::vector<TileBorder>& borders, Ticker& ticker, BlockBytes& share)
{
  return Sharing(plan, node, part, borders, ticker).write(share);
}

} // namespace ahd
