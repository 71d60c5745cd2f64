// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Windows_h
#define ahd_Windows_h

// <windows.h>, as small as possible and without its macros min and max. For sources only.

#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#endif
