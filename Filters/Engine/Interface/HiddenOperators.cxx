// SPDX-License-Identifier: BSD-3-Clause
//
// The operators new and delete of this library alone, for a linker that exports those of a standard
// library that it links statically (CLibrary.cmake): another library's could then take their place,
// or the other way round. Compiled to nothing elsewhere.
#ifdef AHD_HIDDEN_OPERATORS
#include <cstddef>
#include <cstdlib>
#include <new>

namespace
{

/// As the standard says of the operators: asks the handler for more until it throws or there is
/// none.
void* allocate(std::size_t bytes, std::size_t alignment)
{
  void* memory = nullptr;
  while (posix_memalign(&memory, alignment, bytes > 0 ? bytes : 1) != 0)
  {
    const std::new_handler handler = std::get_new_handler();
    if (!handler)
    {
      throw std::bad_alloc();
    }
    handler();
  }
  return memory;
}

} // namespace

// clang-format off
void* operator new(std::size_t bytes) { return allocate(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new[](std::size_t bytes) { return allocate(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t bytes, std::align_val_t to) { return allocate(bytes, std::size_t(to)); }
void* operator new[](std::size_t bytes, std::align_val_t to) { return allocate(bytes, std::size_t(to)); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
// clang-format on
#endif
