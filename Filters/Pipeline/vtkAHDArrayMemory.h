// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAHDArrayMemory_h
#define vtkAHDArrayMemory_h

#include <cstddef>
#include <memory>

/// The memory of large output arrays, handed from the outputs of one execution to those of the
/// next. New memory costs 1 to 2 microseconds for each 4 KiB when it is first written, a third of
/// the time of some outputs; the arrays of before are freed just before the new ones are made.
///
/// So what they free from Open() to Close() waits for Allocate(). After Close() there is nothing
/// left: no memory is held that an output does not hold. Arrays may outlive this object, and be
/// freed by any thread.
class vtkAHDArrayMemory
{
public:
  /// Smaller ones the C library keeps anyway.
  static constexpr std::size_t kLeast = std::size_t(1) << 20;

  vtkAHDArrayMemory();
  ~vtkAHDArrayMemory(); ///< closes
  vtkAHDArrayMemory(const vtkAHDArrayMemory&) = delete;
  void operator=(const vtkAHDArrayMemory&) = delete;

  void Open();
  void Close();

  /// Frees of what waits as much as there is beyond so many bytes.
  void Shrink(std::size_t most);

  /// Bytes that wait.
  std::size_t GetBytes() const;

  /// Memory of `bytes`, for Free(): such that waits and is not more than an eighth too large, or
  /// new. Then as much is freed of what waits, so all together is never more than the larger of
  /// what waited first and what was asked for since. Throws std::bad_alloc.
  void* Allocate(std::size_t bytes);

  /// The free function of arrays in memory of Allocate().
  static void Free(void* memory);

private:
  class Waiting;
  struct Block;
  const std::shared_ptr<Waiting> Blocks;
};

#endif
