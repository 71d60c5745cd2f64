// SPDX-License-Identifier: BSD-3-Clause
#include "Means.h"

#include "../Arithmetic/ExactMean.h"
#include "../Core/Border.h"
#include "../Core/SortAsking.h"
#include "../Triangulation/Triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace ahd
{
namespace
{

double coordinate(const PointView& points, std::size_t i, std::size_t k)
{
  return points.place(i)[k];
}

/// One call of findMeans(), when the tables are made. Functions that return bool return false if
/// cancelled.
class Averaging
{
public:
  Averaging(const Triangulation& triangulation, const PointView& inSpace, Ticker& ticker)
    : triangulation_(triangulation)
    , inSpace_(inSpace)
    , ticker_(ticker)
  {
  }

  bool run(std::size_t count, std::vector<Mean>& means);

private:
  using Pair = std::pair<Index, Index>; ///< the point that stands for a vertex, another there

  bool findPairs(std::size_t count);
  bool findMean(const std::vector<Index>& ids, std::vector<Mean>& means);
  bool gatherNumbers(const std::vector<Index>& ids, std::size_t k);
  bool meanOfNumbers(double& mean);
  bool longMeanOfNumbers(double& mean);

  const Triangulation& triangulation_;
  const PointView& inSpace_;
  Ticker& ticker_;
  std::vector<Pair> pairs_;
  std::vector<double> numbers_; ///< of the points at one place
};

bool Averaging::run(std::size_t count, std::vector<Mean>& means)
{
  const auto isLess = [](const Pair& a, const Pair& b) { return a < b; };
  if (!ticker_.ask() || !findPairs(count) || !sortAsking(pairs_, ticker_, isLess))
  {
    return false;
  }
  std::vector<Index> ids;
  for (std::size_t i = 0; i < pairs_.size();)
  {
    const Index first = pairs_[i].first;
    ids.assign(1, first);
    for (; i < pairs_.size() && pairs_[i].first == first; ++i)
    {
      ids.push_back(pairs_[i].second);
    }
    if (!findMean(ids, means))
    {
      return false;
    }
  }
  return ticker_.ask();
}

bool Averaging::findPairs(std::size_t count)
{
  return inChunks(0, count, ticker_,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index vertex = triangulation_.vertexOf(i);
        const Index first = vertex == kNoIndex ? kNoIndex : triangulation_.pointOf(vertex);
        if (first < count && first != i)
        {
          pairs_.emplace_back(first, static_cast<Index>(i));
        }
      }
    });
}

/// Adds the mean of the points with a finite z, unless there is none. The first of them stands for
/// the vertex.
bool Averaging::findMean(const std::vector<Index>& ids, std::vector<Mean>& means)
{
  Mean mean;
  mean.id = ids.front();
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!gatherNumbers(ids, k))
    {
      return false;
    }
    if (numbers_.empty())
    {
      return true;
    }
    if (!meanOfNumbers(mean.position[k]))
    {
      return false;
    }
  }
  means.push_back(mean);
  return true;
}

bool Averaging::gatherNumbers(const std::vector<Index>& ids, std::size_t k)
{
  numbers_.clear();
  return inChunks(0, ids.size(), ticker_,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (std::isfinite(coordinate(triangulation_.points(), ids[i], 2)))
        {
          numbers_.push_back(coordinate(inSpace_, ids[i], k));
        }
      }
    });
}

/// The mean of equal numbers is that number, to the last bit, a zero's sign included.
bool Averaging::meanOfNumbers(double& mean)
{
  bool areSame = true;
  ShortSum sum;
  const bool all = inChunks(0, numbers_.size(), ticker_,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        areSame = areSame && std::memcmp(&numbers_[i], numbers_.data(), sizeof(double)) == 0;
        sum.add(numbers_[i]);
      }
    });
  if (areSame)
  {
    mean = numbers_.front();
    return all;
  }
  return all && (sum.mean(numbers_.size(), mean) || longMeanOfNumbers(mean));
}

/// Where the sum has more bits than two doubles.
bool Averaging::longMeanOfNumbers(double& mean)
{
  LongSum sum;
  const bool all = inChunks(0, numbers_.size(), ticker_,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        sum.add(numbers_[i]);
      }
    });
  mean = sum.mean(numbers_.size());
  return all;
}

} // namespace

Status findMeans(Triangulation& triangulation, std::size_t count, const PointView& inSpace,
  const Context& context, std::vector<Mean>& means)
{
  means.clear();
  if (triangulation.report().duplicates == 0)
  {
    return Status::Ok;
  }
  const Status status = triangulation.makePointMap(context);
  if (status != Status::Ok)
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      return Averaging(triangulation, inSpace, ticker).run(count, means);
    });
}

} // namespace ahd
