// SPDX-License-Identifier: BSD-3-Clause
//
// The results of prepare() for an input and a source, step by step.
#include "PrepareCase.h"

#include "Crossings/Crossings.h"

#include "Listeners.h"
#include "Prepare/Bounding.h"
#include "Surface/PlaneFit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ahd
{
namespace test
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Ids = std::vector<std::int64_t>;

PreparedInput prepared(const PrepareCase& given)
{
  PreparedInput out;
  EXPECT_EQ(prepare(given.request, Context(), out), Status::Ok);
  return out;
}

Ids idsOf(const PreparedInput& input)
{
  const ConstraintView view = input.constraints();
  return Ids(view.ids, view.ids + view.offsets[view.chains]);
}

Ids offsetsOf(const PreparedInput& input)
{
  const ConstraintView view = input.constraints();
  return Ids(view.offsets, view.offsets + view.chains + 1);
}

const std::vector<Xyz> kSquare = { { { 0, 0, 1 } }, { { 4, 0, 2 } }, { { 4, 4, 3 } },
  { { 0, 4, 4 } } };

TEST(Prepare, BorrowsWhatIsTriangulatedWhereItLies)
{
  const std::vector<float> floats = { 1, 2, 3, 4, 5, 6 };
  const std::vector<unsigned char> marks = { 4, 0 };
  InputRequest request;
  request.points = PointView(floats.data(), 2, 3);
  request.points.skip = marks.data();
  request.points.skipMask = 4;
  Listener listener;
  PreparedInput out;
  ASSERT_EQ(prepare(request, Context{ &listener, nullptr }, out), Status::Ok);
  EXPECT_EQ(out.points().floats, floats.data());
  EXPECT_EQ(out.points().skip, marks.data());
  EXPECT_TRUE(out.points().skipped(0));
  EXPECT_EQ(out.points().count, 2u);
  EXPECT_EQ(out.addedCount(), 0u);
  EXPECT_EQ(out.place(1), (Xyz{ { 4, 5, 6 } }));
  EXPECT_FALSE(out.isProjected());
  EXPECT_FALSE(out.hasConstraints());
  EXPECT_EQ(out.constraints().chains, 0u);
  EXPECT_TRUE(listener.phases().empty()) << "nothing was done";
  EXPECT_EQ(preparationMemoryEstimate(request), 0u);
}

TEST(Prepare, PointsOfTheSourceComeBehindThoseOfTheInput)
{
  const std::vector<float> floats = { 1, 2, 3, 4, 5, 6 };
  const std::vector<unsigned char> marks = { 8, 3 };
  PrepareCase given({}, kSquare, { { 0, 1 }, { 3, 2, 4 } }, { { 0, 1, -1 } });
  given.request.points = PointView(floats.data(), 2, 3);
  given.request.points.skip = marks.data();
  given.request.points.skipMask = 2;
  given.request.firstCell = 7;
  const PreparedInput out = prepared(given);
  EXPECT_EQ(out.inputCount(), 2u);
  EXPECT_EQ(out.sourceCount(), 4u);
  EXPECT_EQ(out.addedCount(), 4u);
  ASSERT_EQ(out.points().count, 6u);
  EXPECT_EQ(out.place(1), (Xyz{ { 4, 5, 6 } }));
  EXPECT_EQ(out.place(2), kSquare[0]);
  EXPECT_EQ(out.place(5), kSquare[3]);
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(out.points().skipped(i), i == 1) << "point " << i;
  }
  EXPECT_EQ(idsOf(out), (Ids{ 2, 3, 5, 4, -1, 2, 3, -1 }));
  EXPECT_EQ(offsetsOf(out), (Ids{ 0, 2, 5, 8 }));
  EXPECT_EQ(out.constraints().lines, 2u);
  EXPECT_EQ(out.cellOf(2), 9);
  EXPECT_EQ(out.unfitIds().count, 2u);
  EXPECT_EQ(out.unfitIds().firstId, 4);
  EXPECT_EQ(out.unfitIds().firstCell, 8);
}

