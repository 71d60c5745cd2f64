// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/vtkAHDRankMemory.h"

#include "Engine/Core/Memory.h"
#include "Engine/Distribute/BlockBytes.h"
#include "Pipeline/vtkAHDMemoryWords.h"

#include <cstdint>
#include <sstream>
#include <vector>

std::string vtkAHDRefuseMemory(const vtkAHDSettings& settings, const vtkAHDAllFacts& facts,
  vtkAHDRanks& ranks, const vtkAHDContext& context, std::size_t bytes, const vtkAHDRankWork& work)
{
  const bool isLimited = settings.MemoryLimit > 0;
  // what is held already is part of the estimate, and of no rank's rest
  const vtkTypeInt64 there = isLimited ? settings.MemoryLimit
                                       : static_cast<vtkTypeInt64>(ahd::availableMemory() / 1024 /
                                           facts.CountOnHostOf(ranks.GetOwn()));
  const std::int64_t figures[] = { static_cast<std::int64_t>(bytes / 1024), there, isLimited };
  ahd::BlockBytes own;
  std::vector<ahd::BlockBytes> all;
  ranks.Together(context, [&] { ahd::BytesWriter(own).write(figures); });
  context.Check(ranks.gather(own, all));
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    ahd::BytesReader reader(all[k]);
    const auto needed = reader.read<std::int64_t>();
    const auto limit = reader.read<std::int64_t>();
    const bool isByUser = reader.read<std::int64_t>() != 0;
    if (needed > limit)
    {
      std::ostringstream error;
      error << work.Doing << " " << work.Points << " points on " << all.size() << " ranks may take "
            << vtkAHDNeeded(needed) << " of memory on rank " << k << work.Share << ", but "
            << vtkAHDButAllowed(limit, isByUser)
            << ". Nothing is put out. Take fewer points or more ranks, "
            << vtkAHDOrSetLimit(needed, true);
      return error.str();
    }
  }
  return std::string();
}
