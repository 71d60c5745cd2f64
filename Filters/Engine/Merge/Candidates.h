// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Candidates_h
#define ahd_Candidates_h

#include "../Core/Progress.h"
#include "../Points/Points.h"

#include <vector>

namespace ahd
{

/// A point with its id.
struct Located
{
  Point at;
  Index id;
};

/// The finite points that are not left out, without most of those far from all others: a point
/// missing in `found` differs from every other point by more than `distance` (1 + 2^-50) in x or in
/// y. A point at the place of another is never missing. `flags` is scratch, a byte per point.
/// Returns false if cancelled. Throws std::bad_alloc.
///
/// Cost: a few steps per point on all threads; 2 bytes per point and thread, for four threads at
/// most, while it works, and `found`. Where more than half of the points may be near others,
/// `found` has all.
bool findCandidates(const PointView& points, double distance, unsigned char* flags, Ticker& ticker,
  std::vector<Located>& found);

} // namespace ahd

#endif
