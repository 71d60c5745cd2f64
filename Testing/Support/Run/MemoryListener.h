// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_MemoryListener_h
#define ahd_MemoryListener_h

#include "Core/AskedMemory.h"

#include <cstddef>

namespace ahd
{
namespace test
{

/// Grants so many of the bytes requested beyond an estimate.
class MemoryListener : public Progress
{
public:
  explicit MemoryListener(std::size_t most = std::size_t(-1)) { memory.limitTo(most); }

  bool advance(Phase, double) override { return true; }
  bool take(std::size_t bytes) override { return memory.take(bytes); }
  void giveBack(std::size_t bytes) override { memory.giveBack(bytes); }

  AskedMemory memory;
};

} // namespace test
} // namespace ahd

#endif
