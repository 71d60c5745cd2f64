// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDLoop_h
#define vtkAHDLoop_h

#include "Engine/Core/Executor.h"
#include "Pipeline/vtkAHDProgress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

/**
 * Calls work(begin, end) for pieces of [0, count), on the threads of `executor` where it pays, and
 * asks on the calling thread between its pieces (`progress`, which shows nothing new) whether the
 * filter is to abort. Returns false if so: then some pieces are missing. `work` throws nothing.
 */
template <typename Work>
bool vtkAHDLoop(
  std::size_t count, ahd::Executor& executor, vtkAHDProgress& progress, const Work& work)
{
  constexpr std::size_t kPiece = std::size_t(1) << 14;
  constexpr std::size_t kLeastShared = std::size_t(1) << 18; // fewer are done sooner than shared
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> aborted{ false };
  const auto ask = [&]
  {
    if (progress.MustAbort())
    {
      aborted = true;
    }
  };
  const auto piece = [&](std::size_t i)
  {
    if (std::this_thread::get_id() == caller)
    {
      ask();
    }
    if (!aborted.load(std::memory_order_relaxed))
    {
      work(i * kPiece, std::min(count, (i + 1) * kPiece));
    }
  };
  const std::size_t pieces = (count + kPiece - 1) / kPiece;
  if (count >= kLeastShared)
  {
    executor.run(pieces, piece, ask);
    return !aborted;
  }
  for (std::size_t i = 0; i < pieces && !aborted; ++i)
  {
    piece(i);
  }
  return !aborted;
}

#endif
