// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_SortByPlace_h
#define ahd_SortByPlace_h

#include "../Core/Buffer.h"
#include "../Core/Progress.h"
#include "Candidates.h"

#include <vector>

namespace ahd
{

/// Sorts points by place, lexicographically, those of one place by id, on all threads: first into
/// strips of equal width in x, then strip by strip. n log n steps however they are spread. `items`
/// is consumed. Returns false if cancelled. Throws std::bad_alloc.
bool sortByPlace(std::vector<Located>& items, Buffer<Located>& sorted, Ticker& ticker);

} // namespace ahd

#endif
