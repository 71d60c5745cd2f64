// SPDX-License-Identifier: BSD-3-Clause
#include "CgalNatural.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <iterator>
#include <limits>
#include <utility>

namespace ahd
{
namespace test
{

namespace
{

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <typename Kernel>
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;

template <typename Kernel>
using Coordinates = std::vector<std::pair<typename Kernel::Point_2, typename Kernel::FT>>;

template <typename Kernel>
std::vector<typename Kernel::Point_2> converted(const std::vector<Point>& points)
{
  std::vector<typename Kernel::Point_2> result;
  for (const Point& p : points)
  {
    result.emplace_back(p.x, p.y);
  }
  return result;
}

} // namespace

struct CgalNatural::Made
{
  Delaunay<Inexact> triangulation;
  std::map<Inexact::Point_2, double, Inexact::Less_xy_2> values;
};

CgalNatural::CgalNatural(const std::vector<Point>& points, const std::vector<double>& values)
  : made_(new Made)
{
  const std::vector<Inexact::Point_2> converts = converted<Inexact>(points);
  made_->triangulation.insert(converts.begin(), converts.end());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    made_->values.emplace(converts[k], values[k]);
  }
}

CgalNatural::~CgalNatural() = default;

std::vector<double> CgalNatural::interpolate(const std::vector<Point>& places) const
{
  std::vector<double> result;
  Coordinates<Inexact> coordinates;
  Delaunay<Inexact>::Face_handle hint;
  for (const Point& place : places)
  {
    const Inexact::Point_2 p(place.x, place.y);
    coordinates.clear();
    hint = made_->triangulation.locate(p, hint);
    const auto found = CGAL::natural_neighbor_coordinates_2(
      made_->triangulation, p, std::back_inserter(coordinates), hint);
    double sum = 0.0;
    for (const auto& one : coordinates)
    {
      sum += one.second * made_->values.find(one.first)->second;
    }
    result.push_back(found.third ? sum / found.second : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

std::vector<std::map<std::int64_t, double>> exactNaturalWeights(
  const std::vector<Point>& points, const std::vector<Point>& places)
{
  Delaunay<Exact> triangulation;
  std::map<Exact::Point_2, std::int64_t, Exact::Less_xy_2> ids;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const Exact::Point_2 p(points[k].x, points[k].y);
    triangulation.insert(p);
    ids.emplace(p, std::int64_t(k));
  }
  std::vector<std::map<std::int64_t, double>> result(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    Coordinates<Exact> coordinates;
    const auto found = CGAL::natural_neighbor_coordinates_2(
      triangulation, Exact::Point_2(places[k].x, places[k].y), std::back_inserter(coordinates));
    for (const auto& one : coordinates)
    {
      if (found.third && one.second != 0)
      {
        result[k][ids.find(one.first)->second] = CGAL::to_double(
          CGAL::exact(one.second / found.second));
      }
    }
  }
  return result;
}

} // namespace test
} // namespace ahd