TEST(Prepare, IdsMayBeThoseOfTheInput)
{
  PrepareCase given(kSquare, {}, { { 0, 2 } }, { { 1, 4, 3 } });
  PreparedInput out = prepared(given);
  EXPECT_EQ(idsOf(out), Ids(5, -1)) << "the source has no points";
  EXPECT_EQ(out.unfitIds().count, 5u);
  given.request.idsAreOfInput = true;
  out = prepared(given);
  EXPECT_EQ(idsOf(out), (Ids{ 0, 2, 1, -1, 3 }));
  EXPECT_EQ(out.unfitIds().count, 1u);
  EXPECT_EQ(out.unfitIds().firstId, 4);
  EXPECT_EQ(out.unfitIds().firstCell, 1);
  EXPECT_EQ(out.addedCount(), 0u);
}

TEST(Prepare, CellsOfBothKindsAndEmptyOnes)
{
  PrepareCase given(kSquare, kSquare, { {}, { 0 }, { 1, 2, 3 } }, { {}, { 0, 1, 2 } });
  const PreparedInput wide = prepared(given);
  EXPECT_EQ(offsetsOf(wide), (Ids{ 0, 0, 1, 4, 4, 7 }));
  given.setWide(false);
  EXPECT_EQ(bytesOf(prepared(given)), bytesOf(wide));
  EXPECT_EQ(segmentsOf(given.request), 7u);

  const PrepareCase none(kSquare, kSquare, { {}, {} });
  EXPECT_EQ(prepared(none).constraints().chains, 0u) << "no cell has a point";
}

TEST(Prepare, ItCanBeMoved)
{
  PrepareCase given(kSquare, kSquare, { { 0, 2 }, { 1, 3 } });
  given.request.split = true;
  PreparedInput first = prepared(given);
  const std::string bytes = bytesOf(first);
  PreparedInput second(std::move(first));
  EXPECT_EQ(bytesOf(second), bytes);
  PreparedInput third;
  third = std::move(second);
  EXPECT_EQ(bytesOf(third), bytes);
}

TEST(Prepare, ToleranceIsAPartOfTheDiagonalOfThoseThatTakePart)
{
  // the diagonal is 5; the point that is left out, and that without a place, do not count
  const std::vector<Xyz> input = { { { 0, 0, 0 } }, { { 3, 4, 0 } }, { { 3, 3.5, 0 } },
    { { 100, 0, 0 } }, { { kNaN, 900, 0 } } };
  const std::vector<unsigned char> marks = { 0, 0, 0, 1, 0 };
  PrepareCase given(input, { { { 0.25, 0, 0 } } }, { { 0, 0 } });
  given.request.points.skip = marks.data();
  for (const double tolerance : { 0.09, 0.1 })
  {
    given.request.tolerance = tolerance;
    const PreparedInput out = prepared(given);
    // in lexicographic order: the point of the source into the first, (3, 4) into (3, 3.5)
    ASSERT_EQ(out.merged().size(), tolerance == 0.1 ? 2u : 1u);
    EXPECT_EQ(out.merged().back().id, 5u);
    EXPECT_EQ(out.merged().back().keptId, 0u);
    EXPECT_EQ(out.merged().front().id, tolerance == 0.1 ? 1u : 5u);
    EXPECT_TRUE(out.points().skipped(5));
    EXPECT_TRUE(out.points().skipped(3));
    EXPECT_EQ(out.points().skipped(1), tolerance == 0.1);
    EXPECT_EQ(idsOf(out), (Ids{ 0, 0 })) << "constraints follow what is merged";
  }
  given.request.tolerance = 1e-9;
  EXPECT_TRUE(prepared(given).merged().empty());
  const PrepareCase huge({ { { -1e308, 0, 0 } }, { { 1e308, 1e308, 0 } } }, {});
  EXPECT_TRUE(prepared(huge).merged().empty());
}

