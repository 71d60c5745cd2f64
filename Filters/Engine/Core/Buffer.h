// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Buffer_h
#define ahd_Buffer_h

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace ahd
{

/// An array that is allocated once, aligned to 64 bytes (a cache line), and not initialised: the
/// engine's large arrays are written before they are read, and touching each page twice costs time.
template <typename T>
class Buffer
{
  static_assert(std::is_trivially_copyable<T>::value, "a Buffer's elements are not constructed");

public:
  Buffer() = default;
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept
  {
    Buffer old(std::move(*this));
    swap(other);
    return *this;
  }
  ~Buffer()
  {
    if (capacity_ != 0)
    {
      free(data_);
    }
  }

  /// Drops what it held and makes room for `size` elements, in the memory it has if that is large
  /// enough and not several times too large. Throws std::bad_alloc; the engine catches it at its
  /// border and reports Status::OutOfMemory.
  void allocate(std::size_t size)
  {
    if (capacity_ != 0 && size <= capacity_ && capacity_ / kMostWaste <= size)
    {
      size_ = size;
      return;
    }
    reset();
    if (size == 0)
    {
      return;
    }
    if (size > std::size_t(-1) / sizeof(T))
    {
      throw std::bad_alloc();
    }
    data_ = static_cast<T*>(::operator new(size * sizeof(T), std::align_val_t(kAlignment)));
    size_ = size;
    capacity_ = size;
  }

  /// Drops what it held and becomes a view of memory owned elsewhere.
  /// @pre `memory` is aligned for T and outlives the use.
  void view(void* memory, std::size_t size)
  {
    reset();
    data_ = static_cast<T*>(memory);
    size_ = size;
  }

  /// Drops its elements, but keeps its memory.
  void clear() { size_ = 0; }

  void reset() { Buffer old(std::move(*this)); }

  /// Gives up its memory, which must be freed by free(); null if it owns none.
  T* release()
  {
    T* const given = capacity_ != 0 ? data_ : nullptr;
    data_ = nullptr;
    size_ = capacity_ = 0;
    return given;
  }
  /// Owns memory that a Buffer of any type gave up.
  static Buffer owner(void* given, std::size_t bytes)
  {
    Buffer buffer;
    buffer.data_ = static_cast<T*>(given);
    buffer.size_ = buffer.capacity_ = bytes / sizeof(T);
    return buffer;
  }
  static void free(void* given) { ::operator delete(given, std::align_val_t(kAlignment)); }

  /// Bytes it owns.
  std::size_t bytes() const { return capacity_ * sizeof(T); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

private:
  static constexpr std::size_t kAlignment = 64;
  static constexpr std::size_t kMostWaste = 4;

  void swap(Buffer& other) noexcept
  {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0; ///< elements it owns; 0 for a view
};

/// Memory used for different things in turn.
using Scratch = Buffer<unsigned char>;

} // namespace ahd

#endif
