// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle is flat over one edge at most, its longest. It is dropped if no triangle is beyond
// that edge, or a dropped one: so each flat triangle follows another one, or the hull, and as
// longest edges grow on the way, none follows itself. Where the way leaves the triangles that a
// block has, it requests the half-edge there from all blocks, once.
#include "BlockRim.h"

#include "../Core/Loops.h"
#include "../Core/SortAsking.h"
#include "../Predicates/Predicates.h"
#include "Steps.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

namespace ahd
{

namespace
{

using Edge = std::array<std::int64_t, 2>;   ///< a half-edge, by the ids of its ends
using Answer = std::array<std::int64_t, 2>; ///< a half-edge's place, the triangle's Fate
enum Fate : std::int32_t                    ///< from 0 on: that of another triangle
{
  Unknown = -3,
  Dropped = -2,
  Kept = -1
};

struct Flat
{
  Index triangle;
  std::int32_t from, to; ///< the longest edge, with the triangle on its left
  Index beyond;          ///< the triangle there, if it is here
  std::int32_t fate;     ///< from 0 on: as beyond this flat triangle
  std::int32_t root;     ///< the place of the half-edge there among the requested ones
};

/// One block's share of the counts.
struct Counts
{
  std::uint64_t triangles = 0, bare = 0;
  double lost = 0.0, whole = 0.0; ///< twice the areas

  auto fields() { return std::tie(triangles, bare, lost, whole); }
};

/// One block's part. Functions that return bool return false if the work is cancelled.
class RimTrimmer
{
public:
  RimTrimmer(const std::vector<Point>& places, BlockStars& stars)
    : places_(places)
    , stars_(stars)
  {
  }

  bool follow(Ticker& ticker)
  {
    return findFlat(ticker) && findBeyond(ticker) && followAll(ticker);
  }
  void ask(std::vector<Edge>& asked) const;
  bool hearAsked(const std::vector<std::vector<Edge>>& all, Ticker& ticker);
  bool answer(std::vector<Answer>& answers, Ticker& ticker);
  bool hearAnswers(const std::vector<std::vector<Answer>>& all, Ticker& ticker);
  bool trim(Counts& counts, Ticker& ticker);

private:
  const Point& place(std::int32_t number) const { return places_[std::size_t(number)]; }
  double doubledArea(std::size_t triangle) const;
  int flatEdgeOf(std::size_t triangle) const;
  bool findFlat(Ticker& ticker);
  template <typename Visit>
  bool eachHalfEdge(std::size_t triangles, const std::vector<unsigned char>& isFrom, Ticker& ticker,
    const Visit& visit) const;
  bool findBeyond(Ticker& ticker);
  bool followAll(Ticker& ticker);
  Flat* flatOf(Index triangle);
  Edge beyond(const Flat& flat) const
  {
    return { { stars_.point(flat.to).id, stars_.point(flat.from).id } };
  }
  std::int64_t placeOf(const Edge& edge) const
  {
    return std::lower_bound(asked_.begin(), asked_.end(), edge) - asked_.begin();
  }
  bool markBare(const std::vector<unsigned char>& kept, Counts& counts, Ticker& ticker) const;

  const std::vector<Point>& places_;
  BlockStars& stars_;
  std::vector<Flat> flats_;         ///< by triangle
  std::vector<Edge> asked_;         ///< of all blocks, sorted
  std::vector<std::int32_t> fates_; ///< beyond these; from 0 on: as beyond this one
  double whole_ = 0.0;              ///< twice the area of own triangles
};

double RimTrimmer::doubledArea(std::size_t triangle) const
{
  const std::int32_t* const corners = stars_.corners(triangle);
  const Point &a = place(corners[0]), &b = place(corners[1]), &c = place(corners[2]);
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

/// The edge over which a triangle is flat, by the corner where it begins; -1 if there is none.
int RimTrimmer::flatEdgeOf(std::size_t triangle) const
{
  const std::int32_t* const c = stars_.corners(triangle);
  for (int k = 0; k < 3; ++k)
  {
    if (isFlat(place(c[k]), place(c[(k + 1) % 3]), place(c[(k + 2) % 3])))
    {
      return k;
    }
  }
  return -1;
}

/// On all threads; finds the area on the way, summed by pieces: the same with any threads.
bool RimTrimmer::findFlat(Ticker& ticker)
{
  constexpr std::size_t kPiece = std::size_t(1) << 14, kLeastShared = std::size_t(1) << 18;
  const std::size_t all = stars_.count(), share = all < kLeastShared ? all + 1 : kPiece;
  std::vector<signed char> edges(all);
  std::vector<double> areas(all / kPiece + 1, 0.0);
  const auto look = [&](std::size_t task, Ticker& own)
  {
    return inSteps(task * share, std::min(all, (task + 1) * share), own,
      [&](std::size_t t)
      {
        edges[t] = static_cast<signed char>(flatEdgeOf(t));
        areas[t / kPiece] += t < stars_.own.count ? doubledArea(t) : 0.0;
      });
  };
  if (!inParallel(ticker, all / share + 1, look))
  {
    return false;
  }
  const auto isThere = [](signed char edge) { return edge >= 0; };
  flats_.reserve(static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), isThere)));
  whole_ = std::accumulate(areas.begin(), areas.end(), 0.0);
  return inSteps(0, all, ticker,
    [&](std::size_t t)
    {
      if (isThere(edges[t]))
      {
        const std::int32_t* const c = stars_.corners(t);
        flats_.push_back(
          { static_cast<Index>(t), c[edges[t]], c[(edges[t] + 1) % 3], kNoIndex, Unknown, 0 });
      }
    });
}

