// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RefineCase_h
#define ahd_RefineCase_h

#include "ConstraintMakers.h"
#include "Engine.h"
#include "EngineRun.h"
#include "ExactSigns.h"
#include "Predicates/Circles.h"
#include "Refine/Refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ahd
{
namespace test
{

/// A constrained triangulation that is refined, and the fresh one of the result.
class RefineCase
{
public:
  using Corners = std::array<Index, 3>;

  explicit RefineCase(ConstraintCase from, FillRule rule = FillRule::EvenOdd)
    : from_(std::move(from))
    , points_(from_.points)
  {
    EXPECT_EQ(given_.run(from_.view()), Status::Ok);
    EXPECT_EQ(given_.constrain(from_.constraints.view(), rule), Status::Ok);
  }
  RefineCase(const RefineCase&) = delete;

  RefineRequest request;
  Refinement made;

  Status run(Progress* progress = nullptr)
  {
    return refine(given_.made, request, Context{ progress, nullptr }, made);
  }

  /// Runs, and says what of the contract of Refine.h does not hold. All in wide or exact
  /// arithmetic.
  std::string faults();

  std::size_t count(RefineReason reason) const
  {
    return std::size_t(std::count_if(made.bad.begin(), made.bad.end(),
      [reason](const BadTriangle& t) { return t.reason == reason; }));
  }
  std::size_t givenTriangles() const { return given_.report().triangles; }
  Point place(std::size_t id) const
  {
    return id < points_.size()
      ? points_[id]
      : Point{ made.points[id - points_.size()].x, made.points[id - points_.size()].y };
  }

private:
  using Wide = long double;

  static Wide lengthSquared(const Point& a, const Point& b)
  {
    const Wide x = Wide(b.x) - a.x, y = Wide(b.y) - a.y;
    return x * x + y * y;
  }
  static Wide doubleArea(const Point& a, const Point& b, const Point& c)
  {
    return (Wide(b.x) - a.x) * (Wide(c.y) - a.y) - (Wide(b.y) - a.y) * (Wide(c.x) - a.x);
  }
  double sizeAt(std::size_t id) const;
  bool isTooLong(Index a, Index b) const;
  bool isBad(const Corners& t) const;
  bool isInLens(Index a, Index b, Index apex) const;
  void checkFresh(std::ostream& says);
  void checkTriangles(std::ostream& says);
  void checkPieces(std::ostream& says) const;
  void checkPoints(std::ostream& says) const;
  void makeSizes();

  const ConstraintCase from_;
  const std::vector<Point>& points_;
  std::vector<Point> all_;
  std::vector<double> sizes_; ///< by id
  Engine given_, fresh_;
  std::vector<Corners> kept_; ///< of the fresh one, from the smallest corner
};

inline double RefineCase::sizeAt(std::size_t id) const
{
  return sizes_.empty() ? 0.0 : sizes_[id];
}

inline void RefineCase::makeSizes()
{
  sizes_.clear();
  for (std::size_t k = 0; request.sizes && k < all_.size(); ++k)
  {
    double size = k < points_.size() ? request.sizes[k] : 0.0;
    for (std::size_t e = 0; k >= points_.size() && e < 3; ++e)
    {
      const SteinerPoint& p = made.points[k - points_.size()];
      size += p.corners[e] == kNoIndex ? 0.0 : p.weights[e] * request.sizes[p.corners[e]];
    }
    sizes_.push_back(size);
  }
}

/// Not by more than rounding, as in isBad().
inline bool RefineCase::isTooLong(Index a, Index b) const
{
  Wide most = std::numeric_limits<double>::infinity();
  most = request.maximumLength > 0.0 ? Wide(request.maximumLength) : most;
  most = sizes_.empty() ? most : std::min(most, (Wide(sizeAt(a)) + sizeAt(b)) / 2);
  return std::sqrt(lengthSquared(all_[a], all_[b])) > most * (1 + 1e-12L);
}

inline bool RefineCase::isBad(const Corners& t) const
{
  const Point &a = all_[t[0]], &b = all_[t[1]], &c = all_[t[2]];
  Wide lengths[] = { lengthSquared(a, b), lengthSquared(b, c), lengthSquared(c, a) };
  std::sort(lengths, lengths + 3);
  const Wide sine = std::sin(Wide(request.minimumAngle) * std::acos(Wide(-1)) / 180);
  const Wide area = doubleArea(a, b, c);
  const bool isThin = area < sine * std::sqrt(lengths[1]) * std::sqrt(lengths[2]) * (1 - 1e-12L);
  const bool isLarge = request.maximumArea > 0.0 &&
    area > 2 * Wide(request.maximumArea) * (1 + 1e-12L);
  return isThin || isLarge || isTooLong(t[0], t[1]) || isTooLong(t[1], t[2]) ||
    isTooLong(t[2], t[0]);
}

/// Is the angle at the apex above 180 degrees less twice the least angle?
inline bool RefineCase::isInLens(Index a, Index b, Index apex) const
{
  const Point &p = all_[apex], &q = all_[a], &r = all_[b];
  if (acuteness(q, p, r) >= 0)
  {
    return false;
  }
  const Wide dot = (Wide(q.x) - p.x) * (Wide(r.x) - p.x) + (Wide(q.y) - p.y) * (Wide(r.y) - p.y);
  const Wide angle = std::acos(Wide(-1)) / 180 * std::max(request.minimumAngle, 10.0);
  const Wide bound = std::cos(2 * angle) * std::sqrt(lengthSquared(p, q) * lengthSquared(p, r));
  return -dot > bound * (1 + 1e-12L);
}

/// The result is the triangulation of the points and constraints.
inline void RefineCase::checkFresh(std::ostream& says)
{
  PointView view = viewOf(all_);
  std::vector<unsigned char> skip = from_.skip;
  skip.resize(from_.skip.empty() ? 0 : all_.size(), 0);
  view.skip = skip.empty() ? nullptr : skip.data();
  if (fresh_.run(view) != Status::Ok ||
    fresh_.constrain(made.constraints(), FillRule::EvenOdd) != Status::Ok)
  {
    says << "no fresh triangulation; ";
    return;
  }
  const ConstraintReport& report = fresh_.constraints();
  if (report.crossing + report.unfilledLoops + report.withoutVertex + report.points != 0)
  {
    says << "pieces are no edges; ";
  }
  if (fresh_.report().duplicates != given_.report().duplicates)
  {
    says << "a point twice; ";
  }
  if (made.triangles == 0)
  {
    return; // without a loop, nothing bounds what is inside
  }
  if (fresh_.report().triangles != made.triangles)
  {
    says << fresh_.report().triangles << " fresh triangles, not " << made.triangles << "; ";
  }
  std::vector<std::int32_t> ids(3 * fresh_.report().triangles);
  if (fresh_.writeTriangles(ids.data()) != Status::Ok)
  {
    says << "no triangles; ";
  }
  kept_.clear();
  for (std::size_t t = 0; t < ids.size(); t += 3)
  {
    Corners c = { { Index(ids[t]), Index(ids[t + 1]), Index(ids[t + 2]) } };
    std::rotate(c.begin(),
      std::min_element(c.begin(), c.end(),
        [this](Index a, Index b) { return lexicographicallyLess(all_[a], all_[b]); }),
      c.end());
    kept_.push_back(c);
  }
}

/// Exactly those that are in `bad` do not meet the request, but for rounding; the area stays.
inline void RefineCase::checkTriangles(std::ostream& says)
{
  std::map<Corners, RefineReason> bad;
  for (const BadTriangle& t : made.bad)
  {
    bad[t.corners] = t.reason;
  }
  std::size_t found = 0;
  Wide area = 0, before = 0;
  for (const Corners& t : kept_)
  {
    const bool isListed = bad.count(t) != 0;
    found += isListed ? 1 : 0;
    area += doubleArea(all_[t[0]], all_[t[1]], all_[t[2]]);
    if (!isListed && isBad(t))
    {
      says << "a bad triangle; ";
    }
  }
  if (found != made.bad.size() || bad.size() != made.bad.size())
  {
    says << made.bad.size() - found << " bad triangles are none; ";
  }
  std::vector<std::int32_t> ids(3 * givenTriangles());
  given_.writeTriangles(ids.data());
  Wide most = 0, longest = 0;
  for (std::size_t t = 0; t < ids.size(); t += 3)
  {
    const auto p = [&](std::size_t k) { return points_[std::size_t(ids[t + k])]; };
    before += doubleArea(p(0), p(1), p(2));
    for (std::size_t k = 0; k < 3; ++k)
    {
      most = std::max({ most, Wide(std::fabs(p(k).x)), Wide(std::fabs(p(k).y)) });
      longest = std::max(longest, lengthSquared(p(k), p((k + 1) % 3)));
    }
  }
  const Wide moved = Wide(made.onSegments) * most * std::sqrt(longest) * 0x1p-53L;
  const Wide rounding = Wide(kept_.size()) * longest * 0x1p-62L; // of areas
  if (std::fabs(area - before) > 1e-12L * before + moved + rounding)
  {
    says << "the area has changed from " << before << " to " << area << "; ";
  }
}

/// As many pieces with something inside are encroached, or too long, as it says.
inline void RefineCase::checkPieces(std::ostream& says) const
{
  std::map<std::pair<Index, Index>, bool> pieces;
  const ConstraintView chains = made.constraints();
  for (std::size_t k = 0; k < chains.chains; ++k)
  {
    const std::int64_t begin = chains.offsets[k], end = chains.offsets[k + 1];
    for (std::int64_t i = begin; i < end; ++i)
    {
      const Index a = Index(chains.ids[i]);
      const Index b = Index(chains.ids[i + 1 < end ? i + 1 : begin]);
      if (i + 1 < end || k >= chains.lines)
      {
        pieces[std::minmax(a, b)] = false;
      }
    }
  }
  for (const Corners& t : kept_)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      const Index a = t[e], b = t[(e + 1) % 3];
      const auto found = pieces.find(std::minmax(a, b));
      if (found != pieces.end() && (isInLens(a, b, t[(e + 2) % 3]) || isTooLong(a, b)))
      {
        found->second = true;
      }
    }
  }
  const auto count = std::count_if(
    pieces.begin(), pieces.end(), [](const auto& piece) { return piece.second; });
  if (std::size_t(count) > made.encroachedPieces)
  {
    says << count << " encroached pieces, not " << made.encroachedPieces << "; ";
  }
}

