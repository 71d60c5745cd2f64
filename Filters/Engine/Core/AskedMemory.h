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

/// How much is held of what is asked for beyond an estimate, and how much may be: a Progress has
/// one to answer Progress::take(). For any threads.
class AskedMemory
{
public:
  /// Forgets what was asked for.
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

  /// Most that was held at a time, or that one asked for.
  std::size_t most() const { return peak_; }
  bool wasRefused() const { return peak_ > most_; }

private:
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::atomic<std::size_t> held_{ 0 };
  std::atomic<std::size_t> peak_{ 0 };
};

/// Memory that was asked for, as long as this lives.
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

  /// Asks for what is needed more than before, if it is. Throws std::bad_alloc if it may not be
  /// taken.
  void atLeast(std::size_t bytes)
  {
    if (bytes > bytes_)
    {
      const std::size_t more = bytes - bytes_;
      bytes_ = bytes;
      ticker_.take(more);
    }
  }
  /// Gives back what is not needed any more.
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

/// Memory that lists grow into, as long as this lives: asked for before they do, by any threads of
/// a phase.
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

  /// Throws std::bad_alloc if they may not be taken.
  void take(std::size_t bytes)
  {
    bytes_ += bytes;
    phase_.take(bytes);
  }

  /// Adds the item. In all, a list asks for three times what it had room for before it last grew:
  /// itself, and twice as much. Nothing for few items.
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