/// Calls visit(triangle, from, to) for the half-edges of the first triangles that begin at one of
/// the points that are marked.
template <typename Visit>
bool RimTrimmer::eachHalfEdge(std::size_t triangles, const std::vector<unsigned char>& isFrom,
  Ticker& ticker, const Visit& visit) const
{
  return inSteps(0, triangles, ticker,
    [&](std::size_t t)
    {
      const std::int32_t* const c = stars_.corners(t);
      for (std::size_t k = 0; k != 3; ++k)
      {
        if (isFrom[std::size_t(c[k])] != 0)
        {
          visit(t, c[k], c[(k + 1) % 3]);
        }
      }
    });
}

/// Of the triangles beyond those that are here.
bool RimTrimmer::findBeyond(Ticker& ticker)
{
  using Wanted = std::array<std::int32_t, 3>; // a half-edge by number, and the flat triangle
  std::vector<Wanted> wanted;
  std::vector<unsigned char> isFrom(places_.size(), 0);
  wanted.reserve(flats_.size());
  for (const Flat& flat : flats_)
  {
    const auto place = static_cast<std::int32_t>(&flat - flats_.data());
    wanted.push_back({ { flat.to, flat.from, place } });
    isFrom[std::size_t(flat.to)] = 1;
  }
  return sortAsking(wanted, ticker, std::less<Wanted>()) &&
    eachHalfEdge(stars_.count(), isFrom, ticker,
      [&](std::size_t t, std::int32_t from, std::int32_t to)
      {
        const auto found = std::lower_bound(
          wanted.begin(), wanted.end(), Wanted{ { from, to, 0 } });
        if (found != wanted.end() && (*found)[0] == from && (*found)[1] == to)
        {
          flats_[std::size_t((*found)[2])].beyond = static_cast<Index>(t);
        }
      });
}

/// Null for one that is not flat.
Flat* RimTrimmer::flatOf(Index triangle)
{
  const auto found = std::lower_bound(flats_.begin(), flats_.end(), triangle,
    [](const Flat& flat, Index t) { return flat.triangle < t; });
  return found != flats_.end() && found->triangle == triangle ? &*found : nullptr;
}

/// Follows flat triangles until their fate is known, or leaves this block. All triangles
/// around an own point are here: beyond an edge of it there is one that is here, or none.
bool RimTrimmer::followAll(Ticker& ticker)
{
  std::vector<Flat*> way;
  for (Flat& first : flats_)
  {
    Flat* flat = &first;
    while (flat && flat->fate == Unknown)
    {
      way.push_back(flat);
      if (flat->beyond == kNoIndex)
      {
        const bool isHull = stars_.isOwn(flat->from) || stars_.isOwn(flat->to);
        flat->fate = isHull ? std::int32_t(Dropped) : std::int32_t(flat - flats_.data());
        break;
      }
      flat = flatOf(flat->beyond);
    }
    const std::int32_t fate = flat ? flat->fate : std::int32_t(Kept);
    for (Flat* const one : way)
    {
      one->fate = fate;
    }
    if (!ticker.step())
    {
      return false;
    }
    way.clear();
  }
  return true;
}

/// The half-edges that this block requests from others.
void RimTrimmer::ask(std::vector<Edge>& asked) const
{
  for (std::size_t i = 0; i != flats_.size(); ++i)
  {
    if (flats_[i].fate == static_cast<std::int32_t>(i))
    {
      asked.push_back(beyond(flats_[i]));
    }
  }
}

bool RimTrimmer::hearAsked(const std::vector<std::vector<Edge>>& all, Ticker& ticker)
{
  for (const std::vector<Edge>& some : all)
  {
    asked_.insert(asked_.end(), some.begin(), some.end());
  }
  if (!sortAsking(asked_, ticker, std::less<Edge>()))
  {
    return false;
  }
  asked_.erase(std::unique(asked_.begin(), asked_.end()), asked_.end());
  fates_.assign(asked_.size(), Dropped); // without a triangle beyond, the chain is dropped
  for (Flat& flat : flats_)
  {
    if (flat.fate >= 0)
    {
      flat.root = static_cast<std::int32_t>(placeOf(beyond(flats_[std::size_t(flat.fate)])));
    }
  }
  return true;
}

