// SPDX-License-Identifier: BSD-3-Clause
#include "ReportRows.h"

#include "../Core/Dispatch.h"

namespace ahd
{

std::uint64_t dispatchTarget()
{
  return std::uint64_t(processorHas(InstructionSet::Avx512) ? InstructionSet::Avx512
      : processorHas(InstructionSet::Avx2)                  ? InstructionSet::Avx2
                                                            : InstructionSet::Baseline);
}

} // namespace ahd
