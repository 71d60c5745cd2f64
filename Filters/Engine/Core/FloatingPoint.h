// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_FloatingPoint_h
#define ahd_FloatingPoint_h

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#elif defined(__aarch64__) && defined(__GNUC__)
#include <cstdint>
#else
#include <cfenv>
#endif

namespace ahd
{

/// For its lifetime, this thread's floating-point arithmetic is as the predicates assume it:
/// rounding to nearest, subnormal numbers kept, no traps. A host program, or the task a borrowed
/// thread ran before, may have changed it. The previous state is restored at the end. On other
/// processors than x86-64 and aarch64 only the rounding mode is set.
class ScopedFloatingPoint
{
public:
#if defined(__SSE2__) || defined(_M_X64)
  ScopedFloatingPoint()
    : before_(_mm_getcsr())
  {
    constexpr unsigned kDefault = 0x1F80;
    _mm_setcsr(kDefault);
  }
  ~ScopedFloatingPoint()
  {
    _mm_setcsr(before_);
  }

private:
  unsigned before_;
#elif defined(__aarch64__) && defined(__GNUC__)
  ScopedFloatingPoint()
  {
    __asm__ volatile("mrs %0, fpcr" : "=r"(before_));
    set(0); // Arm's defaults: all bits of modes and traps are 0
  }
  ~ScopedFloatingPoint()
  {
    set(before_);
  }

private:
  static void set(std::uint64_t modes)
  {
    __asm__ volatile("msr fpcr, %0" : : "r"(modes) : "memory");
  }

  std::uint64_t before_ = 0;
#else
  ScopedFloatingPoint()
    : before_(std::fegetround())
  {
    std::fesetround(FE_TONEAREST);
  }
  ~ScopedFloatingPoint()
  {
    std::fesetround(before_);
  }

private:
  int before_;
#endif
  ScopedFloatingPoint(const ScopedFloatingPoint&) = delete;
  ScopedFloatingPoint& operator=(const ScopedFloatingPoint&) = delete;
};

} // namespace ahd

#endif