/// The fates of own triangles at the requested half-edges.
bool RimTrimmer::answer(std::vector<Answer>& answers, Ticker& ticker)
{
  if (asked_.empty())
  {
    return true;
  }
  std::vector<unsigned char> isFrom(places_.size(), 0);
  const auto mark = [&](std::size_t i)
  {
    const std::int64_t id = stars_.point(static_cast<std::int32_t>(i)).id;
    const auto found = std::lower_bound(asked_.begin(), asked_.end(), Edge{ { id, 0 } });
    isFrom[i] = found != asked_.end() && (*found)[0] == id ? 1 : 0;
  };
  return inSteps(0, isFrom.size(), ticker, mark) &&
    eachHalfEdge(stars_.own.count, isFrom, ticker,
      [&](std::size_t t, std::int32_t from, std::int32_t to)
      {
        const Edge edge = { { stars_.point(from).id, stars_.point(to).id } };
        const std::int64_t place = placeOf(edge);
        if (std::size_t(place) < asked_.size() && asked_[std::size_t(place)] == edge)
        {
          const Flat* const flat = flatOf(static_cast<Index>(t));
          const std::int32_t fate = !flat ? std::int32_t(Kept)
            : flat->fate >= 0             ? flat->root
                                          : flat->fate;
          answers.push_back({ { place, fate } });
        }
      });
}

/// A block that answers with another half-edge has requested that one itself.
bool RimTrimmer::hearAnswers(const std::vector<std::vector<Answer>>& all, Ticker& ticker)
{
  for (const std::vector<Answer>& answers : all)
  {
    for (const Answer& answer : answers)
    {
      fates_[std::size_t(answer[0])] = static_cast<std::int32_t>(answer[1]);
    }
  }
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i != fates_.size(); ++i)
  {
    std::size_t last = i;
    for (; fates_[last] >= 0; last = std::size_t(fates_[last]))
    {
      way.push_back(last);
    }
    for (const std::size_t one : way)
    {
      fates_[one] = fates_[last];
    }
    if (!ticker.step())
    {
      return false;
    }
    way.clear();
  }
  for (Flat& flat : flats_)
  {
    flat.fate = flat.fate >= 0 ? fates_[std::size_t(flat.root)] : flat.fate;
  }
  return true;
}

/// Counts own vertices that are corners of dropped triangles, and of none that stay.
bool RimTrimmer::markBare(
  const std::vector<unsigned char>& kept, Counts& counts, Ticker& ticker) const
{
  std::vector<unsigned char> isBare(places_.size(), 0);
  for (const std::uint8_t mark : { std::uint8_t(1), std::uint8_t(0) })
  {
    const auto set = [&](std::size_t t)
    {
      const std::int32_t* const c = stars_.corners(t);
      for (std::size_t k = 0; k != 3 && kept[t] != mark; ++k)
      {
        isBare[std::size_t(c[k])] = mark;
      }
    };
    if (!inSteps(0, kept.size(), ticker, set))
    {
      return false;
    }
  }
  counts.bare = static_cast<std::uint64_t>(
    std::count(isBare.begin(), isBare.begin() + std::ptrdiff_t(stars_.points), 1));
  return true;
}

bool RimTrimmer::trim(Counts& counts, Ticker& ticker)
{
  std::vector<unsigned char> kept(stars_.count(), 1);
  counts.whole = whole_;
  for (const Flat& flat : flats_)
  {
    kept[flat.triangle] = flat.fate == Kept ? 1 : 0;
    if (flat.fate != Kept && flat.triangle < stars_.own.count)
    {
      counts.lost += doubledArea(flat.triangle);
      ++counts.triangles;
    }
  }
  if (!markBare(kept, counts, ticker))
  {
    return false;
  }
  const std::uint8_t* const aroundKept = kept.data() + stars_.own.count;
  stars_.own.keep(kept.data());
  stars_.around.keep(aroundKept);
  return true;
}

} // namespace

Status trimBlocks(const std::vector<Point>& places, BlockTransport& transport,
  const Context& context, BlockStars& stars, BlockRim& rim)
{
  RimTrimmer trimmer(places, stars);
  std::vector<std::vector<Edge>> asked;
  std::vector<std::vector<Answer>> answers;
  std::vector<Counts> counts;
  Steps steps(transport, context);
  steps.share(asked,
    [&](std::vector<Edge>& own, Ticker& ticker)
    {
      const bool isDone = trimmer.follow(ticker);
      trimmer.ask(own);
      return isDone;
    });
  steps.share(answers,
    [&](std::vector<Answer>& own, Ticker& ticker)
    { return trimmer.hearAsked(asked, ticker) && trimmer.answer(own, ticker); });
  steps.share(counts,
    [&](Counts& own, Ticker& ticker)
    { return trimmer.hearAnswers(answers, ticker) && trimmer.trim(own, ticker); });
  rim = BlockRim();
  double lost = 0.0, whole = 0.0;
  for (const Counts& of : counts)
  {
    rim.triangles += static_cast<std::size_t>(of.triangles);
    rim.bareVertices += static_cast<std::size_t>(of.bare);
    lost += of.lost;
    whole += of.whole;
  }
  rim.area = rim.triangles == 0 ? 0.0 : lost / whole;
  return steps.status();
}

} // namespace ahd
