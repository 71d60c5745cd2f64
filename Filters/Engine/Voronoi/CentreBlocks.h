// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_CentreBlocks_h
#define ahd_CentreBlocks_h

#include "../Core/Dispatch.h"
#include "../Points/Points.h"

#include <cstddef>

namespace ahd
{

/// Computes circumcentre() of triangle k, which has the corners places[vertices[3 k]] and the two
/// after it, to centres[k], for `count` of them. @pre no triangle is flat; isModest() of all
/// coordinates.
using CentresOf = void(
  const Index* vertices, const Point* places, std::size_t count, Point* centres);

// As it is compiled for each instruction set (Core/Dispatch.h).
inline namespace baseline
{
CentresOf circumcentresHere;
}
inline namespace avx2
{
CentresOf circumcentresHere;
}

/// The one for this processor.
CentresOf* circumcentres();

} // namespace ahd

#endif