/// A Steiner point is where its weights say: on its segment to half a unit in the last place.
inline void RefineCase::checkPoints(std::ostream& says) const
{
  std::size_t onSegments = 0;
  for (const SteinerPoint& p : made.points)
  {
    Wide x = 0, y = 0, sum = 0;
    double most = 0.0;
    bool isWithin = true;
    for (std::size_t e = 0; e < 3; ++e)
    {
      const Wide weight = p.weights[e];
      const bool is = p.corners[e] != kNoIndex;
      isWithin = isWithin && weight >= 0 && weight <= 1 && (is || (e == 2 && weight == 0));
      const Point from = is ? points_[p.corners[e]] : Point{ 0.0, 0.0 };
      x += weight * from.x;
      y += weight * from.y;
      sum += weight;
      most = std::max({ most, std::fabs(from.x), std::fabs(from.y) });
    }
    onSegments += p.isOnSegment() ? 1 : 0;
    Wide rounding = std::max(Wide(most) * 0x1p-50L, 0x1p-1070L); // of subnormal numbers
    if (p.isOnSegment())
    {
      const Point a = points_[p.corners[0]], b = points_[p.corners[1]];
      x = a.x + Wide(p.weights[1]) * (Wide(b.x) - a.x);
      y = a.y + Wide(p.weights[1]) * (Wide(b.y) - a.y);
      rounding = std::max(Wide(most) * 0x1.01p-53L, 0x1.01p-1075L);
    }
    if (!isWithin || std::fabs(sum - 1) > 0x1p-51L || std::fabs(x - p.x) > rounding ||
      std::fabs(y - p.y) > rounding)
    {
      says << "a point elsewhere: " << hexText({ p.x, p.y }) << "; ";
      break;
    }
  }
  if (onSegments != made.onSegments)
  {
    says << "points on segments miscounted; ";
  }
}

inline std::string RefineCase::faults()
{
  std::ostringstream says;
  if (run() != Status::Ok || made.fault != RefineFault::None)
  {
    return "not refined";
  }
  all_ = points_;
  for (const SteinerPoint& p : made.points)
  {
    all_.push_back({ p.x, p.y });
  }
  makeSizes();
  kept_.clear();
  checkFresh(says);
  checkTriangles(says);
  checkPieces(says);
  checkPoints(says);
  return says.str();
}

} // namespace test
} // namespace ahd

#endif
