// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Uninitialised_h
#define ahd_Uninitialised_h

#include <memory>
#include <utility>
#include <vector>

namespace ahd
{

/// Leaves new numbers uninitialised, so that the threads that write them touch the memory first,
/// and once.
template <typename T>
struct UninitialisedAllocator : std::allocator<T>
{
  template <typename Other>
  struct rebind
  {
    using other = UninitialisedAllocator<Other>;
  };

  template <typename Other>
  void construct(Other*) noexcept
  {
  }
  template <typename Other, typename... Arguments>
  void construct(Other* to, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(to)) Other(std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose resize() leaves new elements uninitialised.
template <typename T>
using UninitialisedVector = std::vector<T, UninitialisedAllocator<T>>;

} // namespace ahd

#endif
