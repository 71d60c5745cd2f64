// SPDX-License-Identifier: BSD-3-Clause
#include "Clock.h"

#include <chrono>

namespace ahd
{

double steadySeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace ahd
