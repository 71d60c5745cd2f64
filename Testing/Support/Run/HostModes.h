// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_HostModes_h
#define ahd_HostModes_h

#include <string>
#include <vector>

namespace ahd
{
namespace test
{

/// Floating-point arithmetic as a host program may have set it before it calls.
struct HostMode
{
  std::string name;
  int rounding;      ///< FE_UPWARD and the like
  unsigned flushing; ///< kFlushToZero, kDenormalsAreZero: bits of the MXCSR register
  int traps;         ///< exceptions (FE_INEXACT and the like) that end the program by a signal
};

constexpr unsigned kFlushToZero = 0x8000;
constexpr unsigned kDenormalsAreZero = 0x0040;

/// Every rounding but the usual one, flushing, traps, and all together: as far as the processor has
/// them.
const std::vector<HostMode>& hostModes();

/// Sets this thread's arithmetic.
void enter(const HostMode& mode);
/// Is it set so?
bool isIn(const HostMode& mode);
/// As programs begin: rounding to nearest, nothing flushed, no traps.
void leaveHostMode();

} // namespace test
} // namespace ahd

#endif
