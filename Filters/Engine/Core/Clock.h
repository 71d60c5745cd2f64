// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Clock_h
#define ahd_Clock_h

namespace ahd
{

/// Seconds from some beginning.
using Clock = double (*)();

/// A clock that is never set. For progress, as its callers may have none; the rest of the engine
/// reads no clock.
double steadySeconds();

} // namespace ahd

#endif
