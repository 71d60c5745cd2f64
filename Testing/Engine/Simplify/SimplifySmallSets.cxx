// SPDX-License-Identifier: BSD-3-Clause
//
// simplify() against its definition: in each round all is triangulated anew, every point looks for
// its triangle, and every triangle is compared with all others.
#include "SimplifyCase.h"

#include "Predicates/Predicates.h"
#include "Simplify/Measure.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace ahd
{
namespace test
{
namespace
{

/// The definition, of one case.
class Definition
{
public:
  explicit Definition(const SimplifyCase& given)
    : given_(given)
    , isKept_(given.count(), false)
    , isFirst_(given.count(), false)
  {
    std::map<std::pair<double, double>, std::size_t> places;
    for (std::size_t i = 0; i < given.count(); ++i)
    {
      isFirst_[i] = places.insert({ { given.at(i).x, given.at(i).y }, i }).second;
      vertexOf_.push_back(places[{ given.at(i).x, given.at(i).y }]);
    }
    scale_ = 0.0;
    for (std::size_t i = 0; i < given.count(); ++i)
    {
      scale_ = isFirst_[i] ? std::max(scale_, std::fabs(given.height(i))) : scale_;
    }
    scale_ = powerOfTwoBelow(scale_);
    bound_ = given.settings.maximumError * scale_;
  }

  void run()
  {
    keepHull();
    for (const GivenSegment& segment : segmentsOf(given_.constraints.view()))
    {
      isKept_[vertexOf_[std::size_t(segment.from)]] = true;
      isKept_[vertexOf_[std::size_t(segment.to)]] = true;
    }
    for (const bool isWide : { false, true })
    {
      isWide_ = isWide;
      while (round())
      {
      }
    }
    if (given_.settings.secondPass)
    {
      drop();
    }
  }

  std::size_t rounds = 0;
  std::vector<std::size_t> kept() const
  {
    std::vector<std::size_t> ids;
    for (std::size_t i = 0; i < isKept_.size(); ++i)
    {
      if (isKept_[vertexOf_[i]])
      {
        ids.push_back(i);
      }
    }
    return ids;
  }

private:
  struct Best
  {
    double error = -1.0;
    std::size_t id = 0;
  };
  using Triangle = std::array<std::size_t, 3>;

  int side(std::size_t a, std::size_t b, std::size_t p) const
  {
    return orient2d(given_.at(a), given_.at(b), given_.at(p));
  }
  bool isBefore(std::size_t a, std::size_t b) const
  {
    return lexicographicallyLess(given_.at(a), given_.at(b));
  }
  bool isBetween(std::size_t a, std::size_t b, std::size_t p) const
  {
    return side(a, b, p) == 0 && (isBefore(a, p) != isBefore(b, p));
  }
  bool areAllOnOneSide(std::size_t a, std::size_t b) const
  {
    bool are = true;
    for (std::size_t i = 0; i < given_.count(); ++i)
    {
      are = are && side(a, b, i) >= 0;
    }
    return are;
  }

  /// A corner lies between no two others of the hull's edge.
  void keepHull()
  {
    for (std::size_t a = 0; a < given_.count(); ++a)
    {
      for (std::size_t b = 0; b < given_.count(); ++b)
      {
        if (a != b && isFirst_[a] && isFirst_[b] && areAllOnOneSide(a, b))
        {
          hullEdges_.push_back({ a, b });
        }
      }
    }
    for (const auto& edge : hullEdges_)
    {
      for (const std::size_t end : edge)
      {
        bool isCorner = true;
        for (const auto& other : hullEdges_)
        {
          isCorner = isCorner &&
            (other[0] == end || other[1] == end || !isBetween(other[0], other[1], end));
        }
        isKept_[end] = isKept_[end] || isCorner;
      }
    }
  }

  std::vector<Triangle> triangles()
  {
    std::vector<unsigned char> skip(given_.count());
    for (std::size_t i = 0; i < skip.size(); ++i)
    {
      skip[i] = !isKept_[vertexOf_[i]];
    }
    PointView view = given_.view();
    view.skip = skip.data();
    EXPECT_EQ(engine_.run(view), Status::Ok);
    EXPECT_EQ(
      engine_.constrain(given_.constraints.asLines().view(), FillRule::EvenOdd), Status::Ok);
    std::vector<std::int64_t> ids(3 * engine_.report().triangles);
    EXPECT_EQ(engine_.writeTriangles(ids.data()), Status::Ok);
    std::vector<Triangle> result;
    for (std::size_t t = 0; t < ids.size(); t += 3)
    {
      result.push_back(
        { { std::size_t(ids[t]), std::size_t(ids[t + 1]), std::size_t(ids[t + 2]) } });
    }
    return result;
  }

  /// On an edge, to the left of it from its smaller end; on the hull, the one that there is.
  bool has(const Triangle& t, std::size_t p) const
  {
    bool is = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = t[k], b = t[(k + 1) % 3];
      const int sign = side(a, b, p);
      is = is && (sign > 0 || (sign == 0 && (isBefore(a, b) || areAllOnOneSide(a, b))));
    }
    return is;
  }

  double error(const Triangle& t, std::size_t p) const
  {
    const auto sample = [&](std::size_t i) {
      return Sample{ given_.at(i), given_.height(i) * scale_ };
    };
    const Interpolant interpolant(
      std::array<Sample, 3>{ { sample(t[0]), sample(t[1]), sample(t[2]) } });
    const double rounded = interpolant.error(sample(p));
    return isWide_ && !interpolant.isSurelyWithin(sample(p), rounded, 1.0, bound_)
      ? interpolant.wideError(sample(p), 1.0, bound_)
      : rounded;
  }

  std::vector<Best> worst(const std::vector<Triangle>& made) const
  {
    std::vector<Best> result(made.size());
    for (std::size_t p = 0; p < given_.count(); ++p)
    {
      std::size_t owners = isFirst_[p] && !isKept_[p] ? 0 : 1;
      for (std::size_t t = 0; t < made.size() && isFirst_[p] && !isKept_[p]; ++t)
      {
        if (has(made[t], p))
        {
          ++owners;
          const Best mine = { error(made[t], p), p };
          result[t] = isBetter(mine, result[t]) ? mine : result[t];
        }
      }
      EXPECT_EQ(owners, 1u);
    }
    return result;
  }
  bool isBetter(const Best& a, const Best& b) const
  {
    return a.error != b.error ? a.error > b.error : b.error >= 0.0 && isBefore(a.id, b.id);
  }

  bool round()
  {
    const std::vector<Triangle> made = triangles();
    const std::vector<Best> best = worst(made);
    std::vector<Best> maxima;
    for (std::size_t t = 0; t < made.size(); ++t)
    {
      bool is = best[t].error > bound_;
      for (std::size_t u = 0; is && u < made.size(); ++u)
      {
        const bool shares = std::find_first_of(made[t].begin(), made[t].end(), made[u].begin(),
                              made[u].end()) != made[t].end();
        is = u == t || !shares || !isBetter(best[u], best[t]);
      }
      if (is)
      {
        maxima.push_back(best[t]);
      }
    }
    std::sort(maxima.begin(), maxima.end(),
      [this](const Best& a, const Best& b) { return isBetter(a, b); });
    for (const Best& maximum : maxima)
    {
      isKept_[maximum.id] = true;
      order_.push_back(maximum.id);
    }
    rounds += maxima.empty() ? 0 : 1;
    return !maxima.empty();
  }

  bool mayGo(std::size_t p) const
  {
    bool may = true;
    for (const auto& edge : hullEdges_)
    {
      may = may && !isBetween(edge[0], edge[1], p);
    }
    for (const GivenSegment& segment : segmentsOf(given_.constraints.view()))
    {
      may = may && !isBetween(std::size_t(segment.from), std::size_t(segment.to), p);
    }
    return may;
  }

  void drop()
  {
    for (std::size_t k = order_.size(); k-- > 0;)
    {
      if (mayGo(order_[k]))
      {
        isKept_[order_[k]] = false;
        bool isWithin = true;
        for (const Best& best : worst(triangles()))
        {
          isWithin = isWithin && best.error <= bound_;
        }
        isKept_[order_[k]] = !isWithin;
      }
    }
  }

  const SimplifyCase& given_;
  std::vector<bool> isKept_, isFirst_;
  std::vector<std::size_t> vertexOf_, order_;
  std::vector<std::array<std::size_t, 2>> hullEdges_;
  double scale_ = 1.0, bound_ = 0.0;
  bool isWide_ = false;
  Engine engine_;
};

void expectAsDefined(const SimplifyCase& given)
{
  Definition definition(given);
  definition.run();
  const SimplifyResult result = given.simplified();
  EXPECT_EQ(keptIds(result), definition.kept());
  EXPECT_EQ(result.rounds, definition.rounds);
  EXPECT_LE(result.largestError, given.settings.maximumError);
}

/// A lattice with heights of few values: errors and places tie, and points lie on edges.
SimplifyCase latticeCase(std::uint64_t seed, double step)
{
  SimplifyCase given;
  Random random(seed);
  const std::size_t n = 8 + random.below(40);
  for (std::size_t i = 0; i < n; ++i)
  {
    given.add({ step * double(random.below(8)), step * double(random.below(8)) },
      step * double(random.below(6)));
  }
  return given;
}

/// A segment between two of the points, unless it crosses one that is there.
void addSegment(SimplifyCase& given, Random& random)
{
  const std::size_t a = random.below(given.count()), b = random.below(given.count());
  bool crosses = false;
  for (const GivenSegment& other : segmentsOf(given.constraints.view()))
  {
    const Point p = given.at(a), q = given.at(b), r = given.at(std::size_t(other.from)),
                s = given.at(std::size_t(other.to));
    crosses = crosses ||
      (orient2d(p, q, r) * orient2d(p, q, s) < 0 && orient2d(r, s, p) * orient2d(r, s, q) < 0);
  }
  if (!crosses)
  {
    given.constraints.addLine({ std::int64_t(a), std::int64_t(b) });
  }
}

TEST(SimplifySmallSets, OfLattices)
{
  for (std::uint64_t seed = 1; seed <= reduced(300); ++seed)
  {
    SimplifyCase given = latticeCase(seed, seed % 2 == 0 ? 1.0 : 0.1);
    given.settings.maximumError = seed % 3 == 0 ? 0.0 : 0.25 * double(seed % 5);
    given.settings.secondPass = seed % 4 == 1;
    expectAsDefined(given);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
  }
}

TEST(SimplifySmallSets, OfLatticesWithSegments)
{
  for (std::uint64_t seed = 1; seed <= reduced(200); ++seed)
  {
    SimplifyCase given = latticeCase(seed, 1.0);
    Random random(seed);
    for (int k = 0; k < 4; ++k)
    {
      addSegment(given, random);
    }
    given.settings.maximumError = 0.5;
    given.settings.secondPass = seed % 2 == 0;
    expectAsDefined(given);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
  }
}

TEST(SimplifySmallSets, OfPointsAnywhere)
{
  for (std::uint64_t seed = 1; seed <= reduced(200); ++seed)
  {
    const Distribution d = seed % 3 == 0 ? Distribution::NearlyCollinear
      : seed % 3 == 1                    ? Distribution::Uniform
                                         : Distribution::Utm;
    SimplifyCase given;
    Random random(seed);
    for (const Point& p : makePoints(d, 10 + random.below(50), seed))
    {
      given.add(p, random.unit());
    }
    given.settings.maximumError = 0.1 * double(seed % 4);
    given.settings.secondPass = seed % 2 == 0;
    expectAsDefined(given);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
  }
}

} // namespace
} // namespace test
} // namespace ahd
