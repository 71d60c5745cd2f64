// SPDX-License-Identifier: BSD-3-Clause
#include "ConstraintCertifier.h"

#include "CertifiedMesh.h"
#include "ConstraintFill.h"
#include "ConstraintSets.h"
#include "ExactSigns.h"
#include "MeshWalk.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace ahd
{
namespace test
{
namespace
{

constexpr std::int32_t kNone = CertifiedMesh::kNone;
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

/// A segment between two different vertices.
struct Way
{
  std::size_t number; ///< among all segments
  GivenSegment given;
  std::int32_t from, to;
  const LeftOut* leftOut;
  std::vector<std::int32_t> vertices; ///< on it, if it was accepted
};

/// The work of certifyConstrained(), step by step.
class ConstraintCertifier
{
public:
  ConstraintCertifier(const PointView& points, const ConstraintView& constraints, FillRule rule,
    const ConstrainedOutcome& whole, const ConstrainedOutcome& filled)
    : constraints_(constraints)
    , rule_(rule)
    , whole_(whole)
    , filled_(filled)
    , mesh_(points, whole.triples, whole.pointStatus)
    , walk_(mesh_)
    , vertices_(verticesOf(points))
  {
  }

  Complaints run()
  {
    mesh_.check();
    if (!mesh_.faults().empty())
    {
      return mesh_.faults().all();
    }
    compare("pointStatus", whole_.pointStatus == filled_.pointStatus, true);
    collect();
    if (mesh_.triangleCount() > 0)
    {
      lay();
      countUses();
      checkLeftOut();
      mesh_.checkDelaunay(fixed_);
    }
    checkReport(whole_, 0);
    checkReport(filled_, brokenLoops());
    if (mesh_.faults().empty())
    {
      std::vector<char> all(mesh_.triangleCount(), 1);
      checkExtras(whole_, all);
      kept_ = keptByRule(mesh_, rule_, uses_);
      checkFilled();
    }
    return mesh_.faults().all();
  }

private:
  void collect();
  void lay();
  bool layOne(Way& way);
  void mark(std::int32_t from, std::int32_t to, const Way& way);
  void countUses();
  const Way* findWay(std::size_t chain, std::size_t segment) const;
  void checkLeftOut();
  void checkCrossing(const Way& way, const Way& other);
  bool meetInVertex(const Way& way, const Way& other) const;
  void checkReport(const ConstrainedOutcome& outcome, std::size_t unfilled);
  std::size_t brokenLoops() const;
  void checkFilled();
  void checkExtras(const ConstrainedOutcome& outcome, const std::vector<char>& kept);

  int orient(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    return orientSign(mesh_.at(a), mesh_.at(b), mesh_.at(c));
  }
  std::string name(const GivenSegment& s) const
  {
    return "chain " + std::to_string(s.chain) + ", segment " + std::to_string(s.segment);
  }
  std::string name(const Way& way) const
  {
    return name(way.given) + " from " + mesh_.name(way.from) + " to " + mesh_.name(way.to);
  }
  template <typename Value>
  void compare(const std::string& what, Value found, Value right)
  {
    if (found != right)
    {
      mesh_.faults().add("report",
        [&]
        { return what + " is " + std::to_string(found) + " instead of " + std::to_string(right); });
    }
  }

  const ConstraintView& constraints_;
  FillRule rule_;
  const ConstrainedOutcome& whole_;
  const ConstrainedOutcome& filled_;
  CertifiedMesh mesh_;
  MeshWalk walk_;
  std::vector<std::int32_t> vertices_;

  std::size_t segments_ = 0, points_ = 0, withoutVertex_ = 0;
  std::vector<Way> ways_;
  std::vector<char> broken_;          ///< by chain: is a segment missing?
  std::vector<char> fixed_;           ///< by half-edge: is it on an accepted segment?
  std::vector<std::size_t> earliest_; ///< by half-edge: the first segment along it
  std::vector<LoopUses> uses_;        ///< by half-edge
  std::vector<char> kept_;            ///< by triangle: does the rule keep it?
};

// --- Segments
// --------------------------------------------------------------------------------------

/// Separates segments without effect from those to follow.
void ConstraintCertifier::collect()
{
  broken_.assign(constraints_.chains, 0);
  const std::vector<LeftOut>& leftOut = whole_.constraints.leftOut;
  auto next = leftOut.begin();
  for (const GivenSegment& given : segmentsOf(constraints_, vertices_))
  {
    const std::int32_t from = vertexOf(vertices_, given.from);
    const std::int32_t to = vertexOf(vertices_, given.to);
    const bool isNone = from < 0 || to < 0 || mesh_.triangleCount() == 0;
    withoutVertex_ += isNone ? 1 : 0;
    points_ += !isNone && from == to ? 1 : 0;
    Way way{ segments_++, given, from, to, nullptr, {} };
    if (next != leftOut.end() && next->chain == given.chain && next->segment == given.segment)
    {
      way.leftOut = &*next++;
    }
    if (isNone || way.leftOut)
    {
      broken_[given.chain] = given.ofLoop || mesh_.triangleCount() == 0 ? 1 : 0;
    }
    if (!isNone && from != to)
    {
      ways_.push_back(way);
    }
    else if (way.leftOut)
    {
      mesh_.faults().add("left out", [&] { return name(given) + ", which goes nowhere"; });
    }
  }
  if (next != leftOut.end())
  {
    mesh_.faults().add("left out",
      [&]
      {
        return "chain " + std::to_string(next->chain) + ", segment " +
          std::to_string(next->segment) + " does not exist, or comes out of order";
      });
  }
}

void ConstraintCertifier::lay()
{
  fixed_.assign(mesh_.halfEdgeCount(), 0);
  earliest_.assign(mesh_.halfEdgeCount(), kNobody);
  uses_.assign(mesh_.halfEdgeCount(), LoopUses());
  for (Way& way : ways_)
  {
    if (!way.leftOut && !layOne(way))
    {
      mesh_.faults().add("constraint missing",
        [&] { return name(way) + " ends at " + mesh_.name(way.vertices.back()); });
    }
  }
}

/// Follows an accepted segment from vertex to vertex. False if an edge is missing.
bool ConstraintCertifier::layOne(Way& way)
{
  way.vertices.push_back(way.from);
  while (way.vertices.back() != way.to)
  {
    const std::int32_t at = way.vertices.back();
    const std::int32_t next = walk_.neighborTowards(at, way.to);
    if (next == kNone)
    {
      return false;
    }
    mark(at, next, way);
    way.vertices.push_back(next);
  }
  return true;
}

void ConstraintCertifier::mark(std::int32_t from, std::int32_t to, const Way& way)
{
  for (const std::int32_t h : { mesh_.findHalfEdge(from, to), mesh_.findHalfEdge(to, from) })
  {
    if (h != kNone)
    {
      fixed_[std::size_t(h)] = 1;
      earliest_[std::size_t(h)] = std::min(earliest_[std::size_t(h)], way.number);
    }
  }
}

/// By whole loops; in even-odd those of the same edges are one.
void ConstraintCertifier::countUses()
{
  using Edge = std::pair<std::int32_t, std::int32_t>;
  std::map<std::size_t, std::vector<Edge>> loops;
  for (const Way& way : ways_)
  {
    for (std::size_t k = 1;
         way.given.ofLoop && !broken_[way.given.chain] && k < way.vertices.size(); ++k)
    {
      loops[way.given.chain].push_back({ way.vertices[k - 1], way.vertices[k] });
    }
  }
  std::set<std::multiset<Edge>> known;
  for (const auto& loop : loops)
  {
    std::multiset<Edge> edges;
    for (const Edge& edge : loop.second)
    {
      edges.insert(std::minmax(edge.first, edge.second));
    }
    const bool counts = rule_ != FillRule::EvenOdd || known.count(edges) == 0;
    for (const Edge& edge : loop.second)
    {
      for (const bool along : { true, false })
      {
        const std::int32_t h = along ? mesh_.findHalfEdge(edge.first, edge.second)
                                     : mesh_.findHalfEdge(edge.second, edge.first);
        if (h != kNone && counts)
        {
          LoopUses& uses = uses_[std::size_t(h)];
          ++(along ? uses.along : uses.against);
        }
      }
    }
    known.insert(std::move(edges));
  }
}

const Way* ConstraintCertifier::findWay(std::size_t chain, std::size_t segment) const
{
  const auto isBefore = [&](const Way& way, std::size_t)
  { return std::tie(way.given.chain, way.given.segment) < std::tie(chain, segment); };
  const auto found = std::lower_bound(ways_.begin(), ways_.end(), segment, isBefore);
  return found != ways_.end() && found->given.chain == chain && found->given.segment == segment
    ? &*found
    : nullptr;
}

void ConstraintCertifier::checkLeftOut()
{
  for (const Way& way : ways_)
  {
    if (!way.leftOut)
    {
      continue;
    }
    const LeftOut& named = *way.leftOut;
    const Way* other = findWay(named.otherChain, named.otherSegment);
    if (!other || other->number >= way.number || other->leftOut)
    {
      mesh_.faults().add("left out",
        [&]
        {
          return name(way) + " for chain " + std::to_string(named.otherChain) + ", segment " +
            std::to_string(named.otherSegment) + ", which is not accepted before it";
        });
      continue;
    }
    checkCrossing(way, *other);
  }
}

void ConstraintCertifier::checkCrossing(const Way& way, const Way& other)
{
  const bool cross = orient(way.from, way.to, other.from) * orient(way.from, way.to, other.to) <
      0 &&
    orient(other.from, other.to, way.from) * orient(other.from, other.to, way.to) < 0;
  if (!cross || meetInVertex(way, other))
  {
    mesh_.faults().add(
      "left out", [&] { return name(way) + ", which does not cross " + name(other); });
    return;
  }
  std::size_t first = kNobody;
  walk_.crossEdges(way.from, way.to,
    [&](std::int32_t h)
    {
      const std::size_t earliest = earliest_[std::size_t(h)];
      first = earliest < way.number ? earliest : kNobody;
      return first != kNobody;
    });
  if (first != other.number)
  {
    mesh_.faults().add(
      "left out", [&] { return name(way) + ", which does not cross " + name(other) + " first"; });
  }
}

/// Is there a vertex where the two cross? On the way of the other the sides change once.
bool ConstraintCertifier::meetInVertex(const Way& way, const Way& other) const
{
  const int begin = orient(way.from, way.to, other.from);
  const auto found = std::partition_point(other.vertices.begin(), other.vertices.end(),
    [&](std::int32_t v) { return orient(way.from, way.to, v) == begin; });
  return found != other.vertices.end() && orient(way.from, way.to, *found) == 0;
}

std::size_t ConstraintCertifier::brokenLoops() const
{
  return std::size_t(
    std::count(broken_.begin() + std::ptrdiff_t(constraints_.lines), broken_.end(), char(1)));
}

void ConstraintCertifier::checkReport(const ConstrainedOutcome& outcome, std::size_t unfilled)
{
  const ConstraintReport& report = outcome.constraints;
  std::size_t edges = 0;
  for (std::int32_t h = 0; std::size_t(h) < fixed_.size(); ++h)
  {
    edges += fixed_[std::size_t(h)] && mesh_.twin(h) < h ? 1 : 0;
  }
  const auto isSame = [](const LeftOut& a, const LeftOut& b)
  {
    return a.chain == b.chain && a.segment == b.segment && a.otherChain == b.otherChain &&
      a.otherSegment == b.otherSegment;
  };
  const std::vector<LeftOut>& leftOut = whole_.constraints.leftOut;
  compare("segments", report.segments, segments_);
  compare("points", report.points, points_);
  compare("withoutVertex", report.withoutVertex, withoutVertex_);
  compare("crossing", report.crossing, leftOut.size());
  compare("edges", report.edges, edges);
  compare("unfilledLoops", report.unfilledLoops, unfilled);
  compare("triangles", outcome.report.triangles, outcome.triples.size() / 3);
  compare("leftOut, the same whether filled or not,",
    std::equal(
      leftOut.begin(), leftOut.end(), report.leftOut.begin(), report.leftOut.end(), isSame),
    true);
}

// --- Filling
// ---------------------------------------------------------------------------------------

void ConstraintCertifier::checkFilled()
{
  std::size_t taken = 0; // triangles of filled_ that were visited
  for (std::size_t t = 0; t < mesh_.triangleCount(); ++t)
  {
    const auto corners = whole_.triples.begin() + std::ptrdiff_t(3 * t);
    const bool isThere = 3 * taken < filled_.triples.size() &&
      std::equal(corners, corners + 3, filled_.triples.begin() + std::ptrdiff_t(3 * taken));
    taken += isThere ? 1 : 0;
    if (isThere != bool(kept_[t]))
    {
      mesh_.faults().add(
        isThere ? "kept against the rule" : "missing", [&] { return mesh_.triangleName(t); });
    }
  }
  if (3 * taken != filled_.triples.size())
  {
    mesh_.faults().add("filled triangles",
      [&]
      {
        return "number " + std::to_string(taken) +
          " is none of the whole triangulation, or comes " + "out of order";
      });
  }
  if (mesh_.faults().empty())
  {
    checkExtras(filled_, kept_);
  }
}

// --- Arrays of triangles -------------------------------------------------------------

void ConstraintCertifier::checkExtras(
  const ConstrainedOutcome& outcome, const std::vector<char>& kept)
{
  const std::size_t count = outcome.triples.size() / 3;
  compare("number of neighbors", outcome.neighbors.size(), 3 * count);
  compare("number of constraint edges", outcome.constraintEdges.size(), count);
  compare("number of regions", outcome.regions.size(), count);
  if (!mesh_.faults().empty())
  {
    return;
  }
  std::vector<std::int64_t> place(mesh_.triangleCount(), -1);
  std::int64_t next = 0;
  for (std::size_t t = 0; t < place.size(); ++t)
  {
    place[t] = kept[t] ? next++ : -1;
  }
  const std::vector<std::int64_t> region = regionsOf(mesh_, kept, fixed_);
  const auto check = [&](const char* what, std::size_t t, std::int64_t found, std::int64_t right)
  {
    if (found != right)
    {
      mesh_.faults().add(what,
        [&]
        {
          return std::to_string(found) + " instead of " + std::to_string(right) + ": " +
            mesh_.triangleName(t) + ", written as number " + std::to_string(place[t]);
        });
    }
  };
  for (std::size_t t = 0; t < place.size(); ++t)
  {
    if (!kept[t])
    {
      continue;
    }
    const auto k = std::size_t(place[t]);
    int bits = 0;
    for (std::size_t e = 0; e < 3; ++e)
    {
      const std::int32_t twin = mesh_.twin(std::int32_t(3 * t + e));
      bits |= fixed_[3 * t + e] ? 1 << e : 0;
      check("neighbor", t, outcome.neighbors[3 * k + e],
        twin == kNone ? -1 : place[std::size_t(twin / 3)]);
    }
    check("constraint edges", t, outcome.constraintEdges[k], bits);
    check("region", t, outcome.regions[k], region[t]);
  }
}

} // namespace

Complaints certifyConstrained(const PointView& points, const ConstraintView& constraints,
  FillRule rule, const ConstrainedOutcome& whole, const ConstrainedOutcome& filled)
{
  return ConstraintCertifier(points, constraints, rule, whole, filled).run();
}

} // namespace test
} // namespace ahd
