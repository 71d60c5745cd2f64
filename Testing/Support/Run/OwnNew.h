// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_OwnNew_h
#define ahd_OwnNew_h

// Gives a program operator new and delete of its own, over two functions that the program defines.
// Include it in one source. In every form but those for arrays of high alignment: a sanitizer has
// its own form for each missing here, and one cannot free the memory of the other.
#include <algorithm>
#include <cstddef>
#include <new>

namespace ahd
{
namespace test
{

/// A block of `size` bytes; `alignment` is at least that of std::max_align_t. Throws
/// std::bad_alloc.
void* ownAllocate(std::size_t size, std::size_t alignment);
/// Frees it; null is legal.
void ownRelease(void* block);

} // namespace test
} // namespace ahd

void* operator new(std::size_t size)
{
  return ahd::test::ownAllocate(size, alignof(std::max_align_t));
}

void* operator new[](std::size_t size)
{
  return operator new(size);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try
  {
    return operator new(size);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept
{
  return operator new(size, nothrow);
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
  return ahd::test::ownAllocate(size, std::max(std::size_t(alignment), alignof(std::max_align_t)));
}

void operator delete(void* p) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete(void* p, std::size_t) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete(void* p, const std::nothrow_t&) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete[](void* p) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete[](void* p, std::size_t) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete[](void* p, const std::nothrow_t&) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete(void* p, std::align_val_t) noexcept
{
  ahd::test::ownRelease(p);
}

void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  ahd::test::ownRelease(p);
}

#endif
