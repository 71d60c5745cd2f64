// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HashedSamples_h
#define ahd_HashedSamples_h

#include "HashFile.h"

#include <functional>

namespace ahdtest
{

/// All outputs of vtkAdaptiveHilbertInterpolation2D for some inputs and settings, as hashes. Each
/// runs twice, the second time on the kept triangulation, between `before` and `after`.
ahd::test::Hashes hashedSamples(
  const std::function<void()>& before, const std::function<void()>& after);

} // namespace ahdtest

#endif
