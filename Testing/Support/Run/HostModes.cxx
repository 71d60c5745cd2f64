// SPDX-License-Identifier: BSD-3-Clause
#include "HostModes.h"

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ahd
{
namespace test
{
const std::vector<HostMode>& hostModes()
{
  static const std::vector<HostMode> kModes = {
    { "upward", FE_UPWARD, 0, 0 },
    { "downward", FE_DOWNWARD, 0, 0 },
    { "toward zero", FE_TOWARDZERO, 0, 0 },
#if defined(__SSE2__)
    { "flush to zero", FE_TONEAREST, kFlushToZero, 0 },
    { "denormals are zero", FE_TONEAREST, kDenormalsAreZero, 0 },
#endif
#if defined(__SSE2__) && defined(__GLIBC__)
    { "traps", FE_TONEAREST, 0, FE_ALL_EXCEPT },
    { "everything", FE_UPWARD, kFlushToZero | kDenormalsAreZero, FE_ALL_EXCEPT },
#endif
  };
  return kModes;
}

void enter(const HostMode& mode)
{
  leaveHostMode();
  std::fesetround(mode.rounding);
#if defined(__SSE2__)
  _mm_setcsr(_mm_getcsr() | mode.flushing);
#endif
#if defined(__GLIBC__)
  feenableexcept(mode.traps);
#endif
}

bool isIn(const HostMode& mode)
{
#if defined(__SSE2__)
  // The register alone: the functions of <cfenv> look at the x87 unit instead.
  constexpr unsigned kSigns = 0x3F; // of exceptions that were
  const unsigned now = _mm_getcsr();
  enter(mode);
  const bool result = (now & ~kSigns) == (_mm_getcsr() & ~kSigns);
  _mm_setcsr(now);
  return result;
#else
  return std::fegetround() == mode.rounding;
#endif
}

void leaveHostMode()
{
  std::fesetenv(FE_DFL_ENV);
#if defined(__SSE2__)
  constexpr unsigned kDefault = 0x1F80;
  _mm_setcsr(kDefault);
#endif
}

} // namespace test
} // namespace ahd
