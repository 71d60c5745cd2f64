// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include "../Core/Loops.h"

#include <algorithm>
#include <cmath>

namespace ahd
{

bool SampledColumns::build(const TriangulationAccess::State* state, const SampleArray* arrays,
  std::size_t count, std::size_t places, Ticker& ticker)
{
  constexpr std::size_t kPlacesPerVertex = 8; // so many fewer are read where they are
  const std::size_t vertices = state ? state->ranked.count : 0;
  const Index* const ids = state ? state->ranked.id.data() : nullptr;
  const bool gathers = places >= vertices / kPlacesPerVertex;
  columns_.reserve(count);
  gathered_.resize(gathers ? count : 0);
  for (std::size_t k = 0; k != count; ++k)
  {
    const SampleArray& array = arrays[k];
    const std::size_t n = array.components;
    columns_.push_back({ array.values, ids, n, array.out, array.gradients });
    if (!gathers)
    {
      continue;
    }
    gathered_[k].allocate(vertices * n);
    double* const values = gathered_[k].data();
    const auto gather = [&](std::size_t a, std::size_t b)
    {
      constexpr std::size_t kAhead = 16;
      for (std::size_t v = a; v != b; ++v)
      {
        prefetchForRead(array.values + ids[std::min(v + kAhead, vertices - 1)] * n);
        std::copy_n(array.values + ids[v] * n, n, values + v * n);
      }
    };
    if (!inShares(vertices, ticker, 4, kChunk, gather))
    {
      return false;
    }
    columns_.back().values = values;
    columns_.back().ids = nullptr;
  }
  return true;
}

bool ValueSink::put(std::size_t place, const Weights& weights, Ticker& ticker)
{
  ++report_.valued;
  if (mask_)
  {
    mask_[place] = 1;
  }
  for (const SampledColumn& column : *columns_)
  {
    for (std::size_t c = 0; c != column.components; ++c)
    {
      double value = 0.0;
      if (!addUp(column, c, weights, ticker, value))
      {
        return false;
      }
      if (std::isnan(value))
      {
        if (leavesOut_ && !sumOfOthers(column, c, weights, ticker, value))
        {
          return false;
        }
        ++(std::isnan(value) ? report_.withoutValue : report_.leftOut);
      }
      const std::size_t at = place * column.components + c;
      column.out[at] = value;
      if (column.gradients)
      {
        const Point slope = slopeOf(column, c, weights);
        column.gradients[2 * at] = slope.x;
        column.gradients[2 * at + 1] = slope.y;
      }
    }
  }
  return true;
}

void ValueSink::putNone(std::size_t place, bool isFinite)
{
  ++(isFinite ? report_.outside : report_.notFinite);
  if (mask_)
  {
    mask_[place] = 0;
  }
  for (const SampledColumn& column : *columns_)
  {
    const std::size_t begin = place * column.components;
    std::fill_n(column.out + begin, column.components, kNaN);
    if (column.gradients)
    {
      std::fill_n(column.gradients + 2 * begin, 2 * column.components, kNaN);
    }
  }
}

/// Returns false if the work is cancelled.
bool ValueSink::addUp(const SampledColumn& column, std::size_t component, const Weights& weights,
  Ticker& ticker, double& sum) const
{
  sum = 0.0;
  const auto add = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      sum += weights.weights[k] * column.at(weights.vertices[k], component);
    }
  };
  return inChunks(0, weights.count, ticker, add);
}

/// Of those that are no NaN, over the sum of their weights; NaN if there are none. Returns false if
/// the work is cancelled.
bool ValueSink::sumOfOthers(const SampledColumn& column, std::size_t component,
  const Weights& weights, Ticker& ticker, double& sum) const
{
  double all = 0.0;
  sum = 0.0;
  const auto add = [&](std::size_t a, std::size_t b)
  {
    for (std::size_t k = a; k != b; ++k)
    {
      const double value = column.at(weights.vertices[k], component);
      if (!std::isnan(value))
      {
        sum += weights.weights[k] * value;
        all += weights.weights[k];
      }
    }
  };
  const bool done = inChunks(0, weights.count, ticker, add);
  sum = all > 0.0 ? sum / all : kNaN;
  return done;
}

Point ValueSink::slopeOf(
  const SampledColumn& column, std::size_t component, const Weights& weights) const
{
  if (weights.at != kNoHalfEdge)
  {
    const Index* const v = surface_.tables->corners.data() + weights.at / 3 * 3;
    const double value[3] = { column.at(v[0], component), column.at(v[1], component),
      column.at(v[2], component) };
    return slopeIn(surface_.at(v[0]), surface_.at(v[1]), surface_.at(v[2]), value);
  }
  const Index a = weights.ends[0], b = weights.ends[1];
  return a == kNoIndex
    ? Point{ kNaN, kNaN }
    : slopeAlong(surface_.at(a), surface_.at(b), column.at(a, component), column.at(b, component));
}

} // namespace ahd
