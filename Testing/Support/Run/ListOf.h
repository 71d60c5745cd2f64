// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_test_ListOf_h
#define ahd_test_ListOf_h

#include "Core/Buffer.h"
#include "Voronoi/Voronoi.h"

#include <vector>

namespace ahd
{
namespace test
{

/// The content of an array, to be compared and kept.
template <typename Value>
std::vector<Value> listOf(const Buffer<Value>& values)
{
  return std::vector<Value>(values.begin(), values.end());
}

/// Places of corners in the plane.
inline std::vector<Point> listOf(const Buffer<VoronoiCorner>& corners)
{
  return std::vector<Point>(corners.begin(), corners.end());
}

} // namespace test
} // namespace ahd

#endif
