// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Processors_h
#define ahd_Processors_h

namespace ahd
{

/// Logical processors that the threads of this process may run on; at least 1. By its affinity on
/// Linux and Windows; macOS has none. Where Windows has more than 64, those of the groups of this
/// process: all groups from Windows 11 and Server 2022 on, one before.
unsigned availableProcessors();

} // namespace ahd

#endif
