// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CgalNatural_h
#define ahd_CgalNatural_h

#include "Points/Points.h"

#include <map>
#include <memory>
#include <vector>

namespace ahd
{
namespace test
{

/// CGAL's natural neighbours, among points with values.
class CgalNatural
{
public:
  CgalNatural(const std::vector<Point>& points, const std::vector<double>& values);
  ~CgalNatural();

  /// By natural_neighbor_coordinates_2 over Exact_predicates_inexact_constructions_kernel, each
  /// search beginning where the last one ended. NaN where there is no value.
  std::vector<double> interpolate(const std::vector<Point>& places) const;

private:
  struct Made;
  std::unique_ptr<Made> made_;
};

/// Sibson's weights by the same function over an exact kernel, of each place: by number of the
/// point. Empty outside. @pre distinct points.
std::vector<std::map<std::int64_t, double>> exactNaturalWeights(
  const std::vector<Point>& points, const std::vector<Point>& places);

} // namespace test
} // namespace ahd

#endif
