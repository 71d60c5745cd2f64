// SPDX-License-Identifier: BSD-3-Clause
#include "Candidates.h"

#include "../Core/Loops.h"
#include "../Order/Rank.h"
#include "../Order/Representatives.h"
#include "Hull.h"

#include <algorithm>
#include <cmath>

namespace ahd
{
namespace
{

struct Largest
{
  double magnitude = 0.0;
  void merge(const Largest& other) { magnitude = std::max(magnitude, other.magnitude); }
};

} // namespace

Status Candidates::read(const SimplifyRequest& request, const Context& context)
{
  const PointView& points = request.points;
  if (points.count > kMaximumPoints)
  {
    return Status::TooManyPoints;
  }
  {
    Ticker reading(context.progress, Phase::Read, points.count, context.executor);
    if (const Status read = readPoints(points, reading, ranked_); read != Status::Ok)
    {
      return read;
    }
  }
  Ticker sorting(context.progress, Phase::Sort, points.count, context.executor);
  ranked_.scratch.allocate(rankScratchBytes(ranked_.count));
  if (const Status sorted = rankPoints(points, sorting, ranked_); sorted != Status::Ok)
  {
    return sorted;
  }
  const bool goesOn = chooseRepresentatives(points, request.representative, ranked_, sorting);
  duplicates_.assign(ranked_.duplicates.begin(), ranked_.duplicates.end());
  ranked_.duplicates.reset();
  ranked_.key.reset();
  ranked_.scratch.reset();
  std::vector<Index> corners;
  return goesOn && findHullCorners(ranked_.xy.data(), count(), sorting, corners) &&
      readNumbers(request, sorting) && listStaying(request, corners, sorting)
    ? Status::Ok
    : Status::Cancelled;
}

bool Candidates::readValues(const SimplifyRequest& request, Ticker& ticker)
{
  samples_.allocate(count());
  Largest largest;
  const auto read = [&](Largest& part, std::size_t a, std::size_t b)
  {
    for (std::size_t rank = a; rank != b; ++rank)
    {
      const Index i = ranked_.id[rank];
      const double value = request.values.isGiven() ? request.values[i] : request.points.z(i);
      samples_[rank] = { ranked_.xy[rank], value };
      part.magnitude = std::isfinite(value) ? std::max(part.magnitude, std::fabs(value))
                                            : part.magnitude;
    }
  };
  if (!gather(count(), ticker, largest, read))
  {
    return false;
  }
  ranked_.xy.reset();
  scale_ = powerOfTwoBelow(largest.magnitude);
  return inChunksOf(count(), ticker,
    [&](std::size_t a, std::size_t b)
    {
      for (std::size_t rank = a; rank != b; ++rank)
      {
        samples_[rank].value *= scale_;
      }
    });
}

bool Candidates::readNumbers(const SimplifyRequest& request, Ticker& ticker)
{
  if (!readValues(request, ticker) || !findRanks(request, ticker) ||
    !readConstraints(request.constraints, ticker))
  {
    return false;
  }
  weights_.allocate(request.weights.isGiven() ? count() : 0);
  return inSteps(0, weights_.size(), ticker,
    [&](std::size_t rank) { weights_[rank] = request.weights[ranked_.id[rank]]; });
}

/// The rank of each id, where it is needed.
bool Candidates::findRanks(const SimplifyRequest& request, Ticker& ticker)
{
  if (request.constraints.chains == 0 && !(request.mustStay && !duplicates_.empty()))
  {
    return true;
  }
  rankOf_.allocate(request.points.count);
  return fillAll(rankOf_, kNoIndex, ticker) &&
    inSteps(0, ranked_.count, ticker,
      [&](std::size_t rank) { rankOf_[ranked_.id[rank]] = static_cast<Index>(rank); }) &&
    inSteps(0, duplicates_.size(), ticker,
      [&](std::size_t k) { rankOf_[duplicates_[k].id] = rankOf_[duplicates_[k].keptId]; });
}

bool Candidates::readConstraints(const ConstraintView& constraints, Ticker& ticker)
{
  segments_.clear();
  const auto rankOfId = [&](std::int64_t id)
  { return id >= 0 && std::size_t(id) < rankOf_.size() ? rankOf_[std::size_t(id)] : kNoIndex; };
  bool goesOn = true;
  for (std::size_t chain = 0; goesOn && chain < constraints.chains; ++chain)
  {
    const std::int64_t* const ids = constraints.ids + constraints.offsets[chain];
    const std::int64_t* const end = constraints.ids + constraints.offsets[chain + 1];
    goesOn = ticker.step() &&
      inSteps(0, segmentsOf(constraints, chain), ticker,
        [&](std::size_t k)
        {
          const std::int64_t* const next = ids + k + 1 < end ? ids + k + 1 : ids;
          const Index a = rankOfId(ids[k]), b = rankOfId(*next);
          if (a != kNoIndex && b != kNoIndex)
          {
            segments_.push_back({ { a, b } });
          }
        });
  }
  return goesOn;
}

bool Candidates::listStaying(
  const SimplifyRequest& request, const std::vector<Index>& corners, Ticker& ticker)
{
  staying_.clear();
  if (corners.size() < 3)
  {
    return true;
  }
  first_ = { { corners[0], corners[1], corners[2] } };
  Buffer<unsigned char> stays;
  stays.allocate(count());
  const bool goesOn = inSteps(0, count(), ticker,
    [&](std::size_t rank)
    {
      const double w = weight(static_cast<Index>(rank));
      const bool isMarked = request.mustStay && request.mustStay[ranked_.id[rank]] != 0;
      stays[rank] = isMarked || !std::isfinite(samples_[rank].value) || !std::isfinite(w) ||
        w < 0.0;
    });
  for (const Duplicate& duplicate : duplicates_)
  {
    if (request.mustStay && request.mustStay[duplicate.id] != 0)
    {
      stays[rankOf_[duplicate.id]] = 1;
    }
  }
  rankOf_.reset();
  for (const Index corner : corners)
  {
    stays[corner] = 1;
  }
  for (const std::array<Index, 2>& segment : segments_)
  {
    stays[segment[0]] = stays[segment[1]] = 1;
  }
  return goesOn &&
    inSteps(0, count(), ticker,
      [&](std::size_t rank)
      {
        if (stays[rank] != 0)
        {
          staying_.push_back(static_cast<Index>(rank));
        }
      });
}

} // namespace ahd
