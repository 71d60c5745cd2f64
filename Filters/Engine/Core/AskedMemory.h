// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_AskedMemory_h
#define ahd_AskedMemory_h

#include "Progress.h"

#include <atomic>
#include <cstddef>
#include <limits>
#include <vector>

namespace ahd
{

/// Counts the memory requested beyond an estimate, and limits it: a Progress answers
/// Progress::take() with one. Thread-safe.
class AskedMemory
{
public:
  /// Sets the limit, and the counts to 0.
  void limitTo(std::size_t most)
  {
    most_ = most;
    held_ = peak_ = 0;
  }

  bool take(std::size_t bytes)
  {
    const std::size_t held = held_ += bytes;
    std::size_t peak = peak_;
    while (peak < held && !peak_.compare_exchange_weak(peak, held))
    {
    }
    return held <= most_;
  }
  void giveBack(std::size_t bytes) { held_ -= bytes; }

  /// Most bytes held at a time, refused requests included.
  std::size_t most() const { return peak_; }
  bool wasRefused() const { return peak_ > most_; }

private:
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::atomic<std::size_t> held_{ 0 };
  std::atomic<std::size_t> peak_{ 0 };
};

/// Memory requested beyond the estimate, held for the lifetime of this object.
class TakenMemory
{
public:
  explicit TakenMemory(Ticker& ticker)
    : ticker_(ticker)
  {
  }
  ~TakenMemory() { ticker_.giveBack(bytes_); }
  TakenMemory(const TakenMemory&) = delete;
  TakenMemory& operator=(const TakenMemory&) = delete;

  /// Requests the increase, if any. Throws std::bad_alloc if it is refused.
  void atLeast(std::size_t bytes)
  {
    if (bytes > bytes_)
    {
      const std::size_t more = bytes - bytes_;
      bytes_ = bytes;
      ticker_.take(more);
    }
  }
  /// Returns the decrease, if any.
  void atMost(std::size_t bytes)
  {
    if (bytes < bytes_)
    {
      ticker_.giveBack(bytes_ - bytes);
      bytes_ = bytes;
    }
  }

private:
  Ticker& ticker_;
  std::size_t bytes_ = 0;
};

/// Memory for growing lists, requested before they grow and held for the lifetime of this object;
/// for all threads of a phase.
class GrowingMemory
{
public:
  explicit GrowingMemory(Ticker& phase)
    : phase_(phase)
  {
  }
  ~GrowingMemory() { phase_.giveBack(bytes_); }
  GrowingMemory(const GrowingMemory&) = delete;
  GrowingMemory& operator=(const GrowingMemory&) = delete;

  /// Throws std::bad_alloc if they are refused.
  void take(std::size_t bytes)
  {
    bytes_ += bytes;
    phase_.take(bytes);
  }

  /// Appends the item. In all, a list requests three times its capacity before it last grew: the
  /// old array and one twice as large. Few items request nothing.
  template <typename T>
  void add(std::vector<T>& list, const T& item)
  {
    constexpr std::size_t kFew = 256;
    if (list.size() == list.capacity() && list.size() >= kFew)
    {
      take(3 * sizeof(T) * list.size() / (list.size() < 2 * kFew ? 1 : 2));
    }
    list.push_back(item);
  }

private:
  Ticker& phase_;
  std::atomic<std::size_t> bytes_{ 0 };
};

} // namespace ahd

#endif