TEST(Prepare, BoundingPointsLieAroundAllThatTakePart)
{
  const std::vector<Xyz> input = { { { 0, 0, kNaN } }, { { 4, 1, 2 } }, { { 9, 9, 9 } },
    { { kInfinity, 0, 50 } } };
  const std::vector<unsigned char> marks = { 0, 0, 1, 0 };
  PrepareCase given(input, { { { 2, 3, 5 } } });
  given.request.points.skip = marks.data();
  given.request.bounding = true;
  given.request.offset = 1.5;
  PreparedInput out = prepared(given);
  const auto eight = boundingPoints({ { 0, 0, 2 } }, { { 4, 3, 5 } }, 1.5);
  ASSERT_EQ(out.points().count, 13u);
  EXPECT_EQ(expectedPoints(given.request), 13u);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(out.place(5 + i), eight[i]);
    EXPECT_FALSE(out.points().skipped(5 + i));
  }
  EXPECT_TRUE(out.points().skipped(2));

  given.request.fitPlane = true;
  EXPECT_EQ(expectedPoints(given.request), 5u);
  EXPECT_EQ(prepared(given).points().count, 5u) << "there are none in another plane";

  PrepareCase flat({ { { 0, 0, kNaN } }, { { 4, 3, kInfinity } } }, {});
  flat.request.bounding = true;
  EXPECT_EQ(prepared(flat).place(2), boundingPoints({ { 0, 0, 0 } }, { { 4, 3, 0 } }, 1.0)[0]);

  PrepareCase none({ { { kNaN, 1, 1 } } }, {});
  none.request.bounding = true;
  EXPECT_EQ(prepared(none).points().count, 1u) << "no point to put them around";
}

TEST(Prepare, TheFittedPlaneIsThatOfTheInput)
{
  std::vector<Xyz> input = oddPoints(500, 1);
  for (Xyz& p : input)
  {
    p[2] = 0.5 * p[0] - 0.25 * p[1] + 0.01 * p[2];
  }
  PrepareCase given(input, kSquare);
  given.request.fitPlane = true;
  const PreparedInput out = prepared(given);
  Plane expected;
  ASSERT_EQ(expected.fit(viewOf(input), Context()), Status::Ok);
  EXPECT_TRUE(out.isProjected());
  EXPECT_EQ(out.plane().normal(), expected.normal());
  EXPECT_EQ(out.plane().firstAxis(), expected.firstAxis());
  for (std::size_t i = 0; i < out.points().count; ++i)
  {
    const Xyz& p = i < 500 ? input[i] : kSquare[i - 500];
    const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double place = out.place(i)[k];
      ASSERT_TRUE(finite ? place == expected.project(p)[k] : std::isnan(place)) << "point " << i;
    }
  }
}

/// Swaps x and y, and counts its calls.
class Turn : public Projection
{
public:
  bool project(const PointView& points, double* to, const Context& context) const override
  {
    ++calls;
    if (context.progress && !context.progress->advance(Phase::Merge, 0.0))
    {
      return false;
    }
    for (std::size_t i = 0; i < points.count; ++i)
    {
      const double x = points.doubles[3 * i];
      to[3 * i] = points.doubles[3 * i + 1];
      to[3 * i + 1] = -x;
    }
    return true;
  }
  mutable int calls = 0;
};

TEST(Prepare, AnyOtherPlaneCanBeHad)
{
  PrepareCase given({ { { 1, 2, 3 } } }, { { { 4, 5, 6 } } });
  const Turn turn;
  given.request.projection = &turn;
  given.request.bounding = true;
  Listener listener;
  PreparedInput out;
  ASSERT_EQ(prepare(given.request, Context{ &listener, nullptr }, out), Status::Ok);
  EXPECT_EQ(turn.calls, 1);
  EXPECT_TRUE(out.isProjected());
  ASSERT_EQ(out.points().count, 2u);
  EXPECT_EQ(out.place(0), (Xyz{ { 2, -1, 3 } }));
  EXPECT_EQ(out.place(1), (Xyz{ { 5, -4, 6 } }));
  EXPECT_EQ(listener.phases(), std::vector<Phase>{ Phase::Merge });
  given.request.fitPlane = true;
  prepared(given);
  EXPECT_EQ(turn.calls, 1) << "a fitted plane comes first";
}

