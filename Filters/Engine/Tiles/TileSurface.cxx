// SPDX-License-Identifier: BSD-3-Clause
//
// What values at places of a leaf need: points of other leaves, and with lines or loops triangles.
#include "../Constrain/EdgeTable.h"
#include "../Core/Border.h"
#include "../Core/SortAsking.h"
#include "../Surface/Circumradius.h"
#include "TileVisits.h"

#include <algorithm>

namespace ahd
{

namespace
{

/// A point of another leaf.
struct Listed
{
  std::uint32_t block;
  std::int64_t id;
  Point at;

  bool operator<(const Listed& other) const
  {
    return block != other.block ? block < other.block : id < other.id;
  }
  bool operator==(const Listed& other) const { return block == other.block && id == other.id; }
};

/// Ascending, each once.
bool list(std::size_t leaf, const TileKept& kept, Ticker& ticker, std::vector<Listed>& listed)
{
  for (const TileSection& section : kept.sections)
  {
    const auto add = [&](std::size_t i)
    {
      const BorderPoint& point = section.points[i];
      if (point.block != leaf)
      {
        listed.push_back({ point.block, point.id, point.at });
      }
    };
    if (!inSteps(0, section.points.size(), ticker, add))
    {
      return false;
    }
  }
  return sortOnce(listed, ticker);
}

bool put(const std::vector<Listed>& listed, Ticker& ticker, TileOutput& out)
{
  return inSteps(0, listed.size(), ticker,
    [&](std::size_t i)
    {
      out.listPoints.insert(out.listPoints.end(), { listed[i].at.x, listed[i].at.y });
      out.listIds.push_back(listed[i].id);
    });
}

/// The triangles that values at places of a leaf need.
class Surface
{
public:
  Surface(const TilePlan& plan, const TilePoints& given, const std::vector<Listed>& listed,
    Ticker& ticker)
    : plan_(plan)
    , given_(given)
    , listed_(listed)
    , ticker_(ticker)
  {
  }

  bool make(const TileKept& kept, double longest, TileOutput& out)
  {
    return takeOwn(kept) && takeSections(kept) && (!(longest > 0.0) || dropLong(longest)) &&
      markEnds() && put(out);
  }

private:
  /// Places among the leaf's points, then the list.
  struct Triangle
  {
    std::array<Index, 3> corners;
    std::uint8_t flags;
  };

  bool takeOwn(const TileKept& kept)
  {
    return inSteps(0, kept.own.count, ticker_,
      [&](std::size_t t)
      {
        if (kept.isOwnKept(t))
        {
          triangles_.push_back({ kept.own[t], 0 });
        }
      });
  }

  /// @pre it is the leaf's, or listed
  Index placeOf(const BorderPoint& point) const
  {
    const std::size_t own = given_.points.count;
    if (point.block != given_.leaf)
    {
      const Listed wanted{ point.block, point.id, point.at };
      return static_cast<Index>(own) +
        static_cast<Index>(
          std::lower_bound(listed_.begin(), listed_.end(), wanted) - listed_.begin());
    }
    return static_cast<Index>(given_.ids
        ? std::lower_bound(given_.ids, given_.ids + own, point.id) - given_.ids
        : point.id - static_cast<std::int64_t>(plan_.firstPoint(given_.leaf)));
  }

  bool takeSections(const TileKept& kept)
  {
    for (std::size_t k = 0; k != kept.sections.size(); ++k)
    {
      const TileSection& section = kept.sections[k];
      const auto take = [&](std::size_t t)
      {
        const std::array<Index, 3>& c = section.corners[t];
        if (kept.isKept(k, t))
        {
          triangles_.push_back({ { { placeOf(section.points[c[0]]), placeOf(section.points[c[1]]),
                                   placeOf(section.points[c[2]]) } },
            static_cast<std::uint8_t>(section.flags[t] & 7u) });
        }
      };
      if (!inSteps(0, section.corners.size(), ticker_, take))
      {
        return false;
      }
    }
    return true;
  }

  bool dropLong(double longest)
  {
    const LengthLimit limit(longest);
    const std::size_t own = given_.points.count;
    const auto at = [&](Index place)
    { return place < own ? given_.points[place] : listed_[place - own].at; };
    std::size_t kept = 0;
    const auto look = [&](std::size_t t)
    {
      const std::array<Index, 3> c = triangles_[t].corners;
      triangles_[kept] = triangles_[t];
      kept += limit.isExceeded(at(c[0]), at(c[1]), at(c[2])) ? 0u : 1u;
    };
    const bool goesOn = inSteps(0, triangles_.size(), ticker_, look);
    triangles_.resize(kept);
    return goesOn;
  }

  /// An edge of one triangle only.
  bool markEnds()
  {
    EdgeTable<std::uint64_t> uses(ticker_);
    if (!uses.begin(triangles_.size() + triangles_.size() / 2))
    {
      return false;
    }
    for (const Triangle& t : triangles_)
    {
      for (std::size_t e = 0; e != 3; ++e)
      {
        std::uint64_t* const count = uses.add(t.corners[e], t.corners[(e + 1) % 3], 0);
        if (!count || !ticker_.step())
        {
          return false;
        }
        ++*count;
      }
    }
    return inSteps(0, triangles_.size(), ticker_,
      [&](std::size_t i)
      {
        Triangle& t = triangles_[i];
        for (std::size_t e = 0; e != 3; ++e)
        {
          const bool isEnd = *uses.find(t.corners[e], t.corners[(e + 1) % 3]) == 1;
          t.flags = static_cast<std::uint8_t>(t.flags | unsigned(isEnd) << e);
        }
      });
  }

  bool put(TileOutput& out)
  {
    return inSteps(0, triangles_.size(), ticker_,
      [&](std::size_t i)
      {
        out.surface.insert(
          out.surface.end(), triangles_[i].corners.begin(), triangles_[i].corners.end());
        out.surfaceEdges.push_back(triangles_[i].flags);
      });
  }

  const TilePlan& plan_;
  const TilePoints& given_;
  const std::vector<Listed>& listed_;
  Ticker& ticker_;
  std::vector<Triangle> triangles_;
};

} // namespace

Status TileVisits::makeList(
  std::size_t leaf, const TileKept& kept, const Context& context, TileOutput& out) const
{
  out = TileOutput();
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      out.constraints = kept.constraints;
      std::vector<Listed> listed;
      return list(leaf, kept, ticker, listed) && put(listed, ticker, out);
    });
}

Status TileVisits::makeSurface(const TilePoints& given, const TileKept& kept, double longest,
  const Context& context, TileOutput& out) const
{
  out = TileOutput();
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      out.constraints = kept.constraints;
      std::vector<Listed> listed;
      return list(given.leaf, kept, ticker, listed) && put(listed, ticker, out) &&
        Surface(plan_, given, listed, ticker).make(kept, longest, out);
    });
}

} // namespace ahd
