// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Clock_h
#define ahd_Clock_h

namespace ahd
{

/// Seconds since an arbitrary start.
using Clock = double (*)();

/// A monotonic clock. For progress, as its callers may have none; the rest of the engine reads no
/// clock.
double steadySeconds();

} // namespace ahd

#endif