TEST(Prepare, CrossingsComeLastBetweenTheirEnds)
{
  // two lines that cross a quarter along the one, half along the other
  PrepareCase given({ { { 9, 9, 0 } } },
    { { { 0, 1, 10 } }, { { 4, 1, 20 } }, { { 1, 0, 100 } }, { { 1, 2, 300 } } },
    { { 0, 1 }, { 2, 3 } });
  given.request.firstCell = 5;
  EXPECT_EQ(prepared(given).points().count, 5u) << "not without being asked";
  given.request.split = true;
  given.request.bounding = true;
  Listener listener;
  PreparedInput out;
  ASSERT_EQ(prepare(given.request, Context{ &listener, nullptr }, out), Status::Ok);
  EXPECT_EQ(listener.phases(), (std::vector<Phase>{ Phase::Merge, Phase::Split }));
  ASSERT_EQ(out.points().count, 1u + 4 + 8 + 1);
  ASSERT_EQ(out.crossings().size(), 1u);
  EXPECT_EQ(out.firstCrossing(), 13u);
  EXPECT_EQ(out.crossings()[0].ends, (std::array<Index, 4>{ { 1, 2, 3, 4 } }));
  EXPECT_EQ(out.crossings()[0].along, (std::array<double, 2>{ { 0.25, 0.5 } }));
  EXPECT_EQ(out.place(13), (Xyz{ { 1, 1, 0.5 * 12.5 + 0.5 * 200 } }));
  EXPECT_EQ(out.crossingCells(), (std::vector<std::array<std::int64_t, 2>>{ { { 6, 5 } } }));
  EXPECT_EQ(idsOf(out), (Ids{ 1, 13, 2, 3, 13, 4 }));
  EXPECT_EQ(offsetsOf(out), (Ids{ 0, 3, 6 }));
}

TEST(Prepare, ALoopEndsWhereItBegan)
{
  // the last side of the loop is crossed
  PrepareCase given({},
    { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 4, 4, 8 } }, { { 4, 2, 0 } }, { { 0, 2, 0 } } },
    { { 3, 4 } }, { { 0, 1, 2 } });
  given.request.split = true;
  const PreparedInput out = prepared(given);
  ASSERT_EQ(out.crossings().size(), 1u);
  EXPECT_EQ(out.crossings()[0].ends, (std::array<Index, 4>{ { 0, 2, 4, 3 } }));
  EXPECT_EQ(out.place(5), (Xyz{ { 2, 2, 2 } }));
  EXPECT_EQ(idsOf(out), (Ids{ 3, 5, 4, 0, 1, 2, 5 }));
}

TEST(Prepare, HeightsDoNotDependOnOrderAndDirection)
{
  const std::vector<Xyz> source = { { { 0, 0, 0.1 } }, { { 3, 3, 0.7 } }, { { 0, 3, 0.3 } },
    { { 3, 0, 1.9 } }, { { 0, 1.5, 2.2 } }, { { 3, 1.5, 0.9 } } };
  std::vector<std::vector<std::int64_t>> lines = { { 0, 1 }, { 2, 3 }, { 4, 5 } };
  std::set<double> heights;
  for (int order = 0; order != 6; ++order)
  {
    std::rotate(lines.begin(), lines.begin() + 1, lines.end());
    std::swap(lines[0][0], lines[0][1]);
    PrepareCase given({}, source, { lines[0], lines[1], lines[2] }, {});
    given.request.split = true;
    const PreparedInput out = prepared(given);
    ASSERT_EQ(out.crossings().size(), 1u);
    heights.insert(out.place(6)[2]);
    EXPECT_EQ(out.bentCount(), 0u);
  }
  EXPECT_EQ(heights.size(), 1u);
}

