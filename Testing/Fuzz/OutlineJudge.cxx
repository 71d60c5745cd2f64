// SPDX-License-Identifier: BSD-3-Clause
#include "OutlineJudge.h"

#include "Dice.h"
#include "Judge.h"
#include "Outline/Outline.h"
#include "Predicates/Predicates.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace ahd
{
namespace fuzz
{
namespace
{

constexpr std::size_t kMostCells = 2000;

/// A surface, and its outline.
struct Outlined
{
  const FuzzCase& given;
  Dice dice;
  std::vector<double> xyz;
  std::vector<std::int64_t> ids, offsets = { 0 };
  std::vector<double> groups;
  Outline made;

  Outlined(const FuzzCase& fuzzed, const PointView& points)
    : given(fuzzed)
    , dice(fuzzed.head[kMostBoxes] + 1u)
  {
    for (std::size_t i = 0; i < points.count; ++i)
    {
      // One that is left out must not stand for another at its place.
      const double x = points.skipped(i) ? std::numeric_limits<double>::quiet_NaN() : points[i].x;
      xyz.insert(xyz.end(), { x, points[i].y, 0.0 });
    }
  }

  std::size_t cells() const { return offsets.size() - 1; }
  void addCell(const std::vector<std::int64_t>& corners)
  {
    ids.insert(ids.end(), corners.begin(), corners.end());
    offsets.push_back(std::int64_t(ids.size()));
    const std::size_t kind = dice.below(8);
    groups.push_back(kind == 0 ? std::numeric_limits<double>::quiet_NaN() : double(kind / 4));
  }
  Point at(std::size_t id) const { return { xyz[3 * id], xyz[3 * id + 1] }; }
  void is(bool isTrue, const char* what) const { expect(isTrue, what, given); }

  void outline()
  {
    OutlineRequest request;
    request.points = PointView(xyz.data(), xyz.size() / 3, 3);
    request.cells.offsets64 = offsets.data();
    request.cells.ids64 = ids.data();
    request.cells.cells = cells();
    request.cells.ids = ids.size();
    request.groups = given.head[kMostBoxes] == 0 ? nullptr : groups.data();
    groups.resize(request.groups ? groups.size() : 0);
    is(ahd::outline(request, Context(), made) == Status::Ok, "outlined");
    expectStops(given,
      [&request](Progress* progress)
      {
        Outline other;
        return ahd::outline(request, { progress, nullptr }, other);
      });
  }
};

/// Rings are of points, polygons of rings, and name a cell.
void expectNumbers(const Outlined& all)
{
  const auto ascends = [&all](const std::vector<Index>& offsets, std::size_t last)
  {
    all.is(!offsets.empty() && offsets.front() == 0 && offsets.back() == last &&
        std::is_sorted(offsets.begin(), offsets.end()),
      "offsets ascend from 0 to the end");
  };
  const Outline& made = all.made;
  ascends(made.rings, made.corners.size());
  ascends(made.polygons, made.rings.size() - 1);
  all.is(made.cells.size() + 1 == made.polygons.size(), "a cell for each polygon");
  const auto areBelow = [](const std::vector<Index>& numbers, std::size_t end)
  { return std::all_of(numbers.begin(), numbers.end(), [end](Index i) { return i < end; }); };
  all.is(areBelow(made.corners, all.xyz.size() / 3) && areBelow(made.cells, all.cells()),
    "ids of points and cells");
}

using Directed = std::array<std::int64_t, 2>;

/// The edges between triangles that are not joined, with the numbers of those on their left.
std::multiset<std::pair<Directed, double>> borderOf(const Outlined& all)
{
  std::map<Directed, double> numbers; // of the triangle on the left
  for (std::size_t k = 0; k < all.ids.size(); ++k)
  {
    const std::size_t t = k / 3, next = 3 * t + (k + 1) % 3;
    const double number = all.groups.empty() ? 0.0 : all.groups[t];
    if (number == number)
    {
      numbers[{ all.ids[k], all.ids[next] }] = number;
    }
  }
  std::multiset<std::pair<Directed, double>> border;
  for (const auto& [edge, number] : numbers)
  {
    const auto twin = numbers.find({ edge[1], edge[0] });
    if (twin == numbers.end() || twin->second != number)
    {
      border.emplace(edge, number);
    }
  }
  return border;
}

/// Takes the edges of a ring out of the border.
void takeRing(const Outlined& all, const std::vector<std::int64_t>& ring, double number,
  std::multiset<std::pair<Directed, double>>& border)
{
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const auto found = border.find({ { ring[i], ring[(i + 1) % ring.size()] }, number });
    all.is(found != border.end(), "an edge of a ring is one of the border");
    border.erase(found);
  }
}

void expectSurface(
  const FuzzCase& given, const PointView& points, const std::vector<std::int32_t>& triples)
{
  Outlined all(given, points);
  for (std::size_t k = 0; k + 2 < triples.size(); k += 3)
  {
    all.addCell({ triples[k], triples[k + 1], triples[k + 2] });
  }
  all.outline();
  expectNumbers(all);
  const Outline& made = all.made;
  all.is(made.plane == OutlinePlane::Xy && made.unfitCells + made.unfitEdges == 0, "all fits");
  auto border = borderOf(all);
  for (std::size_t k = 0; k + 1 < made.polygons.size(); ++k)
  {
    for (std::size_t r = made.polygons[k]; r < made.polygons[k + 1]; ++r)
    {
      const std::vector<std::int64_t> ring(
        made.corners.begin() + made.rings[r], made.corners.begin() + made.rings[r + 1]);
      all.is(
        ring.size() >= 3 && std::set<std::int64_t>(ring.begin(), ring.end()).size() == ring.size(),
        "a ring passes a vertex once");
      // it begins at its smallest vertex
      const int turn = orient2d(all.at(std::size_t(ring.back())), all.at(std::size_t(ring[0])),
        all.at(std::size_t(ring[1])));
      all.is(r == made.polygons[k] ? turn > 0 : turn < 0, "one outer ring, then holes");
      takeRing(all, ring, all.groups.empty() ? 0.0 : all.groups[made.cells[k]], border);
    }
  }
  all.is(border.empty(), "all of the border is in rings");
}

void expectAnyCells(const FuzzCase& given, const PointView& points)
{
  Outlined all(given, points);
  for (std::size_t i = 2; i < all.xyz.size(); i += 3)
  {
    all.xyz[i] = double(all.dice.below(3));
  }
  const std::size_t count = all.dice.below(40);
  for (std::size_t k = 0; k < count; ++k)
  {
    std::vector<std::int64_t> corners(all.dice.below(7));
    for (std::int64_t& corner : corners)
    {
      corner = std::int64_t(all.dice.below(std::min<std::size_t>(points.count, 12) + 2)) - 1;
    }
    all.addCell(corners);
  }
  all.outline();
  expectNumbers(all);
}

} // namespace

void expectOutlines(
  const FuzzCase& given, const PointView& points, const std::vector<std::int32_t>& triples)
{
  if (triples.size() / 3 <= kMostCells)
  {
    expectSurface(given, points, triples);
    expectAnyCells(given, points);
  }
}

} // namespace fuzz
} // namespace ahd
