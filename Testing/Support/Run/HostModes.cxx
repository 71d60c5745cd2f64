// SPDX-License-Identifier: BSD-3-Clause
#include "HostModes.h"

#include <cfenv>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ahd
{
namespace test
{
#if defined(__aarch64__)
namespace
{
constexpr std::uint64_t kFlushes = std::uint64_t(1) << 24; // bit FZ of the register FPCR

std::uint64_t controls()
{
  std::uint64_t bits = 0;
  __asm__ volatile("mrs %0, fpcr" : "=r"(bits));
  return bits;
}

void setControls(std::uint64_t bits)
{
  __asm__ volatile("msr fpcr, %0" : : "r"(bits) : "memory");
}
}
#endif

const std::vector<HostMode>& hostModes()
{
  static const std::vector<HostMode> kModes = {
    { "upward", FE_UPWARD, 0, 0 },
    { "downward", FE_DOWNWARD, 0, 0 },
    { "toward zero", FE_TOWARDZERO, 0, 0 },
#if defined(__SSE2__) || defined(__aarch64__)
    { "flush to zero", FE_TONEAREST, kFlushToZero, 0 },
#endif
#if defined(__SSE2__)
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
#elif defined(__aarch64__)
  setControls(controls() | (mode.flushing & kFlushToZero ? kFlushes : 0));
#endif
#if defined(__GLIBC__)
  feenableexcept(mode.traps);
#endif
}

bool isIn(const HostMode& mode)
{
#if defined(__SSE2__)
  // The register alone: the functions of <cfenv> read the x87 unit instead.
  constexpr unsigned kSigns = 0x3F; // of exceptions that were
  const unsigned now = _mm_getcsr();
  enter(mode);
  const bool result = (now & ~kSigns) == (_mm_getcsr() & ~kSigns);
  _mm_setcsr(now);
  return result;
#elif defined(__aarch64__)
  const std::uint64_t now = controls();
  enter(mode);
  const bool result = now == controls();
  setControls(now);
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
