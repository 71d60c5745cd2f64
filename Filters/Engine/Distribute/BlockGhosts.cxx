// SPDX-License-Identifier: BSD-3-Clause
#include "BlockGhosts.h"

#include "../Core/SortAsking.h"
#include "Steps.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ahd
{

GhostTriangle BlockGhosts::triangle(std::size_t place) const
{
  const std::int32_t* const c = stars_.corners(place);
  const std::size_t own = stars_.own.count;
  return { { stars_.point(c[0]), stars_.point(c[1]), stars_.point(c[2]) },
    place < own ? firstId_ + static_cast<std::int64_t>(place) : aroundIds_[place - own],
    stars_.edges(place) };
}

bool BlockGhosts::hasPointOf(std::size_t block, std::size_t place) const
{
  const std::int32_t* const c = stars_.corners(place);
  return std::any_of(
    c, c + 3, [&](std::int32_t corner) { return stars_.point(corner).block == block; });
}

/// The ids of own triangles, for each block that has them around it.
bool BlockGhosts::listIds(std::vector<Ids>& to, Ticker& ticker) const
{
  to.assign(stars_.blocks, Ids());
  const auto list = [&](std::size_t t)
  {
    const std::int32_t* const c = stars_.corners(t); // the lowest is own
    const std::uint64_t second = stars_.point(c[1]).block, third = stars_.point(c[2]).block;
    const std::int64_t id = firstId_ + static_cast<std::int64_t>(t);
    if (second != stars_.block)
    {
      to[second].push_back(id);
    }
    if (third != stars_.block && third != second)
    {
      to[third].push_back(id);
    }
  };
  return inSteps(stars_.own.inside, stars_.own.count, ticker, list);
}

/// The triangles around come from their owner in its order: so do their ids.
bool BlockGhosts::takeIds(const std::vector<Ids>& from, Ticker& ticker)
{
  std::vector<std::size_t> next(stars_.blocks, 0);
  const std::size_t own = stars_.own.count;
  aroundIds_.resize(stars_.around.count);
  cells_.reserve(aroundIds_.size());
  return inSteps(0, aroundIds_.size(), ticker,
    [&](std::size_t t)
    {
      const std::uint64_t owner = stars_.point(stars_.corners(own + t)[0]).block;
      aroundIds_[t] = from[owner][next[owner]++];
      cells_.push_back(triangle(own + t));
    });
}

Status BlockGhosts::begin(std::size_t firstId)
{
  firstId_ = static_cast<std::int64_t>(firstId);
  std::vector<Ids> from;
  Steps steps(transport_, context_);
  steps.exchange(from, [&](std::vector<Ids>& to, Ticker& ticker) { return listIds(to, ticker); });
  steps.each([&](Ticker& ticker) { return takeIds(from, ticker); });
  return steps.status();
}

bool BlockGhosts::addForeign(std::vector<BlockPoint>& points, Ticker& ticker) const
{
  const auto add = [&](std::size_t i)
  {
    std::copy_if(cells_[i].corners, cells_[i].corners + 3, std::back_inserter(points),
      [&](const BlockPoint& corner) { return corner.block != stars_.block; });
  };
  return inSteps(0, cells_.size(), ticker, add) && sortOnce(points, ticker);
}

Status BlockGhosts::addForeign(std::vector<BlockPoint>& points) const
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context_.progress, Phase::Outputs, 0);
      return addForeign(points, ticker);
    });
}

/// The points of others on the inside of the next layer and of no earlier one.
bool BlockGhosts::listNew(std::vector<BlockPoint>& points, Ticker& ticker) const
{
  const BlockTriangles& own = stars_.own;
  const auto add = [&](std::size_t i)
  {
    if (!stars_.isOwn(own.corners[i]))
    {
      points.push_back(stars_.point(own.corners[i]));
    }
  };
  if (hasLayer_ ? !addForeign(points, ticker)
                : !inSteps(3 * own.inside, 3 * own.count, ticker, add) || !sortOnce(points, ticker))
  {
    return false;
  }
  const auto isKnown = [&](const BlockPoint& point)
  { return std::binary_search(known_.begin(), known_.end(), point); };
  points.erase(std::remove_if(points.begin(), points.end(), isKnown), points.end());
  return true;
}