TEST(Prepare, CellsOfAThousandCrossingsAreKept)
{
  std::vector<Xyz> ends;
  Cells lines;
  for (int i = 0; i < 40; ++i)
  {
    const std::int64_t k = 4 * std::int64_t(i);
    ends.insert(ends.end(),
      { Xyz{ { i + 0.5, -1, 0 } }, Xyz{ { i + 0.5, 41, 0 } }, Xyz{ { -1, i + 0.5, 0 } },
        Xyz{ { 41, i + 0.5, 0 } } });
    lines.push_back({ k, k + 1 });
    lines.push_back({ k + 2, k + 3 });
  }
  PrepareCase given({}, ends, lines);
  given.request.split = true;
  const PreparedInput out = prepared(given);
  EXPECT_EQ(out.crossings().size(), 1600u);
  EXPECT_EQ(out.crossingCells().size(), 1000u);
  EXPECT_EQ(out.addedCount(), 160u + 1600);
}

TEST(Prepare, NoPointsAtAll)
{
  InputRequest request;
  request.bounding = request.split = true;
  request.tolerance = 0.5;
  PreparedInput out;
  ASSERT_EQ(prepare(request, Context(), out), Status::Ok);
  EXPECT_EQ(out.points().count, 0u);
  request.fitPlane = true;
  PreparedInput fitted;
  ASSERT_EQ(prepare(request, Context(), fitted), Status::Ok);
  EXPECT_EQ(fitted.points().count, 0u);
  EXPECT_EQ(fitted.plane().normal(), (Xyz{ { 0, 0, 1 } }));
}

TEST(Prepare, OddPointsAreFound)
{
  for (const std::size_t count : { 10, 5000, 20000 })
  {
    std::vector<Xyz> points(count, Xyz{ { 1, 2, 3 } });
    std::vector<float> floats(3 * count, 1.0f);
    OddPoints odd;
    ASSERT_EQ(findOddPoints(viewOf(points), Context(), odd), Status::Ok);
    EXPECT_EQ(odd.firstNotFinite + odd.oddZ, 0u);
    std::vector<unsigned char> marks(count, 0);
    marks[2] = 1;
    for (const std::size_t i : { std::size_t(2), std::size_t(4), count - 3 })
    {
      points[i][0] = kNaN;
      floats[3 * i] = float(kNaN);
    }
    for (const std::size_t i : { std::size_t(5), count - 3, count - 1 })
    {
      points[i][2] = -kInfinity;
      floats[3 * i + 2] = float(kNaN);
    }
    PointView view = viewOf(points);
    PointView ofFloats(floats.data(), count, 3);
    view.skip = ofFloats.skip = marks.data();
    for (const PointView& points3 : { view, ofFloats })
    {
      ASSERT_EQ(findOddPoints(points3, Context(), odd), Status::Ok);
      EXPECT_EQ(odd.firstNotFinite, 4u);
      EXPECT_EQ(odd.oddZ, 2u);
    }
  }
}

TEST(Prepare, MemoryIsEstimated)
{
  PrepareCase given(kSquare, {}, { { 0, 1 }, { 2, 3, 0 } });
  given.request.idsAreOfInput = true;
  EXPECT_EQ(preparationMemoryEstimate(given.request), 7u * 8);
  given.request.split = true;
  EXPECT_EQ(preparationMemoryEstimate(given.request), 7u * 8 + splitMemoryEstimate(3, 0));
  given.request.fitPlane = true;
  const std::size_t fitted = 7u * 8 + splitMemoryEstimate(3, 0) + 4 * 25 +
    planeFitMemoryEstimate(4);
  EXPECT_EQ(preparationMemoryEstimate(given.request), fitted);
  given.request.tolerance = 0.1;
  EXPECT_EQ(preparationMemoryEstimate(given.request), fitted + 4 * 80);
}

} // namespace
} // namespace test
} // namespace ahd
