// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Record_h
#define ahd_Record_h

#include "../Points/Points.h"

#include <cstdint>

namespace ahd
{

/// A point on its way to its rank.
struct Record
{
  double x;
  double y;
  std::uint64_t key;
  Index id;
};

} // namespace ahd

#endif
