// SPDX-License-Identifier: BSD-3-Clause
#include "SpacePoints.h"

#include "../Core/Border.h"
#include "../Core/Loops.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ahd
{
namespace
{

/// Fills in the numbers of row `to` in columns from `first` on.
template <typename Origin>
void interpolateRow(
  const Origin& origin, double* values, std::size_t columns, std::size_t to, std::size_t first)
{
  for (std::size_t c = first; c < columns; ++c)
  {
    values[columns * to + c] = interpolate(
      origin, [values, columns, c](Index id) { return values[columns * std::size_t(id) + c]; });
  }
}

/// At the points added to lines: columns from `firstColumn` on.
void interpolateOnLines(
  const PreparedInput& points, double* values, std::size_t columns, std::size_t firstColumn)
{
  for (std::size_t k = points.sourceCount(); k < points.surfacePlaces().size(); ++k)
  {
    interpolateRow(
      points.surfacePlaces()[k], values, columns, points.inputCount() + k, firstColumn);
  }
}

} // namespace

void interpolateAtSurface(const PreparedInput& points, double* values, std::size_t columns)
{
  std::size_t to = points.inputCount();
  for (const SurfacePlace& place : points.surfacePlaces())
  {
    if (place.isInside())
    {
      interpolateRow(place, values, columns, to, 0);
    }
    ++to;
  }
}

void interpolateAtCrossings(
  const PreparedInput& points, double* values, std::size_t columns, std::size_t firstColumn)
{
  std::size_t to = points.firstCrossing();
  for (const CrossingOrigin& crossing : points.crossings())
  {
    interpolateRow(crossing, values, columns, to++, firstColumn);
  }
}

Status SpacePoints::make(const PointView& input, const PointView& source,
  const PreparedInput& points, const Context& context)
{
  view_ = input;
  view_.skip = nullptr;
  if (points.addedCount() == 0)
  {
    return Status::Ok;
  }
  return unlessCancelled(
    [&]
    {
      const std::size_t count = points.points().count, own = points.inputCount();
      const bool isMoved = points.isProjected();
      double* const to = doubles_.take(3 * count);
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      const bool all = inChunksOf(count, ticker,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            const std::array<double, 3> p = isMoved && i < own ? input.place(i)
              : isMoved && i < own + source.count              ? source.place(i - own)
                                                               : points.place(i);
            std::copy(p.begin(), p.end(), to + 3 * i);
          }
        });
      if (isMoved && all)
      {
        interpolateAtSurface(points, to, 3);
        interpolateAtCrossings(points, to, 3, 0);
      }
      view_ = PointView(to, count, 3);
      isCopy_ = true;
      return all;
    });
}

/// Lets the points be a copy, with z.
template <typename Number>
bool SpacePoints::copy(Room<Number>& room, const Context& context)
{
  Number* const to = room.take(3 * view_.count);
  Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
  const bool all = inChunksOf(view_.count, ticker,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::array<double, 3> p = view_.place(i);
        for (std::size_t k = 0; k < 3; ++k)
        {
          to[3 * i + k] = static_cast<Number>(p[k]);
        }
      }
    });
  view_ = PointView(to, view_.count, 3);
  isCopy_ = true;
  return all;
}

Status SpacePoints::showMeans(RunResult& made, const Context& context)
{
  const PreparedInput& points = made.points;
  if (made.triangulation.report().duplicates == 0)
  {
    return Status::Ok;
  }
  std::vector<Mean> means;
  const Status status = findMeans(
    made.triangulation, points.firstCrossing(), view_, context, means);
  if (status != Status::Ok || means.empty())
  {
    return status;
  }
  return unlessCancelled(
    [&]
    {
      const bool isFloat = view_.floats != nullptr;
      if (!isCopy_ && !(isFloat ? copy(floats_, context) : copy(doubles_, context)))
      {
        return false;
      }
      for (const Mean& mean : means)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::size_t at = 3 * std::size_t(mean.id) + k;
          isFloat ? void(floats_.numbers[at] = static_cast<float>(mean.position[k]))
                  : void(doubles_.numbers[at] = mean.position[k]);
        }
      }
      if (isFloat)
      {
        rounded_ = std::move(means);
        return true;
      }
      const std::size_t firstColumn = points.isProjected() ? 0 : 2;
      interpolateOnLines(points, doubles_.numbers, 3, firstColumn);
      interpolateAtCrossings(points, doubles_.numbers, 3, firstColumn);
      return true;
    });
}

void SpacePoints::writeMeans(double* xyz) const
{
  for (const Mean& mean : rounded_)
  {
    std::copy(mean.position.begin(), mean.position.end(), xyz + 3 * std::size_t(mean.id));
  }
}

} // namespace ahd
