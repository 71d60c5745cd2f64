// SPDX-License-Identifier: BSD-3-Clause
#include "BlockNeeds.h"

#include "../Core/SortAsking.h"
#include "../Points/JoinedBounds.h"
#include "BlockState.h"
#include "Steps.h"

#include <algorithm>
#include <functional>

namespace ahd
{

namespace
{

Status okUnlessCancelled(bool isDone)
{
  return isDone ? Status::Ok : Status::Cancelled;
}

} // namespace

/// Those that are triangulated.
bool BlockNeeds::readOwn(Ticker& ticker)
{
  const PointView& points = input_.points;
  const auto read = [&](std::size_t i)
  {
    const Point p = points[i];
    if (isFinite(p) && !points.skipped(i))
    {
      places_.insert(places_.end(), { p.x, p.y });
      ids_.push_back(input_.ids[i]);
      ownBounds_ = joined(ownBounds_, p);
    }
  };
  const bool isDone = inSteps(0, points.count, ticker, read);
  own_ = ids_.size();
  return isDone;
}

/// In the triangulation; -1 if it has none.
std::int64_t BlockNeeds::numberOf(std::int64_t id) const
{
  const auto others = ids_.begin() + static_cast<std::ptrdiff_t>(own_);
  for (const auto& part :
    { std::make_pair(ids_.begin(), others), std::make_pair(others, ids_.end()) })
  {
    const auto found = std::lower_bound(part.first, part.second, id);
    if (found != part.second && *found == id)
    {
      return found - ids_.begin();
    }
  }
  return -1;
}

/// Own points that all blocks must have: those on the bounds of own points, with loops also the
/// vertices of their hull, and those that constraints name.
Status BlockNeeds::listShared(std::vector<Shared>& shared, Ticker& ticker)
{
  if (!readOwn(ticker))
  {
    return Status::Cancelled;
  }
  const ConstraintView& given = input_.constraints;
  const PointView view(places_.data(), own_, 2);
  Triangulation own;
  Status status = triangulate(view, Options(), workspace_, context_, own);
  status = status == Status::Ok ? findExtremes(own, given.chains > given.lines, context_, shared_)
                                : status;
  if (status != Status::Ok)
  {
    return status;
  }
  const std::size_t count = constraintIds(given);
  const auto first = count == 0 ? std::size_t(0) : std::size_t(given.offsets[0]);
  const auto add = [&](std::size_t i)
  {
    const std::int64_t number = numberOf(given.ids[i]);
    if (number >= 0)
    {
      shared_.push_back(static_cast<Index>(number));
    }
  };
  const bool isDone = inSteps(first, first + count, ticker, add) && sortOnce(shared_, ticker);
  for (const Index number : shared_)
  {
    shared.push_back({ ids_[number], view[number] });
  }
  return okUnlessCancelled(isDone);
}

/// Those of others, behind own points.
bool BlockNeeds::addShared(const std::vector<std::vector<Shared>>& all, Ticker& ticker)
{
  std::vector<Shared> others;
  for (std::size_t block = 0; block != all.size(); ++block)
  {
    if (block != input_.block)
    {
      others.insert(others.end(), all[block].begin(), all[block].end());
    }
  }
  const bool isDone = sortAsking(others, ticker, std::less<Shared>());
  for (const Shared& point : others)
  {
    places_.insert(places_.end(), { point.at.x, point.at.y });
    ids_.push_back(point.id);
  }
  return isDone;
}

Status BlockNeeds::make(const std::vector<std::vector<Shared>>& all, Ticker& ticker)
{
  if (!addShared(all, ticker))
  {
    return Status::Cancelled;
  }
  const PointView view(places_.data(), ids_.size(), 2);
  const bool isConstrained = constraintIds(input_.constraints) > 0;
  Status status = isConstrained && also_ == Also::Nearest
    ? triangulate(view, Options(), workspace_, context_, plain_)
    : Status::Ok;
  status = status == Status::Ok ? triangulate(view, Options(), workspace_, context_, made_)
                                : status;
  status = status == Status::Ok && isConstrained ? constrain(ticker) : status;
  status = status == Status::Ok ? made_.makePointMap(context_) : status;
  return status == Status::Ok ? okUnlessCancelled(listCoincident(ticker)) : status;
}

Status BlockNeeds::constrain(Ticker& ticker)
{
  ConstraintView given = input_.constraints;
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(given.offsets[given.chains]));
  if (!inSteps(std::size_t(given.offsets[0]), numbers.size(), ticker,
        [&](std::size_t i) { numbers[i] = numberOf(given.ids[i]); }))
  {
    return Status::Cancelled;
  }
  given.ids = numbers.data();
  return ahd::constrain(std::move(made_), given, input_.rule, context_, made_);
}

/// Own points at the places of others.
bool BlockNeeds::listCoincident(Ticker& ticker)
{
  const auto look = [&](std::size_t i)
  {
    const Index vertex = made_.vertexOf(i);
    const Index first = vertex == kNoIndex ? vertex : made_.pointOf(vertex);
    if (first != kNoIndex && first != i)
    {
      coincident_.emplace_back(first, static_cast<Index>(i));
    }
  };
  return inSteps(0, own_, ticker, look) && sortAsking(coincident_, ticker, std::less<Pair>());
}

