// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_RefineWriting_h
#define ahd_RefineWriting_h

#include "Refiner.h"

namespace ahd
{

/// What the mesh has become, in terms of the caller's points. Returns false if cancelled. Throws
/// std::bad_alloc. @pre refiner.run()
bool writeRefinement(const Domain& domain, const Refiner& refiner, Ticker& ticker, Refinement& out);

} // namespace ahd

#endif
