// SPDX-License-Identifier: BSD-3-Clause
//
// Bytes become a sequence of steps (LifetimeWorld.h): each is four bytes, its kind and where its
// dice begin, so that a step stays the same where others are left out. With AHD_FUZZ_SHOW set the
// steps are printed. Testing/Package/Lifetimes/lifetimes.py makes sequences, and shortens them.
#include "LifetimeWorld.h"

#include "vtkLogger.h"
#include "vtkObject.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

/// VTK is not compiled with the sanitizers, and frees some things only at the end of the program.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options()
{
  return "detect_container_overflow=0:alloc_dealloc_mismatch=0:detect_leaks=0:"
         "malloc_context_size=6:quarantine_size_mb=32:max_free_fill_size=65536";
}

namespace
{
constexpr std::size_t kBytes = 4;      // of a step
constexpr std::size_t kMostSteps = 64; // more take longer, and find no more faults
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace ahd::fuzz;
  vtkObject::GlobalWarningDisplayOff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  const bool shows = std::getenv("AHD_FUZZ_SHOW") != nullptr;
  LifetimeWorld world;
  for (std::size_t k = 0; k < std::min(size / kBytes, kMostSteps); ++k)
  {
    const std::uint8_t* step = data + kBytes * k;
    const std::size_t kind = step[0] % LifetimeWorld::kinds();
    if (shows)
    {
      std::fprintf(
        stderr, "%s %02x%02x%02x\n", LifetimeWorld::name(kind), step[1], step[2], step[3]);
    }
    Dice dice(unsigned(step[1]) | unsigned(step[2]) << 8 | unsigned(step[3]) << 16);
    world.step(kind, dice);
    if (shows)
    {
      std::fprintf(stderr, "  %s\n", world.state().c_str());
    }
  }
  world.finish();
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

/// Steps are inserted, dropped, replaced and repeated elsewhere.
extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed)
{
  ahd::fuzz::Dice dice(seed);
  std::size_t steps = size / kBytes;
  const std::size_t room = std::min(most / kBytes, kMostSteps);
  for (std::size_t moves = 1 + dice.below(4); moves > 0; --moves)
  {
    const std::size_t at = dice.below(steps + 1);
    std::uint8_t* const step = data + kBytes * at;
    const std::size_t how = dice.below(4);
    if (how == 0 && at < steps)
    {
      std::memmove(step, step + kBytes, kBytes * (steps - at - 1));
      --steps;
    }
    else if (how == 1 && at < steps && steps > 1)
    {
      std::memmove(step, data + kBytes * dice.below(steps), kBytes);
    }
    else if (steps < room)
    {
      std::memmove(step + kBytes, step, kBytes * (steps - at));
      ++steps;
      std::generate(step, step + kBytes, [&] { return std::uint8_t(dice.below(256)); });
    }
  }
  return kBytes * steps;
}
