// SPDX-License-Identifier: BSD-3-Clause
//
// The operators new and delete that the library has of its own with some linkers: here they are
// those of this program, and what they ask of the system is seen.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

namespace
{

/// What the operators asked of the system, and how it answers.
struct Asked
{
  std::size_t alignment = 0, bytes = 0; ///< last
  std::size_t freed = 0;
  void* last = nullptr;     ///< freed
  std::size_t failures = 0; ///< to come
};
Asked asked;
std::size_t handled = 0;

} // namespace

// The linker puts these in place of the system's (--wrap).
extern "C"
{
  int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes);
  int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes);
  void __real_free(void* memory);
  void __wrap_free(void* memory);

  int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes)
  {
    asked.alignment = alignment;
    asked.bytes = bytes;
    if (asked.failures > 0)
    {
      --asked.failures;
      return ENOMEM;
    }
    return __real_posix_memalign(memory, alignment, bytes);
  }

  void __wrap_free(void* memory)
  {
    ++asked.freed;
    asked.last = memory;
    __real_free(memory);
  }
}

namespace
{

constexpr std::size_t kUsual = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

/// One place of so many bytes from `take`, which `give` gives back.
template <typename Take, typename Give>
void expectPlace(std::size_t bytes, std::size_t alignment, const Take& take, const Give& give)
{
  const std::size_t before = asked.freed;
  void* const place = take();
  const Asked then = asked;
  std::memset(place, 7, bytes);
  give(place);
  const Asked now = asked;
  EXPECT_NE(place, nullptr);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(place) % alignment, 0u);
  EXPECT_EQ(then.alignment, alignment);
  EXPECT_EQ(then.bytes, bytes > 0 ? bytes : 1);
  EXPECT_EQ(then.freed, before);
  EXPECT_EQ(now.freed, before + 1);
  EXPECT_EQ(now.last, place);
}

} // namespace

TEST(HiddenOperators, EachTakesAndGivesBack)
{
  for (const std::size_t bytes : { 0u, 1u, 48u, 5000u })
  {
    const auto one = [bytes] { return ::operator new(bytes); };
    const auto many = [bytes] { return ::operator new[](bytes); };
    expectPlace(bytes, kUsual, one, [](void* place) { ::operator delete(place); });
    expectPlace(bytes, kUsual, one, [=](void* place) { ::operator delete(place, bytes); });
    expectPlace(bytes, kUsual, many, [](void* place) { ::operator delete[](place); });
    expectPlace(bytes, kUsual, many, [=](void* place) { ::operator delete[](place, bytes); });
  }
}

TEST(HiddenOperators, EachIsAlignedAsWished)
{
  for (const std::size_t alignment : { 32u, 4096u })
  {
    const std::align_val_t to{ alignment };
    for (const std::size_t bytes : { 0u, 40u, 5000u })
    {
      const auto one = [=] { return ::operator new(bytes, to); };
      const auto many = [=] { return ::operator new[](bytes, to); };
      expectPlace(bytes, alignment, one, [=](void* p) { ::operator delete(p, to); });
      expectPlace(bytes, alignment, one, [=](void* p) { ::operator delete(p, bytes, to); });
      expectPlace(bytes, alignment, many, [=](void* p) { ::operator delete[](p, to); });
      expectPlace(bytes, alignment, many, [=](void* p) { ::operator delete[](p, bytes, to); });
    }
  }
}

TEST(HiddenOperators, WithoutAHandlerItThrows)
{
  asked.failures = 1;
  bool threw = false;
  try
  {
    ::operator delete(::operator new(48));
  }
  catch (const std::bad_alloc&)
  {
    threw = true;
  }
  EXPECT_TRUE(threw);
  EXPECT_EQ(asked.failures, 0u);
}

TEST(HiddenOperators, AHandlerIsAskedUntilThereIsMemory)
{
  handled = 0;
  std::set_new_handler([] { ++handled; });
  asked.failures = 3;
  void* const place = ::operator new(48);
  std::set_new_handler(nullptr);
  EXPECT_NE(place, nullptr);
  EXPECT_EQ(handled, 3u);
  ::operator delete(place);
}

TEST(HiddenOperators, WhatAHandlerThrowsEndsIt)
{
  std::set_new_handler([] { throw std::domain_error("no more"); });
  asked.failures = 1;
  EXPECT_THROW(::operator delete(::operator new(48)), std::domain_error);
  std::set_new_handler(nullptr);
  EXPECT_EQ(asked.failures, 0u);
}
