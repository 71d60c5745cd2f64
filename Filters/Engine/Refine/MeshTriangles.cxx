// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of a refined mesh beside those of before: regions, which are bad, angles.
#include "RefinedMesh.h"

#include "../Arithmetic/PowerOfTwo.h"
#include "../Core/AskedMemory.h"
#include "../Core/Border.h"
#include "../Core/Chunks.h"
#include "Functions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ahd
{
namespace
{

/// Finds triangles by edges.
class EdgeRows
{
public:
  explicit EdgeRows(std::size_t edges) { edges_.reserve(edges); }

  static constexpr std::size_t kBytes = 3 * sizeof(std::int64_t); ///< of an edge

  void add(Index from, Index to) { edges_.emplace_back(from, to); }

  bool find(const std::int32_t* corners, std::size_t count, Ticker& ticker)
  {
    std::sort(edges_.begin(), edges_.end());
    rows_.assign(edges_.size(), -1);
    return inSteps(0, count, ticker,
      [&](std::size_t row)
      {
        for (std::size_t e = 0; e < 3; ++e)
        {
          const std::size_t k = placeOf({ static_cast<Index>(corners[3 * row + e]),
            static_cast<Index>(corners[3 * row + (e + 1) % 3]) });
          if (k < rows_.size())
          {
            rows_[k] = static_cast<std::int64_t>(row);
          }
        }
      });
  }

  /// The triangle on the left of the edge; -1: none.
  std::int64_t at(Index from, Index to) const
  {
    const std::size_t k = placeOf({ from, to });
    return k < rows_.size() ? rows_[k] : -1;
  }

private:
  using Edge = std::pair<Index, Index>;

  std::size_t placeOf(const Edge& edge) const
  {
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return found != edges_.end() && *found == edge
      ? static_cast<std::size_t>(found - edges_.begin())
      : edges_.size();
  }

  std::vector<Edge> edges_;
  std::vector<std::int64_t> rows_;
};

/// The square of the sine of the smallest angle, to rounding.
double leastSineSquared(const std::array<Point, 3>& corners)
{
  double x[3], y[3], largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    x[k] = corners[(k + 1) % 3].x - corners[k].x;
    y[k] = corners[(k + 1) % 3].y - corners[k].y;
    largest = std::max({ largest, std::fabs(x[k]), std::fabs(y[k]) });
  }
  const double scale = powerOfTwoBelow(largest);
  double squares[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    x[k] *= scale;
    y[k] *= scale;
    squares[k] = x[k] * x[k] + y[k] * y[k];
  }
  std::sort(squares, squares + 3);
  const double twiceArea = x[0] * y[1] - x[1] * y[0];
  return twiceArea * twiceArea / (squares[1] * squares[2]);
}

double degreesOf(double sineSquared)
{
  double low = 0.0, high = 90.0;
  for (int k = 0; k < 60; ++k)
  {
    const double middle = 0.5 * (low + high), sine = sineOfDegrees(middle);
    (sine * sine < sineSquared ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

bool findLeastAngle(
  const PointView& points, const RefinedMesh& mesh, Ticker& ticker, MeshTriangles& to)
{
  const auto placeOf = [&](std::int32_t corner)
  {
    const auto id = static_cast<std::size_t>(corner);
    if (id < points.count)
    {
      return points[id];
    }
    const SteinerPoint& added = mesh.found.points[id - points.count];
    return Point{ added.x, added.y };
  };
  double least = 1.0;
  const bool isDone = inSteps(0, to.count, ticker,
    [&](std::size_t row)
    {
      const std::int32_t* const c = to.corners + 3 * row;
      least = std::min(
        least, leastSineSquared({ { placeOf(c[0]), placeOf(c[1]), placeOf(c[2]) } }));
    });
  to.leastAngle = to.count > 0 ? degreesOf(least) : 0.0;
  return isDone;
}

/// Each region has a piece along it.
bool takeRegions(const TrianglesBefore& before, const RefinedMesh& mesh, const EdgeRows& rows,
  MeshTriangles& to, Ticker& ticker)
{
  EdgeRows were(2 * mesh.pieces.size());
  for (const MeshPiece& piece : mesh.pieces)
  {
    were.add(piece.edge[0], piece.edge[1]);
    were.add(piece.edge[1], piece.edge[0]);
  }
  if (!were.find(before.corners, before.count, ticker))
  {
    return false;
  }
  std::vector<std::int64_t> numbers(to.count, 0);
  const auto side = [&](const MeshPiece& piece, std::size_t from)
  {
    const std::int64_t was = were.at(piece.edge[from], piece.edge[1 - from]);
    const std::int64_t row = rows.at(piece.ids[from], piece.ids[1 - from]);
    if (was >= 0 && row >= 0)
    {
      numbers[std::size_t(to.regions[row])] = before.regions[std::size_t(was)];
    }
  };
  for (const MeshPiece& piece : mesh.pieces)
  {
    side(piece, 0);
    side(piece, 1);
  }
  return inSteps(0, to.count, ticker,
    [&](std::size_t row) { to.regions[row] = numbers[std::size_t(to.regions[row])]; });
}

} // namespace

bool MeshTriangles::fit(std::size_t points) const
{
  const auto isId = [points](std::int32_t id) { return id >= 0 && std::size_t(id) < points; };
  const auto isRegion = [this](std::int64_t one) { return one >= 0 && std::size_t(one) < count; };
  return std::all_of(corners, corners + 3 * count, isId) &&
    (!regions || std::all_of(regions, regions + count, isRegion));
}

Status describeTriangles(const PointView& points, const TrianglesBefore& before,
  const RefinedMesh& mesh, const Context& context, MeshTriangles& triangles)
{
  return unlessCancelled(
    [&]
    {
      Ticker ticker(context.progress, Phase::Outputs, 0, context.executor);
      TakenMemory memory(ticker);
      const std::size_t edges = 2 * mesh.pieces.size() + mesh.found.bad.size();
      memory.atLeast(2 * edges * EdgeRows::kBytes + triangles.count * sizeof(std::int64_t));
      EdgeRows rows(edges);
      for (const MeshPiece& piece : mesh.pieces)
      {
        rows.add(piece.ids[0], piece.ids[1]);
        rows.add(piece.ids[1], piece.ids[0]);
      }
      for (const BadTriangle& bad : mesh.found.bad)
      {
        rows.add(bad.corners[0], bad.corners[1]);
      }
      const bool isDone = rows.find(triangles.corners, triangles.count, ticker) &&
        (!triangles.regions || takeRegions(before, mesh, rows, triangles, ticker)) &&
        findLeastAngle(points, mesh, ticker, triangles);
      for (std::size_t k = 0; isDone && triangles.bad && k < mesh.found.bad.size(); ++k)
      {
        const std::array<Index, 3>& corners = mesh.found.bad[k].corners;
        triangles.bad[k] = rows.at(corners[0], corners[1]);
      }
      return isDone;
    });
}

} // namespace ahd