bool BlockGhosts::listQuestions(std::vector<Ids>& to, Ticker& ticker)
{
  std::vector<BlockPoint> points;
  if (!listNew(points, ticker))
  {
    return false;
  }
  to.assign(stars_.blocks, Ids());
  for (const BlockPoint& point : points)
  {
    to[point.block].push_back(point.id);
  }
  known_.insert(known_.end(), points.begin(), points.end());
  hasLayer_ = true;
  return sortOnce(known_, ticker);
}

/// All triangles around requested own points, by point and place.
bool BlockGhosts::listAround(
  const std::vector<Ids>& asked, std::vector<Corner>& around, Ticker& ticker) const
{
  std::vector<unsigned char> isAsked(stars_.points, 0);
  for (const Ids& some : asked)
  {
    std::for_each(some.begin(), some.end(), [&](std::int64_t id) { isAsked[ownPlace(id)] = 1; });
  }
  const auto add = [&](std::size_t t)
  {
    const std::int32_t* const c = stars_.corners(t);
    for (std::size_t k = 0; k != 3; ++k)
    {
      if (stars_.isOwn(c[k]) && isAsked[std::size_t(c[k])] != 0)
      {
        around.push_back({ { std::size_t(c[k]), t } });
      }
    }
  };
  return inSteps(0, stars_.count(), ticker, add) && sortOnce(around, ticker);
}

/// Finds the triangles around the points that other blocks request, but for those that have a point
/// of these blocks, which have them.
bool BlockGhosts::findAnswers(const std::vector<Ids>& asked, Ticker& ticker)
{
  std::vector<Corner> around;
  if (!listAround(asked, around, ticker))
  {
    return false;
  }
  answers_.assign(asked.size(), std::vector<std::size_t>());
  for (std::size_t block = 0; block != asked.size(); ++block)
  {
    const auto answer = [&](std::size_t i)
    {
      const Corner first = { { ownPlace(asked[block][i]), 0 } };
      auto next = std::lower_bound(around.begin(), around.end(), first);
      for (; next != around.end() && (*next)[0] == first[0]; ++next)
      {
        if (!hasPointOf(block, (*next)[1]))
        {
          answers_[block].push_back((*next)[1]);
        }
      }
    };
    if (!inSteps(0, asked[block].size(), ticker, answer) || !sortOnce(answers_[block], ticker))
    {
      return false;
    }
  }
  return true;
}

Status BlockGhosts::ask()
{
  std::vector<Ids> from;
  Steps steps(transport_, context_);
  steps.exchange(
    from, [&](std::vector<Ids>& to, Ticker& ticker) { return listQuestions(to, ticker); });
  going_ = 0;
  steps.exchange(from,
    [&](std::vector<Ids>& to, Ticker& ticker)
    {
      if (!findAnswers(from, ticker))
      {
        return false;
      }
      to.assign(stars_.blocks, Ids());
      for (std::size_t block = 0; block != to.size(); ++block)
      {
        const std::size_t count = answers_[block].size();
        to[block].assign(count > 0 ? 1 : 0, static_cast<std::int64_t>(count));
        going_ += count;
      }
      return true;
    });
  coming_ = 0;
  for (const Ids& count : from)
  {
    coming_ += count.empty() ? 0 : static_cast<std::size_t>(count[0]);
  }
  return steps.status();
}

Status BlockGhosts::take()
{
  std::vector<std::vector<GhostTriangle>> from;
  Steps steps(transport_, context_);
  steps.exchange(from,
    [&](std::vector<std::vector<GhostTriangle>>& to, Ticker& ticker)
    {
      to.resize(stars_.blocks);
      for (std::size_t block = 0; block != to.size(); ++block)
      {
        const std::vector<std::size_t>& answer = answers_[block];
        to[block].reserve(answer.size());
        if (!inSteps(0, answer.size(), ticker,
              [&](std::size_t k) { to[block].push_back(triangle(answer[k])); }))
        {
          return false;
        }
      }
      answers_.clear();
      return true;
    });
  steps.each(
    [&](Ticker& ticker)
    {
      cells_.reserve(cells_.size() + coming_);
      for (std::vector<GhostTriangle>& some : from)
      {
        cells_.insert(cells_.end(), some.begin(), some.end());
        some = std::vector<GhostTriangle>();
      }
      coming_ = going_ = 0;
      return sortOnce(cells_, ticker);
    });
  return steps.status();
}

} // namespace ahd
