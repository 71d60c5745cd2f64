// SPDX-License-Identifier: BSD-3-Clause
//
// The last part of the definition: the kept triangles, and their regions.
#include "ConstraintDefinition.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace ahd
{
namespace test
{

/// Does v lie on the segment, its ends included?
bool Definition::lies(std::int32_t v, std::int32_t from, std::int32_t to) const
{
  const Point p = at(v);
  Point low = at(from);
  Point high = at(to);
  if (lexicographicallyLess(high, low))
  {
    std::swap(low, high);
  }
  return orient(from, to, v) == 0 && !lexicographicallyLess(p, low) &&
    !lexicographicallyLess(high, p);
}

void Definition::collectEdges()
{
  for (const Triple& t : result_.all)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t a = t[i];
      const std::int32_t b = t[(i + 1) % 3];
      if (std::any_of(accepted_.begin(), accepted_.end(),
            [&](const Accepted& s)
            { return this->lies(a, s.from, s.to) && this->lies(b, s.from, s.to); }))
      {
        result_.edges.insert(std::minmax(a, b));
      }
    }
  }
  result_.report.edges = result_.edges.size();
}

/// Triangles have the same number if no border separates them.
std::map<Triple, int> Definition::regionsOf(
  const std::set<Triple>& triples, const std::set<EdgeIds>& borders) const
{
  std::map<Triple, int> result;
  for (const Triple& t : triples)
  {
    const int number = int(result.size());
    result[t] = number;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    std::map<EdgeIds, int*> seen;
    for (auto& region : result)
    {
      const Triple& t = region.first;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const EdgeIds edge = std::minmax(t[i], t[(i + 1) % 3]);
        int*& other = seen[edge];
        if (other && borders.count(edge) == 0 && *other != region.second)
        {
          *other = region.second = std::min(*other, region.second);
          changed = true;
        }
        other = &region.second;
      }
    }
  }
  return result;
}

void Definition::fill(FillRule rule)
{
  std::vector<Accepted> loops;
  std::copy_if(accepted_.begin(), accepted_.end(), std::back_inserter(loops),
    [&](const Accepted& s) { return s.ofLoop && brokenLoops_.count(s.chain) == 0; });
  if (loops.empty())
  {
    result_.kept = result_.all;
  }
  else if (rule == FillRule::Orientation)
  {
    fillByOrientation(loops);
  }
  else
  {
    fillEvenOdd(loops);
  }
}

void Definition::fillByOrientation(const std::vector<Accepted>& loops)
{
  std::set<EdgeIds> borders;
  std::map<EdgeIds, int> uses; ///< of a directed edge, less those the other way
  for (const EdgeIds& edge : result_.edges)
  {
    int count = 0;
    for (const Accepted& s : loops)
    {
      const bool isOn = lies(edge.first, s.from, s.to) && lies(edge.second, s.from, s.to);
      const bool isAlong = lexicographicallyLess(at(edge.first), at(edge.second)) ==
        lexicographicallyLess(at(s.from), at(s.to));
      count += !isOn ? 0 : isAlong ? 1 : -1;
    }
    uses[edge] = count;
    uses[{ edge.second, edge.first }] = -count;
    if (count != 0)
    {
      borders.insert(edge);
    }
  }
  const std::map<Triple, int> regions = regionsOf(result_.all, borders);
  std::set<int> dropped;
  for (const auto& region : regions)
  {
    const Triple& t = region.first;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto use = uses.find({ t[i], t[(i + 1) % 3] });
      if (use != uses.end() && use->second < 0)
      {
        dropped.insert(region.second);
      }
    }
  }
  for (const auto& region : regions)
  {
    if (dropped.count(region.second) == 0)
    {
      result_.kept.insert(region.first);
    }
  }
}

/// By the number of loop segments that a ray from the middle of the triangle meets.
bool Definition::isInsideOdd(const std::vector<Accepted>& loops, const Triple& t) const
{
  Vector middle;
  for (const std::int32_t v : t)
  {
    middle.x += mpq_class(at(v).x) / 3;
    middle.y += mpq_class(at(v).y) / 3;
  }
  bool odd = false;
  for (const Accepted& s : loops)
  {
    const bool isBelow = mpq_class(at(s.from).y) < middle.y;
    if (isBelow == (mpq_class(at(s.to).y) < middle.y))
    {
      continue;
    }
    const Vector toMiddle = { middle.x - mpq_class(at(s.from).x),
      middle.y - mpq_class(at(s.from).y) };
    const int side = sgn(ahd::test::cross(between(at(s.from), at(s.to)), toMiddle));
    const bool isToTheRight = isBelow ? side > 0 : side < 0;
    odd = odd != isToTheRight;
  }
  return odd;
}

/// The segments of loops but for those along the same edges as an earlier one.
std::vector<Accepted> Definition::withoutRepeated(const std::vector<Accepted>& loops) const
{
  std::map<std::size_t, std::multiset<EdgeIds>> edges;
  for (const Accepted& s : loops)
  {
    for (const EdgeIds& edge : result_.edges)
    {
      if (lies(edge.first, s.from, s.to) && lies(edge.second, s.from, s.to))
      {
        edges[s.chain].insert(edge);
      }
    }
  }
  std::map<std::multiset<EdgeIds>, std::size_t> first;
  std::vector<Accepted> result;
  for (const Accepted& s : loops)
  {
    if (first.emplace(edges[s.chain], s.chain).first->second == s.chain)
    {
      result.push_back(s);
    }
  }
  return result;
}

void Definition::fillEvenOdd(const std::vector<Accepted>& loops)
{
  const std::vector<Accepted> counted = withoutRepeated(loops);
  for (const Triple& t : result_.all)
  {
    if (isInsideOdd(counted, t))
    {
      result_.kept.insert(t);
    }
  }
}

void Definition::number()
{
  result_.regions = regionsOf(result_.kept, result_.edges);
}

} // namespace test
} // namespace ahd
