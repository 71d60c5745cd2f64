// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Outside_h
#define ahd_Outside_h

#include "Sample.h"

#include <cstddef>

namespace ahd
{

/// Gives finite places that have no value, whose `mask` is 0, one in place of what `out` of the
/// arrays has there; slopes and mask stay. `sampler`: prepared for SampleMethod::Nearest, the
/// values of the nearest vertex; for another method, those at the nearest place of the surface.
/// Returns Ok, Cancelled or OutOfMemory; unless Ok, some places may have theirs. Time: what Nearest
/// takes at these places.
Status fillOutside(const Sampler& sampler, const SamplePlaces& places, const SampleArray* arrays,
  std::size_t count, const unsigned char* mask, const Context& context);

/// Upper estimate of the bytes that fillOutside() takes for so many points, and for these places,
/// which are not looked at; `components` of all arrays together; what prepare() of its Sampler
/// takes included.
std::size_t fillOutsideMemoryEstimate(
  std::size_t pointCount, const SamplePlaces& places, std::size_t components);

} // namespace ahd

#endif
