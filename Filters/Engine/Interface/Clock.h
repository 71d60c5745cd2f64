// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Clock_h
#define ahd_Clock_h

namespace ahd
{

/// Seconds from some beginning, by a clock that is never set. For jobs of the C interface; the rest
/// of the engine reads no clock.
double steadySeconds();

} // namespace ahd

#endif
