// SPDX-License-Identifier: BSD-3-Clause
//
// The cost of splitting where constraints cross, beside CGAL's Constrained_Delaunay_triangulation_2
// with Exact_predicates_tag, one thread, CPU time, in turns. Each from the points to the
// constrained triangulation; "left out" is ours without splitting. The segments are those of
// crossingCases().
#include "BesideCgal.h"
#include "Crossings/Crossings.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ahd;
using namespace ahd::test;

/// Returns the number of crossing pairs.
std::size_t triangulateOurs(const ConstraintCase& given, bool splits)
{
  static Workspace workspace;
  SplitConstraints split;
  std::vector<Point> points;
  PointView view = given.view();
  ConstraintView constraints = given.constraints.view();
  if (splits && splitAtCrossings(view, constraints, nullptr, split) == Status::Ok)
  {
    points = given.points;
    for (const CrossingPoint& p : split.points)
    {
      points.push_back(p.at);
    }
    view = PointView(&points[0].x, points.size(), 2);
    constraints = split.view();
  }
  Triangulation made;
  triangulate(view, Options(), workspace, Context(), made);
  constrain(std::move(made), constraints, FillRule::Orientation, Context(), made);
  workspace.reclaim(std::move(made));
  return split.crossings;
}

template <typename Work>
void time(std::vector<double>& times, Work work)
{
  const double begin = seconds();
  work();
  times.push_back(seconds() - begin);
}

double median(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times.empty() ? 0.0 : times[times.size() / 2];
}

void measure(const CrossingSegments& shape, double scale, int repeat)
{
  const ConstraintCase given = crossingSegments(shape, scale);
#ifdef AHD_WITH_CGAL
  const CgalConstrained cgal(given);
#endif
  std::vector<double> leftOut, split, theirs;
  std::size_t crossings = 0;
  for (int k = 0; k < repeat; ++k)
  {
    time(leftOut, [&] { triangulateOurs(given, false); });
    time(split, [&] { crossings = triangulateOurs(given, true); });
#ifdef AHD_WITH_CGAL
    time(theirs, [&] { cgal.split(); });
#endif
  }
  std::printf("%-14s %8zu crossings, seconds: left out %.4f, split %.4f, CGAL %.4f\n", shape.name,
    crossings, median(leftOut), median(split), median(theirs));
}

} // namespace

/// [repeat, 5] [scale, 1]
int main(int argc, char** argv)
{
  const int repeat = argc > 1 ? std::atoi(argv[1]) : 5;
  const double scale = argc > 2 ? std::atof(argv[2]) : 1.0;
  std::vector<CrossingSegments> shapes = crossingCases();
  shapes.push_back({ "1M-3k-short", 1000000, 0.0001, 0 });
  shapes.push_back({ "1M-none", 1000000, 1e-7, 0 });
  for (const CrossingSegments& shape : shapes)
  {
    measure(shape, scale, std::max(1, repeat));
  }
  return 0;
}