/// Of points that stand for vertices, all at the same places; others' are left out.
bool BlockNeeds::addCoincident(std::vector<Index>& numbers, Ticker& ticker) const
{
  const auto add = [&](std::size_t k)
  {
    const Index first = numbers[k];
    auto more = std::lower_bound(coincident_.begin(), coincident_.end(), Pair(first, 0));
    for (; more != coincident_.end() && more->first == first; ++more)
    {
      numbers.push_back(more->second);
    }
  };
  const bool isDone = inSteps(0, numbers.size(), ticker, add) && sortOnce(numbers, ticker);
  numbers.erase(std::lower_bound(numbers.begin(), numbers.end(), own_), numbers.end());
  return isDone;
}

/// Could others' points that a block does not have change the order of those that it has, or which
/// constraints are left out, or be wanted wherever they are? The same on all blocks.
bool BlockNeeds::mustTakeAll(const std::vector<Facts>& all) const
{
  bool crosses = false;
  std::uint64_t most = 0;
  for (const Facts& one : all)
  {
    std::uint64_t together = one.crowd;
    for (const Facts& other : all)
    {
      const bool isNear = &other != &one && shareBox(bounds(), one.bounds, other.bounds);
      together += isNear ? other.crowd : 0;
    }
    most = std::max(most, together);
    crosses = crosses || one.crosses;
  }
  const bool hasLoops = input_.constraints.chains > input_.constraints.lines;
  return crosses || most > crowdLimit() || also_ == Also::All ||
    (also_ == Also::Nearest && hasLoops);
}

Status BlockNeeds::begin()
{
  std::vector<std::vector<Shared>> shared;
  std::vector<Facts> facts;
  Steps steps(transport_, context_);
  steps.share(shared, [&](std::vector<Shared>& own, Ticker& t) { return listShared(own, t); });
  steps.share(facts,
    [&](Facts& own, Ticker& ticker)
    {
      std::size_t most = 0;
      Status status = make(shared, ticker);
      status = status == Status::Ok ? findCrowd(made_, context_, most) : status;
      own = { most, made_.constraints().crossing > 0, ownBounds_ };
      return status;
    });
  listsAll_ = mustTakeAll(facts);
  return steps.status();
}

/// The ids of own points that others need for places in these boxes, ascending.
Status BlockNeeds::list(
  const std::vector<Bounds>& boxes, std::vector<std::int64_t>& ids, Ticker& ticker)
{
  if (boxes.empty())
  {
    return Status::Ok;
  }
  if (listsAll_)
  {
    ids.assign(ids_.begin(), ids_.begin() + std::ptrdiff_t(own_));
    return Status::Ok;
  }
  std::vector<Index> numbers, hidden;
  Status status = findBoxNeighbors(made_, boxes, context_, numbers);
  status = status == Status::Ok ? findBoxNeighbors(plain_, boxes, context_, hidden) : status;
  numbers.insert(numbers.end(), hidden.begin(), hidden.end());
  for (const Index own : shared_)
  {
    const Index vertex = made_.vertexOf(own);
    numbers.push_back(vertex == kNoIndex ? own : made_.pointOf(vertex));
  }
  if (status != Status::Ok || !sortOnce(numbers, ticker) || !addCoincident(numbers, ticker))
  {
    return status != Status::Ok ? status : Status::Cancelled;
  }
  for (const Index number : numbers)
  {
    ids.push_back(ids_[number]);
  }
  return Status::Ok;
}

Status BlockNeeds::find(const std::vector<Bounds>& boxes, std::vector<BlockPoint>& needed)
{
  std::vector<std::vector<Bounds>> all;
  std::vector<std::vector<std::int64_t>> from;
  Steps steps(transport_, context_);
  steps.share(all,
    [&](std::vector<Bounds>& own, Ticker&)
    {
      own = boxes;
      growByRounding(bounds(), own);
      return true;
    });
  steps.exchange(from,
    [&](std::vector<std::vector<std::int64_t>>& to, Ticker& ticker)
    {
      to.resize(all.size());
      Status status = Status::Ok;
      for (std::size_t block = 0; block != all.size() && status == Status::Ok; ++block)
      {
        status = list(all[block], to[block], ticker);
      }
      return status;
    });
  steps.each(
    [&](Ticker& ticker)
    {
      for (std::size_t block = 0; block != from.size(); ++block)
      {
        for (const std::int64_t id : from[block])
        {
          needed.push_back({ id, block });
        }
      }
      return sortAsking(needed, ticker, std::less<BlockPoint>());
    });
  return steps.status();
}

std::size_t needsMemoryEstimate(std::size_t points, std::size_t constraintIds, bool nearest)
{
  const std::size_t one = triangulationMemoryEstimate(points, Options());
  if (one == std::size_t(-1))
  {
    return one; // too many points
  }
  // a place, a number and an id, which may have room for as many more; pairs of coincident points
  constexpr std::size_t kPerPoint = 2 * (2 * sizeof(double) + sizeof(Index) + 8) + 16 + 8;
  const std::size_t constrained = constraintIds == 0
    ? 0
    : constraintMemoryEstimate(points, constraintIds);
  return points * kPerPoint + constrained + 8 * constraintIds +
    (one + tableMemoryEstimate(points)) * (constraintIds > 0 && nearest ? 2 : 1);
}

} // namespace ahd
